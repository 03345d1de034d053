#pragma once
/// Makes the Newton matrix positive definite: H + shift * metric, with as few factorisations as possible.

#include "lissom/equilibrium/newton_workspace.h"
#include "lissom/equilibrium/options.h"

namespace lissom {

class ShiftPolicy {
 public:
  explicit ShiftPolicy(ShiftRule rule) : rule_(rule) {}

  /// Leaves a positive-definite factor of H + shift * metric in the workspace. Returns false when none was found.
  bool factorize(NewtonWorkspace& workspace);

  /// Shift of the last factor; 0 when H itself was positive definite.
  double shift() const { return shift_; }

  /// Stiffness relative to the metric, below 0, of the softest direction known from the last factor, and that direction
  /// over the free unknowns; 0 when none is known.
  double negative() const { return negative_; }
  VecX negative_direction() const { return vectors_.col(0); }

  /// Prepares the shift of the next iteration from the present factor.
  void learn(NewtonWorkspace& workspace);

 private:
  /// To be tried where none was not enough.
  double first_shift() const;
  /// Lowest eigenvalue of (H, metric) by a few steps of subspace iteration on the present factor.
  double estimate_lowest(NewtonWorkspace& workspace);

  ShiftRule rule_;
  double shift_ = 0, next_ = 0;
  double failed_ = 0;  // largest at this step that was not enough
  double negative_ = 0;
  double worked_ = 0;  // last shift above 0 that was enough
  MatX vectors_;       // unknowns x 2, kept between iterations
  VecX work_, image_;
};

}  // namespace lissom
