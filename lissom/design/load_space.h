#pragma once
/// Loads, targets of soft pins and movements of supports as design parameters: what a structure has to carry, or how it has to
/// be held, for a shape.

#include <memory>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/design/linear_space.h"

namespace lissom {

enum class LoadKind { kForce, kMoment, kLineLoad, kEdgeLoad, kGravity, kPinStiffness, kPinTarget, kMove };

enum class LoadPart {
  kX,
  kY,
  kZ,
  kSize,  ///< along its present direction; also for what is a number
};

struct LoadChoice {
  LoadKind kind = LoadKind::kForce;
  int pose = 0;
  int index = 0;  ///< in the list of the pose: forces, moments, ..., supports; of no meaning for gravity
  LoadPart part = LoadPart::kSize;
  Vec2 range = Vec2::Zero();  ///< bounds, SI
};

/// kUnknown where the pose has no such load, kUnsupported for targets of pins that follow the drawing and for movements of
/// mirror planes, kConflict where a number is chosen twice.
Result<LinearSpace> load_space(std::shared_ptr<const Design> base, const std::vector<LoadChoice>& choices);

}  // namespace lissom
