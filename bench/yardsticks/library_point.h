#pragma once
/// A reduced problem as libraries of optimisation see it: value and gradient at any x they like.

#include <functional>
#include <string>

#include "lissom/design/reduced_problem.h"

namespace lissom {

/// What a library has come to.
struct YardstickReport {
  std::string ending;  ///< the library's own word for it
  int iterations = 0;
  int attempts = 0, failed = 0, gradients = 0;
  double value = 0;  ///< h of the best point, where the problem is left
};

struct YardstickOptions {
  double tolerance = 1e-9;  ///< of the gradient, as the library understands it
  int max_iterations = 500;
  std::function<bool()> cancelled = [] { return false; };
};

class LibraryPoint {
 public:
  explicit LibraryPoint(ReducedProblem& problem);

  /// h at x, clipped to the bounds. False: no equilibrium there.
  bool value(const VecX& x, double& h);
  /// Moves the point to x, higher or not. False: no equilibrium there.
  bool gradient(const VecX& x, VecX& g);

  /// Brings the problem back to the lowest point seen, and reports.
  YardstickReport finish();

 private:
  bool settle(const VecX& x);

  ReducedProblem& problem_;
  VecX attempted_, best_;
  bool attempt_settled_ = false;
  double attempted_value_ = 0, best_value_ = 0;
  YardstickReport report_;
};

}  // namespace lissom
