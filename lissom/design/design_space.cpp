#include "lissom/design/design_space.h"

#include <fmt/format.h>
#include <string_view>

#include "lissom/core/assert.h"

namespace lissom {

Result<Design> DesignSpace::applied(Design design, const VecX& p) const {
  (void)design, (void)p;
  return Error{ErrorCode::kUnsupported, "/parameters", "these parameters cannot be combined with others",
               "use them alone"};
}

DesignJacobian chained(DesignJacobian jacobian, const SparseMatrix& d_p) {
  const auto chain = [&d_p](SparseMatrix& matrix) {
    if (matrix.cols() > 0) matrix = SparseMatrix(matrix * d_p);
  };
  chain(jacobian.inputs);
  chain(jacobian.numbers);
  for (PoseJacobian& pose : jacobian.poses) {
    chain(pose.loads);
    chain(pose.held);
  }
  return jacobian;
}

Status check_bounds(std::span<const Parameter> parameters, const VecX& p) {
  LISSOM_ASSERT(p.size() == static_cast<Eigen::Index>(parameters.size()));
  for (int i = 0; i < p.size(); ++i) {
    const Parameter& parameter = parameters[static_cast<std::size_t>(i)];
    if (p[i] >= parameter.lower && p[i] <= parameter.upper) continue;
    std::string_view unit = si_unit(parameter.kind);
    const double factor = unit == "m" ? 1e3 : unit == "Pa" ? 1e-6 : 1;  // as people write lengths and moduli
    if (factor != 1) unit = unit == "m" ? "mm" : "MPa";
    const std::string_view space = unit.empty() ? "" : " ";
    return Error{ErrorCode::kRange, "/parameters",
                 fmt::format("{} is {:g}{}{}, outside of {:g} to {:g}{}{}", parameter.name, factor * p[i], space, unit,
                             factor * parameter.lower, factor * parameter.upper, space, unit),
                 "stay within the bounds, or widen them"};
  }
  return {};
}

}  // namespace lissom
