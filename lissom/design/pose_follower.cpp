#include "lissom/design/pose_follower.h"

#include <fmt/format.h>
#include <utility>

#include "lissom/core/assert.h"

namespace lissom {

namespace {

/// Of an attempt. What follows its prediction takes a handful; what takes more has lost its way, most often past a fold, and
/// a shorter step costs less than to find out.
constexpr int kMostIterations = 25;

}  // namespace

Result<std::unique_ptr<PoseFollower>> PoseFollower::make(const Design& design, int pose, const SolveOptions& options,
                                                         const Context& context) {
  std::unique_ptr<PoseFollower> follower(new PoseFollower(design, pose, options));
  Result<StaticProblem> problem =
      make_static_problem(design.model, follower->system_, follower->pose_of(design), "/poses/" + std::to_string(pose));
  if (!problem) return problem.error();
  follower->problem_ = std::make_unique<StaticProblem>(std::move(problem).value());
  follower->solver_ = std::make_unique<LiveSolver>(*follower->problem_, options, context);
  return follower;
}

Status PoseFollower::renew(const Design& design) {
  at_point_ = false;
  Status renewed = renew_numbers(design.model, pose_of(design), "/poses/" + std::to_string(pose_), design.system,
                                 system_, *problem_);
  if (renewed) solver_->renew_terms();
  return renewed;
}

PoseEnd PoseFollower::end_of(const Equilibrium& equilibrium, const std::string& pose) const {
  const auto ended = [&](Outcome outcome, const std::string& what) {
    return PoseEnd{outcome, fmt::format("pose \"{}\" {}", pose, what)};
  };
  switch (equilibrium.verdict) {
    case Verdict::kStable:
      // Derivatives are taken with a factor without a shift.
      if (solver_->stands()) return {Outcome::kSettled, {}};
      return ended(Outcome::kUnstable, "has a motion without stiffness: " + equilibrium.message);
    case Verdict::kCancelled:
      return ended(Outcome::kCancelled, "was stopped");
    case Verdict::kCritical:
    case Verdict::kUnstable:
      return ended(Outcome::kUnstable, "is not stable: " + equilibrium.message);
    case Verdict::kIterationLimit:
    case Verdict::kStalled:
    case Verdict::kRunaway:
    case Verdict::kBadStart:
      break;
  }
  return ended(Outcome::kUnsettled, "found no equilibrium: " + equilibrium.message);
}

PoseEnd PoseFollower::release(const Design& design, const State* start) {
  const Pose& pose = pose_of(design);
  if (const Status s = renew(design); !s) return {Outcome::kNoDesign, s.error().text()};
  ++solves_;
  attempted_ = solver_->settle(start != nullptr ? *start : start_state(*problem_, pose), 1);
  const PoseEnd end = end_of(attempted_, pose.name);
  return end.outcome == Outcome::kSettled ? restore(design, attempted_.state) : end;
}

PoseEnd PoseFollower::restore(const Design& design, const State& equilibrium) {
  if (const Status s = renew(design); !s) return {Outcome::kNoDesign, s.error().text()};
  point_ = equilibrium;
  at_point_ = true;
  if (solver_->take_up(point_)) return {Outcome::kSettled, {}};
  return {Outcome::kUnstable, fmt::format("pose \"{}\" is not stable", pose_of(design).name)};
}

PoseEnd PoseFollower::attempt(const Design& changed) {
  LISSOM_ASSERT(at_point_);
  if (const Status s = renew(changed); !s) return {Outcome::kNoDesign, s.error().text()};
  ++solves_;
  attempted_ = solver_->resettle(point_, kMostIterations);
  const std::string& name = pose_of(changed).name;
  PoseEnd end = end_of(attempted_, name);
  const Following& following = solver_->following();
  if (end.outcome != Outcome::kSettled || !following.jumped) return end;
  return {Outcome::kJumped, fmt::format("pose \"{}\" jumped: it moved by {:.3g} mm where {:.3g} mm were predicted",
                                        name, 1e3 * following.moved, 1e3 * following.predicted)};
}

void PoseFollower::accept() {
  // Numbers are those of the attempt.
  point_ = attempted_.state;
  at_point_ = solver_->take_up(point_);
  LISSOM_ASSERT(at_point_);
}

void PoseFollower::stand_at_point(const Design& design) {
  if (at_point_) return;
  const PoseEnd end = restore(design, State(point_));
  LISSOM_ASSERT(end.outcome == Outcome::kSettled);
}

}  // namespace lissom
