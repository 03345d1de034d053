#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "lissom/core/nearest_name.h"
#include "lissom/geometry/planar_patterns.h"
#include "lissom/model/discretize_parts.h"
#include "lissom/model/element_map.h"
#include "lissom/model/limits.h"
#include "lissom/model/membrane_formulas.h"

namespace lissom {

namespace {

std::string membrane_place(size_t m) { return fmt::format("/membranes/{}", m); }

std::string membrane_label(const Model& model, size_t m) {
  const std::string& name = model.membranes[m].name;
  return name.empty() ? fmt::format("membrane {}", m) : fmt::format("membrane \"{}\"", name);
}

int refined(int cells, double refine) { return std::max(1, static_cast<int>(std::lround(cells * refine))); }

MembraneMesh lifted(const PlanarTriangles& flat) {
  MembraneMesh mesh;
  mesh.points.reserve(flat.points.size());
  for (const Vec2& p : flat.points) mesh.points.emplace_back(p.x(), p.y(), 0);
  mesh.triangles = flat.triangles;
  return mesh;
}

MembraneMesh cut(const MembraneShape& shape, double refine) {
  if (const auto* grid = std::get_if<MembraneGrid>(&shape)) {
    return lifted(
        grid_triangles(grid->corner, grid->size, refined(grid->cells_x, refine), refined(grid->cells_y, refine)));
  }
  if (const auto* disc = std::get_if<MembraneDisc>(&shape)) {
    return lifted(disc_triangles(disc->centre, disc->inner_radius, disc->radius, refined(disc->rings, refine),
                                 refined(disc->sectors, refine)));
  }
  if (const auto* sheet = std::get_if<MembraneTriangles>(&shape)) {
    return lifted(equilateral_triangles(sheet->corner, sheet->edge / refine, refined(sheet->columns, refine),
                                        refined(sheet->rows, refine)));
  }
  return std::get<MembraneMesh>(shape);
}

Error not_a_surface(const Draft& draft, size_t m, int a, const char* what, const char* hint) {
  const Vec3& p = draft.structure.nodes[a];
  return {ErrorCode::kGeometry, membrane_place(m),
          fmt::format("{} {} at ({:.4g}, {:.4g}, {:.4g}) mm", membrane_label(draft.model, m), what, 1e3 * p.x(),
                      1e3 * p.y(), 1e3 * p.z()),
          hint};
}

Status add_triangles(Draft& draft, size_t m) {
  Structure& s = draft.structure;
  const Membrane& membrane = draft.model.membranes[m];
  StructureMembrane& out = s.membranes[m];
  out.first_triangle = static_cast<int>(s.triangles.size());
  const MembraneMesh& mesh = draft.membranes[m];
  out.triangles = static_cast<int>(mesh.triangles.size());
  for (size_t t = 0; t < mesh.triangles.size(); ++t) {
    StructureTriangle triangle;
    triangle.membrane = static_cast<int>(m);
    triangle.stiffness = multiplier(mesh.stiffness, t);
    triangle.density = multiplier(mesh.density, t);
    for (int i = 0; i < 3; ++i) triangle.node[i] = out.nodes[mesh.triangles[t][i]];
    const Vec3 &a = s.nodes[triangle.node[0]], &b = s.nodes[triangle.node[1]], &c = s.nodes[triangle.node[2]];
    const Vec3 normal = (b - a).cross(c - a);
    const double longest2 = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    if (!(normal.norm() > 1e-6 * longest2)) {
      return not_a_surface(draft, m, triangle.node[0], "has a triangle without area",
                           "move its points apart or leave it out");
    }
    triangle.corner = material_corners<double>({a, b, c}, membrane.warp_angle);
    s.triangles.push_back(triangle);
  }
  return {};
}

/// Hinges between neighbouring triangles of one membrane, in the order of the triangle on the left.
Status add_hinges(Draft& draft, size_t m) {
  Structure& s = draft.structure;
  const StructureMembrane& membrane = s.membranes[m];
  const int end = membrane.first_triangle + membrane.triangles;
  const auto corner = [&](int place, int next) { return s.triangles[place / 3].node[(place + next) % 3]; };
  // Half edges by the node that they leave, in the order of their places: three times the triangle, and the corner.
  const int begin = membrane.first_triangle;
  std::vector<int> first(s.nodes.size() + 1, 0);
  for (int place = 3 * begin; place < 3 * end; ++place) ++first[static_cast<size_t>(corner(place, 0)) + 1];
  for (size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
  struct HalfEdge {
    int end, place;
  };
  std::vector<HalfEdge> leaving(static_cast<size_t>(3) * membrane.triangles);
  std::vector<int> next(first.begin(), first.end() - 1);
  for (int place = 3 * begin; place < 3 * end; ++place) leaving[next[corner(place, 0)]++] = {corner(place, 1), place};
  /// The first place of the half edge from a to b, or -1.
  const auto half_edge = [&](int a, int b) {
    for (int i = first[a]; i < first[a + 1]; ++i) {
      if (leaving[i].end == b) return leaving[i].place;
    }
    return -1;
  };
  for (int place = 3 * begin; place < 3 * end; ++place) {
    if (half_edge(corner(place, 0), corner(place, 1)) == place) continue;
    return not_a_surface(draft, m, corner(place, 0), "has an edge that two triangles run along in the same direction",
                         "turn one of them around; at most two triangles meet at an edge");
  }
  for (int t = begin; t < end; ++t) {
    for (int place = 3 * t; place < 3 * t + 3; ++place) {
      const int a = corner(place, 0), b = corner(place, 1);
      const int other = half_edge(b, a);
      if (other < 3 * t) continue;  // the rim, or done from the other side
      StructureHinge hinge{{a, b, corner(place, 2), corner(other, 2)}, static_cast<int>(m), {t, other / 3}, 0};
      if (draft.model.membranes[m].rest_folds == RestFolds::kAsDrawn) {
        hinge.rest_angle = fold_angle<double>(s.nodes[hinge.node[0]], s.nodes[hinge.node[1]], s.nodes[hinge.node[2]],
                                              s.nodes[hinge.node[3]]);
      }
      s.hinges.push_back(hinge);
    }
  }
  return {};
}

}  // namespace

Status cut_membranes(Draft& draft, double refine) {
  const Model& model = draft.model;
  size_t nodes = 0;
  for (size_t m = 0; m < model.membranes.size(); ++m) {
    const Membrane& membrane = model.membranes[m];
    if (!model.membrane_material(membrane.material)) {
      std::vector<std::string> names;
      for (const MembraneMaterial& own : model.membrane_materials) names.push_back(own.name);
      for (const MembraneMaterial& known : membrane_library()) names.push_back(known.name);
      return Error{
          ErrorCode::kUnknown, membrane_place(m) + "/material",
          fmt::format("{} is of a fabric \"{}\" that is not known", membrane_label(model, m), membrane.material),
          suggestion(membrane.material, names)};
    }
    draft.membranes.push_back(cut(membrane.shape, refine));
    const MembraneMesh& mesh = draft.membranes.back();
    if (Status s = check_element_maps(mesh.stiffness, mesh.density, mesh.triangles.size(), kTriangleWords,
                                      membrane_place(m) + "/mesh");
        !s) {
      return s;
    }
    nodes += mesh.points.size();
    if (nodes > static_cast<size_t>(kMostNodes)) {
      return Error{ErrorCode::kRange, membrane_place(m),
                   fmt::format("the membranes would have more than {} vertices", kMostNodes), "use larger triangles"};
    }
  }
  return {};
}

Status set_membranes(Draft& draft) {
  for (size_t m = 0; m < draft.membranes.size(); ++m) {
    if (Status s = add_triangles(draft, m); !s) return s;
    if (Status s = add_hinges(draft, m); !s) return s;
  }
  return {};
}

}  // namespace lissom
