#pragma once
/// Triangles of membranes in a situation, as quantities measure them.

#include <vector>

#include "lissom/mechanics/membrane_strain.h"
#include "lissom/session/quantities.h"

namespace lissom {

using Mat32 = Eigen::Matrix<double, 3, 2>;

/// A triangle of the situation: its stretch, and its two sides from the first corner, drawn and now.
struct Sides {
  Mat32 drawn, now;  ///< m, columns in space
  TriangleStretch stretch;
  const TriangleRest* moduli = nullptr;

  /// How much of each side makes up a direction of the drawing, laid into the drawn triangle.
  Vec2 parts(const Vec3& direction) const;
  /// The same for the direction at right angles to it, anticlockwise in the drawn triangle.
  Vec2 parts_across(const Vec3& direction) const;
};

Sides sides_of(const Situation& s, int triangle);

/// A situation with the triangles whose corners are all selected.
struct Cloth {
  const Situation* in = nullptr;
  std::vector<int> triangles;
};

/// Those that a measurement selects; an error when there are none.
Result<Cloth> cloth_at(const Measurement& m);

}  // namespace lissom
