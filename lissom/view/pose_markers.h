#pragma once
/// Supports and forces of a pose as markers of a drawing.

#include <span>
#include <vector>

#include "lissom/model/structure.h"
#include "lissom/view/rod_drawing.h"

namespace lissom {

/// Markers at the given node positions (m). Pins, partly held nodes and soft pins stand as pins, both kinds of clamps as
/// clamps; symmetry planes, moments and distributed loads have no marker.
Result<std::vector<Marker>> pose_markers(const Model& model, const Structure& structure, const Pose& pose,
                                         std::span<const Vec3> positions);

}  // namespace lissom
