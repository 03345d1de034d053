#include "lissom/editing/history.h"

#include <cstdlib>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "lissom/editing/text_lines.h"
#include "lissom/model/document.h"

namespace lissom {

namespace {

using Json = nlohmann::ordered_json;
constexpr int kHistoryVersion = 1;

Error unreadable(const std::string& why) {
  return {ErrorCode::kSyntax, {}, "the history cannot be read: " + why, "the document itself is not touched by this"};
}

bool is_text(const Json& json, const char* key) { return json.contains(key) && json[key].is_string(); }

/// The lines after a patch; nothing where it does not fit.
std::optional<Json> patched(const Json& lines, const Json& patch) {
  try {
    Json result = lines.patch(patch);
    if (!result.is_array()) return std::nullopt;
    for (const Json& line : result) {
      if (!line.is_string()) return std::nullopt;
    }
    return result;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

std::shared_ptr<const std::string> joined(const Json& lines) {
  return std::make_shared<const std::string>(text_of(lines.get<std::vector<std::string>>()));
}

std::optional<Json> first_lines(const Json& json) {
  if (!json.contains("first")) return std::nullopt;
  return patched(json["first"], Json::array());
}

/// A step as it stands in the file.
std::optional<History::Step> step_of(const Json& json) {
  if (!json.is_object() || !is_text(json, "title") || !json.contains("edit") || !json.contains("patch")) {
    return std::nullopt;
  }
  if (!json.contains("seconds") || !json["seconds"].is_number()) return std::nullopt;
  const Json& edit = json["edit"];
  return History::Step{json["title"], edit.is_null() ? std::string() : edit.dump(), json["seconds"]};
}

}  // namespace

History::History(Model first, HistoryLimits limits) : limits_(limits) {
  auto text = std::make_shared<const std::string>(write_document(first));
  append({{}, std::move(text), std::make_shared<const Model>(std::move(first)), {}});
}

const History::Step& History::step(int number) const {
  LISSOM_ASSERT(number >= 1 && number <= size());
  return steps_[static_cast<std::size_t>(number)].step;
}

const std::shared_ptr<const Model>& History::model() const { return steps_[static_cast<std::size_t>(at_)].model; }
const std::string& History::text() const { return *steps_[static_cast<std::size_t>(at_)].text; }

void History::append(Entry entry) {
  bytes_ += entry.text->size() + entry.patch.size();
  steps_.push_back(std::move(entry));
}

void History::forget_oldest() {
  while (size() > 1 && at_ > 0 && (size() > limits_.steps || bytes_ > limits_.bytes)) {
    bytes_ -= steps_[0].text->size() + steps_[0].patch.size();
    steps_.erase(steps_.begin());
    bytes_ -= steps_[0].patch.size();
    steps_[0].patch.clear();
    --at_;
    saved_at_ = std::max(saved_at_ - 1, -1);
  }
}

void History::forget_far_models() {
  for (int step = 0; step <= size(); ++step) {
    std::shared_ptr<const Model>& model = steps_[static_cast<std::size_t>(step)].model;
    // Files that a document names may have changed since.
    if (model && std::abs(step - at_) > limits_.models && model->network_files.empty()) model.reset();
  }
}

bool History::add(Step step, Model after) {
  auto text = std::make_shared<const std::string>(write_document(after));
  if (*text == this->text()) return false;
  while (size() > at_) {
    bytes_ -= steps_.back().text->size() + steps_.back().patch.size();
    steps_.pop_back();
  }
  if (saved_at_ > at_) saved_at_ = -1;
  std::string patch = line_patch(lines_of(this->text()), lines_of(*text));
  append({std::move(step), std::move(text), std::make_shared<const Model>(std::move(after)), std::move(patch)});
  at_ = size();
  forget_oldest();
  forget_far_models();
  return true;
}

Status History::load(int step) {
  Entry& entry = steps_[static_cast<std::size_t>(step)];
  if (entry.model) return {};
  Result<Model> model = read_document(*entry.text, folder_);
  if (!model) return model.error();
  entry.model = std::make_shared<const Model>(std::move(model).value());
  return {};
}

Status History::go_to(int step) {
  if (step < 0 || step > size()) {
    return Error{ErrorCode::kRange,
                 {},
                 fmt::format("there is no step {}", step),
                 fmt::format("the last one is number {}", size())};
  }
  if (Status s = load(step); !s) return s;
  at_ = step;
  forget_far_models();
  return {};
}

Status History::undo() {
  if (!can_undo()) return Error{ErrorCode::kRange, {}, "there is nothing to undo", "this is the document as opened"};
  return go_to(at_ - 1);
}

Status History::redo() {
  if (!can_redo()) return Error{ErrorCode::kRange, {}, "there is nothing to redo", "this is the newest step"};
  return go_to(at_ + 1);
}

std::string History::write() const {
  constexpr auto kReplace = Json::error_handler_t::replace;
  Json head;
  head["lissom_history"] = kHistoryVersion;
  head["at"] = at_;
  head["saved_at"] = saved_at_;
  head["document"] = text_hash(text());
  std::string out = head.dump(-1, ' ', false, kReplace);
  out.pop_back();
  out += ",\n\"first\": " + Json(lines_of(*steps_[0].text)).dump(1, ' ', false, kReplace) + ",\n\"steps\": [";
  for (std::size_t i = 1; i < steps_.size(); ++i) {
    const Entry& entry = steps_[i];
    Json step;
    step["title"] = entry.step.title;
    step["seconds"] = entry.step.seconds;
    std::string line = step.dump(-1, ' ', false, kReplace);
    line.pop_back();
    const std::string edit = entry.step.edit.empty() ? "null" : entry.step.edit;
    out += fmt::format("{}\n{},\"edit\":{},\"patch\":{}}}", i > 1 ? "," : "", line, edit, entry.patch);
  }
  return out + "\n]}\n";
}

Result<History> History::read(std::string_view text, const std::filesystem::path& folder, HistoryLimits limits) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded() || !json.is_object()) return unreadable("it is not JSON, or was cut off");
  if (!json.contains("lissom_history") || json["lissom_history"] != kHistoryVersion) {
    return unreadable("it has another version");
  }
  const std::optional<Json> first = first_lines(json);
  const bool whole = first && json.contains("steps") && json["steps"].is_array() && is_text(json, "document") &&
                     json.contains("at") && json["at"].is_number_integer() && json.contains("saved_at") &&
                     json["saved_at"].is_number_integer();
  if (!whole) return unreadable("something is missing in it");
  History history;
  history.limits_ = limits;
  history.folder_ = folder;
  Json lines = *first;
  history.append({{}, joined(lines), nullptr, {}});
  for (const Json& step : json["steps"]) {
    std::optional<Step> read = step_of(step);
    std::optional<Json> after = read ? patched(lines, step["patch"]) : std::nullopt;
    if (!after) return unreadable(fmt::format("step {} does not fit", history.size() + 1));
    lines = std::move(*after);
    history.append({std::move(*read), joined(lines), nullptr, step["patch"].dump()});
  }
  const long long at = json["at"], saved_at = json["saved_at"];
  if (at < 0 || at > history.size() || saved_at < -1 || saved_at > history.size()) return unreadable("its steps miss");
  if (Status s = history.go_to(static_cast<int>(at)); !s) return unreadable(s.error().text());
  history.saved_at_ = static_cast<int>(saved_at);
  if (text_hash(history.text()) != json["document"]) return unreadable("it was changed by hand");
  history.forget_oldest();
  return history;
}

bool History::meet(Model document, double seconds) {
  const std::string text = write_document(document);
  const auto same = [&](int step) { return *steps_[static_cast<std::size_t>(step)].text == text; };
  int found = at_;
  if (!same(found)) found = size();
  while (found >= 0 && !same(found)) --found;
  if (found >= 0) {
    steps_[static_cast<std::size_t>(found)].model = std::make_shared<const Model>(std::move(document));
    at_ = found;
    return true;
  }
  at_ = size();
  saved_at_ = -1;
  add({"Changed elsewhere", {}, seconds}, std::move(document));
  return false;
}

}  // namespace lissom
