#include "lissom/studio/live_shape.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "lissom/editing/tool_constraints.h"
#include "lissom/mechanics/membrane_strain.h"
#include "lissom/studio/event_json.h"
#include "lissom/studio/remedies.h"
#include "lissom/studio/shape_constraints.h"
#include "lissom/studio/shown_units.h"

namespace lissom {

namespace {

using Json = nlohmann::json;

constexpr std::chrono::milliseconds kBetweenShapes{30};  // of a solve under way
// While somebody drags, the shape comes first; a mesh that fits comes where the drag ends.
constexpr MeshLimits kWhileDragged{.angle_ratio = 0.35, .length_ratio = 1.8, .turn_ratio = 2.5};

const Pose& pose_of(const LiveDesign& design) { return design.model().poses[static_cast<std::size_t>(design.pose())]; }

double share_of(const LiveDesign& design, const State& state) {
  return stretch_share(pose_of(design), state.load_factor);
}

bool is_shape(Verdict verdict) { return verdict == Verdict::kStable || verdict == Verdict::kCritical; }

/// Poses are what plans are released in; one without any is released as it is.
Model with_a_pose(Model model) {
  if (model.poses.empty()) model.poses.emplace_back().name = "released";
  return model;
}

}  // namespace

LiveShape::LiveShape(const Pages& pages, ThreadPool* threads, GivingWay giving_way)
    : pages_(pages), threads_(threads), giving_way_(std::move(giving_way)) {}

Context LiveShape::context() {
  Context context;
  context.threads = threads_;
  context.cancel = &stopped_;
  return context;
}

LiveDesign::Options LiveShape::options() {
  LiveDesign::Options options;
  options.solve.modes = 1;
  options.watch = [this](const LiveDesign& design, const State& state, double residual) {
    watch(design, state, residual);
  };
  return options;
}

void LiveShape::begin(const Occasion& occasion) {
  stopped_ = gave_way_ = false;
  occasion_ = occasion;
  began_ = last_shown_ = Clock::now();
  looked_.reset();
}

Status LiveShape::release(const Model& model, const Occasion& occasion) {
  begin(occasion);
  const Model posed = with_a_pose(model);
  Result<std::unique_ptr<LiveDesign>> made = LiveDesign::make(posed, 0, options(), context());
  if (!made) return made.error();
  design_ = std::move(made).value();
  const bool new_mesh = announced_ != design_->mesh().get();
  judge(*design_, {}, new_mesh);
  return {};
}

Status LiveShape::follow(const Model& model, const Occasion& occasion) {
  if (!design_) return release(model, occasion);
  begin(occasion);
  const Model posed = with_a_pose(model);
  const Result<DesignChange> change =
      occasion.drag == 0 ? design_->change(posed) : design_->change(posed, kWhileDragged);
  if (!change) return change.error();
  std::string note;
  if (change.value().following.jumped) {
    note = fmt::format("it jumped to another shape: {:.1f} mm where {:.1f} mm were foretold",
                       1e3 * change.value().following.moved, 1e3 * change.value().following.predicted);
  } else if (change.value().remeshed) {
    note = "new mesh: " + change.value().reason;
  }
  judge(*design_, std::move(note), change.value().remeshed);
  return {};
}

Status LiveShape::stand(const Model& model, const ShapeSnapshot& kept, const Occasion& occasion) {
  begin(occasion);
  const Model posed = with_a_pose(model);
  if (design_) {
    if (Status s = design_->take(posed, kept.mesh, *kept.state); !s) return s;
  } else {
    Result<std::unique_ptr<LiveDesign>> made = LiveDesign::at(posed, 0, kept.mesh, *kept.state, options(), context());
    if (!made) return made.error();
    design_ = std::move(made).value();
  }
  if (announced_ != kept.mesh.get()) announce(*design_);
  mesh_of_ = kept.mesh_of;
  judge(*design_, {}, false);
  return {};
}

void LiveShape::look_at(const Model& model, System system) {
  State state = drawn_state(system);
  look({model, std::move(system), std::move(state), 0});
}

void LiveShape::look_at(const Model& model, System system, const Equilibrium& equilibrium, int pose) {
  const double share = stretch_share(model.poses[static_cast<std::size_t>(pose)], equilibrium.state.load_factor);
  look({model, std::move(system), equilibrium.state, share});
  verdict_ = verdict_event(equilibrium, {});
  measures_ = measures_event(looked_->system, looked_->state, equilibrium.energy, share);
  warnings_ = lissom::warnings(looked_->system, looked_->state, share);
  warnings_event_ = warnings_event(warnings_, std::vector<bool>(warnings_.size(), false));
  for (const Json* event : {&verdict_, &measures_, &warnings_event_}) pages_.tell_all(*event);
}

void LiveShape::look(Looked looked) {
  forget();
  looked_ = std::make_unique<Looked>(std::move(looked));
  parts_ = no_plan_parts(looked_->system);
  topology_pack_ = topology_pack({{"topology", ++topology_}, {"plan_revision", 0}}, looked_->system, parts_);
  show_settled();
  pages_.show_all(topology_pack_, StudioMessage::Lane::kOrdered);
  pages_.show_all(shape_pack_, StudioMessage::Lane::kShape);
}

void LiveShape::forget() {
  design_.reset();
  looked_.reset();
  announced_ = nullptr;
  mesh_of_.reset();
  topology_pack_.reset();
  shape_pack_.reset();
  flat_pack_.reset();
  verdict_ = measures_ = warnings_event_ = nullptr;
  warnings_.clear();
  pinned_places_.clear();
}

ShapeSnapshot LiveShape::snapshot() const {
  if (!design_ || !is_shape(design_->equilibrium().verdict)) return {};
  return {design_->mesh(), mesh_of_, std::make_shared<const State>(shown_)};
}

void LiveShape::announce(const LiveDesign& design) {
  announced_ = design.mesh().get();
  mesh_of_ = std::make_shared<const Model>(design.model());
  parts_ = plan_parts(*design.model().plan, design.expanded(), design.system());
  topology_pack_ =
      topology_pack({{"topology", ++topology_}, {"plan_revision", occasion_.revision}}, design.system(), parts_);
  pages_.show_all(topology_pack_, StudioMessage::Lane::kOrdered);
  show_flat(design);
}

void LiveShape::show_flat(const LiveDesign& design) {
  flat_pack_ =
      places_pack({{"pack", "flat"}, {"topology", topology_}}, design.system(), drawn_state(design.system()), {});
  pages_.show_all(flat_pack_, StudioMessage::Lane::kOrdered);
}

Pack LiveShape::shape_of(const LiveDesign& design, const State& state, double residual, bool settled) const {
  const Json header = {{"topology", topology_},
                       {"residual_n", residual},
                       {"settled", settled},
                       {"drag", occasion_.drag},
                       {"plan_revision", occasion_.revision}};
  return shape_pack(header, {design.model(), design.system(), state, nullptr, share_of(design, state)}, fields_);
}

void LiveShape::watch(const LiveDesign& design, const State& state, double residual) {
  const bool first = announced_ != design.mesh().get();
  if (first) announce(design);
  const Clock::time_point now = Clock::now();
  if (now - began_ > giving_way_.own_time && giving_way_.overtaken()) stopped_ = gave_way_ = true;
  if (!first && now - last_shown_ < kBetweenShapes) return;
  last_shown_ = now;
  pages_.show_all(shape_of(design, pinned(design, state), residual, false), StudioMessage::Lane::kShape);
}

State LiveShape::pinned(const LiveDesign& design, const State& state) const {
  return pinned_down(design.problem(), state, pinned_nodes(design.model(), parts_, pinned_places_));
}

std::vector<PinnedNode> LiveShape::pins() const {
  return design_ ? pinned_nodes(design_->model(), parts_, pinned_places_) : std::vector<PinnedNode>();
}

void LiveShape::renew_pins(const LiveDesign& design) {
  const std::vector<PlanPoint>& points = design.model().plan->points;
  std::map<std::string, Vec3> places;
  for (const std::string& name : constraints_of(design.model()).pinned) {
    const auto known = pinned_places_.find(name);
    const auto point = std::find_if(points.begin(), points.end(), [&](const PlanPoint& p) { return p.name == name; });
    if (known != pinned_places_.end()) {
      places.insert(*known);
    } else if (point != points.end()) {
      places[name] = shown_.position(parts_.point_nodes[static_cast<std::size_t>(point - points.begin())]);
    }
  }
  pinned_places_ = std::move(places);
}

void LiveShape::show_settled() {
  if (looked_) {
    shape_pack_ =
        shape_pack({{"topology", topology_}, {"residual_n", 0}, {"settled", true}, {"drag", 0}, {"plan_revision", 0}},
                   {looked_->model, looked_->system, looked_->state, nullptr, looked_->share}, fields_);
  } else if (design_) {
    const Equilibrium& equilibrium = design_->equilibrium();
    shape_pack_ = shape_of(*design_, shown_, equilibrium.residual, is_shape(equilibrium.verdict));
  }
}

void LiveShape::judge(const LiveDesign& design, std::string note, bool new_mesh) {
  const Equilibrium& equilibrium = design.equilibrium();
  const bool good = is_shape(equilibrium.verdict);
  if (announced_ != design.mesh().get()) announce(design);
  VerdictStory story{milliseconds_since(began_), good ? "settled" : "last good", std::move(note)};
  // What a newer request is about to replace stays on the screen as it came; while somebody drags, without a word.
  const bool passing = gave_way_ && equilibrium.verdict == Verdict::kCancelled;
  // On a new mesh there is no last good shape that could stay.
  if (good || new_mesh || !shape_pack_) {
    if (!good) story.shown = "unsettled";
    shown_ = pinned(design, equilibrium.state);
    renew_pins(design);
    show_settled();
  } else if (passing) {
    story.shown = "unsettled";
    story.note = "it gave way to what was asked next";
  } else {
    // Pages have seen states on the way, and are told that nothing more comes of this plan.
    shape_pack_ = shape_of(design, shown_, equilibrium.residual, false);
  }
  if (passing && occasion_.drag != 0) return;
  if (!passing) pages_.show_all(shape_pack_, StudioMessage::Lane::kShape);
  if (occasion_.drag == 0 && !new_mesh) show_flat(design);
  verdict_ = verdict_event(equilibrium, story);
  pages_.tell_all(verdict_);
  const double share = share_of(design, equilibrium.state);
  measures_ = measures_event(design.system(), shown_, equilibrium.energy, share);
  pages_.tell_all(measures_);
  warnings_ = lissom::warnings(design.system(), equilibrium.state, share);
  std::vector<bool> one_click;
  for (const Warning& warning : warnings_) one_click.push_back(has_remedy(warning, design.model()));
  Json event = warnings_event(warnings_, one_click);
  if (event == warnings_event_) return;
  warnings_event_ = std::move(event);
  pages_.tell_all(warnings_event_);
}

void LiveShape::stand_still(int revision) {
  if (!design_ || !shape_pack_) return;
  occasion_ = {0, revision};
  show_settled();
  pages_.show_all(shape_pack_, StudioMessage::Lane::kShape);
}

void LiveShape::show_fields(const ShownFields& fields) {
  fields_ = fields;
  if (!shape_pack_) return;
  occasion_.drag = 0;
  show_settled();
  pages_.show_all(shape_pack_, StudioMessage::Lane::kShape);
}

void LiveShape::greet(int page) const {
  if (topology_pack_) pages_.show(page, topology_pack_, StudioMessage::Lane::kOrdered);
  if (flat_pack_) pages_.show(page, flat_pack_, StudioMessage::Lane::kOrdered);
  if (shape_pack_) pages_.show(page, shape_pack_, StudioMessage::Lane::kShape);
  for (const Json* event : {&verdict_, &measures_, &warnings_event_}) {
    if (!event->is_null()) pages_.tell(page, *event);
  }
}

}  // namespace lissom
