#pragma once
/// Centrelines as the user describes them, before any discretisation.

#include <variant>
#include <vector>

#include "lissom/core/types.h"

namespace lissom {

/// Straight pieces between points; every point becomes a node.
struct Polyline {
  std::vector<Vec3> points;  ///< m, (n x 3)
  bool closed = false;
};

/// C1 Catmull-Rom curve through control points, uniform parameter, one-sided quadratic end tangents
/// [mathematics 6.1, 6.2]. Sampled at equidistant parameters.
struct Spline {
  std::vector<Vec3> points;  ///< m, (n x 3)
  bool closed = false;
};

/// Circular arc: `start` turned about `axis` through `centre` by `angle`. |angle| = 2 pi makes a closed circle if `closed`.
struct Arc {
  Vec3 centre = Vec3::Zero();  ///< m
  Vec3 start = Vec3::Zero();   ///< m
  Vec3 axis = Vec3::UnitZ();
  double angle = 0;  ///< rad
  bool closed = false;
};

/// Circular helix: `start` turned about `axis` through `centre`, rising by `pitch` along the axis per turn.
struct Helix {
  Vec3 centre = Vec3::Zero();  ///< m
  Vec3 start = Vec3::Zero();   ///< m
  Vec3 axis = Vec3::UnitZ();
  double pitch = 0;  ///< m per turn
  double turns = 0;  ///< negative: left-handed
};

using Curve = std::variant<Polyline, Spline, Arc, Helix>;

bool is_closed(const Curve& curve);

}  // namespace lissom
