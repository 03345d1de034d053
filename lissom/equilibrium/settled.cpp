#include "lissom/equilibrium/settled.h"

#include "lissom/equilibrium/solve.h"

namespace lissom {

Result<Equilibrium> settled(const Model& model, const System& system, const Pose& pose, const std::string& where,
                            const Context& context) {
  const Result<StaticProblem> problem = make_static_problem(model, system, pose, where);
  if (!problem) return problem.error();
  SolveOptions options;
  options.modes = 0;
  return solve(problem.value(), start_state(problem.value(), pose), 1, options, context);
}

}  // namespace lissom
