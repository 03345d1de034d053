#include "lissom/editing/listed_files.h"

#include <algorithm>
#include <chrono>

#include "lissom/core/file_io.h"
#include "lissom/model/document.h"
#include "lissom/model/json_value.h"

namespace lissom {

namespace {

namespace fs = std::filesystem;

constexpr int kDeepestFolder = 3;
constexpr std::size_t kMostListed = 1000;
constexpr int kMostVisited = 20'000;  // a home folder must not hold up the page
constexpr std::uintmax_t kMostRead = std::uintmax_t{4} << 20;
constexpr std::size_t kHead = 200;  // bytes in which a result says that it is one

/// What a document or result is, by what it says.
std::string kind_in(const std::string& text) {
  if (std::string_view(text).substr(0, kHead).find("\"lissom_result\"") != std::string_view::npos) return "result";
  const Result<JsonValue> json = parse_json(text, kDeepestDocument);
  if (!json || !json.value().is(JsonValue::Kind::kObject)) return "other";
  if (json.value().find("lissom_project") != nullptr) return "project";
  if (json.value().find("lissom") == nullptr) return "other";
  return json.value().find("plan") != nullptr ? "plan" : "structure";
}

std::string kind_of(const fs::path& path, std::uintmax_t bytes) {
  const fs::path ending = path.extension();
  if (ending != fs::path(kDocumentEnding) && ending != ".json") return "other";
  if (bytes > kMostRead) return ending == ".json" ? "other" : "structure";
  const Result<std::string> text = read_file(path, kMostRead);
  return text ? kind_in(text.value()) : "other";
}

double seconds_of(const fs::file_time_type& time) {
  const auto age = std::chrono::duration<double>(fs::file_time_type::clock::now() - time);
  return seconds_now() - age.count();
}

}  // namespace

fs::path path_of(const std::string& name) { return {std::u8string(name.begin(), name.end())}; }

std::string name_of(const fs::path& path) {
  const std::u8string text = path.generic_u8string();
  return {text.begin(), text.end()};
}

bool is_hidden(const std::string& file) {
  const fs::path path = path_of(file);
  return std::any_of(path.begin(), path.end(), [](const fs::path& step) { return name_of(step).starts_with('.'); });
}

bool is_document(const std::string& file) {
  return !is_hidden(file) && path_of(file).extension() == kDocumentEnding && !is_history(file);
}

std::string history_name(const std::string& file) {
  std::string name = file;
  if (name.ends_with(kDocumentEnding)) name.resize(name.size() - kDocumentEnding.size());
  return name.append(kHistoryEnding);
}

bool is_history(const std::string& file) { return file.ends_with(kHistoryEnding); }

bool is_side_file(const std::string& file) {
  return file.starts_with('.') && file.ends_with(kSideEnding) && file.size() > kSideEnding.size() + 1 &&
         file.find('/') == std::string::npos && file.find('\\') == std::string::npos;
}

int points_in(std::string_view text) {
  const Result<JsonValue> json = parse_json(text, kDeepestDocument);
  if (!json || !json.value().is(JsonValue::Kind::kObject)) return 0;
  const JsonValue* plan = json.value().find("plan");
  const JsonValue* points = plan != nullptr && plan->is(JsonValue::Kind::kObject) ? plan->find("points") : nullptr;
  return points == nullptr ? 0 : static_cast<int>(points->items.size());
}

std::vector<ListedFile> listed_files(const fs::path& folder) {
  std::vector<ListedFile> list;
  std::error_code code;
  fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied, code), end;
  for (int visited = 0; !code && entry != end && visited < kMostVisited; entry.increment(code), ++visited) {
    const fs::path path = entry->path();
    std::error_code ignored;
    const bool hidden = name_of(path.filename()).starts_with('.');
    if (entry->is_directory(ignored) && (hidden || entry.depth() + 1 >= kDeepestFolder))
      entry.disable_recursion_pending();
    if (hidden || entry->is_symlink(ignored) || !entry->is_regular_file(ignored)) continue;
    const std::string name = name_of(path.lexically_relative(folder));
    if (is_history(name)) continue;
    list.push_back({name, {}, entry->file_size(ignored), seconds_of(entry->last_write_time(ignored))});
  }
  std::sort(list.begin(), list.end(), [](const ListedFile& a, const ListedFile& b) { return a.name < b.name; });
  if (list.size() > kMostListed) list.resize(kMostListed);
  for (ListedFile& file : list) {
    file.kind = kind_of(folder / path_of(file.name), file.bytes);
  }
  return list;
}

}  // namespace lissom
