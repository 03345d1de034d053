#pragma once
/// Natural frequencies and mode shapes: small free vibrations about an equilibrium.
///
/// H u = omega^2 M u, H the exact Hessian at the equilibrium (so prestress counts), M the lumped masses. Mass on positions
/// and rolls only; joint rotations follow without delay. Solved by lissom/core/eigen_solver.h.

#include <string>
#include <vector>

#include "lissom/core/context.h"
#include "lissom/core/result.h"
#include "lissom/equilibrium/static_problem.h"
#include "lissom/motion/mass.h"

namespace lissom {

/// What kind of motion carries the kinetic energy of a mode.
enum class ModeKind {
  kAny,
  kBending,    ///< nodes move across their rods
  kAxial,      ///< nodes move along their rods
  kTorsional,  ///< sections turn about their rods
};

struct NaturalMode {
  double frequency = 0;    ///< Hz; 0 for motions that cost no energy, and for unstable ones
  double growth_rate = 0;  ///< 1/s: above 0 where the equilibrium is unstable and the mode grows like exp(rate t)
  VecX shape;              ///< global increments of all unknowns with unit modal mass: u' M u = 1 kg m^2 (m, rad)

  /// Shares of the kinetic energy, between 0 and 1. axial + torsional + bending = 1.
  double axial = 0, torsional = 0, bending = 0;
  /// Sum of m u u' over the nodes: a' translation a is the share of motion along the unit vector a. Its trace is
  /// 1 - torsional.
  Mat3 translation = Mat3::Zero();

  bool unstable() const { return growth_rate > 0; }
  double share(ModeKind kind) const;
  double share_along(const Vec3& axis) const { return axis.dot(translation * axis); }
};

/// The `count` lowest modes (fewer when fewer unknowns have mass), ascending: unstable, at rest, vibrating.
/// `state` has to be an equilibrium of `problem`; without loads and natural strains the drawn state is one. Make the
/// problem with NullMotions::kKeep, so that an unsupported structure vibrates freely, and with kKeepRigid for
/// RollInertia::kNone.
Result<std::vector<NaturalMode>> natural_modes(const StaticProblem& problem, const State& state, int count,
                                               RollInertia roll_inertia, const Context& context = {});

/// Which modes to look for. A mode belongs when more than half of its kinetic energy does.
struct ModeFilter {
  ModeKind kind = ModeKind::kAny;
  Vec3 axis = Vec3::Zero();  ///< nodes move along this direction; zero: any
};

/// Round rods and symmetric structures have several modes of one frequency, of which a solver returns any combination.
/// Turns the modes of each such group (frequencies within `spread` of each other, relative) so that as many as possible
/// belong to the filter wholly. Modes keep their order otherwise.
std::vector<NaturalMode> separated(const System& system, const State& state, std::vector<NaturalMode> modes,
                                   RollInertia roll_inertia, const ModeFilter& filter, double spread = 1e-5);

/// Index in `modes` of the k-th (from 0) that belongs to the filter; -1 when there are not that many. Separate first.
int find_mode(const std::vector<NaturalMode>& modes, const ModeFilter& filter, int k);

}  // namespace lissom
