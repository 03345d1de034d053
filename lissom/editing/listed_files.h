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

/// "wing.history.json" of "wing.lissom".
std::string history_name(const std::string& file);
bool is_history(const std::string& file);
/// ".wing.autosave", in no folder.
bool is_side_file(const std::string& file);

/// Points of the plan in the text of a document; 0 where there is none.
int points_in(std::string_view text);

std::vector<ListedFile> listed_files(const std::filesystem::path& folder);

}  // namespace lissom
