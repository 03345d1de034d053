#include "lissom/studio/desk.h"

#include <fmt/format.h>
#include <utility>

#include "lissom/core/nearest_name.h"
#include "lissom/core/spare_memory.h"
#include "lissom/editing/edits_json.h"
#include "lissom/editing/plan_json.h"
#include "lissom/equilibrium/solve.h"
#include "lissom/session/result_file.h"
#include "lissom/studio/event_json.h"
#include "lissom/studio/kept_state.h"
#include "lissom/studio/requests.h"

namespace lissom {

namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostKeptShapes = 50;  // of more steps the history has no models at hand
constexpr double kBetweenSaves = 4;          // s, of side files

}  // namespace

Desk::Desk(ProjectStore store, const Pages& pages, Inbox& inbox, Jobs& jobs, ThreadPool* threads,
           std::chrono::milliseconds own_time)
    : store_(std::move(store)),
      pages_(pages),
      inbox_(inbox),
      jobs_(jobs),
      shape_(pages, threads,
             {own_time, [&inbox] { return inbox.any([](const Asked& a) { return asks_for_another_shape(a.body); }); }}),
      tools_(*this),
      branches_(*this),
      recovery_(store_.find_recovery()) {}

void Desk::fail(const Error& error) const { pages_.tell_all({{"event", "failed"}, {"error", error_json(error)}}); }

void Desk::leave() {
  if (project_->history.saved() || project_->history.size() == 0) return store_.forget_autosave();
  const Status s = store_.leave(*project_, write_kept_state(shape_.snapshot()));
  if (!s) fail(s.error());
}

void Desk::take_over(OpenProject project, const std::string& kept_state) {
  interrupt();
  if (project_) {
    leave();
    recovery_ = store_.find_recovery();
  }
  drag_.reset();
  kept_.clear();
  shape_.forget();
  tools_.forget();
  project_.emplace(std::move(project));
  model_ = project_->history.model();
  following_ = Following::kRunning;
  tell_project();
  pages_.tell_all(history_json());
  for (const std::string& note : project_->notes) pages_.tell_all({{"event", "log"}, {"text", note}});
  if (!has_plan()) {
    ++revision_;
    Result<System> system = make_system(*model_);
    if (!system) return fail(system.error());
    shape_.look_at(*model_, std::move(system).value());
    return;
  }
  const std::optional<ShapeSnapshot> kept = read_kept_state(kept_state);
  if (const Status s = show(model_, 0, kept ? &*kept : nullptr); !s) return fail(s.error());
  keep_shape();
  give_back_spare_memory();
}

Json Desk::project_json() const {
  if (!project_) return {{"event", "project"}, {"kind", "none"}};
  Json event = {{"event", "project"},
                {"name", project_->name},
                {"file", project_->file},
                {"title", model_->title},
                {"saved", project_->history.saved()},
                {"kind", has_plan() ? "plan" : "structure"},
                {"poses", Json::array()}};
  for (const Pose& pose : model_->poses) event["poses"].push_back(pose.name);
  return event;
}

void Desk::tell_project() const {
  Json event = project_json();
  if (recovery_)
    event["recovery"] = {{"name", recovery_->name}, {"when", recovery_->when}, {"steps", recovery_->steps}};
  pages_.tell_all(event);
}

Json Desk::plan_json() const {
  Json event = plan_to_json(*model_);
  event["event"] = "plan";
  event["revision"] = revision_;
  return event;
}

Json Desk::history_json() const { return history_event(project_->history); }

void Desk::tell_plan() const {
  if (has_plan()) pages_.tell_all(plan_json());
}

void Desk::greet(int page) const {
  Json event = project_json();
  if (recovery_)
    event["recovery"] = {{"name", recovery_->name}, {"when", recovery_->when}, {"steps", recovery_->steps}};
  pages_.tell(page, event);
  if (!project_) return;
  if (has_plan()) pages_.tell(page, plan_json());
  pages_.tell(page, history_json());
  shape_.greet(page);
  tools_.greet(page);
  branches_.greet(page);
}

Result<int> Desk::node_of_point(const std::string& name) const {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < model_->plan->points.size(); ++i) {
    if (model_->plan->points[i].name == name && i < shape_.parts().point_nodes.size())
      return shape_.parts().point_nodes[i];
    names.push_back(model_->plan->points[i].name);
  }
  return Error{ErrorCode::kUnknown, "/points", "there is no point \"" + name + "\"", suggestion(name, names)};
}

void Desk::interrupt() {
  jobs_.cancel({});
  tools_.design_changed();
  branches_.forget();
}

Status Desk::show(std::shared_ptr<const Model> model, int drag, const ShapeSnapshot* kept) {
  const std::shared_ptr<const Model> before = std::exchange(model_, std::move(model));
  ++revision_;
  const LiveShape::Occasion occasion{drag, revision_};
  Status status;
  if (following_ == Following::kHeld) {
    tell_plan();
    return status;
  }
  // The plan goes first, so that pages know what the shape is of; one that is refused is taken back.
  if (kept != nullptr && kept->state) {
    tell_plan();
    status = shape_.stand(*model_, *kept, occasion);
    if (status) return status;
    status = shape_.follow(*model_, occasion);
  } else {
    tell_plan();
    status = shape_.follow(*model_, occasion);
  }
  if (status) return status;
  model_ = before;
  ++revision_;
  tell_plan();
  shape_.stand_still(revision_);
  return status;
}

void Desk::keep_shape() {
  ShapeSnapshot shape = shape_.snapshot();
  if (!shape.state) return;
  kept_.push_back({project_->history.model(), std::move(shape)});
  if (kept_.size() > kMostKeptShapes) kept_.pop_front();
}

const ShapeSnapshot* Desk::kept_shape() const {
  const std::shared_ptr<const Model> wanted = project_->history.model();
  for (auto kept = kept_.rbegin(); kept != kept_.rend(); ++kept) {
    if (kept->model == wanted) return &kept->shape;
  }
  return nullptr;
}

Json Desk::add_step(std::string title, const std::string& edit, Model model) {
  if (!project_->history.add({title, edit, seconds_now()}, std::move(model))) return {{"title", "Nothing changed"}};
  model_ = project_->history.model();
  keep_shape();
  pages_.tell_all(history_json());
  tell_project();
  autosave(*project_);
  return {{"title", std::move(title)}};
}

Result<Json> Desk::edit(const Json& edit) {
  Result<EditOutcome> outcome = apply_edit(*project_->history.model(), edit);
  if (!outcome) return outcome.error();
  interrupt();
  drag_.reset();
  EditOutcome& made = outcome.value();
  if (const Status s = show(std::make_shared<const Model>(made.model), 0); !s) return s.error();
  Json answer = add_step(made.title, edit.dump(), std::move(made.model));
  if (!made.notes.empty()) answer["notes"] = made.notes;
  return answer;
}

void Desk::commit(std::string title, const std::string& edit, Model model, const ShapeSnapshot* shape) {
  tools_.design_changed();
  branches_.forget();
  if (const Status s = show(std::make_shared<const Model>(model), 0, shape); !s) return fail(s.error());
  add_step(std::move(title), edit, std::move(model));
}

Result<Json> Desk::drag(int page, int number, const Json& edit) {
  const std::shared_ptr<const Model> from = project_->history.model();
  Result<EditOutcome> outcome = apply_edit(*from, edit);
  if (!outcome) return outcome.error();
  interrupt();
  if (!drag_ || drag_->page != page || drag_->number != number) drag_ = Drag{page, number, {}, {}, nullptr, false};
  const auto model = std::make_shared<const Model>(std::move(outcome.value().model));
  if (const Status s = show(model, number); !s) return s.error();
  drag_->edit = edit;
  drag_->title = outcome.value().title;
  drag_->model = model;
  drag_->shown = following_ == Following::kRunning && !shape_.gave_way();
  return Json::object();
}

Result<Json> Desk::end_drag(int number, const Json& edit) {
  // Most drags end where the last move was: then the shape is there already, and often on a mesh that fits.
  if (!drag_ || drag_->number != number || drag_->edit != edit || !drag_->shown || !shape_.mesh_fits()) {
    Result<Json> answer = this->edit(edit);
    if (!answer) cancel_drag();
    return answer;
  }
  const Drag done = *std::exchange(drag_, std::nullopt);
  return add_step(done.title, edit.dump(), *done.model);
}

void Desk::cancel_drag() {
  const bool moved = drag_ && drag_->model;
  drag_.reset();
  if (!moved) return;
  if (const Status s = show(project_->history.model(), 0, kept_shape()); !s) fail(s.error());
}

void Desk::page_gone(int page) {
  if (drag_ && drag_->page == page) cancel_drag();
}

Result<Json> Desk::go_to(int step) {
  drag_.reset();
  const int before = project_->history.at();
  if (const Status s = project_->history.go_to(step); !s) return s.error();
  if (before == project_->history.at()) return Json{{"at", before}};
  interrupt();
  const std::shared_ptr<const Model> model = project_->history.model();
  if (const Status s = show(model, 0, kept_shape()); !s) {
    // A document of the history was shown before: what keeps it from being shown now is told, and the document stands.
    model_ = model;
    ++revision_;
    tell_plan();
    fail(s.error());
  }
  pages_.tell_all(history_json());
  tell_project();
  autosave(*project_);
  return Json{{"at", project_->history.at()}};
}

void Desk::set_following(Following following) {
  following_ = following;
  if (following == Following::kHeld || !has_plan()) return;
  if (const Status s = show(model_, 0); !s) return fail(s.error());
  keep_shape();
}

Result<Json> Desk::settle(bool from_flat) {
  if (!has_plan()) {
    return Error{ErrorCode::kUnsupported, {}, "this structure is here to be looked at", "solve it by `lissom solve`"};
  }
  interrupt();
  const Status s = from_flat ? shape_.release(*model_, {0, revision_}) : shape_.follow(*model_, {0, revision_});
  if (!s) return s.error();
  keep_shape();
  return Json::object();
}

Status Desk::look(int pose) {
  if (has_plan())
    return Error{ErrorCode::kUnsupported, {}, "a plan is shown as it settles", "edit it, or settle it anew"};
  if (pose >= static_cast<int>(model_->poses.size())) {
    return Error{ErrorCode::kUnknown, "/pose", fmt::format("there is no pose {}", pose), "choose one of the poses"};
  }
  jobs_.cancel({});
  Result<System> made = make_system(*model_);
  if (!made) return made.error();
  if (pose < 0) return shape_.look_at(*model_, std::move(made).value()), Status();
  const auto system = std::make_shared<System>(std::move(made).value());
  jobs_.start("settle", "N", [this, system, pose, model = model_, revision = revision_](const Context& context) {
    const Pose& own = model->poses[static_cast<std::size_t>(pose)];
    const Result<StaticProblem> problem = make_static_problem(*model, *system, own, fmt::format("/poses/{}", pose));
    if (!problem) return Jobs::End{Jobs::End::State::kFailed, problem.error().text(), {}};
    const auto found =
        std::make_shared<Equilibrium>(solve(problem.value(), start_state(problem.value(), own), 1, {}, context));
    const auto state = found->verdict == Verdict::kCancelled ? Jobs::End::State::kCancelled : Jobs::End::State::kDone;
    return Jobs::End{state, found->message, [this, system, found, pose, model, revision] {
                       if (revision == revision_) shape_.look_at(*model, std::move(*system), *found, pose);
                     }};
  });
  return {};
}

Status Desk::flip(const State& state) {
  const ShapeSnapshot present = shape_.snapshot();
  if (!present.mesh) return Error{ErrorCode::kConflict, {}, "there is no shape to flip", "let it settle first"};
  jobs_.cancel({});
  tools_.design_changed();
  const ShapeSnapshot other{present.mesh, present.mesh_of, std::make_shared<const State>(state)};
  if (Status s = shape_.stand(*model_, other, {0, revision_}); !s) return s;
  keep_shape();
  return {};
}

Status Desk::save(const std::string& file, ProjectStore::Replace replace) {
  if (Status s = store_.save(*project_, file, replace); !s) return s;
  pages_.tell_all(history_json());
  tell_project();
  return {};
}

void Desk::autosave(const OpenProject& project) {
  // The shape as text is worth making only when it is to be written.
  const double now = seconds_now();
  if (now - autosaved_ < kBetweenSaves) return;
  autosaved_ = now;
  const Status s = store_.autosave(project, write_kept_state(shape_.snapshot()), ProjectStore::When::kNow);
  if (!s) fail(s.error());
}

void Desk::idle() {
  if (!project_ || (project_->history.saved() && !drag_)) return;
  if (!drag_ || !drag_->model) return autosave(*project_);
  // Of a long drag what it has come to is kept, too.
  OpenProject dragged = *project_;
  dragged.history.add({drag_->title, drag_->edit.dump(), seconds_now()}, *drag_->model);
  autosave(dragged);
}

Status Desk::recover(bool take) {
  if (!recovery_) return Error{ErrorCode::kUnknown, {}, "there is nothing to recover", "go on as it is"};
  const Recovery found = *recovery_;
  if (!take) {
    recovery_.reset();
    Status s = store_.dismiss(found);
    tell_project();
    return s;
  }
  Result<Recovered> recovered = store_.recover(found);
  if (!recovered) return recovered.error();
  recovery_.reset();
  take_over(std::move(recovered.value().project), recovered.value().state);
  return {};
}

void Desk::close() {
  shape_.stop();
  if (!project_) return;
  leave();
}

}  // namespace lissom
