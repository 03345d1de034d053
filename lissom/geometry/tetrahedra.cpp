#include "lissom/geometry/tetrahedra.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_3.h>
#include <CGAL/Random.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/exceptions.h>
#include <CGAL/exude_mesh_3.h>
#include <CGAL/make_mesh_3.h>
#include <CGAL/perturb_mesh_3.h>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <numbers>
#include <string>
#include <unordered_map>
#include <utility>

#include "lissom/geometry/surface_topology.h"

namespace lissom {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Polyhedron = CGAL::Surface_mesh<Kernel::Point_3>;
using Domain = CGAL::Polyhedral_mesh_domain_3<Polyhedron, Kernel>;
using Triangulation = CGAL::Mesh_triangulation_3<Domain>::type;
using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation>;
using Criteria = CGAL::Mesh_criteria_3<Triangulation>;

/// The corners of all kept tetrahedra, numbered in the order in which these name them.
TetrahedralMesh collected(const Complex& complex) {
  TetrahedralMesh mesh;
  std::unordered_map<const void*, int> number;
  for (auto cell = complex.cells_in_complex_begin(); cell != complex.cells_in_complex_end(); ++cell) {
    std::array<int, 4> corner{};
    for (int i = 0; i < 4; ++i) {
      const auto vertex = cell->vertex(i);
      const auto [place, fresh] = number.emplace(&*vertex, static_cast<int>(mesh.points.size()));
      if (fresh) {
        const auto& p = vertex->point();
        mesh.points.emplace_back(p.x(), p.y(), p.z());
      }
      corner[static_cast<std::size_t>(i)] = place->second;
    }
    mesh.tetrahedra.push_back(corner);
  }
  return mesh;
}

constexpr unsigned kAttempts = 6;
constexpr double kTetrahedraPerCube = 5;  // of side cell_size, as counted on bodies of few cells and of many
constexpr double kLeastFilled = 0.8;      // of the enclosed volume; what is thinner than cells may be missed

std::string place_text(const Vec3& p) {
  return fmt::format("near ({:.4g}, {:.4g}, {:.4g}) mm", 1e3 * p.x(), 1e3 * p.y(), 1e3 * p.z());
}

Error refuse(const std::string& where, std::string message, std::string hint) {
  return {ErrorCode::kGeometry, where, std::move(message), std::move(hint)};
}

Status check_triangles(const Surface& surface) {
  if (surface.triangles.empty()) return refuse("surface", "the surface has no triangles", "give a closed surface");
  for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
    if (surface.vertices[v].allFinite()) continue;
    return refuse(fmt::format("vertex {}", v), "a coordinate is not finite", "give three numbers");
  }
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const std::array<int, 3>& corner = surface.triangles[t];
    for (const int v : corner) {
      if (v >= 0 && static_cast<std::size_t>(v) < surface.vertices.size()) continue;
      return refuse(fmt::format("triangle {}", t), fmt::format("there is no vertex {}", v),
                    fmt::format("the surface has {}, counted from 0", surface.vertices.size()));
    }
    if (corner[0] != corner[1] && corner[1] != corner[2] && corner[2] != corner[0]) continue;
    return refuse(fmt::format("triangle {}", t), "two corners of this triangle are the same vertex", "leave it out");
  }
  return {};
}

/// Every edge belongs to two triangles, which run along it in opposite directions.
Status check_closed(const Surface& surface) {
  const std::vector<int> mates = side_mates(surface.triangles);
  for (int side = 0; side < static_cast<int>(mates.size()); ++side) {
    const int a = side_start(surface.triangles, side), b = side_end(surface.triangles, side);
    const int mate = mates[static_cast<std::size_t>(side)];
    if (mate >= 0 && side_start(surface.triangles, mate) == b) continue;
    const Vec3 middle =
        0.5 * (surface.vertices[static_cast<std::size_t>(a)] + surface.vertices[static_cast<std::size_t>(b)]);
    if (mate == kRim) {
      return refuse(place_text(middle),
                    fmt::format("the surface is open: the edge between the vertices {} and {} has one triangle", a, b),
                    "fill its holes first, or pose it as a shell, which may be open");
    }
    const char* what =
        mate == kCrowded ? "more than two triangles meet at the edge" : "two triangles run the same way along the edge";
    return refuse(place_text(middle), fmt::format("{} between the vertices {} and {}", what, a, b),
                  "a surface that holds a volume has two triangles at each edge, turned alike: mend it first");
  }
  return {};
}

Result<Polyhedron> polyhedron_of(const Surface& surface) {
  Polyhedron polyhedron;
  for (const Vec3& p : surface.vertices) polyhedron.add_vertex(Kernel::Point_3(p.x(), p.y(), p.z()));
  const auto index = [](int v) { return Polyhedron::Vertex_index(static_cast<std::uint32_t>(v)); };
  for (const std::array<int, 3>& t : surface.triangles) {
    if (polyhedron.add_face(index(t[0]), index(t[1]), index(t[2])) != Polyhedron::null_face()) continue;
    return refuse(place_text(surface.vertices[static_cast<std::size_t>(t[0])]),
                  "parts of the surface touch at a vertex", "give each part a vertex of its own there");
  }
  return polyhedron;
}

double or_else(double asked, double otherwise) { return asked > 0 ? asked : otherwise; }

/// Refinement begins with points found at random, and may miss a body when they are few; then the mesh is empty. Flat
/// tetrahedra are removed without limits on time, which would let the result depend on the clock.
TetrahedralMesh filled(const Polyhedron& polyhedron, const TetrahedralOptions& options, unsigned seed) {
  namespace p = CGAL::parameters;
  // Whatever ran in this thread before: the same numbers.
  CGAL::Random random(seed);
  CGAL::get_default_random() = CGAL::Random(seed);
  const Domain domain(polyhedron, &random);
  const Criteria criteria(p::facet_angle = options.facet_angle * 180 / std::numbers::pi,
                          p::facet_size = or_else(options.facet_size, options.cell_size),
                          p::facet_distance = or_else(options.facet_distance, options.cell_size / 10),
                          p::cell_radius_edge_ratio = options.edge_ratio, p::cell_size = options.cell_size);
  try {
    Complex complex = CGAL::make_mesh_3<Complex>(domain, criteria, p::no_perturb(), p::no_exude());
    CGAL::perturb_mesh_3(complex, domain, p::time_limit = 0);
    CGAL::exude_mesh_3(complex, p::time_limit = 0);
    return collected(complex);
  } catch (const CGAL::Failure_exception&) {
    return {};
  }
}

double volume_of(const TetrahedralMesh& mesh) {
  double volume = 0;
  for (const std::array<int, 4>& corner : mesh.tetrahedra) {
    const auto at = [&](std::size_t i) -> const Vec3& { return mesh.points[static_cast<std::size_t>(corner[i])]; };
    volume += (at(1) - at(0)).cross(at(2) - at(0)).dot(at(3) - at(0)) / 6;
  }
  return volume;
}

}  // namespace

Status TetrahedralOptions::validate() const {
  const auto bad = [](const char* what, std::string message, const char* hint) {
    return Error{ErrorCode::kRange, what, std::move(message), hint};
  };
  if (!(cell_size > 0) || !std::isfinite(cell_size)) {
    return bad("cell_size", fmt::format("the size of tetrahedra is {:g} m", cell_size), "give a positive length");
  }
  if (!(facet_size >= 0) || !(facet_distance >= 0) || !std::isfinite(facet_size + facet_distance)) {
    return bad("facet_size", "a size or distance of triangles is negative",
               "give positive lengths, or 0 for a usual one");
  }
  if (facet_size > 0 && facet_size < 0.05 * cell_size) {
    return bad("facet_size", fmt::format("triangles of {:g} m on tetrahedra of {:g} m", facet_size, cell_size),
               "give at least a twentieth of the cell size");
  }
  if (facet_distance > 0 && facet_distance < 0.002 * cell_size) {
    return bad("facet_distance",
               fmt::format("a distance of {:g} m with tetrahedra of {:g} m", facet_distance, cell_size),
               "give at least a five-hundredth of the cell size");
  }
  if (!(facet_angle > 0 && facet_angle <= std::numbers::pi / 6)) {
    return bad("facet_angle", fmt::format("the least angle is {:g} rad", facet_angle), "give at most 30 degrees");
  }
  if (!(edge_ratio >= 2) || !std::isfinite(edge_ratio)) {
    return bad("edge_ratio", fmt::format("the ratio of radius and side is {:g}", edge_ratio), "give at least 2");
  }
  if (most_tetrahedra < 1) return bad("most_tetrahedra", "no tetrahedron is allowed", "give a positive number");
  return {};
}

Result<TetrahedralMesh> fill_surface(const Surface& surface, const TetrahedralOptions& options) {
  if (Status s = options.validate(); !s) return s.error();
  if (Status s = check_triangles(surface); !s) return s.error();
  if (Status s = check_closed(surface); !s) return s.error();
  const double volume = enclosed_volume(surface), cube = options.cell_size * options.cell_size * options.cell_size;
  if (!(volume > 0)) {
    return refuse("surface", fmt::format("the surface holds {:.3g} cm^3", 1e6 * volume),
                  "turn its triangles round: they run anticlockwise seen from outside");
  }
  if (kTetrahedraPerCube * volume / cube > options.most_tetrahedra) {
    return Error{ErrorCode::kRange, "cell_size",
                 fmt::format("about {:.2g} tetrahedra of {:.3g} mm would fill {:.3g} cm^3",
                             kTetrahedraPerCube * volume / cube, 1e3 * options.cell_size, 1e6 * volume),
                 fmt::format("use a cell size of {:.2g} mm or more",
                             1e3 * std::cbrt(kTetrahedraPerCube * volume / options.most_tetrahedra))};
  }
  const Result<Polyhedron> polyhedron = polyhedron_of(surface);
  if (!polyhedron) return polyhedron.error();
  double best = 0;
  for (unsigned attempt = 0; attempt < kAttempts; ++attempt) {
    TetrahedralMesh mesh = filled(polyhedron.value(), options, attempt);
    const double share = volume_of(mesh) / volume;
    if (share > kLeastFilled) return mesh;
    best = std::max(best, share);
  }
  return refuse(
      "cell_size",
      fmt::format("tetrahedra of {:.3g} mm fill {:.0f} % of the surface", 1e3 * options.cell_size, 100 * best),
      "use smaller ones, or a smaller facet distance; does the surface pass through itself?");
}

}  // namespace lissom
