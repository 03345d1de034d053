#pragma once
/// A design parameter as people see it.

#include <optional>
#include <string>

#include "lissom/core/types.h"

namespace lissom {

enum class ParameterKind {
  kRadius,          ///< half-extent of rods at a control point, m
  kPosition,        ///< coordinate of a control point in the plan, m
  kDisplacement,    ///< component of the displacement of a control of the rest shape, m
  kPreStretch,      ///< of the fabric, dimensionless
  kLength,          ///< of straight rods as drawn, m
  kYoungsModulus,   ///< of rods, Pa
  kSheetStiffness,  ///< of fabric along one of its axes, N/m
  kPoissonRatio,    ///< of fabric, dimensionless
  kThickness,       ///< of fabric, m
  kCurvature,       ///< natural, of rods, 1/m
  kTwistRate,       ///< natural, of rods, rad/m
  kLengthFactor,    ///< natural length of rods over the drawn one, dimensionless
  kForce,           ///< component of a force, or its size, N
  kMoment,          ///< component of a moment, N m
  kForcePerLength,  ///< component of a load along rods or rims, N/m
  kAcceleration,    ///< component of gravity, m/s^2
  kPinStiffness,    ///< of a soft pin, N/m
  kPinTarget,       ///< coordinate of the target of a soft pin, m
  kMove,            ///< component of the movement of a support, m
  kFactor,          ///< of a combination of other parameters, dimensionless
};

struct Parameter {
  ParameterKind kind = ParameterKind::kRadius;
  std::string name;             ///< "point \"tip\": r_n"
  double lower = 0, upper = 0;  ///< bounds, SI
  double scale = 1;             ///< a change that is felt: parameters over their scales compare with each other
  std::optional<Vec3> at = {};  ///< m, the place in the drawing that it belongs to
  int axis = -1;                ///< 0, 1, 2: a component along x, y, z; of radii 0, 1: along n, b
};

/// "m", "" for numbers without a unit.
const char* si_unit(ParameterKind kind);

}  // namespace lissom
