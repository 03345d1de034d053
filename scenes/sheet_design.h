#pragma once
/// The Sheet of the thesis' table 5.1 as an inverse problem: a honeycomb of 0.2 m in TPU that is to bend easily one way and
/// hardly the other, and to stretch easily one way and hardly the other, each shown by the shape of another sheet.

#include <functional>
#include <vector>

#include "lissom/model/model.h"

namespace lissom::scene_models {

/// Half-extents along n and b (m) at a place, of a rod that runs along `direction`.
using RadiiField = std::function<Vec2(const Vec3& place, const Vec3& direction)>;

/// The model with these radii in the middle of every edge of its straight rods.
Model with_radii(const Model& model, const RadiiField& field);

/// Three by six hexagons, 71 rods of ten edges between 54 joints, 693 nodes, all radii 2 mm. Four poses: bent by weights while
/// held along one side, then along the other; pulled in the plane away from one side, then from the other. Sides are held by
/// soft pins of `stiffness` (N/m) at each node, where they are drawn.
Model sheet_to_design(double stiffness);

/// Of each pose the radii of the sheet that shows what is wanted.
std::vector<RadiiField> sheet_targets();

}  // namespace lissom::scene_models
