#pragma once
/// A design parameter as people see it.

#include <string>

namespace lissom {

enum class ParameterKind {
  kRadius,      ///< half-extent of rods at a control point, m
  kPosition,    ///< coordinate of a control point in the plan, m
  kPreStretch,  ///< of the fabric, dimensionless
};

struct Parameter {
  ParameterKind kind = ParameterKind::kRadius;
  std::string name;             ///< "point \"tip\": r_n"
  double lower = 0, upper = 0;  ///< bounds, SI
  double scale = 1;             ///< a change that is felt: parameters over their scales compare with each other
};

/// "m", "" for numbers without a unit.
inline const char* si_unit(ParameterKind kind) { return kind == ParameterKind::kPreStretch ? "" : "m"; }

}  // namespace lissom
