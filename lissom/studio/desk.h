#pragma once
/// The document under edit, its history and its shape: what requests work on. Used by the engine's thread alone.

#include <deque>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "lissom/editing/project_store.h"
#include "lissom/studio/branch_shapes.h"
#include "lissom/studio/inbox.h"
#include "lissom/studio/jobs.h"
#include "lissom/studio/live_shape.h"
#include "lissom/studio/pages.h"
#include "lissom/studio/shape_tools.h"

namespace lissom {

class Desk {
 public:
  Desk(ProjectStore store, const Pages& pages, Inbox& inbox, Jobs& jobs, ThreadPool* threads,
       std::chrono::milliseconds own_time);

  /// Puts a project on the desk and releases it, or stands at the shape that a killed session kept.
  void take_over(OpenProject project, const std::string& kept_state = {});
  /// Everything that there is to know, to one page.
  void greet(int page) const;

  bool has_document() const { return project_.has_value(); }
  const Model& model() const { return *model_; }
  bool has_plan() const { return model_ && model_->plan.has_value(); }
  const History& history() const { return project_->history; }
  OpenProject& project() { return *project_; }
  ProjectStore& store() { return store_; }
  LiveShape& shape() { return shape_; }
  ShapeTools& tools() { return tools_; }
  BranchShapes& branches() { return branches_; }
  Result<int> node_of_point(const std::string& name) const;
  Jobs& jobs() { return jobs_; }
  Inbox& inbox() { return inbox_; }
  const Pages& pages() const { return pages_; }
  int revision() const { return revision_; }

  /// One edit, one step: {title, notes}.
  Result<nlohmann::json> edit(const nlohmann::json& edit);
  /// A step whose model, and maybe shape, is known already.
  void commit(std::string title, const std::string& edit, Model model, const ShapeSnapshot* shape = nullptr);

  Result<nlohmann::json> drag(int page, int number, const nlohmann::json& edit);
  Result<nlohmann::json> end_drag(int number, const nlohmann::json& edit);
  void cancel_drag();
  /// A page has gone: what it was dragging is let go.
  void page_gone(int page);

  Result<nlohmann::json> go_to(int step);

  /// Whether the shape follows edits.
  enum class Following { kRunning, kHeld };
  void set_following(Following following);
  Result<nlohmann::json> settle(bool from_flat);
  /// Of a structure that is only looked at: as drawn (negative), or in a pose, by the job `settle`.
  Status look(int pose);
  /// The structure flips to another shape of the same design.
  Status flip(const State& state);

  Status save(const std::string& file, ProjectStore::Replace replace);
  /// To be called now and then when nothing else is to be done.
  void idle();
  /// Before the end: what is not saved is kept for the next session.
  void close();

  void tell_project() const;
  /// What a killed session has left, taken up or thrown away.
  Status recover(bool take);

 private:
  struct KeptShape {
    std::shared_ptr<const Model> model;
    ShapeSnapshot shape;
  };
  struct Drag {
    int page = 0, number = 0;
    nlohmann::json edit;  ///< the last one
    std::string title;
    std::shared_ptr<const Model> model;  ///< after it
    bool shown = false;                  ///< the shape is that of `model`
  };

  /// Shows a document, and lets the shape follow it.
  Status show(std::shared_ptr<const Model> model, int drag, const ShapeSnapshot* kept = nullptr);
  nlohmann::json add_step(std::string title, const std::string& edit, Model model);
  void keep_shape();
  const ShapeSnapshot* kept_shape() const;
  /// Ends what is about to become untrue.
  void interrupt();
  void tell_plan() const;
  void tell_history() const { pages_.tell_all(history_json()); }
  nlohmann::json project_json() const;
  nlohmann::json plan_json() const;
  nlohmann::json history_json() const;
  void autosave(const OpenProject& project);
  /// The project at hand is left: what of it is not saved can be found again.
  void leave();
  void fail(const Error& error) const;

  ProjectStore store_;
  const Pages& pages_;
  Inbox& inbox_;
  Jobs& jobs_;
  LiveShape shape_;
  ShapeTools tools_;
  BranchShapes branches_;
  std::optional<OpenProject> project_;
  std::shared_ptr<const Model> model_;  ///< as shown: that of the history, or of a drag
  int revision_ = 0;
  std::optional<Drag> drag_;
  std::deque<KeptShape> kept_;  ///< of steps of the history, the latest last
  Following following_ = Following::kRunning;
  std::optional<Recovery> recovery_;
  double autosaved_ = 0;  ///< s since 1970
};

}  // namespace lissom
