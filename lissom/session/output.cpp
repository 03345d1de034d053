#include "lissom/session/output.h"

#include <system_error>

#include "lissom/core/file_io.h"

namespace lissom {

namespace {

Status make_folder(const std::filesystem::path& folder) {
  if (folder.empty()) return {};
  std::error_code code;
  std::filesystem::create_directories(folder, code);
  if (!code) return {};
  return Error{ErrorCode::kFile, folder.string(), "the folder cannot be made: " + code.message(),
               "choose another one with -o"};
}

}  // namespace

Status Output::prepare() const {
  if (Status s = make_folder(folder_); !s) return s;
  const std::filesystem::path probe = folder_ / ".lissom-writes-here";
  const Status written = write_file(probe, "");
  std::error_code code;
  std::filesystem::remove(probe, code);
  if (written) return {};
  return Error{ErrorCode::kFile, folder_.string(),
               "nothing can be written into this folder: " + written.error().message, "choose another one with -o"};
}

Status Output::write(const std::filesystem::path& name, const std::string& bytes) {
  const std::filesystem::path path = folder_ / name;
  if (Status s = make_folder(path.parent_path()); !s) return s;
  Status status = write_file(path, bytes);
  if (status) written_.push_back(path);
  return status;
}

Status Output::write(const std::filesystem::path& name, const Result<std::string>& bytes) {
  if (!bytes) return bytes.error();
  return write(name, bytes.value());
}

}  // namespace lissom
