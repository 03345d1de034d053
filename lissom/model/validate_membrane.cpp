#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "lissom/model/element_map.h"
#include "lissom/model/limits.h"
#include "lissom/model/units.h"
#include "lissom/model/validate_parts.h"

namespace lissom {
namespace {

/// Twice the area of a triangle over its longest side squared, below which it counts as a line.
constexpr double kFlattest = 1e-6;

std::string at(const std::string& where, const char* key, std::size_t index) {
  return where + "/" + key + "/" + std::to_string(index);
}

void check_cells(Checker& check, double cells, const std::string& where) {
  if (cells <= kMostNodes) return;
  check.fail(ErrorCode::kRange, where, "the membrane would have " + number_text(cells) + " cells",
             "use larger ones: at most " + std::to_string(kMostNodes));
}

void check_triangle(Checker& check, const MembraneMesh& mesh, std::size_t t, const std::string& where) {
  const std::array<int, 3>& corner = mesh.triangles[t];
  for (std::size_t i = 0; i < 3; ++i) {
    if (corner[i] >= 0 && static_cast<std::size_t>(corner[i]) < mesh.points.size()) continue;
    return check.fail(ErrorCode::kRange, where + "/" + std::to_string(i),
                      "there is no point " + std::to_string(corner[i]) + " in this mesh",
                      "it has " + std::to_string(mesh.points.size()) + ", counted from 0");
  }
  const Vec3 &a = mesh.points[corner[0]], &b = mesh.points[corner[1]], &c = mesh.points[corner[2]];
  const double longest2 = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  if ((b - a).cross(c - a).norm() > kFlattest * longest2) return;
  check.fail(ErrorCode::kGeometry, where, "this triangle has no area: its corners lie on a line",
             "move its points apart, or leave it out");
}

/// Every edge belongs to one triangle, or to two that run along it in opposite directions.
void check_surface(Checker& check, const MembraneMesh& mesh, const std::string& where) {
  std::map<std::pair<int, int>, std::size_t> first;  // triangles by directed edge
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const int a = mesh.triangles[t][i], b = mesh.triangles[t][(i + 1) % 3];
      const auto [known, fresh] = first.emplace(std::pair(a, b), t);
      if (fresh) continue;
      const bool third = first.contains({b, a});
      return check.fail(ErrorCode::kGeometry, at(where, "triangles", t),
                        (third ? "more than two triangles meet at the edge between the points "
                               : "triangle " + std::to_string(known->second) +
                                     " runs the same way along the edge between the points ") +
                            std::to_string(a) + " and " + std::to_string(b),
                        third ? "a membrane is a surface: split it into several membranes"
                              : "turn one of the two around: all triangles go the same way round");
    }
  }
  std::vector<bool> used(mesh.points.size(), false);
  for (const std::array<int, 3>& t : mesh.triangles) {
    for (const int corner : t) used[corner] = true;
  }
  const auto unused = std::find(used.begin(), used.end(), false);
  if (unused == used.end()) return;
  check.fail(ErrorCode::kGeometry, at(where, "points", static_cast<std::size_t>(unused - used.begin())),
             "this point belongs to no triangle", "remove it, or use it");
}

struct ShapeCheck {
  Checker& check;
  std::string where;

  void place(const Vec2& p, const std::string& key) const {
    check.finite(p.x(), where + key + "/0");
    check.finite(p.y(), where + key + "/1");
  }
  void operator()(const MembraneGrid& grid) const {
    const std::string here = where + "/grid";
    place(grid.corner, "/grid/corner");
    check.positive(grid.size.x(), here + "/size/0", "size");
    check.positive(grid.size.y(), here + "/size/1", "size");
    if (grid.cells_x < 1 || grid.cells_y < 1) check.fail(ErrorCode::kRange, here + "/cells", "a grid needs cells");
    check_cells(check, 1.0 * grid.cells_x * grid.cells_y, here + "/cells");
  }
  void operator()(const MembraneDisc& disc) const {
    const std::string here = where + "/disc";
    place(disc.centre, "/disc/centre");
    check.positive(disc.radius, here + "/radius", "radius");
    check.not_negative(disc.inner_radius, here + "/inner_radius", "radius");
    if (disc.inner_radius >= disc.radius) {
      check.fail(ErrorCode::kConflict, here + "/inner_radius", "the hole is as large as the disc, or larger",
                 "give an inner radius below the radius");
    }
    if (disc.rings < 1) check.fail(ErrorCode::kRange, here + "/rings", "a disc needs at least one ring");
    if (disc.sectors < 3) check.fail(ErrorCode::kRange, here + "/sectors", "a disc needs at least three sectors");
    check_cells(check, 1.0 * disc.rings * disc.sectors, here);
  }
  void operator()(const MembraneTriangles& sheet) const {
    const std::string here = where + "/triangles";
    place(sheet.corner, "/triangles/corner");
    check.positive(sheet.edge, here + "/edge", "edge");
    if (sheet.columns < 1 || sheet.rows < 1) check.fail(ErrorCode::kRange, here, "a sheet needs columns and rows");
    check_cells(check, 1.0 * sheet.columns * sheet.rows, here);
  }
  void operator()(const MembraneMesh& mesh) const {
    const std::string here = where + "/mesh";
    for (std::size_t i = 0; i < mesh.points.size() && !check.failed(); ++i) {
      check.finite(mesh.points[i], at(here, "points", i));
    }
    if (mesh.triangles.empty()) {
      check.fail(ErrorCode::kGeometry, here + "/triangles", "the mesh is empty: it has no triangle");
    }
    for (std::size_t t = 0; t < mesh.triangles.size() && !check.failed(); ++t) {
      check_triangle(check, mesh, t, at(here, "triangles", t));
    }
    if (!check.failed()) check_surface(check, mesh, here);
    check.take(check_element_maps(mesh.stiffness, mesh.density, mesh.triangles.size(), kTriangleWords, here));
  }
};

}  // namespace

void check_fabric(Checker& check, const MembraneMaterial& fabric, const std::string& where) {
  check.take(fabric.validate(where));
  check.positive(fabric.stiffness_1, where + "/stiffness", "stiffness");
  check.positive(fabric.stiffness_2, where + "/stiffness", "stiffness");
  check.finite(fabric.thickness, where + "/thickness");
  check.finite(fabric.area_density, where + "/area_density");
}

void check_fabric_test(Checker& check, const FabricTest& test, const std::string& where) {
  if (test.pulls.empty()) check.fail(ErrorCode::kType, where, "this test has no pull");
  for (std::size_t i = 0; i < test.pulls.size() && !check.failed(); ++i) {
    const StripPull& pull = test.pulls[i];
    const std::string here = where + "/" + std::to_string(i);
    check.finite(pull.angle, here + "/angle");
    check.positive(pull.force_per_width, here + "/force_per_width", "force");
    check.not_negative(pull.across, here + "/across", "stretch");
    check.finite(pull.stretch, here + "/stretch");
    if (!(pull.stretch > 1)) {
      check.fail(ErrorCode::kRange, here + "/stretch", "a strip that is pulled becomes longer: its stretch is above 1",
                 "give the present over the rest length");
    }
  }
}

void check_membrane(Checker& check, const Membrane& membrane, const std::string& where) {
  std::visit(ShapeCheck{check, where}, membrane.shape);
  check.known(membrane.material, check.fabrics, "fabric", where + "/material");
  for (int i = 0; i < 2; ++i) check.positive(membrane.pre_stretch[i], where + "/pre_stretch", "pre-stretch");
  check.finite(membrane.warp_angle, where + "/warp_angle");
  check.not_negative(membrane.bending, where + "/bending", "multiplier");
}

}  // namespace lissom
