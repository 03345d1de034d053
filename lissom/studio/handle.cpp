#include "lissom/studio/handle.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "lissom/equilibrium/newton_workspace.h"
#include "lissom/equilibrium/rigid_drift.h"
#include "lissom/equilibrium/step_path.h"
#include "lissom/geometry/frame.h"

namespace lissom {

namespace {

constexpr double kLeastWeight = 0.01;  // below it a node is not pulled
constexpr double kStale = 0.35;        // rad: rods that turn further are not where a linear answer has them
constexpr double kFurthest = 0.5;      // rad: previews in which rods would turn further stay behind the pull
constexpr int kMostTargets = 700;      // nodes by which shapes are compared
constexpr double kPulledWeight = 4;    // of pulled nodes among them

constexpr int kMostHalvings = 4;  // of an answer that has no room however cautious it is

/// 1 at the centre, 0 and flat at the radius.
double falloff(double distance, double radius) {
  if (!(radius > 0)) return distance > 0 ? 0 : 1;
  const double share = std::min(distance / radius, 1.0);
  return (1 - share * share) * (1 - share * share);
}

}  // namespace

/// A problem of its own, whose numbers are those of the last answer, and the path that shapes follow there.
struct Handle::Probe {
  System system;
  std::optional<StaticProblem> problem;
  Context context;
  std::optional<NewtonWorkspace> workspace;
  std::optional<StepPathPolicy> path;
  std::vector<double> strains;  ///< axial, of the edges at the start
};

Result<Handle> Handle::make(std::shared_ptr<const ShapeResponse> response, HardConstraints constraints, HandleGrip grip,
                            const Context& context) {
  Handle handle;
  handle.response_ = std::move(response);
  handle.constraints_ = std::move(constraints);
  const ShapeResponse& s = *handle.response_;
  const int nodes = s.system().layout.nodes();
  for (const std::vector<int>* list : {&grip.nodes, &grip.held}) {
    for (const int node : *list) {
      if (node >= 0 && node < nodes) continue;
      return Error{ErrorCode::kUnknown, "/nodes", "there is no node " + std::to_string(node),
                   "select on the shape as it is now"};
    }
  }
  if (grip.nodes.empty()) {
    return Error{ErrorCode::kUnknown, "/nodes", "nothing is taken hold of",
                 "select points or a part of the shape first"};
  }
  for (const int node : grip.nodes) {
    handle.centre_ += s.start().state.position(node) / static_cast<double>(grip.nodes.size());
  }
  handle.grip_ = std::move(grip);
  const Design& base = *s.space().base();
  auto probe = std::make_shared<Probe>();
  probe->context = context;
  probe->system = base.system;
  const Pose& pose = base.model.poses[static_cast<std::size_t>(s.start().pose)];
  Result<StaticProblem> problem = make_static_problem(base.model, probe->system, pose, "/poses");
  if (!problem) return problem.error();
  probe->problem.emplace(std::move(problem).value());
  probe->workspace.emplace(*probe->problem, probe->context);
  probe->path.emplace(*probe->workspace, StepPath::kRotating);
  for (int e = 0; e < base.system.edge_count(); ++e) {
    const auto i = static_cast<std::size_t>(e);
    probe->strains.push_back(s.start().state.edges[i].length / base.system.rest.edges[i].length - 1);
  }
  handle.probe_ = std::move(probe);
  handle.weigh();
  return handle;
}

Status Handle::set_radius(double radius) {
  if (!(radius >= 0) || !std::isfinite(radius)) {
    return Error{ErrorCode::kRange, "/radius_mm", "the radius is negative", "give 0 or more"};
  }
  grip_.radius = radius;
  weigh();
  return {};
}

void Handle::weigh() {
  const State& state = response_->start().state;
  const int nodes = response_->system().layout.nodes();
  std::vector<double> weight(static_cast<std::size_t>(nodes), 0);
  for (int i = 0; i < nodes && grip_.radius > 0; ++i) {
    double nearest = INFINITY;
    for (const int node : grip_.nodes) nearest = std::min(nearest, (state.position(node) - state.position(i)).norm());
    weight[static_cast<std::size_t>(i)] = falloff(nearest, grip_.radius);
  }
  for (const int node : grip_.nodes) weight[static_cast<std::size_t>(node)] = 1;
  for (const int node : grip_.held) weight[static_cast<std::size_t>(node)] = 1;
  std::vector<PulledNode> pulled;
  for (int i = 0; i < nodes; ++i) {
    if (weight[static_cast<std::size_t>(i)] > kLeastWeight) pulled.push_back({i, weight[static_cast<std::size_t>(i)]});
  }
  edit_ = std::make_unique<TargetEdit>(response_, constraints_, std::move(pulled), grip_.stay);
}

Result<Handle::Preview> Handle::move(const HandleMove& move) {
  if (!(move.scale > 0))
    return Error{ErrorCode::kRange, "/scale", "the scale is not positive", "give a positive number"};
  const State& start = response_->start().state;
  const Mat3 turn = move.scale * rotation_from_vector(move.turn);
  const std::vector<PulledNode>& pulled = edit_->pulled();
  Preview preview;
  preview.wanted = VecX::Zero(3 * static_cast<Eigen::Index>(pulled.size()));
  for (std::size_t i = 0; i < pulled.size(); ++i) {
    if (std::find(grip_.held.begin(), grip_.held.end(), pulled[i].node) != grip_.held.end()) continue;
    const Vec3 arm = start.position(pulled[i].node) - centre_;
    preview.wanted.segment<3>(3 * static_cast<Eigen::Index>(i)) = turn * arm - arm + move.move;
  }
  std::string lags;
  bool followed = false;
  // Each of them goes less far than the one before.
  const int cautions = static_cast<int>(TargetEdit::kCautions.size());
  for (int i = 0; i < cautions + kMostHalvings; ++i) {
    preview.answer =
        i < cautions ? edit_->answer(preview.wanted, i) : edit_->shortened(preview.answer, preview.wanted, 0.5);
    followed = follow(preview);
    if (followed && preview.refused.empty() && preview.turn < kFurthest) break;
    if (lags.empty()) lags = preview.refused.empty() ? "rods would have to turn too far at once" : preview.refused;
  }
  if (!followed) {
    return Error{ErrorCode::kRange, "/move_mm", "the shape cannot be pulled that far at once",
                 "pull less, accept, and go on"};
  }
  preview.lags = std::move(lags);
  last_ = std::make_shared<const Preview>(preview);
  return preview;
}

bool Handle::follow(Preview& preview) const {
  const ShapeResponse& s = *response_;
  const auto pose = static_cast<std::size_t>(s.start().pose);
  preview.turn = largest_turn(s.system(), s.start().state, preview.answer.dq);
  preview.stale = preview.turn > kStale;
  preview.refused.clear();
  preview.residual = 0;
  Result<Design> design = s.space().at(preview.answer.p);
  Status renewed = design ? Status() : Status(design.error());
  if (renewed) {
    renewed = renew_numbers(design.value().model, design.value().model.poses[pose], "/poses",
                            std::move(design.value().system), probe_->system, *probe_->problem);
  }
  if (!renewed) {
    // What is shown is the straight line.
    preview.stale = true;
    preview.refused = renewed.error().message;
    return s.moved(preview.answer.dq, preview.state);
  }
  // A straight line stretches rods that turn; along this path they keep their strains, and bend as they are asked to.
  probe_->path->begin(s.start().state, preview.answer.dq, 1, false, probe_->strains);
  if (!probe_->path->at(1, preview.state)) return s.moved(preview.answer.dq, preview.state);
  lay_down(*probe_->problem, preview.state);
  preview.state = pinned_down(*probe_->problem, preview.state, s.pins());
  VecX gradient, free;
  probe_->workspace->gradient(preview.state, gradient);
  probe_->problem->supports.restrict(gradient, free);
  preview.residual = probe_->workspace->residual(free);
  return true;
}

ShapeTarget Handle::target() const {
  ShapeTarget target;
  const System& system = response_->system();
  target.places = last_->state.q.head(3 * system.layout.nodes());
  target.p = last_->answer.p;
  target.nodes = spread_nodes(system, kMostTargets);
  target.weights.assign(target.nodes.size(), 1);
  for (const PulledNode& pulled : edit_->pulled()) {
    target.nodes.push_back(pulled.node);
    target.weights.push_back(kPulledWeight * pulled.weight * pulled.weight);
  }
  return target;
}

}  // namespace lissom
