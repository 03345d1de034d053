#pragma once
/// The rest shape of rod networks as design parameters: displacements of the controls of rods, added to the shape as drawn, so
/// that a rod keeps the form it was given [mathematics 6.1]; and the length of straight rods.

#include <memory>
#include <string>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/design/linear_space.h"
#include "lissom/design/rod_controls.h"

namespace lissom {

/// A rigid motion of the whole drawing makes the same structure at another place. Where a structure is held at places of its
/// drawing it changes nothing but where the result is, and in weightless poses not even that matters: a method would drift.
enum class RestShapeGauge {
  /// Six coordinates stay: all of one end, those of the end farthest from it that are across the line between them, and the
  /// one across the plane of these two and a third. All shapes can still be reached, each at one place. (An orthonormal basis
  /// without rigid motions would make every parameter act on every node.)
  kFixSix,
  kFree,  ///< all may change: where supports, targets or gravity tell places and directions apart
};

struct RestShapeOptions {
  ControlStage stage = ControlStage::kThirds;
  double reach = 0;  ///< m, bound of each component of a displacement
  RestShapeGauge gauge = RestShapeGauge::kFixSix;
};

/// Three parameters to a control, x, y, z, those left out that the gauge fixes; all 0 at the start. What a pose holds moves
/// with the drawing, soft pins with a target of their own do not. kUnsupported for what redrawn.h does not take, and for poses
/// that clamp whole edges, whose roll would turn with them.
Result<LinearSpace> rest_shape_space(std::shared_ptr<const Design> base, const RestShapeOptions& options);

/// The length of these straight rods, natural as drawn: nodes move along the drawn line, away from the start of each. Of one
/// rod the parameter is its length (m), of several the factor by which all lengths are multiplied. `factors`: its bounds over
/// what is drawn. kUnsupported where a rod is not straight or is met by others away from its start.
Result<LinearSpace> straight_length_space(std::shared_ptr<const Design> base, const std::vector<std::string>& rods,
                                          const Vec2& factors);

}  // namespace lissom
