#pragma once
/// Moduli of rods and fabrics, and the natural shapes of rods, as design parameters.

#include <memory>
#include <string>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/design/linear_space.h"

namespace lissom {

enum class ModulusChoice {
  kPerMaterial,  ///< one for each material, common to its rods
  kPerRod,       ///< rods get materials of their own
};

/// Young's moduli of rods; shear moduli follow by Poisson's ratios, densities stay. `range`: bounds, Pa. kUnsupported per rod
/// for the rods of a plan, which share their material.
Result<LinearSpace> youngs_modulus_space(std::shared_ptr<const Design> base, ModulusChoice choice, const Vec2& range);

enum class SheetProperty {
  kStiffness,   ///< along both axes, their ratio stays, N/m: the parameter is that along axis 1
  kStiffness1,  ///< along axis 1 alone, N/m
  kStiffness2,
  kPoissonRatio,
  kThickness,    ///< m; acts on bending only, for stiffness is per width
  kPreStretch,   ///< along both axes, their ratio stays: the parameter is that along axis 1
  kPreStretch1,  ///< along axis 1 alone
  kPreStretch2,
};

struct SheetChoice {
  SheetProperty property = SheetProperty::kStiffness;
  Vec2 range = Vec2::Zero();  ///< bounds, SI
};

/// One parameter to each choice and fabric (pre-stretch: to each membrane). kConflict where a property is chosen twice, alone
/// and with both axes too.
Result<LinearSpace> fabric_space(std::shared_ptr<const Design> base, const std::vector<SheetChoice>& choices);

enum class NaturalProperty {
  kCurvatureB,    ///< towards b, 1/m
  kCurvatureN,    ///< towards n, 1/m
  kTwist,         ///< rad/m
  kLengthFactor,  ///< natural length over the drawn one
};

struct NaturalChoice {
  NaturalProperty property = NaturalProperty::kLengthFactor;
  Vec2 range = Vec2::Zero();  ///< bounds, SI
};

/// One parameter to each choice and rod of `rods` (empty: all). kUnsupported for rates of rods whose natural shape is not
/// described as straight or by constant rates.
Result<LinearSpace> natural_shape_space(std::shared_ptr<const Design> base, const std::vector<std::string>& rods,
                                        const std::vector<NaturalChoice>& choices);

}  // namespace lissom
