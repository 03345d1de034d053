#pragma once
/// Whole files in and out. Writing is atomic: a killed run leaves either the old file or the new one, never half of one.
/// The only file of the engine that talks to the file system beyond std::filesystem.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "lissom/core/result.h"

namespace lissom {

constexpr std::uintmax_t kLargestFile = std::uintmax_t{1} << 30;  ///< bytes that read_file takes unless told otherwise

/// The bytes of a file. Errors name the path and the reason: missing, a folder, no permission, larger than `limit` bytes.
Result<std::string> read_file(const std::filesystem::path& path, std::uintmax_t limit = kLargestFile);

/// The bytes of a file that a document names: a path relative to `folder` (empty: the current one) with forward slashes
/// that stays inside the folder, also when symbolic links are followed. Errors have no `where`; they name the file.
Result<std::string> read_file_below(const std::filesystem::path& folder, const std::string& name,
                                    std::uintmax_t limit = kLargestFile);

/// Where a file of that name below a folder is, or would be: the rules of read_file_below, for every link on the way, whether
/// or not it is there.
Result<std::filesystem::path> path_below(const std::filesystem::path& folder, const std::string& name);

/// Replaces a file below a folder, as write_file does. Makes the folders on the way.
Status write_file_below(const std::filesystem::path& folder, const std::string& name, std::string_view bytes);

/// Replaces `path` by `bytes`: a temporary file in the same folder, flushed to the disk, then renamed. Keeps the permissions
/// of a file that it replaces and follows symbolic links; devices and pipes are written directly.
Status write_file(const std::filesystem::path& path, std::string_view bytes);

}  // namespace lissom
