#pragma once
/// One pose of a system ready to be solved: its energy, its supports, and the scales by which a solve is judged.

#include <string>

#include "lissom/core/result.h"
#include "lissom/mechanics/potential.h"
#include "lissom/mechanics/supports.h"
#include "lissom/mechanics/system.h"

namespace lissom {

/// Sizes of forces and of stiffness; all that makes "small" mean the same for a toy and for a gridshell.
struct Scales {
  double force = 0;      ///< N, F0: largest load on a node at load factor 1, at least 1e-6 of the largest E A
  double moment = 0;     ///< N m, F0 times the mean edge length
  double rounding = 0;   ///< N, below this a residual is rounding of the axial forces
  double stiffness = 0;  ///< N/m, of the softest bending: max B / size^3; eigenvalues are judged by it
  double length = 0;     ///< m, size of the structure
};

/// Does not own the system; it must outlive the problem.
struct StaticProblem {
  const System* system = nullptr;
  Potential potential;
  Supports supports;
  Scales scales;
  bool stretches_with_load = false;  ///< the pre-stretch of membranes grows with the load factor
  VecX mode_metric;  ///< per free unknown: share of the length (positions), times the squared gyration radius
                     ///< (rolls), 0 (joint rotations). Eigenvalues by it are stiffnesses in N/m of a mode of
                     ///< unit root-mean-square displacement.
};

/// `where` is the JSON pointer of the pose, for errors ("/poses/0").
Result<StaticProblem> make_static_problem(const Model& model, const System& system, const Pose& pose,
                                          const std::string& where, NullMotions null_motions = NullMotions::kRemove);

/// Takes over the numbers of a changed model (lengths, curvatures, radii, moduli, pre-stretch) with the same nodes, edges,
/// joints and triangles; patterns and symbolic factors of solvers on `problem` stay valid. `system` is the one that the
/// problem refers to. Changes nothing and is an error where the topology differs.
Status renew_numbers(const Model& model, const Pose& pose, const std::string& where, System& system,
                     StaticProblem& problem);

/// The same with a system of the changed model at hand.
Status renew_numbers(const Model& model, const Pose& pose, const std::string& where, System changed, System& system,
                     StaticProblem& problem);

/// The drawn shape with the pose's seed: where a solve starts from.
State start_state(const StaticProblem& problem, const Pose& pose);

}  // namespace lissom
