#pragma once
/// What lies in the folder of a studio, and what it is called.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "lissom/editing/project_store.h"

namespace lissom {

inline constexpr std::string_view kDocumentEnding = ".lissom", kHistoryEnding = ".history.json",
                                  kSideEnding = ".autosave";

/// Names are UTF-8 with forward slashes, whatever the system has.
std::filesystem::path path_of(const std::string& name);
std::string name_of(const std::filesystem::path& path);

/// Whether a name is that of a document, and neither hidden nor in a hidden folder, nor leads out of the folder.
bool is_document(const std::string& file);
bool is_hidden(const std::string& file);
/// "wing.history.json" of "wing.lissom".
std::string history_name(const std::string& file);
bool is_history(const std::string& file);
/// ".wing.autosave", in no folder.
bool is_side_file(const std::string& file);

/// Points of the plan in the text of a document; 0 where there is none.
int points_in(std::string_view text);

std::vector<ListedFile> listed_files(const std::filesystem::path& folder);

}  // namespace lissom
