#pragma once
/// The documents that were open lately, over all folders: a file in the user's state folder.

#include <filesystem>
#include <string>
#include <vector>

namespace lissom {

/// Names of files of a folder, newest first, those that are still there. Nothing is an error: who has no list has none.
std::vector<std::string> recent_files(const std::filesystem::path& state_folder, const std::filesystem::path& folder);

/// Puts a file first. What cannot be written is not remembered.
void remember_file(const std::filesystem::path& state_folder, const std::filesystem::path& folder,
                   const std::string& name, double seconds);

}  // namespace lissom
