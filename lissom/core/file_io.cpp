#include "lissom/core/file_io.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>
#include <vector>

#if defined(_WIN32)
#include <io.h>
#elif __has_include(<unistd.h>)
#include <unistd.h>
#endif

namespace lissom {
namespace fs = std::filesystem;
namespace {

enum class Access { kRead, kCreate, kOverwrite };

struct Closer {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Closer>;

File open(const fs::path& path, Access access) {
#if defined(_WIN32)
  const wchar_t* mode = access == Access::kRead ? L"rb" : access == Access::kCreate ? L"wbx" : L"wb";
  return File(_wfopen(path.c_str(), mode));
#else
  const char* mode = access == Access::kRead ? "rb" : access == Access::kCreate ? "wbx" : "wb";
  return File(std::fopen(path.c_str(), mode));
#endif
}

/// Hands the bytes to the disk, not just to the operating system, where that can be asked for.
bool flush_to_disk(std::FILE* file) {
  if (std::fflush(file) != 0) return false;
#if defined(_WIN32)
  return _commit(_fileno(file)) == 0;
#elif __has_include(<unistd.h>)
  return fsync(fileno(file)) == 0 || errno == EINVAL || errno == ENOTSUP;
#else
  return true;
#endif
}

Error file_error(const fs::path& path, std::string message, std::string hint = {}) {
  return {ErrorCode::kFile, path.string(), std::move(message), std::move(hint)};
}

std::string reason(int error) { return std::generic_category().message(error); }

bool write_all(std::FILE* file, std::string_view bytes) {
  return bytes.empty() || std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
}

Status write_directly(const fs::path& path, std::string_view bytes) {
  const File file = open(path, Access::kOverwrite);
  if (!file) return file_error(path, "cannot be written: " + reason(errno));
  if (!write_all(file.get(), bytes) || std::fflush(file.get()) != 0) {
    return file_error(path, "writing failed: " + reason(errno));
  }
  return {};
}

/// A file beside `path` that did not exist before. Leftovers of killed runs are stepped over.
File create_beside(const fs::path& path, fs::path& temporary) {
  constexpr int kTries = 1000;
  for (int i = 0; i < kTries; ++i) {
    temporary = path;
    fs::path name = ".";
    name += path.filename();
    name += ".tmp" + std::to_string(i);
    temporary.replace_filename(name);
    if (File file = open(temporary, Access::kCreate)) return file;
    if (errno != EEXIST) break;
  }
  return nullptr;
}

constexpr const char* kInside = "put it into the folder of the document and name it from there, such as \"roof.obj\"";

Error refusal(std::string message, std::string hint = {}) {
  return {ErrorCode::kFile, {}, std::move(message), std::move(hint)};
}

/// A name below a folder that is one by its letters; links have not been followed yet.
struct Below {
  fs::path base;      ///< the folder, canonical
  fs::path relative;  ///< without ".."
  std::string quoted;
};

Result<Below> check_name(const fs::path& folder, const std::string& name) {
  std::string quoted = '"' + name + '"';
  bool odd = name.empty();
  for (const char c : name) odd = odd || c == '\\' || c == ':' || static_cast<unsigned char>(c) < ' ';
  if (odd) return refusal(quoted + " is not a portable path", "use letters, digits and forward slashes");
  fs::path relative(std::u8string(name.begin(), name.end()));
  bool outside = relative.has_root_path();
  for (const fs::path& step : relative) outside = outside || step == "..";
  if (outside) return refusal(quoted + " leads out of the folder of the document", kInside);
  std::error_code code;
  fs::path base = fs::canonical(folder.empty() ? fs::path(".") : folder, code);
  if (code) return refusal("the folder \"" + folder.string() + "\" cannot be entered: " + code.message());
  return Below{std::move(base), std::move(relative), std::move(quoted)};
}

bool is_below(const fs::path& base, const fs::path& path) {
  return std::mismatch(base.begin(), base.end(), path.begin(), path.end()).first == base.end();
}

}  // namespace

Result<std::string> read_file(const fs::path& path, std::uintmax_t limit) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (status.type() == fs::file_type::not_found) {
    return file_error(path, "there is no such file", "check the path; it is taken from the current folder");
  }
  if (fs::is_directory(status)) return file_error(path, "this is a folder, not a file", "name a file inside it");
  const File file = open(path, Access::kRead);
  if (!file) return file_error(path, "cannot be read: " + reason(errno));
  std::string bytes;
  std::vector<char> block(std::size_t{1} << 16);
  for (;;) {
    const std::size_t count = std::fread(block.data(), 1, block.size(), file.get());
    if (bytes.size() + count > limit) {
      return file_error(path, "the file is larger than " + std::to_string(limit) + " bytes", "is it the right file?");
    }
    bytes.append(block.data(), count);
    if (count < block.size()) break;
  }
  if (std::ferror(file.get())) return file_error(path, "reading failed: " + reason(errno));
  return bytes;
}

Result<std::string> read_file_below(const fs::path& folder, const std::string& name, std::uintmax_t limit) {
  const Result<Below> below = check_name(folder, name);
  if (!below) return below.error();
  const auto& [base, relative, quoted] = below.value();
  std::error_code code;
  const fs::path path = fs::canonical(base / relative, code);
  if (code == std::errc::no_such_file_or_directory || code == std::errc::not_a_directory) {
    return refusal("there is no file " + quoted,
                   "it was looked for in " + (folder.empty() ? std::string("the current folder") : folder.string()));
  }
  if (code) return refusal(quoted + " cannot be reached: " + code.message());
  if (!is_below(base, path))
    return refusal(quoted + " is a link that leads out of the folder of the document", kInside);
  if (fs::is_directory(path, code)) return refusal(quoted + " is a folder, not a file", "name a file inside it");
  if (!fs::is_regular_file(path, code)) return refusal(quoted + " is not an ordinary file", kInside);
  Result<std::string> bytes = read_file(path, limit);
  if (bytes) return bytes;
  return refusal(quoted + ": " + bytes.error().message, bytes.error().hint);
}

Result<fs::path> path_below(const fs::path& folder, const std::string& name) {
  const Result<Below> below = check_name(folder, name);
  if (!below) return below.error();
  const auto& [base, relative, quoted] = below.value();
  fs::path path = base;
  std::error_code code;
  for (const fs::path& step : relative) {
    if (step.empty() || step == ".") continue;
    if (path != base && fs::exists(path, code) && !fs::is_directory(path, code)) {
      return refusal(quoted + " goes on behind a file", kInside);
    }
    path /= step;
    if (!fs::is_symlink(fs::symlink_status(path, code))) continue;
    path = fs::canonical(path, code);
    if (code) return refusal(quoted + " is a link that leads nowhere: " + code.message(), kInside);
    if (!is_below(base, path))
      return refusal(quoted + " is a link that leads out of the folder of the document", kInside);
  }
  if (path == base || fs::is_directory(path, code)) {
    return refusal(quoted + " is a folder, not a file", "name a file inside it");
  }
  if (fs::exists(path, code) && !fs::is_regular_file(path, code)) {
    return refusal(quoted + " is not an ordinary file", kInside);
  }
  return path;
}

Status write_file_below(const fs::path& folder, const std::string& name, std::string_view bytes) {
  const Result<fs::path> path = path_below(folder, name);
  if (!path) return path.error();
  std::error_code code;
  fs::create_directories(path.value().parent_path(), code);
  if (code) return refusal("the folder of \"" + name + "\" cannot be made: " + code.message());
  Status status = write_file(path.value(), bytes);
  if (status) return status;
  return refusal('"' + name + "\": " + status.error().message, status.error().hint);
}

Status write_file(const fs::path& path, std::string_view bytes) {
  std::error_code code;
  const fs::file_status status = fs::status(path, code);
  if (fs::is_directory(status)) return file_error(path, "this is a folder, not a file", "name a file inside it");
  if (fs::exists(status) && !fs::is_regular_file(status)) return write_directly(path, bytes);
  fs::path target = path;
  if (fs::is_symlink(fs::symlink_status(path, code))) {
    target = fs::weakly_canonical(path, code);
    if (code) return file_error(path, "the symbolic link cannot be followed: " + code.message());
  }
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, code)) {
    return file_error(path, "the folder \"" + folder.string() + "\" does not exist", "create it first");
  }

  fs::path temporary;
  File file = create_beside(target, temporary);
  if (!file) return file_error(path, "cannot be written: " + reason(errno));
  const bool written = write_all(file.get(), bytes) && flush_to_disk(file.get());
  const int failure = errno;
  const bool closed = std::fclose(file.release()) == 0;
  if (!written || !closed) {
    fs::remove(temporary, code);
    return file_error(path, "writing failed: " + reason(failure), "is the disk full? The old file is untouched");
  }
  if (fs::exists(status)) fs::permissions(temporary, status.permissions(), code);
  fs::rename(temporary, target, code);
  if (code) {
    const std::string message = "cannot be replaced: " + code.message();
    fs::remove(temporary, code);
    return file_error(path, message, "the old file is untouched");
  }
  return {};
}

}  // namespace lissom
