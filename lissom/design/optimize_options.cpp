#include "lissom/design/optimize_options.h"

#include <cmath>
#include <string>

#include "lissom/core/assert.h"

namespace lissom {

namespace {

constexpr std::array<DesignMethodInfo, 7> kMethods = {{
    {DesignMethod::kGaussNewton, "gauss_newton", "products of first derivatives; slow where residuals stay large"},
    {DesignMethod::kBfgs, "bfgs", "second derivatives from changes of the gradient alone"},
    {DesignMethod::kStructuredBfgs, "structured_bfgs",
     "products of first derivatives, the rest from changes of the gradient"},
    {DesignMethod::kDennisGayWelsch, "dennis_gay_welsch",
     "the same by another update, which may follow negative curvature"},
    {DesignMethod::kLevenbergMarquardt, "levenberg_marquardt", "damped products of first derivatives"},
    {DesignMethod::kNewton, "newton", "exact second derivatives, as products"},
    {DesignMethod::kGaussNewtonProducts, "gauss_newton_products",
     "products of first derivatives that are never put together: for thousands of parameters"},
}};

Error out_of_range(const char* where, const char* message, const char* hint) {
  return Error{ErrorCode::kRange, where, message, hint};
}

bool share(double value) { return value >= 0 && value < 1; }
bool positive(double value) { return value > 0 && std::isfinite(value); }

}  // namespace

const std::array<DesignMethodInfo, 7>& design_methods() { return kMethods; }

std::string_view design_method_name(DesignMethod method) {
  for (const DesignMethodInfo& info : kMethods) {
    if (info.method == method) return info.name;
  }
  LISSOM_ASSERT(false);
  return {};
}

std::optional<SecantRule> secant_rule(DesignMethod method) {
  switch (method) {
    case DesignMethod::kGaussNewton:
      return SecantRule::kGaussNewton;
    case DesignMethod::kBfgs:
      return SecantRule::kBfgs;
    case DesignMethod::kStructuredBfgs:
      return SecantRule::kStructuredBfgs;
    case DesignMethod::kDennisGayWelsch:
      return SecantRule::kDennisGayWelsch;
    case DesignMethod::kLevenbergMarquardt:
    case DesignMethod::kNewton:
    case DesignMethod::kGaussNewtonProducts:
      break;
  }
  return std::nullopt;
}

Status OptimizeOptions::validate() const {
  if (max_iterations < 1) return out_of_range("max_iterations", "at least one iteration is needed", "100 is usual");
  if (!share(gradient_tolerance)) {
    return out_of_range("gradient_tolerance", "the tolerance has to lie between 0 and 1", "1e-6 is usual");
  }
  if (!share(decrease_tolerance)) {
    return out_of_range("decrease_tolerance", "the tolerance has to lie between 0 and 1", "1e-9 is usual");
  }
  if (!(value_tolerance >= 0)) {
    return out_of_range("value_tolerance", "the value that is good enough cannot be negative", "0 asks for the best");
  }
  if (!positive(first_cap)) {
    return out_of_range("first_cap", "the first step needs a positive length", "1, one scale, is usual");
  }
  if (!positive(least_step) || least_step > first_cap) {
    return out_of_range("least_step", "the least step has to lie between 0 and the first cap", "1e-6 is usual");
  }
  if (max_halvings < 0) return out_of_range("max_halvings", "the number of halvings cannot be negative", "10 is usual");
  if (!positive(first_damping)) {
    return out_of_range("first_damping", "the first damping has to be positive", "1e-3 is usual");
  }
  if (!positive(least_damped) || least_damped > 1) {
    return out_of_range("least_damped", "the share has to lie between 0 and 1", "1e-12 is usual");
  }
  if (max_products < 1) return out_of_range("max_products", "at least one product is needed", "200 is usual");
  if (!positive(newton_forcing) || newton_forcing >= 1) {
    return out_of_range("newton_forcing", "the share has to lie between 0 and 1", "0.1 is usual");
  }
  return {};
}

}  // namespace lissom
