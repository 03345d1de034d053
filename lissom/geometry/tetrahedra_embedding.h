#pragma once
/// Points that are carried along by a body of tetrahedra: where each is among the corners, and where that is when the corners
/// have moved.

#include <array>
#include <span>
#include <vector>

#include "lissom/core/types.h"

namespace lissom {

struct TetrahedralMesh;

/// A point as the weighted mean of the corners of a tetrahedron.
struct EmbeddedPoint {
  int tetrahedron = -1;
  std::array<double, 4> weights{};  ///< barycentric, sum 1; some are negative where the point is outside
};

class SolidEmbedding {
 public:
  /// Of `points` (m, n x 3) in a mesh with at least one tetrahedron. A point that is in none belongs to the nearest; of several
  /// that are as near, to the one that it is least outside of, by weights.
  SolidEmbedding(const TetrahedralMesh& mesh, std::span<const Vec3> points);

  /// Places (m, n x 3) of the embedded points when the mesh's points are at `positions` (m); exact for affine motions.
  std::vector<Vec3> carried(std::span<const Vec3> positions) const;

  std::span<const EmbeddedPoint> points() const { return points_; }
  double farthest_outside() const { return farthest_outside_; }  ///< m, of all points; 0: each is inside

 private:
  std::vector<std::array<int, 4>> tetrahedra_;
  std::vector<EmbeddedPoint> points_;
  double farthest_outside_ = 0;
};

}  // namespace lissom
