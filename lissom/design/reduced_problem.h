#pragma once
/// An inverse problem as its methods see it: minimise h(x) = 1/2 |r(x)|^2 over a box, where every value of r costs equilibria.
/// There is a point, at which derivatives can be had, and an attempt, which becomes the point when it is accepted. Parameters
/// x are design parameters over their scales, so that they compare with each other.

#include <string>

#include "lissom/core/types.h"

namespace lissom {

/// What became of an attempt.
enum class Outcome {
  kSettled,    ///< in stable equilibrium near its prediction in all poses
  kJumped,     ///< a pose landed on another branch
  kUnstable,   ///< a pose ended in an equilibrium that is not stable
  kUnsettled,  ///< a pose found no equilibrium
  kNoDesign,   ///< the parameters make no design
  kCancelled,
};

struct Attempt {
  Outcome outcome = Outcome::kNoDesign;
  double value = 0;    ///< h, kSettled only
  std::string reason;  ///< in words, unless settled
};

/// What the work so far consisted of.
struct DesignEffort {
  int attempts = 0;
  int solves = 0;          ///< equilibria
  int factorizations = 0;  ///< attempted, those for derivatives included
  int back_solves = 0;     ///< right-hand sides
};

/// Residuals that are the positive part of something linear, max(0, value + rows v) at the point moved by v.
struct OneSided {
  SparseMatrix rows;
  VecX value;
};

class ReducedProblem {
 public:
  virtual ~ReducedProblem() = default;

  virtual int size() const = 0;
  /// As verdicts call it: "parameter 3", or a name.
  virtual std::string parameter_name(int i) const { return "parameter " + std::to_string(i); }
  virtual const VecX& lower() const = 0;
  virtual const VecX& upper() const = 0;

  /// The point, h and r there.
  virtual const VecX& x() const = 0;
  virtual double value() const = 0;
  virtual const VecX& residual() const = 0;

  /// Derivatives at the point, computed when first asked for. g = J'r by adjoints, without J.
  virtual const VecX& gradient() = 0;
  /// J'J, (m x m).
  virtual const MatX& gram() = 0;
  /// J v and J'w for w over residuals.
  virtual VecX jacobian_times(const VecX& v) = 0;
  virtual VecX jacobian_transposed_times(const VecX& w) = 0;
  /// Those of the residuals that are one-sided everywhere, not at the point alone; r and J have them too, as they are there.
  virtual const OneSided& one_sided() const {
    static const OneSided none;
    return none;
  }
  /// Exact Hessian of h times v.
  virtual VecX hessian_times(const VecX& v) = 0;

  /// Settles at x, within the bounds, starting from the prediction of the point; the point stays.
  virtual Attempt attempt(const VecX& x) = 0;
  /// r of the last attempt, settled.
  virtual const VecX& attempted_residual() const = 0;
  /// The last attempt, settled, becomes the point.
  virtual void accept() = 0;

  /// Hard constraints enter r as an augmented Lagrangian: sqrt(penalty) (c + multiplier / penalty) is a part of r, or its
  /// positive part where c <= 0 is wanted. c at the point over its scale, (constraints), the violation where c <= 0 is wanted
  /// and holds being negative.
  virtual int constraints() const { return 0; }
  virtual VecX constraint_values() const { return {}; }
  /// Whether constraint i wants c <= 0; else c = 0.
  virtual bool is_inequality(int i) const { return (void)i, false; }
  /// Changes r, h and derivatives of the point. Multipliers of inequalities are >= 0.
  virtual void set_multipliers(const VecX& multipliers, double penalty) { (void)multipliers, (void)penalty; }

  virtual DesignEffort effort() const = 0;
};

}  // namespace lissom
