#include "lissom/editing/project_store.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fmt/format.h>

#include "lissom/core/file_io.h"
#include "lissom/core/nearest_name.h"
#include "lissom/editing/listed_files.h"
#include "lissom/editing/recent_files.h"
#include "lissom/editing/templates.h"
#include "lissom/editing/text_lines.h"
#include "lissom/model/document.h"

namespace lissom {

namespace {

namespace fs = std::filesystem;

constexpr const char* kInside = "name a file of the folder that the studio was started in";

/// Files and folders that are hidden are nobody's business here.
Status check_visible(const std::string& file) {
  if (!is_hidden(file)) return {};
  return Error{ErrorCode::kFile, {}, fmt::format("\"{}\" is hidden, or leads out of the folder", file), kInside};
}

Status check_document_name(const std::string& file) {
  if (Status s = check_visible(file); !s) return s;
  if (is_document(file)) return {};
  return Error{ErrorCode::kFile, {}, fmt::format("\"{}\" is no document", file), "documents end in .lissom"};
}

std::string stem_of(const std::string& file) { return name_of(path_of(file).stem()); }

}  // namespace

fs::path user_state_folder() {
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return fs::path(value == nullptr ? "" : value);
  };
  const fs::path state = variable("XDG_STATE_HOME");
  if (state.is_absolute()) return state / "lissom";
  const fs::path home = variable("HOME");
  return home.is_absolute() ? home / ".local" / "state" / "lissom" : fs::path();
}

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

Result<ProjectStore> ProjectStore::make(const fs::path& folder, std::span<const DesignText> designs,
                                        ProjectStoreOptions options) {
  std::error_code code;
  fs::path whole = fs::canonical(folder.empty() ? fs::path(".") : folder, code);
  if (code || !fs::is_directory(whole, code)) {
    return Error{ErrorCode::kFile, folder.string(), "there is no such folder", "make it, or start in another one"};
  }
  return ProjectStore(std::move(whole), designs, std::move(options));
}

Result<Model> ProjectStore::read_model(const std::string& file, const std::string& text) const {
  Result<Model> model = read_document(text, (folder_ / path_of(file)).parent_path());
  if (model) return model;
  Error error = model.error();
  error.where = error.where.empty() ? file : file + ": " + error.where;
  return error;
}

Result<OpenProject> ProjectStore::open(const std::string& file) {
  if (Status s = check_document_name(file); !s) return s.error();
  const Result<std::string> text = read_file_below(folder_, file, kLargestDocument);
  if (!text) return text.error();
  Result<Model> model = read_model(file, text.value());
  if (!model) return model.error();
  OpenProject project{stem_of(file), file, History(model.value(), options_.history)};
  project.disk_hash = text_hash(text.value());
  const Result<std::string> saved = read_file_below(folder_, history_name(file));
  if (saved) {
    Result<History> history = History::read(saved.value(), (folder_ / path_of(file)).parent_path(), options_.history);
    if (history) {
      project.history = std::move(history).value();
      if (!project.history.meet(std::move(model).value(), seconds_now())) {
        project.notes.emplace_back("Another program has changed this document. Undo gives back what it was before.");
      }
    } else {
      project.set_history_aside = true;
      project.notes.push_back("What was done before is not known: " + history.error().text() + ".");
    }
  }
  project.history.mark_saved();
  remember_file(options_.state_folder, folder_, file, seconds_now());
  return project;
}

Result<OpenProject> ProjectStore::open_design(const std::string& name) const {
  std::vector<std::string> names;
  for (const DesignText& design : designs_) {
    names.emplace_back(design.name);
    if (design.name != name) continue;
    Result<Model> model = read_document(design.text);
    if (!model) return model.error();
    return OpenProject{name, {}, History(std::move(model).value(), options_.history)};
  }
  return Error{ErrorCode::kUnknown, {}, fmt::format("there is no design \"{}\"", name), suggestion(name, names)};
}

Result<OpenProject> ProjectStore::open_template(const std::string& name) const {
  std::vector<std::string> names;
  for (const Template& one : templates()) {
    names.emplace_back(one.name);
    if (one.name == name) return OpenProject{name, {}, History(one.make(), options_.history)};
  }
  return Error{ErrorCode::kUnknown, {}, fmt::format("there is no template \"{}\"", name), suggestion(name, names)};
}

Status ProjectStore::check_target(const OpenProject& project, const std::string& target, Replace replace) const {
  if (Status s = check_document_name(target); !s) return s;
  if (const Result<fs::path> path = path_below(folder_, target); !path) return path.error();
  if (replace == Replace::kAny) return {};
  const Result<std::string> there = read_file_below(folder_, target, kLargestDocument);
  if (!there) return {};
  if (target != project.file) {
    return Error{ErrorCode::kConflict,
                 {},
                 fmt::format("there is a file \"{}\" already", target),
                 "choose another name, or replace it"};
  }
  if (text_hash(there.value()) == project.disk_hash) return {};
  return Error{ErrorCode::kConflict,
               {},
               fmt::format("another program has changed \"{}\" since it was opened", target),
               "save under another name, or replace it: what it holds now is kept beside it"};
}

Status ProjectStore::keep_other(const std::string& file, const std::string& word) const {
  const Result<fs::path> from = path_below(folder_, file);
  if (!from) return from.error();
  fs::path to = from.value();
  std::error_code code;
  for (int number = 1;; ++number) {
    to.replace_filename(
        path_of(fmt::format("{}.{}{}{}", name_of(from.value().stem()), word, number > 1 ? std::to_string(number) : "",
                            name_of(from.value().extension()))));
    if (!fs::exists(fs::symlink_status(to, code))) break;
  }
  const Result<std::string> bytes = read_file(from.value());
  return bytes ? write_file(to, bytes.value()) : Status(bytes.error());
}

Status ProjectStore::save(OpenProject& project, const std::string& file, Replace replace) {
  std::string target = file.empty() ? project.file : file;
  if (target.empty()) return Error{ErrorCode::kFile, {}, "the project has no name yet", "give it one"};
  if (!path_of(target).has_extension()) target += kDocumentEnding;
  if (Status s = check_target(project, target, replace); !s) return s;
  const std::string& text = project.history.text();
  if (const Result<Model> again = read_model(target, text); !again) return again.error();
  const Result<std::string> there = read_file_below(folder_, target, kLargestDocument);
  if (there && text_hash(there.value()) != (target == project.file ? project.disk_hash : std::string())) {
    if (Status s = keep_other(target, "elsewhere"); !s) return s;
  }
  const std::string history = history_name(target);
  if ((project.set_history_aside || target != project.file) && read_file_below(folder_, history)) {
    if (Status s = keep_other(history, "before"); !s) return s;
  }
  // First the history, which knows the old document too: a session that is killed in between loses nothing.
  History saved = project.history;
  saved.mark_saved();
  if (Status s = write_file_below(folder_, history, saved.write()); !s) return s;
  if (Status s = write_file_below(folder_, target, text); !s) return s;
  project.history.mark_saved();
  project.disk_hash = text_hash(text);
  project.file = target;
  project.name = stem_of(target);
  project.set_history_aside = false;
  forget_autosave();
  remember_file(options_.state_folder, folder_, target, seconds_now());
  return {};
}

std::vector<ListedFile> ProjectStore::files() const { return listed_files(folder_); }

std::vector<std::string> ProjectStore::recent() const { return recent_files(options_.state_folder, folder_); }

std::vector<ListedDesign> ProjectStore::designs() const {
  std::vector<ListedDesign> list;
  for (const DesignText& design : designs_) {
    list.push_back({std::string(design.name), std::string(design.title), points_in(design.text)});
  }
  return list;
}

Result<std::string> ProjectStore::read(const std::string& file) const {
  if (Status s = check_visible(file); !s) return s.error();
  return read_file_below(folder_, file);
}

Status ProjectStore::write(const std::string& file, std::string_view bytes) const {
  if (Status s = check_visible(file); !s) return s;
  const std::string ending = name_of(path_of(file).extension());
  if (std::find(std::begin(kExportEndings), std::end(kExportEndings), ending) == std::end(kExportEndings)) {
    return Error{ErrorCode::kFile,
                 {},
                 fmt::format("\"{}\" is no file that can be written here", file),
                 fmt::format("let it end in {}", fmt::join(kExportEndings, ", "))};
  }
  return write_file_below(folder_, file, bytes);
}

}  // namespace lissom
