#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "lissom/core/file_io.h"
#include "lissom/editing/listed_files.h"
#include "lissom/editing/project_store.h"
#include "lissom/editing/side_file.h"
#include "lissom/editing/text_lines.h"
#include "lissom/model/document.h"
#include "lissom/session/document_file.h"

namespace lissom {

namespace {

namespace fs = std::filesystem;

Error no_side_file() {
  return {ErrorCode::kFile, {}, "this is no side file", "name a file of the folder that the studio was started in"};
}

/// Whether there is anything that could be lost.
bool safe(const OpenProject& project) {
  const bool untouched = project.file.empty() && project.history.size() == 0;
  return untouched || project.history.saved();
}

}  // namespace

std::string ProjectStore::free_side_name(const std::string& name) const {
  const std::string part = file_name_part(name);
  std::error_code code;
  for (int number = 1;; ++number) {
    std::string side = fmt::format(".{}{}{}", part, number > 1 ? fmt::format("-{}", number) : "", kSideEnding);
    if (!fs::exists(fs::symlink_status(folder_ / path_of(side), code))) return side;
  }
}

Status ProjectStore::write_side_file(const OpenProject& project, const std::string& state, const std::string& owner) {
  if (aside_.empty()) aside_ = free_side_name(project.name);
  const History& history = project.history;
  SideFile side{project.name,
                project.file,
                seconds_now(),
                std::abs(history.at() - std::max(history.saved_at(), 0)),
                owner,
                text_hash(history.text()),
                project.disk_hash,
                state,
                history.write()};
  Status status = write_file_below(folder_, aside_, lissom::write_side_file(side));
  if (status) autosaved_at_ = side.when;
  return status;
}

Status ProjectStore::autosave(const OpenProject& project, const std::string& state, When when) {
  if (safe(project)) {
    forget_autosave();
    return {};
  }
  const bool due = autosaved_at_ < 0 || std::abs(seconds_now() - autosaved_at_) >= options_.autosave_every;
  if (when == When::kDue && !due) return {};
  return write_side_file(project, state, this_session());
}

Status ProjectStore::leave(const OpenProject& project, const std::string& state) {
  if (safe(project)) {
    forget_autosave();
    return {};
  }
  Status status = write_side_file(project, state, {});
  if (status) {
    aside_.clear();
    autosaved_at_ = -1;
  }
  return status;
}

std::optional<Recovery> ProjectStore::find_recovery() const {
  std::optional<Recovery> newest;
  std::error_code code;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_, code)) {
    const std::string aside = name_of(entry.path().filename());
    if (!is_side_file(aside) || aside == aside_ || !entry.is_regular_file(code) || entry.is_symlink(code)) continue;
    const Result<std::string> text = read_file(entry.path());
    if (!text) continue;
    Result<SideFile> side = read_side_file(text.value());
    if (!side || session_lives(side.value().owner)) continue;
    const SideFile& found = side.value();
    const Result<std::string> saved = read_file_below(folder_, found.file, kLargestDocument);
    if (saved && text_hash(saved.value()) == found.document) continue;  // saved before it could be removed
    if (newest && (newest->when > found.when || (newest->when == found.when && newest->aside < aside))) continue;
    newest = Recovery{found.name, found.file, found.when, found.steps, aside};
  }
  return newest;
}

Result<Recovered> ProjectStore::recover(const Recovery& found) {
  if (!is_side_file(found.aside)) return no_side_file();
  const Result<std::string> text = read_file_below(folder_, found.aside);
  if (!text) return text.error();
  Result<SideFile> side = read_side_file(text.value());
  if (!side) return side.error();
  const SideFile& from = side.value();
  Result<History> history = History::read(from.history, (folder_ / path_of(from.file)).parent_path(), options_.history);
  if (!history) return history.error();
  Recovered recovered{{from.name, from.file, std::move(history).value()}, from.state};
  if (!from.file.empty() && !is_document(from.file)) recovered.project.file.clear();
  recovered.project.disk_hash = from.disk_hash;
  aside_ = found.aside;
  if (Status s = write_side_file(recovered.project, from.state, this_session()); !s) return s.error();
  return recovered;
}

Status ProjectStore::dismiss(const Recovery& found) {
  if (!is_side_file(found.aside)) return no_side_file();
  std::error_code code;
  fs::remove(folder_ / path_of(found.aside), code);
  if (code) return Error{ErrorCode::kFile, found.aside, "cannot be removed: " + code.message(), {}};
  return {};
}

void ProjectStore::forget_autosave() {
  if (aside_.empty()) return;
  std::error_code code;
  fs::remove(folder_ / path_of(aside_), code);
  aside_.clear();
  autosaved_at_ = -1;
}

}  // namespace lissom
