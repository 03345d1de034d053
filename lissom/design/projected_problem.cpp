#include "lissom/design/projected_problem.h"

#include <cmath>
#include <utility>

#include "lissom/core/assert.h"

namespace lissom {

namespace {

constexpr double kFarFromPrediction = 5;  // times the predicted step [mathematics 5.4]
constexpr double kNoticed = 0.1;          // scales per unknown, root mean square: smaller moves are none to speak of

}  // namespace

Result<std::unique_ptr<ProjectedProblem>> ProjectedProblem::make(StructureProblem& problem,
                                                                 const ProjectionOptions& options,
                                                                 const Context& context) {
  if (!(options.target_weight >= 0 && std::isfinite(options.target_weight)) || options.max_iterations < 1) {
    return Error{ErrorCode::kRange, "projection", "a weight is negative, or there are no iterations",
                 "give a weight of 0 or more and at least one iteration"};
  }
  Result<std::unique_ptr<TotalSpace>> space = TotalSpace::make(problem, context);
  if (!space) return space.error();
  return std::unique_ptr<ProjectedProblem>(new ProjectedProblem(problem, std::move(space).value(), options, context));
}

std::optional<std::string> ProjectedProblem::settle(const VecX& x) {
  TotalSpace& space = *space_;
  // After an attempt that was accepted it stands there, with its factors.
  if (space.x() != problem_->x() || space.residual() != problem_->residual()) {
    if (const Status s = space.stand_at(problem_->point()); !s) return s.error().text();
  }
  if (const Status s = space.linearize(); !s) return s.error().text();
  if (!space.is_regular()) return space.singular();
  const VecX moves = x - space.x();
  VecX prediction(space.size());
  prediction << -space.solve(space.mixed() * moves), moves;
  if (!space.attempt(prediction, 1)) return "the prediction makes no design or no shape";
  space.accept();
  const DesignPoint predicted = space.point();
  const ProjectionEnd end = project(space, options_, context_);
  counts_.iterations += end.iterations;
  if (space.negative() > 0 && space.imbalance() <= 1) ++counts_.unstable;
  if (!end.reached) return end.reason;
  // Far from where it was led, a state is on another branch.
  double moved = 0, unknowns = 0;
  const DesignPoint found = space.point();
  for (std::size_t k = 0; k < found.states.size(); ++k) {
    const PoseFollower& pose = *problem_->poses()[k];
    const Eigen::Index places = 3 * pose.system().layout.nodes();
    const double length = 0.01 * pose.problem().scales.length;
    moved += (found.states[k].q - predicted.states[k].q).head(places).squaredNorm() / (length * length);
    unknowns += static_cast<double>(places);
  }
  const double expected = prediction.head(space.states()).norm();
  if (std::sqrt(moved) > kFarFromPrediction * expected + kNoticed * std::sqrt(unknowns)) {
    return "a state went far from its prediction";
  }
  return std::nullopt;
}

Attempt ProjectedProblem::attempt(const VecX& x) {
  projected_.reset();
  const VecX inside = x.cwiseMax(lower()).cwiseMin(upper());
  const std::optional<std::string> failed = settle(inside);
  if (!failed) {
    projected_ = space_->point();
    attempted_x_ = space_->x();
    attempted_residual_ = space_->residual();
    ++counts_.projected;
    return {Outcome::kSettled, space_->value(), {}};
  }
  if (context_.cancelled()) return {Outcome::kCancelled, 0, *failed};
  ++counts_.fallbacks;
  counts_.last_reason = *failed;
  attempted_x_ = inside;
  return problem_->attempt(inside);
}

const VecX& ProjectedProblem::attempted_residual() const {
  return projected_ ? attempted_residual_ : problem_->attempted_residual();
}

void ProjectedProblem::accept() {
  if (!projected_) return problem_->accept();
  const Status taken = problem_->restore(*projected_);
  LISSOM_ASSERT(taken);  // the inertia of the same matrix was looked at
  projected_.reset();
}

DesignEffort ProjectedProblem::effort() const {
  DesignEffort effort = problem_->effort();
  effort.attempts += counts_.projected;
  effort.solves += counts_.projected * static_cast<int>(problem_->poses().size());
  effort.factorizations += space_->effort().factorizations;
  effort.back_solves += space_->effort().back_solves;
  return effort;
}

}  // namespace lissom
