#pragma once
/// Options of a static solve. Every policy can be switched by itself, so that its worth can be measured.

#include "lissom/core/result.h"

namespace lissom {

enum class Method {
  kMinimize,  ///< energy minimisation; ends in stable shapes
  kFindRoot,  ///< Newton on the forces with a merit of their norm [thesis 3.4]; may end in unstable shapes
};

/// Path of a trial step: where the nodes go for a fraction a of the step d [convergence 4].
enum class StepPath {
  kStraight,            ///< q + a d
  kSecondOrder,         ///< q + a d + a^2 p, p from differences of gradients (A)
  kRotating,            ///< edges turn by a d instead of shearing, positions fitted to them (R)
  kSecondOrderRotating  ///< both
};

enum class ShiftRule {
  kRemembered,  ///< last shift / 8, times 4 until positive definite [mathematics 4]
  kEigenvalue,  ///< from an estimate of the lowest eigenvalue (E)
};

enum class Expansion { kOff, kOn };   ///< try longer steps while a shift is active (X)
enum class Relaxation { kOff, kOn };  ///< balance a part of the unknowns inside each trial

/// What becomes of a factor once the state has moved on.
enum class FactorReuse {
  kOff,  ///< every step has its own
  kOn,   ///< steps are solved by conjugate gradients on the old one while that is cheaper [convergence 5]
};

/// What to do in an equilibrium that is not stable.
enum class AtSaddle {
  kEscape,  ///< move along the lowest mode, to the side of lower energy
  kStay,    ///< report it
};

struct SolveOptions {
  Method method = Method::kMinimize;
  double tolerance = 1e-6;  ///< of the residual, relative to Scales::force
  int max_iterations = 500;
  StepPath path = StepPath::kSecondOrderRotating;
  ShiftRule shift = ShiftRule::kEigenvalue;
  Expansion expansion = Expansion::kOn;
  Relaxation frames = Relaxation::kOff;  ///< rolls and joint rotations (F)
  Relaxation rods =
      Relaxation::kOn;  ///< all of the rods, the rest of the membranes held (B); where there are membranes
  FactorReuse reuse = FactorReuse::kOn;  ///< where there are membranes
  AtSaddle at_saddle = AtSaddle::kEscape;
  double max_turn = 0.7;  ///< rad, largest turn of an edge in one step
  double max_roll = 0.5;  ///< rad, largest change of a roll or joint rotation in one step
  int modes = 3;          ///< how many modes to report at the end; 0: inertia only

  Status validate() const;
};

}  // namespace lissom
