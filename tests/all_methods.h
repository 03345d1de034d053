#pragma once
/// All methods of inverse design, asked for all that rounding allows.

#include <string>
#include <vector>

#include "lissom/design/optimize_options.h"

namespace lissom {

inline std::vector<OptimizeOptions> all_methods(int max_iterations = 600) {
  std::vector<OptimizeOptions> all;
  for (const DesignMethodInfo& info : design_methods()) {
    OptimizeOptions o;
    o.method = info.method;
    o.max_iterations = max_iterations;
    o.gradient_tolerance = 1e-12;
    o.decrease_tolerance = 0;
    o.least_step = 1e-12;
    all.push_back(o);
    o.control = StepControl::kTrustRegion;
    if (secant_rule(info.method)) all.push_back(o);
  }
  return all;
}

inline std::string name_of(const OptimizeOptions& o) {
  const bool line = secant_rule(o.method) && o.control == StepControl::kLineSearch;
  return std::string(design_method_name(o.method)) + (line ? ", line search" : ", region");
}

}  // namespace lissom
