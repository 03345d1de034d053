#pragma once
/// A surface of triangles that distances are measured to: the nearest point, and what of a motion changes the vector from it.

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/core/types.h"

namespace lissom {

/// The point of a surface that is nearest to some place p.
struct NearestPoint {
  Vec3 point = Vec3::Zero();  ///< m
  int triangle = -1;
  /// d (p - point) / dp, a projector: n n' over the inside of a triangle, I - t t' over an edge, I over a corner. Constant
  /// as long as p stays over the same of these.
  Mat3 across = Mat3::Zero();
  /// Unit. Normal of the triangle, or the mean one of those that meet in the edge or, weighted with their angles, in the
  /// corner: p is outside where (p - point) . normal > 0 [Baerentzen, Aanaes 2005].
  Vec3 normal = Vec3::UnitZ();
};

class TriangleSurface {
 public:
  /// Vertices in m; triangles anticlockwise seen from outside, where an outside matters. kRange or kGeometry, with
  /// `where` + "/vertices/7" and the like, for numbers that are not finite, vertices that do not exist, triangles without
  /// area, and no triangles at all.
  static Result<TriangleSurface> make(std::vector<Vec3> vertices, std::vector<std::array<int, 3>> triangles,
                                      const std::string& where);

  /// Of several nearest points some one, always the same. Any number of threads may ask.
  NearestPoint nearest(const Vec3& p) const;

  const std::vector<Vec3>& vertices() const { return vertices_; }
  const std::vector<std::array<int, 3>>& triangles() const { return triangles_; }

 private:
  class Search;
  TriangleSurface() = default;

  std::vector<Vec3> vertices_;
  std::vector<std::array<int, 3>> triangles_;
  std::vector<Vec3> normals_;                      // unit, per triangle
  std::vector<std::array<Vec3, 3>> edge_normals_;  // per triangle: of its edges i to i + 1
  std::vector<Vec3> corner_normals_;               // per vertex
  std::shared_ptr<const Search> search_;
};

}  // namespace lissom
