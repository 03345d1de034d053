#include "lissom/studio/handle.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "lissom/geometry/frame.h"
#include "lissom/mechanics/potential.h"

namespace lissom {

namespace {

constexpr double kLeastWeight = 0.01;  // below it a node is not pulled
constexpr double kStale = 0.3;         // of the answer, what balancing would move the shape by
constexpr int kMostTargets = 700;      // nodes by which shapes are compared
constexpr double kPulledWeight = 4;    // of pulled nodes among them

/// 1 at the centre, 0 and flat at the radius.
double falloff(double distance, double radius) {
  if (!(radius > 0)) return distance > 0 ? 0 : 1;
  const double share = std::min(distance / radius, 1.0);
  return (1 - share * share) * (1 - share * share);
}

}  // namespace

/// A problem of its own, whose numbers are those of the last answer, and a factor of the start to see what they would do.
struct Handle::Probe {
  System system;
  std::optional<StaticProblem> problem;
  AssemblyBuffers buffers;
  Context context;
  std::unique_ptr<PoseFollower> start;
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
  SolveOptions solve;
  solve.modes = 0;
  Result<std::unique_ptr<PoseFollower>> start = PoseFollower::make(base, s.start().pose, solve, probe->context);
  if (!start) return start.error();
  probe->start = std::move(start).value();
  if (const PoseEnd end = probe->start->restore(base, s.start().state); end.outcome != Outcome::kSettled) {
    return Error{ErrorCode::kConflict, {}, end.reason, "let the shape settle first"};
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
  edit_ = std::make_unique<TargetEdit>(response_, constraints_, std::move(pulled));
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
  preview.answer = edit_->answer(preview.wanted);
  if (!response_->moved(preview.answer.dq, preview.state)) {
    return Error{ErrorCode::kRange, "/move_mm", "the shape cannot be pulled that far at once",
                 "pull less, accept, and go on"};
  }
  judge(preview);
  last_ = std::make_shared<const Preview>(preview);
  return preview;
}

void Handle::judge(Preview& preview) {
  Result<Design> design = response_->space().at(preview.answer.p);
  const auto pose = static_cast<std::size_t>(response_->start().pose);
  if (!design || !renew_numbers(design.value().model, design.value().model.poses[pose], "/poses",
                                std::move(design.value().system), probe_->system, *probe_->problem)) {
    preview.stale = true;
    return;
  }
  const Supports& supports = probe_->problem->supports;
  VecX gradient, free, step;
  probe_->problem->potential.gradient(preview.state, gradient, probe_->buffers);
  supports.restrict(gradient, free);
  preview.residual = free.cwiseAbs().maxCoeff();
  probe_->start->factor().solve(free, free);
  supports.expand(free, step);
  const int nodes = response_->system().layout.nodes();
  preview.correction = step.head(3 * nodes).norm() / std::sqrt(nodes);
  const double answer = preview.answer.dq.head(3 * nodes).norm() / std::sqrt(nodes);
  preview.stale = preview.correction > kStale * answer && answer > 1e-4 * response_->system().structure.size;
}

ShapeTarget Handle::target() const {
  ShapeTarget target;
  const System& system = response_->system();
  target.places = last_->state.q.head(3 * system.layout.nodes());
  target.nodes = spread_nodes(system, kMostTargets);
  target.weights.assign(target.nodes.size(), 1);
  for (const PulledNode& pulled : edit_->pulled()) {
    target.nodes.push_back(pulled.node);
    target.weights.push_back(kPulledWeight * pulled.weight * pulled.weight);
  }
  return target;
}

}  // namespace lissom
