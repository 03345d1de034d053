#pragma once
/// The folder that a studio works in: its documents with their histories, what a killed session left, what was open lately,
/// and the designs that come with lissom. Names are relative to the folder, with forward slashes, and never lead out of it,
/// also not through symbolic links. Every file is replaced as a whole or not at all.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/editing/history.h"
#include "lissom/model/design_text.h"

namespace lissom {

/// A document that is open.
struct OpenProject {
  std::string name;  ///< of the file without folder and ending, or of the template or design
  std::string file;  ///< below the folder; empty: not saved yet
  History history;
  std::vector<std::string> notes{};  ///< what was noticed when it was opened, for people

  /// What the file held when it was last read or written, 16 hexadecimal digits; empty: there is none.
  std::string disk_hash{};
  bool set_history_aside = false;  ///< the history file could not be read and is kept under another name by save()
};

/// A file of the folder.
struct ListedFile {
  std::string name;
  std::string kind;  ///< "plan", "structure", "project", "result" or "other"
  std::uintmax_t bytes = 0;
  double modified = 0;  ///< s since 1970
};

/// A design that comes with lissom.
struct ListedDesign {
  std::string name, title;
  int points = 0;  ///< of its plan
};

/// What a killed session left.
struct Recovery {
  std::string name;
  std::string file;   ///< of the project; empty: it had not been saved
  double when = 0;    ///< s since 1970
  int steps = 0;      ///< done and not saved
  std::string aside;  ///< the side file
};

struct Recovered {
  OpenProject project;
  std::string state;  ///< as autosave() was given it
};

struct ProjectStoreOptions {
  /// Where the list of recent files is kept; empty: nowhere. user_state_folder() is the usual place.
  std::filesystem::path state_folder;
  double autosave_every = 4;  ///< s, at least, between side files that are not asked for at once
  HistoryLimits history;
};

/// $XDG_STATE_HOME/lissom, else ~/.local/state/lissom; empty when there is no home.
std::filesystem::path user_state_folder();

/// s since 1970.
double seconds_now();

/// Of files that write() makes.
inline constexpr std::string_view kExportEndings[] = {".svg", ".dxf", ".stl",  ".3mf", ".obj", ".ply", ".png", ".webm",
                                                      ".glb", ".csv", ".html", ".vtp", ".vtu", ".pvd", ".pdf", ".txt"};

class ProjectStore {
 public:
  /// The folder has to exist. What `designs` point to has to outlive the store.
  static Result<ProjectStore> make(const std::filesystem::path& folder, std::span<const DesignText> designs,
                                   ProjectStoreOptions options = {});

  const std::filesystem::path& folder() const { return folder_; }

  /// A document of the folder, with the history beside it. A document without a plan is opened too: to look at.
  Result<OpenProject> open(const std::string& file);
  Result<OpenProject> open_design(const std::string& name) const;
  /// Of templates.h.
  Result<OpenProject> open_template(const std::string& name) const;

  enum class Replace {
    kOwn,  ///< only the file that the project came from, and only when no other program has changed it since
    kAny,
  };
  /// Writes the document to `file` (empty: where it came from) and its history beside it, and removes the side file.
  Status save(OpenProject& project, const std::string& file = {}, Replace replace = Replace::kOwn);

  enum class When {
    kDue,  ///< when the last side file is older than `autosave_every`
    kNow,
  };
  /// Writes the side file: document, history, and what else the caller needs to go on (`state`). Nothing when all is saved.
  Status autosave(const OpenProject& project, const std::string& state = {}, When when = When::kDue);
  /// Leaves the side file of a project that is not saved behind, to be found again, when the session turns to another one.
  Status leave(const OpenProject& project, const std::string& state = {});
  /// The newest side file that no living session writes.
  std::optional<Recovery> find_recovery() const;
  Result<Recovered> recover(const Recovery& found);
  /// Throws away what was found.
  Status dismiss(const Recovery& found);
  /// Removes the side file of this session: the user has let go of what is not saved.
  void forget_autosave();

  /// Sorted by name: at most 1000, three folders deep, without hidden files and histories.
  std::vector<ListedFile> files() const;
  std::vector<std::string> recent() const;  ///< newest first, those of this folder that are still there
  std::vector<ListedDesign> designs() const;

  /// Bytes of any file of the folder.
  Result<std::string> read(const std::string& file) const;
  /// Writes an export or a picture (kExportEndings) into the folder. Makes folders.
  Status write(const std::string& file, std::string_view bytes) const;

 private:
  ProjectStore(std::filesystem::path folder, std::span<const DesignText> designs, ProjectStoreOptions options)
      : folder_(std::move(folder)), designs_(designs), options_(std::move(options)) {}

  Result<Model> read_model(const std::string& file, const std::string& text) const;
  /// Moves what a file holds to a name that is free.
  Status keep_other(const std::string& file, const std::string& word) const;
  Status check_target(const OpenProject& project, const std::string& target, Replace replace) const;
  Status write_side_file(const OpenProject& project, const std::string& state, const std::string& owner);
  std::string free_side_name(const std::string& name) const;

  std::filesystem::path folder_;
  std::span<const DesignText> designs_;
  ProjectStoreOptions options_;
  std::string aside_;         ///< name of this session's side file; empty: none yet
  double autosaved_at_ = -1;  ///< s since 1970
};

}  // namespace lissom
