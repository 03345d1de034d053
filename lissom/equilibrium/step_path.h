#pragma once
/// The path that a trial step follows [convergence 3, 4]. On straight lines edges that turn are stretched, and thin rods
/// are so stiff in stretch that only tiny steps survive; these paths keep lengths to second order or to all orders.

#include <optional>
#include <span>

#include "lissom/equilibrium/edge_laplacian.h"
#include "lissom/equilibrium/length_fit.h"
#include "lissom/equilibrium/newton_workspace.h"
#include "lissom/equilibrium/options.h"
#include "lissom/equilibrium/rigid_drift.h"

namespace lissom {

class StepPathPolicy {
 public:
  StepPathPolicy(NewtonWorkspace& workspace, StepPath path);

  /// Takes the rigid motions of free parts out of a step.
  const RigidDrift& drift() const { return drift_; }

  /// Prepares the path of step d (global axes) from `state`. `reach` is the largest fraction that will be tried. A second
  /// order needs the factor in the workspace to be the one that gave d. `arrival`: see LengthFit; has to outlive the step.
  void begin(const State& state, const VecX& d, double reach, bool own_factor = true,
             std::span<const double> arrival = {});

  /// State at fraction a; false when it cannot be had.
  [[nodiscard]] bool at(double a, State& trial);

 private:
  void second_order(double reach);
  bool rotate(double a, VecX& increment);

  NewtonWorkspace& workspace_;
  StepPath path_;
  RigidDrift drift_;
  const State* state_ = nullptr;
  std::span<const double> arrival_;
  VecX d_, p_, increment_;
  bool has_p_ = false;
  VecX forward_, backward_, free_;
  State probe_;
  VecX pull_, fitted_;
  std::optional<EdgeLaplacian> fit_;     // of rods alone
  std::optional<LengthFit> length_fit_;  // of rods in membranes
};

/// Gradient at `moved` of the energy anchored at `anchor`, with `moved` = anchor advanced by dq [mathematics 1.8]: the
/// gradient that is re-anchored at `moved` plus the holonomy of the frames and the left Jacobian of joint rotations.
/// Global axes in and out.
void to_anchored_gradient(const System& system, const State& anchor, const State& moved, const VecX& dq,
                          VecX& gradient);

}  // namespace lissom
