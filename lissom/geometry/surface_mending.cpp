#include "lissom/geometry/surface_mending.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "lissom/geometry/surface_file.h"

namespace lissom {

Vec3 Mending::middle(int triangle) const {
  const auto& t = surface.triangles[triangle];
  return (surface.vertices[t[0]] + surface.vertices[t[1]] + surface.vertices[t[2]]) / 3;
}

std::string Mending::triangle_name(int triangle) const {
  return origins[triangle] < 0 ? "a lid" : fmt::format("triangle {}", origins[triangle]);
}

std::string Mending::triangle_place(int triangle) const {
  return origins[triangle] < 0 ? where : fmt::format("{}/triangles/{}", where, origins[triangle]);
}

double Mending::height(int triangle) const {
  const auto& t = surface.triangles[triangle];
  const Vec3 &a = surface.vertices[t[0]], &b = surface.vertices[t[1]], &c = surface.vertices[t[2]];
  const double longest = std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
  return longest > 0 ? (b - a).cross(c - a).norm() / longest : 0;
}

bool Mending::is_thin(const Vec3& a, const Vec3& b, const Vec3& c) const {
  const double longest = std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
  const double least = std::max(options.merge * extent, options.thin * longest);
  return !((b - a).cross(c - a).norm() > least * longest);
}

bool Mending::is_thin(int triangle) const {
  const auto& t = surface.triangles[triangle];
  return is_thin(surface.vertices[t[0]], surface.vertices[t[1]], surface.vertices[t[2]]);
}

void Mending::turn_over(int triangle) {
  std::swap(surface.triangles[triangle][1], surface.triangles[triangle][2]);
  if (!unsewn.empty()) std::swap(unsewn[triangle][1], unsewn[triangle][2]);
}

void Mending::drop(const std::vector<char>& marked) {
  std::size_t kept = 0;
  for (std::size_t t = 0; t < marked.size(); ++t) {
    if (marked[t]) continue;
    surface.triangles[kept] = surface.triangles[t];
    if (!unsewn.empty()) unsewn[kept] = unsewn[t];
    origins[kept++] = origins[t];
  }
  surface.triangles.resize(kept);
  if (!unsewn.empty()) unsewn.resize(kept);
  origins.resize(kept);
}

void Mending::note(SurfaceNote note, SurfaceNote::Outcome outcome) {
  if (note.count == 0) return;
  note.outcome = outcome;
  notes.push_back(std::move(note));
}

namespace {

Status check_vertices(const Mending& mending, Eigen::AlignedBox3d& box) {
  const Surface& surface = mending.surface;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    for (const int v : surface.triangles[t]) {
      if (v < 0 || v >= static_cast<int>(surface.vertices.size())) {
        return Error{ErrorCode::kRange, mending.triangle_place(static_cast<int>(t)),
                     fmt::format("there is no vertex {}", v),
                     fmt::format("vertices are numbered from 0 to {}", static_cast<int>(surface.vertices.size()) - 1)};
      }
      if (!surface.vertices[v].allFinite()) {
        return Error{ErrorCode::kRange, fmt::format("{}/vertices/{}", mending.where, v),
                     "a coordinate is not a finite number, and triangles meet there",
                     "delete or correct the vertex in the program that made the surface"};
      }
      box.extend(surface.vertices[v]);
    }
  }
  return {};
}

}  // namespace

double largest_extent(const Surface& surface) {
  Eigen::AlignedBox3d box;
  for (const auto& t : surface.triangles) {
    for (const int v : t) box.extend(surface.vertices[v]);
  }
  return box.isEmpty() ? 0 : box.sizes().maxCoeff();
}

Status check_numbers(Mending& mending) {
  const Surface& surface = mending.surface;
  if (surface.triangles.size() > static_cast<std::size_t>(kMostSurfaceTriangles) ||
      surface.vertices.size() > static_cast<std::size_t>(kMostSurfaceVertices)) {
    return Error{
        ErrorCode::kUnsupported, mending.where,
        fmt::format("the surface has {} triangles and {} vertices", surface.triangles.size(), surface.vertices.size()),
        fmt::format("make it coarser: at most {} triangles", kMostSurfaceTriangles)};
  }
  if (surface.triangles.empty()) {
    return Error{ErrorCode::kGeometry, mending.where, "the surface has no triangles", "export the surface again"};
  }
  if (!surface.darkness.empty() && surface.darkness.size() != surface.vertices.size()) {
    return Error{ErrorCode::kRange, mending.where + "/darkness",
                 fmt::format("{} values for {} vertices", surface.darkness.size(), surface.vertices.size()),
                 "give one for each vertex, or none"};
  }
  mending.origins.resize(surface.triangles.size());
  for (std::size_t t = 0; t < mending.origins.size(); ++t) mending.origins[t] = static_cast<int>(t);
  Eigen::AlignedBox3d box;
  if (Status s = check_vertices(mending, box); !s) return s;
  const double extent = box.sizes().maxCoeff();
  const double farthest = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  if (!(extent > 1e-9) || farthest > 1e6) {
    return Error{ErrorCode::kRange, mending.where,
                 fmt::format("the surface is {:.3g} m across and reaches {:.3g} m from the origin", extent, farthest),
                 "check the unit, and move the surface to the origin"};
  }
  if (farthest > 1e7 * extent) {
    return Error{
        ErrorCode::kRange, mending.where,
        fmt::format(
            "the surface is {:.3g} m across but {:.3g} m from the origin, which leaves its coordinates few digits",
            extent, farthest),
        "move it to the origin in the program that made it"};
  }
  return {};
}

}  // namespace lissom
