#pragma once
/// How JSON of this folder is laid out.

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace lissom {

/// On one line. Bytes that are no UTF-8 (in names of files) are replaced.
inline std::string json_line(const nlohmann::ordered_json& json) {
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

/// One line per entry of an object: readable at the top, compact where it is long.
inline std::string json_lines(const nlohmann::ordered_json& object) {
  std::string text = "{\n";
  for (auto entry = object.begin(); entry != object.end(); ++entry) {
    if (entry != object.begin()) text += ",\n";
    text += "  " + json_line(nlohmann::ordered_json(entry.key())) + ": " + json_line(entry.value());
  }
  return text + "\n}\n";
}

inline nlohmann::ordered_json file_list(const std::vector<std::filesystem::path>& files) {
  nlohmann::ordered_json names = nlohmann::ordered_json::array();
  for (const std::filesystem::path& file : files) names.push_back(file.string());
  return names;
}

}  // namespace lissom
