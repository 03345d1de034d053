#include "lissom/geometry/dual_network.h"

#include <fmt/format.h>

#include "lissom/geometry/surface_boundary.h"
#include "lissom/geometry/surface_decimate.h"
#include "lissom/geometry/surface_locate.h"
#include "lissom/geometry/surface_topology.h"

namespace lissom {

namespace {

constexpr double kCorner = 0.7;  // rad, turn of a boundary that makes a joint

std::size_t at(int i) { return static_cast<std::size_t>(i); }

Vec3 centre(const Surface& surface, int triangle) { return position(surface, {triangle, Vec3::Constant(1.0 / 3)}); }

}  // namespace

Result<SurfaceNetwork> dual_network(const Surface& surface, const DualOptions& options, const std::string& where) {
  if (options.triangles < 4) {
    return Error{ErrorCode::kRange, where + "/triangles",
                 fmt::format("{} triangles are too few for a mesh of rods", options.triangles), "ask for four or more"};
  }
  const Surface coarse = decimate(surface, options.triangles);
  const int left = static_cast<int>(coarse.triangles.size());
  if (left > options.triangles + 1) {
    return Error{ErrorCode::kGeometry, where + "/triangles",
                 fmt::format("the surface keeps its form only down to {} triangles, not {}", left, options.triangles),
                 fmt::format("ask for {} or more", left)};
  }
  SurfaceNetwork network;
  for (int t = 0; t < left; ++t) {
    const Vec3 normal = area_vector(coarse, t);
    network.joints.push_back({nearest_place(surface, centre(coarse, t), normal), SurfaceJoint::Kind::kInside});
  }
  const std::vector<int> adjacent = side_mates(coarse.triangles), mates = side_mates(surface.triangles);
  const std::vector<BoundaryLoop> loops = boundary_loops(surface);
  const auto connect = [&](int a, int b) {
    const SurfacePlace from = network.joints[at(a)].place, to = network.joints[at(b)].place;
    network.lines.push_back({{a, b}, {}, false, triangles_near(surface, mates, from, to)});
  };
  for (int t = 0; t < left; ++t) {
    for (int i = 0; i < 3; ++i) {
      const int mate = adjacent[at(3 * t + i)];
      if (mate / 3 > t) connect(t, mate / 3);
      if (mate >= 0) continue;
      const std::array<int, 3>& corner = coarse.triangles[at(t)];
      const Vec3 middle = 0.5 * (coarse.vertices[at(corner[at(i)])] + coarse.vertices[at(corner[at((i + 1) % 3)])]);
      network.joints.push_back({nearest_on_boundary(surface, loops, middle), SurfaceJoint::Kind::kBoundary});
      connect(t, static_cast<int>(network.joints.size()) - 1);
    }
  }
  if (Status s = add_boundary_lines(surface, kCorner, network, where); !s) return s.error();
  return network;
}

}  // namespace lissom
