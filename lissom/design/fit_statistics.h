#pragma once
/// How well least squares determine parameters: covariances s^2 (J'J)^-1, Student's intervals, correlations, and which
/// parameters the residuals say nothing about [Seber, Wild 1989, Nonlinear Regression, 2.1 and 5.1]. Exact for residuals that
/// are linear in the parameters, to first order for others.

#include <vector>

#include "lissom/core/types.h"

namespace lissom {

/// A parameter of a fit before anything is said about it.
struct FittedParameter {
  enum class Bound { kNone, kLower, kUpper };
  Bound bound = Bound::kNone;  ///< that holds it, so that it is no unknown any more
  double reach = 1;            ///< largest half-width of an interval that says anything
};

struct ParameterCertainty {
  enum class State {
    kDetermined,
    kAtLowerBound,
    kAtUpperBound,
    kUndetermined,  ///< other values fit as well, alone or together with others
    kUncertain,     ///< the interval is wider than its reach
  };
  State state = State::kDetermined;
  /// In the unit of the parameter, and of the interval. NaN for what is not determined or at a bound, and without degrees of
  /// freedom.
  double standard_error = 0, half_width = 0;
};

struct FitStatistics {
  int residuals = 0;
  int rank = 0;          ///< parameters, or combinations of them, that the residuals determine
  int freedom = 0;       ///< degrees of freedom: residuals - rank
  double deviation = 0;  ///< s: residual standard deviation, in units of the residuals; NaN without freedom
  double quantile = 0;   ///< of Student's t, by which standard errors are multiplied; NaN without freedom
  std::vector<ParameterCertainty> parameters;
  MatX correlation;                            ///< (m x m); NaN where a parameter is not determined
  std::vector<std::vector<int>> combinations;  ///< parameters of which only a combination is determined, ascending
};

/// `jacobian` (n x m): d residuals / d parameters, without rows that count for nothing; `confidence` between 0 and 1.
FitStatistics fit_statistics(const MatX& jacobian, const VecX& residual, const std::vector<FittedParameter>& parameters,
                             double confidence);

/// t with P(|T| <= t) = confidence for Student's T with `freedom` >= 1 degrees of freedom.
double student_quantile(int freedom, double confidence);

}  // namespace lissom
