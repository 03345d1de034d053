#include "lissom/editing/side_file.h"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sstream>

#include "lissom/core/file_io.h"

namespace lissom {

namespace {

using Json = nlohmann::ordered_json;
constexpr int kSideVersion = 1;

Error unreadable(const std::string& why) {
  return {ErrorCode::kSyntax, {}, "the side file cannot be read: " + why, "the document itself is not touched by this"};
}

/// Number and starting time of a process, from its line under /proc [proc(5): fields 1 and 22; the name in field 2 may hold
/// anything, brackets too].
std::string session_of(const std::string& process) {
  const Result<std::string> line = read_file(std::filesystem::path("/proc") / process / "stat");
  if (!line) return {};
  const std::size_t name = line.value().rfind(')');
  if (name == std::string::npos) return {};
  std::istringstream fields(line.value().substr(name + 1));
  constexpr int kStartTime = 20;  // after the name
  std::string field;
  for (int i = 0; i < kStartTime; ++i) fields >> field;
  const std::string number = line.value().substr(0, line.value().find(' '));
  return fields ? number + "-" + field : std::string();
}

}  // namespace

std::string this_session() { return session_of("self"); }

bool session_lives(const std::string& session) {
  const std::string process = session.substr(0, session.find('-'));
  if (process.empty() || !std::all_of(process.begin(), process.end(), [](char c) { return c >= '0' && c <= '9'; })) {
    return false;
  }
  return session_of(process) == session;
}

std::string write_side_file(const SideFile& side) {
  Json head;
  head["lissom_autosave"] = kSideVersion;
  head["name"] = side.name;
  head["file"] = side.file;
  head["when"] = side.when;
  head["steps"] = side.steps;
  head["owner"] = side.owner;
  head["document"] = side.document;
  head["disk_hash"] = side.disk_hash;
  head["state"] = side.state;
  std::string text = head.dump(-1, ' ', false, Json::error_handler_t::replace);
  text.pop_back();
  return text + ",\n\"history\": " + side.history + "}\n";
}

Result<SideFile> read_side_file(std::string_view text) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded() || !json.is_object()) return unreadable("it is not JSON, or was cut off");
  const auto version = json.find("lissom_autosave");
  if (version == json.end() || *version != kSideVersion) return unreadable("it has another version");
  SideFile side;
  struct Text {
    const char* key;
    std::string* to;
  };
  const Text texts[] = {{"name", &side.name},         {"file", &side.file},           {"owner", &side.owner},
                        {"document", &side.document}, {"disk_hash", &side.disk_hash}, {"state", &side.state}};
  for (const auto& [key, to] : texts) {
    const auto found = json.find(key);
    if (found == json.end() || !found->is_string()) return unreadable(fmt::format("\"{}\" is missing", key));
    *to = found->get<std::string>();
  }
  const auto when = json.find("when"), steps = json.find("steps"), history = json.find("history");
  const bool whole = when != json.end() && when->is_number() && steps != json.end() && steps->is_number_integer() &&
                     history != json.end() && history->is_object();
  if (!whole) return unreadable("something is missing in it");
  side.when = when->get<double>();
  side.steps = steps->get<int>();
  side.history = history->dump();
  return side;
}

}  // namespace lissom
