#include "lissom/model/solid.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "lissom/model/element_map.h"
#include "lissom/model/limits.h"

namespace lissom {

namespace {

/// Six times the volume of a tetrahedron over its longest side cubed, below which it counts as flat.
constexpr double kFlattest = 1e-6;

Status check_points(const Solid& solid, const std::string& where) {
  for (std::size_t i = 0; i < solid.points.size(); ++i) {
    if (solid.points[i].allFinite() && solid.points[i].cwiseAbs().maxCoeff() <= kLargest) continue;
    return Error{ErrorCode::kRange, fmt::format("{}/points/{}", where, i), "this point is not a place: too far away",
                 "give finite numbers; is the unit the right one?"};
  }
  std::vector<bool> used(solid.points.size(), false);
  for (const std::array<int, 4>& corner : solid.tetrahedra) {
    for (const int i : corner) used[static_cast<std::size_t>(i)] = true;
  }
  const auto unused = std::find(used.begin(), used.end(), false);
  if (unused == used.end()) return {};
  return Error{ErrorCode::kGeometry, fmt::format("{}/points/{}", where, unused - used.begin()),
               "this point belongs to no tetrahedron", "remove it, or use it"};
}

Status check_corners(const Solid& solid, std::size_t t, const std::string& where) {
  for (std::size_t i = 0; i < 4; ++i) {
    const int corner = solid.tetrahedra[t][i];
    if (corner >= 0 && static_cast<std::size_t>(corner) < solid.points.size()) continue;
    return Error{ErrorCode::kRange, fmt::format("{}/{}", where, i),
                 fmt::format("there is no point {} in this solid", corner),
                 fmt::format("it has {}, counted from 0", solid.points.size())};
  }
  return {};
}

}  // namespace

Status check_tetrahedron(const std::array<Vec3, 4>& x, const std::string& where) {
  double longest2 = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < i; ++j) longest2 = std::max(longest2, (x[i] - x[j]).squaredNorm());
  }
  const double six_volumes = (x[1] - x[0]).cross(x[2] - x[0]).dot(x[3] - x[0]);
  const double least = kFlattest * longest2 * std::sqrt(longest2);
  if (six_volumes > least) return {};
  if (six_volumes < -least) {
    return Error{ErrorCode::kGeometry, where, "this tetrahedron is inside out",
                 "exchange two of its corners: from the fourth the first three run clockwise"};
  }
  return Error{ErrorCode::kGeometry, where, "this tetrahedron has no volume: its corners lie in a plane",
               "move its points apart, or leave it out"};
}

Status check_solid_mesh(const Solid& solid, const std::string& where) {
  if (solid.tetrahedra.empty()) {
    return Error{ErrorCode::kGeometry, where + "/tetrahedra", "the solid is empty: it has no tetrahedron",
                 "give four numbers of points for each"};
  }
  for (std::size_t t = 0; t < solid.tetrahedra.size(); ++t) {
    if (Status s = check_corners(solid, t, fmt::format("{}/tetrahedra/{}", where, t)); !s) return s;
  }
  if (Status s = check_points(solid, where); !s) return s;
  for (std::size_t t = 0; t < solid.tetrahedra.size(); ++t) {
    std::array<Vec3, 4> x;
    for (std::size_t i = 0; i < 4; ++i) x[i] = solid.points[static_cast<std::size_t>(solid.tetrahedra[t][i])];
    if (Status s = check_tetrahedron(x, fmt::format("{}/tetrahedra/{}", where, t)); !s) return s;
  }
  return check_element_maps(solid.stiffness, solid.density, solid.tetrahedra.size(), kTetrahedronWords, where);
}

Status check_solid_material(const Material& material, const std::string& where) {
  if (material.poisson_ratio < 0.5) return {};
  return Error{ErrorCode::kRange, where,
               fmt::format("a solid cannot be of \"{}\", whose Poisson ratio is {:g}: its volume could not change",
                           material.name, material.poisson_ratio),
               "use a ratio below 0.5; tetrahedra become too stiff above about 0.45"};
}

}  // namespace lissom
