#include "lissom/design/structure_problem.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "lissom/core/assert.h"
#include "lissom/design/parameter_goals.h"

namespace lissom {

namespace {

/// Poses that have a goal, ascending.
std::vector<int> poses_of(const std::vector<Goal>& goals) {
  std::vector<int> poses;
  for (const Goal& goal : goals) poses.push_back(goal.pose);
  std::sort(poses.begin(), poses.end());
  poses.erase(std::unique(poses.begin(), poses.end()), poses.end());
  return poses;
}

}  // namespace

StructureProblem::StructureProblem(std::shared_ptr<const DesignSpace> space, std::vector<Goal> goals,
                                   std::vector<ParameterGoal> wishes, const StructureProblemOptions& options,
                                   const Context& context)
    : space_(std::move(space)),
      goals_(std::move(goals)),
      effective_(goals_),
      wishes_(std::move(wishes)),
      options_(options),
      context_(context) {
  options_.solve.modes = 0;  // inertia tells what is stable
  const std::span<const Parameter> parameters = space_->parameters();
  scale_.resize(space_->size());
  lower_.resize(space_->size());
  upper_.resize(space_->size());
  for (int i = 0; i < space_->size(); ++i) {
    scale_[i] = parameters[i].scale;
    lower_[i] = parameters[i].lower / scale_[i];
    upper_[i] = parameters[i].upper / scale_[i];
  }
}

Result<std::unique_ptr<StructureProblem>> StructureProblem::make(std::shared_ptr<const DesignSpace> space,
                                                                 std::vector<Goal> goals,
                                                                 std::vector<ParameterGoal> wishes,
                                                                 const StructureProblemOptions& options,
                                                                 const Context& context) {
  if (const Status s = options.solve.validate(); !s) return s.error();
  if (goals.empty()) {
    return Error{ErrorCode::kConflict, "/design/goals", "the design has no goal", "say what it should reach"};
  }
  if (space->size() == 0) {
    return Error{ErrorCode::kConflict, "/design/parameters", "the design has no parameters", "say what may change"};
  }
  for (std::size_t g = 0; g < goals.size(); ++g) {
    if (const Status s = check_goal(goals[g], "/design/goals/" + std::to_string(g)); !s) return s.error();
  }
  std::unique_ptr<StructureProblem> problem(
      new StructureProblem(std::move(space), std::move(goals), std::move(wishes), options, context));
  problem->p_ = problem->space_->start();
  problem->x_ = problem->p_.cwiseQuotient(problem->scale_);
  Result<Design> design = problem->space_->at(problem->p_);
  if (!design) return design.error();
  problem->design_ = std::move(design).value();
  const int all = static_cast<int>(problem->design_.model.poses.size());
  const std::vector<int> poses = poses_of(problem->goals_);
  if (poses.front() < 0 || poses.back() >= all) {
    return Error{
        ErrorCode::kUnknown, "/design/goals",
        fmt::format("a goal is of pose number {}, there are {}", poses.front() < 0 ? poses.front() : poses.back(), all),
        "name one of the poses"};
  }
  // One pose may use all threads, several share them out.
  problem->inner_.cancel = context.cancel;
  problem->inner_.threads = poses.size() == 1 ? context.threads : nullptr;
  for (const int pose : poses) {
    Result<std::unique_ptr<PoseFollower>> follower =
        PoseFollower::make(problem->design_, pose, problem->options_.solve, problem->inner_);
    if (!follower) return follower.error();
    problem->poses_.push_back(std::move(follower).value());
    problem->by_pose_.emplace_back();
    for (std::size_t g = 0; g < problem->goals_.size(); ++g) {
      if (problem->goals_[g].pose == pose) problem->by_pose_.back().push_back(static_cast<int>(g));
    }
  }
  problem->pin_factors_ = VecX::Ones(static_cast<Eigen::Index>(poses.size()));
  for (const Goal& goal : problem->goals_) {
    if (goal.force == GoalForce::kHard) problem->constraints_ += goal.objective->size();
  }
  return problem;
}

void StructureProblem::for_poses(const std::function<void(int)>& body) const {
  const int count = static_cast<int>(poses_.size());
  if (count > 1 && context_.threads != nullptr) {
    context_.threads->run(count, body);
  } else {
    for (int k = 0; k < count; ++k) body(k);
  }
}

Result<Design> StructureProblem::design_at(const VecX& p, const VecX& pin_factors) const {
  Result<Design> design = space_->at(p);
  if (!design) return design;
  for (std::size_t k = 0; k < poses_.size(); ++k) {
    Pose& pose = design.value().model.poses[static_cast<std::size_t>(poses_[k]->pose())];
    for (SoftPin& pin : pose.soft_pins) pin.stiffness *= pin_factors[static_cast<Eigen::Index>(k)];
  }
  return design;
}

PoseShape StructureProblem::shape_of(const Design& design, int k, const State& state) const {
  const PoseFollower& follower = *poses_[static_cast<std::size_t>(k)];
  return {design, design.model.poses[static_cast<std::size_t>(follower.pose())], follower.problem(), state};
}

VecX StructureProblem::residual_at(const Design& design, const VecX& p, const std::vector<const State*>& states) const {
  std::vector<VecX> parts(effective_.size() + wishes_.size());
  for_poses([&](int k) {
    for (const int g : by_pose_[static_cast<std::size_t>(k)]) {
      const PoseShape shape = shape_of(design, k, *states[static_cast<std::size_t>(k)]);
      parts[static_cast<std::size_t>(g)] = goal_residual(effective_[static_cast<std::size_t>(g)], shape);
    }
  });
  for (std::size_t w = 0; w < wishes_.size(); ++w) {
    parts[effective_.size() + w] = wish_residual(wishes_[w], p);
  }
  // In the order of the linearizations: pose by pose.
  VecX r(0);
  const auto append = [&](const VecX& part) {
    const Eigen::Index size = r.size();
    r.conservativeResize(size + part.size());
    r.tail(part.size()) = part;
  };
  for (const std::vector<int>& goals : by_pose_) {
    for (const int g : goals) append(parts[static_cast<std::size_t>(g)]);
  }
  for (std::size_t w = 0; w < wishes_.size(); ++w) append(parts[effective_.size() + w]);
  return r;
}

void StructureProblem::settle_point() {
  linear_.clear();
  dense_.clear();
  gradient_.reset();
  gram_.reset();
  std::vector<const State*> states;
  for (const auto& pose : poses_) states.push_back(&pose->state());
  for_poses([&](int k) { poses_[static_cast<std::size_t>(k)]->stand_at_point(design_); });
  wish_rows_.clear();
  for (const ParameterGoal& wish : wishes_) wish_rows_.push_back(wish_jacobian(wish, p_) * scale_.asDiagonal());
  one_sided_ = one_sided_wishes(wishes_, p_, scale_);
  residual_ = residual_at(design_, p_, states);
  value_ = 0.5 * residual_.squaredNorm();
}

Status StructureProblem::release(const VecX* p, const DesignPoint* near) {
  LISSOM_ASSERT(near == nullptr || near->states.size() == poses_.size());
  if (p != nullptr) p_ = *p;
  x_ = p_.cwiseQuotient(scale_);
  if (near != nullptr) pin_factors_ = near->pin_factors;
  Result<Design> design = design_at(p_, pin_factors_);
  if (!design) return design.error();
  design_ = std::move(design).value();
  std::vector<PoseEnd> ends(poses_.size());
  for_poses([&](int k) {
    const auto i = static_cast<std::size_t>(k);
    ends[i] = poses_[i]->release(design_, near != nullptr ? &near->states[i] : nullptr);
  });
  for (std::size_t k = 0; k < poses_.size(); ++k) {
    if (ends[k].outcome == Outcome::kSettled) continue;
    return Error{ErrorCode::kConflict, "/poses/" + std::to_string(poses_[k]->pose()),
                 "the design cannot start: " + ends[k].reason,
                 "look at the pose with `lissom solve`, and mend what it names, before parameters are sought"};
  }
  settle_point();
  if (!std::isfinite(value_)) {
    return Error{ErrorCode::kRange, "/design/goals", "the goals have no finite value at the start",
                 "check their targets"};
  }
  return ensure_linear();
}

Status StructureProblem::restore(const DesignPoint& point) {
  const std::size_t poses = poses_.size();
  if (point.states.size() != poses || point.p.size() != size() ||
      point.pin_factors.size() != static_cast<Eigen::Index>(poses)) {
    return Error{ErrorCode::kConflict, "", "the saved point is of another design",
                 "resume with the document it was made from"};
  }
  Result<Design> design = design_at(point.p, point.pin_factors);
  if (!design) return design.error();
  design_ = std::move(design).value();
  pin_factors_ = point.pin_factors;
  p_ = point.p;
  x_ = p_.cwiseQuotient(scale_);
  std::vector<PoseEnd> ends(poses_.size());
  for_poses([&](int k) {
    const auto i = static_cast<std::size_t>(k);
    ends[i] = poses_[i]->restore(design_, point.states[i]);
  });
  for (const PoseEnd& end : ends) {
    if (end.outcome != Outcome::kSettled) {
      return Error{ErrorCode::kConflict, "", "the saved point is not in equilibrium: " + end.reason,
                   "start the run anew"};
    }
  }
  settle_point();
  return ensure_linear();
}

DesignPoint StructureProblem::point() const {
  DesignPoint point{p_, {}, pin_factors_};
  for (const auto& pose : poses_) point.states.push_back(pose->state());
  return point;
}

std::vector<GoalMeasure> StructureProblem::measures() const {
  std::vector<GoalMeasure> measures;
  for (std::size_t k = 0; k < poses_.size(); ++k) {
    poses_[k]->stand_at_point(design_);  // an attempt may have left its numbers
    for (const int g : by_pose_[k]) {
      const Goal& goal = goals_[static_cast<std::size_t>(g)];
      const VecX r = goal_residual(goal, shape_of(design_, static_cast<int>(k), poses_[k]->state()));
      measures.push_back(
          {goal.name, goal.pose, goal.scale * r.norm() / std::sqrt(goal.weight), goal.objective->unit()});
    }
  }
  return measures;
}

std::vector<PoseEnd> StructureProblem::follow(const Design& changed) {
  std::vector<PoseEnd> ends(poses_.size());
  for_poses([&](int k) {
    PoseFollower& pose = *poses_[static_cast<std::size_t>(k)];
    pose.stand_at_point(design_);
    ends[static_cast<std::size_t>(k)] = pose.attempt(changed);
  });
  return ends;
}

Attempt StructureProblem::attempt(const VecX& x) {
  ++effort_.attempts;
  // What is at a bound is at it to the last bit.
  attempted_x_ = x.cwiseMax(lower_).cwiseMin(upper_);
  VecX p(size());
  for (int i = 0; i < size(); ++i) {
    const Parameter& parameter = space_->parameters()[static_cast<std::size_t>(i)];
    p[i] = std::clamp(attempted_x_[i] * scale_[i], parameter.lower, parameter.upper);
  }
  Result<Design> design = design_at(p, pin_factors_);
  if (!design) return {Outcome::kNoDesign, 0, design.error().text()};
  attempted_design_ = std::move(design).value();
  const std::vector<PoseEnd> ends = follow(attempted_design_);
  for (const PoseEnd& end : ends) {
    if (end.outcome == Outcome::kCancelled) return {end.outcome, 0, end.reason};
  }
  for (const PoseEnd& end : ends) {
    if (end.outcome != Outcome::kSettled) return {end.outcome, 0, end.reason};
  }
  std::vector<const State*> states;
  for (const auto& pose : poses_) states.push_back(&pose->attempted().state);
  attempted_residual_ = residual_at(attempted_design_, p, states);
  attempted_p_ = p;
  const double value = 0.5 * attempted_residual_.squaredNorm();
  if (!std::isfinite(value)) return {Outcome::kUnsettled, 0, "the goals have no finite value"};
  return {Outcome::kSettled, value, {}};
}

void StructureProblem::accept() {
  for_poses([&](int k) { poses_[static_cast<std::size_t>(k)]->accept(); });
  std::swap(design_, attempted_design_);
  p_ = attempted_p_;
  x_ = p_.cwiseQuotient(scale_);  // as `restore` has it
  settle_point();
}

}  // namespace lissom
