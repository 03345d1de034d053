#include "lissom/session/output.h"

#include <system_error>

#include "lissom/core/file_io.h"

namespace lissom {

Status Output::write(const std::filesystem::path& name, const std::string& bytes) {
  const std::filesystem::path path = folder_ / name;
  if (path.has_parent_path()) {
    std::error_code code;
    std::filesystem::create_directories(path.parent_path(), code);
    if (code) {
      return Error{ErrorCode::kFile, path.parent_path().string(), "the folder cannot be made: " + code.message(),
                   "choose another one with -o"};
    }
  }
  Status status = write_file(path, bytes);
  if (status) written_.push_back(path);
  return status;
}

Status Output::write(const std::filesystem::path& name, const Result<std::string>& bytes) {
  if (!bytes) return bytes.error();
  return write(name, bytes.value());
}

}  // namespace lissom
