#pragma once
/// Pseudo-arc-length continuation: load factor and shape are unknowns together, so that folds are passed
/// [Riks 1979; Crisfield 1981].

#include "lissom/equilibrium/critical_point.h"

namespace lissom {

class ArcLength {
 public:
  /// `first_load_step` sets the first arc: that of a load step of this size (its sign is the direction).
  ArcLength(NewtonWorkspace& workspace, double tolerance, double first_load_step);

  enum class Outcome { kMoved, kStuck };
  /// One step from an equilibrium to the next along the branch.
  Outcome step(const State& from, State& to);

  double direction() const { return direction_; }  ///< sign of dlambda of the last step
  double direction_before() const { return direction_before_; }
  double extremum() const { return extremum_; }  ///< load factor at the turning point just passed

 private:
  bool correct_along(State& state, const VecX& tangent, double tangent_load);
  double dot(const VecX& a, double la, const VecX& b, double lb) const;

  NewtonWorkspace& workspace_;
  double tolerance_;
  double first_load_step_;
  double arc_ = 0, direction_ = 0, direction_before_ = 0, extremum_ = 0, last_slope_ = 0, last_load_ = 0;
  VecX last_tangent_;  // free unknowns, scaled metric
  double last_tangent_load_ = 0;
  VecX weight_;  // metric of the arc
};

}  // namespace lissom
