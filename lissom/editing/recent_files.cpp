#include "lissom/editing/recent_files.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "lissom/core/file_io.h"

namespace lissom {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kName = "recent.json";
constexpr int kRecentVersion = 1;
constexpr std::size_t kMostFiles = 200;
constexpr std::uintmax_t kLargestList = std::uintmax_t{1} << 20;

struct RecentFile {
  std::string folder, name;
  double seconds = 0;
};

std::vector<RecentFile> read_list(const fs::path& state_folder) {
  std::vector<RecentFile> list;
  const Result<std::string> text = read_file(state_folder / kName, kLargestList);
  if (!text) return list;
  const Json json = Json::parse(text.value(), nullptr, false);
  if (!json.is_object() || !json.contains("files") || !json["files"].is_array()) return list;
  for (const Json& one : json["files"]) {
    const bool whole = one.is_object() && one.contains("folder") && one["folder"].is_string() && one.contains("name") &&
                       one["name"].is_string() && one.contains("seconds") && one["seconds"].is_number();
    if (whole) list.push_back({one["folder"], one["name"], one["seconds"]});
  }
  return list;
}

}  // namespace

std::vector<std::string> recent_files(const fs::path& state_folder, const fs::path& folder) {
  std::vector<std::string> names;
  if (state_folder.empty()) return names;
  for (const RecentFile& file : read_list(state_folder)) {
    if (file.folder != folder.string()) continue;
    const Result<fs::path> path = path_below(folder, file.name);
    std::error_code code;
    if (path && fs::is_regular_file(path.value(), code)) names.push_back(file.name);
  }
  return names;
}

void remember_file(const fs::path& state_folder, const fs::path& folder, const std::string& name, double seconds) {
  if (state_folder.empty()) return;
  std::vector<RecentFile> list = read_list(state_folder);
  std::erase_if(list, [&](const RecentFile& one) { return one.folder == folder.string() && one.name == name; });
  list.insert(list.begin(), {folder.string(), name, seconds});
  if (list.size() > kMostFiles) list.resize(kMostFiles);
  Json json;
  json["lissom_recent"] = kRecentVersion;
  json["files"] = Json::array();
  for (const RecentFile& one : list) {
    json["files"].push_back({{"folder", one.folder}, {"name", one.name}, {"seconds", one.seconds}});
  }
  std::error_code code;
  fs::create_directories(state_folder, code);
  if (code) return;
  // A list of recent files is not worth a message.
  static_cast<void>(write_file(state_folder / kName, json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n"));
}

}  // namespace lissom
