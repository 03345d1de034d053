#pragma once
/// Options of an inverse design: the method, how its steps are controlled, and when it ends [mathematics 5.3, 5.4].

#include <array>
#include <optional>
#include <string_view>

#include "lissom/core/result.h"
#include "lissom/design/secant.h"

namespace lissom {

enum class DesignMethod {
  kGaussNewton,
  kBfgs,
  kStructuredBfgs,
  kDennisGayWelsch,
  kLevenbergMarquardt,
  kNewton,               ///< exact Hessians, as products, by conjugate gradients in a trust region
  kGaussNewtonProducts,  ///< J'J as products, the same way: no matrix over the parameters, for thousands of them
};

struct DesignMethodInfo {
  DesignMethod method;
  std::string_view name, meaning;
};
/// All methods, for documents and help.
const std::array<DesignMethodInfo, 7>& design_methods();
std::string_view design_method_name(DesignMethod method);
/// The rule of the methods that are secant rules with a quadratic subproblem: the first four.
std::optional<SecantRule> secant_rule(DesignMethod method);

/// How steps of the secant methods are kept in hand. The others have one way only.
enum class StepControl {
  kLineSearch,   ///< capped steps, halved until h falls [mathematics 5.4 (e), (f)]
  kTrustRegion,  ///< the cap is a radius, changed by how well the model foretold h
};

/// What conjugate gradients of exact Newton are preconditioned with.
enum class NewtonPreconditioner {
  kNone,
  kGram,  ///< J'J, factored on the free parameters: costs J once per point
};

struct OptimizeOptions {
  DesignMethod method = DesignMethod::kStructuredBfgs;
  StepControl control = StepControl::kLineSearch;
  NewtonPreconditioner preconditioner = NewtonPreconditioner::kGram;
  int max_iterations = 100;

  /// Converged when no parameter promises more than this share of what the best one promised at the start: to first order,
  /// for a move by one scale or as far as its bounds allow.
  double gradient_tolerance = 1e-6;
  /// Converged when the whole model, not cut by a cap or radius, promises less than this share of h.
  double decrease_tolerance = 1e-9;
  /// Good enough when h is not above; 0: never.
  double value_tolerance = 0;

  /// Largest change of a parameter in the first step, in scales; then the cap or radius adapts.
  double first_cap = 1;
  /// In scales: steps below it are not tried; the end when longer ones are no good.
  double least_step = 1e-6;
  /// Of one iteration with a line search; then the model is renewed.
  int max_halvings = 10;
  /// First mu of kLevenbergMarquardt, of the diagonal of J'J.
  double first_damping = 1e-3;
  /// Of the largest entry of that diagonal: parameters that matter less are damped as if they mattered so much. Where little
  /// is enough they go far for a little gain.
  double least_damped = 1e-12;
  /// Hessian products of one step of kNewton or kGaussNewtonProducts, and how far they bring the gradient of the model: to this share or, if that is
  /// less, to the square root of the share to which the promises have come since the start.
  int max_products = 200;
  double newton_forcing = 0.1;

  Status validate() const;
};

}  // namespace lissom
