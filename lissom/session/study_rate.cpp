// The linearised problem of a pose: how everything begins to change with the load factor.

#include "lissom/equilibrium/newton_workspace.h"
#include "lissom/equilibrium/report.h"
#include "lissom/equilibrium/solve.h"
#include "lissom/session/study.h"

namespace lissom {

namespace {

/// Derivative of the gradient by the load factor, unknowns held: loads are linear in the factor, so one difference over
/// a factor of 1 is exact.
VecX load_rate(const StaticProblem& problem, const State& state) {
  AssemblyBuffers buffers;
  VecX here, there;
  State loaded = state;
  loaded.load_factor += 1;
  problem.potential.gradient(state, here, buffers);
  problem.potential.gradient(loaded, there, buffers);
  return there - here;
}

/// Derivative of the prescribed unknowns, global axes. Moves are linear in the factor; turns of clamps are not, and the
/// central difference is wrong by (turn * h)^2 / 6.
VecX prescribed_rate(const StaticProblem& problem, const State& state) {
  constexpr double kStep = 1e-4;
  const VecX ahead = problem.supports.prescribed_increment(*problem.system, state, state.load_factor + kStep);
  const VecX back = problem.supports.prescribed_increment(*problem.system, state, state.load_factor - kStep);
  return (ahead - back) / (2 * kStep);
}

}  // namespace

Result<Rate> Study::make_rate(Key key) {
  const Pose& pose = model_.poses[key.first];
  const Result<const StaticProblem*> found = problem(key.first, key.second);
  if (!found) return found.error();
  const StaticProblem& problem = *found.value();
  Rate rate;
  rate.system = problem.system;
  rate.problem = &problem;
  if (pose.frozen) {
    rate.state = drawn_state(*problem.system);
  } else {
    const double factor = pose.path ? pose.path->from : 0;
    Equilibrium start = solve(problem, start_state(problem, pose), factor, options_, context_);
    if (start.verdict != Verdict::kStable && start.verdict != Verdict::kCritical &&
        start.verdict != Verdict::kUnstable) {
      return Error{ErrorCode::kGeometry,
                   {},
                   name_of(key.first) + " is not in balance at its first load factor: " + start.message,
                   ""};
    }
    rate.state = std::move(start.state);
  }
  rate.reaction = support_reactions(problem, rate.state);

  NewtonWorkspace workspace(problem, context_);
  workspace.assemble(rate.state);
  const VecX load = load_rate(problem, rate.state);
  VecX local = prescribed_rate(problem, rate.state);
  problem.potential.to_local(local);
  VecX force;
  multiply(problem.potential.pattern(), workspace.hessian(), local, force);
  force += load;
  if (problem.supports.unknowns() > 0) {
    VecX right, free, correction, image;
    problem.supports.restrict(force, right);
    right = -right;
    const Error singular{
        ErrorCode::kGeometry,
        {},
        "the linearised problem of " + name_of(key.first) + " is singular: something can move without a force",
        "hold it, or measure without \"_rate\""};
    if (!workspace.factorize(0).complete) return singular;
    workspace.factor().solve(right, free);
    workspace.multiply_free(free, image);
    workspace.factor().solve(right - image, correction);  // one refinement
    free += correction;
    workspace.multiply_free(free, image);
    if (!free.allFinite() || (image - right).norm() > 1e-6 * right.norm()) return singular;
    VecX expanded;
    problem.supports.expand(free, expanded);
    local += expanded;
    multiply(problem.potential.pattern(), workspace.hessian(), local, force);
    force += load;
  }
  rate.reaction_rate = reactions(problem, force);
  problem.potential.to_global(local);
  rate.unknowns = std::move(local);
  return rate;
}

}  // namespace lissom
