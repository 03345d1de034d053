#include "lissom/design/constrained_step.h"

#include <algorithm>
#include <utility>

namespace lissom {

namespace {

constexpr int kMostHalvings = 6, kMostCorrections = 6;

/// p / scale within the bounds.
VecX clipped(std::span<const Parameter> parameters, VecX x) {
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const Parameter& parameter = parameters[static_cast<std::size_t>(i)];
    x[i] = std::clamp(x[i], parameter.lower / parameter.scale, parameter.upper / parameter.scale);
  }
  return x;
}

}  // namespace

Result<ConstrainedStep> constrained_step(const ShapeResponse& response, const HardConstraints& constraints,
                                         const VecX& change, double tolerance, const Context& context) {
  const PlanDesignSpace& space = response.space();
  const Design& base = *space.base();
  SolveOptions solve;
  solve.modes = 0;
  Result<std::unique_ptr<PoseFollower>> made = PoseFollower::make(base, response.start().pose, solve, context);
  if (!made) return made.error();
  PoseFollower& follower = *made.value();
  if (const PoseEnd end = follower.restore(base, response.start().state); end.outcome != Outcome::kSettled) {
    return Error{ErrorCode::kConflict, {}, end.reason, "let the shape settle first"};
  }
  const VecX start = response.p().cwiseQuotient(response.scale());
  const MatX k = constraint_response(constraints, response.start().state.q, response.matrix());
  const ConstraintProjection projection(k);
  const int own = constraints.size();
  std::string reason;
  double share = 1;
  for (int halving = 0; halving <= kMostHalvings && !context.cancelled(); ++halving, share /= 2) {
    ConstrainedStep step;
    step.cut = halving > 0;
    VecX x = clipped(space.parameters(), start + share * change);
    step.cut = step.cut || (x - start - share * change).norm() > 1e-9 * change.norm();
    bool good = true;
    for (int correction = 0; correction <= kMostCorrections; ++correction) {
      step.p = x.cwiseProduct(response.scale());
      Result<Design> design = space.at(step.p);
      if (!design) {
        reason = design.error().text();
        good = false;
        break;
      }
      step.design = std::move(design).value();
      follower.stand_at_point(base);
      const PoseEnd end = follower.attempt(step.design);
      if (end.outcome != Outcome::kSettled) {
        reason = end.reason;
        good = false;
        break;
      }
      step.state = pinned_down(follower.problem(), follower.attempted().state, response.pins());
      VecX c(k.rows());
      c.head(own) = violations(constraints, response.start().state.q, step.state.q);
      if (constraints.ties.rows() > 0) c.tail(constraints.ties.rows()) = constraints.ties * (x - start);
      step.violation = own > 0 ? c.head(own).cwiseAbs().maxCoeff() : 0;
      if (k.rows() == 0 || step.violation <= tolerance || correction == kMostCorrections) break;
      x = clipped(space.parameters(), x - projection.least_change(c));
    }
    if (good) return step;
  }
  return Error{ErrorCode::kConflict,
               {},
               "no stable shape follows along this change: " + reason,
               "take a smaller amplitude, or another mode"};
}

}  // namespace lissom
