#pragma once
/// Triangles for the zero of a function of space: how smooth shapes are drawn by a formula.

#include <functional>

#include "lissom/core/result.h"
#include "lissom/geometry/surface.h"

namespace lissom {

/// m or anything of that sign: negative inside, positive outside.
using ImplicitShape = std::function<double(const Vec3&)>;

struct ImplicitOptions {
  Vec3 inside = Vec3::Zero();  ///< m, a point of the shape
  double radius = 0;           ///< m, of a sphere about it that holds the whole shape
  double edge = 0;             ///< m, largest radius of a triangle's circle: about its side
  double distance = 0;         ///< m, from the middle of that circle to the surface
};

/// Closed, manifold, turned outwards: restricted Delaunay triangles [Boissonnat, Oudot 2005, through CGAL]. Same input, same
/// bytes. kRange where `inside` is not; kGeometry where no closed surface comes about.
Result<Surface> implicit_surface(const ImplicitShape& shape, const ImplicitOptions& options);

}  // namespace lissom
