#include "lissom/design/parameter.h"

namespace lissom {

const char* si_unit(ParameterKind kind) {
  switch (kind) {
    case ParameterKind::kRadius:
    case ParameterKind::kPosition:
    case ParameterKind::kDisplacement:
    case ParameterKind::kLength:
    case ParameterKind::kThickness:
    case ParameterKind::kPinTarget:
    case ParameterKind::kMove:
      return "m";
    case ParameterKind::kPreStretch:
    case ParameterKind::kPoissonRatio:
    case ParameterKind::kLengthFactor:
    case ParameterKind::kFactor:
      return "";
    case ParameterKind::kYoungsModulus:
      return "Pa";
    case ParameterKind::kSheetStiffness:
    case ParameterKind::kForcePerLength:
    case ParameterKind::kPinStiffness:
      return "N/m";
    case ParameterKind::kCurvature:
      return "1/m";
    case ParameterKind::kTwistRate:
      return "rad/m";
    case ParameterKind::kForce:
      return "N";
    case ParameterKind::kMoment:
      return "N m";
    case ParameterKind::kAcceleration:
      return "m/s^2";
  }
  return "";
}

}  // namespace lissom
