#include "lissom/geometry/surface_decimate.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/tangential_relaxation.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <boost/property_map/function_property_map.hpp>

#include "lissom/geometry/cgal_surface.h"

namespace lissom {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
namespace simplification = CGAL::Surface_mesh_simplification;

constexpr int kRelaxations = 5;

/// Edges that relaxation leaves alone: a boundary keeps its shape.
auto boundary_edges(const Mesh& mesh) {
  return boost::make_function_property_map<Mesh::Edge_index>(
      [&mesh](const Mesh::Edge_index& edge) { return mesh.is_border(edge); });
}

/// Stops at a number of triangles, which CGAL's own conditions do not count.
struct EnoughTriangles {
  const Mesh* mesh;
  std::size_t triangles;

  template <class Cost, class Profile>
  bool operator()(const Cost&, const Profile&, std::size_t, std::size_t) const {
    return mesh->number_of_faces() <= triangles;
  }
};

}  // namespace

Surface decimate(const Surface& surface, int triangles) {
  Mesh mesh;
  for (const Vec3& x : surface.vertices) mesh.add_vertex({x[0], x[1], x[2]});
  for (const std::array<int, 3>& corner : surface.triangles) {
    const auto vertex = [&](std::size_t i) { return Mesh::Vertex_index(static_cast<Mesh::size_type>(corner[i])); };
    mesh.add_face(vertex(0), vertex(1), vertex(2));
  }
  const EnoughTriangles enough{&mesh, static_cast<std::size_t>(triangles)};
  simplification::edge_collapse(mesh, enough,
                                CGAL::parameters::get_cost(simplification::Edge_length_cost<Mesh>())
                                    .get_placement(simplification::LindstromTurk_placement<Mesh>()));
  mesh.collect_garbage();
  CGAL::Polygon_mesh_processing::tangential_relaxation(
      mesh, CGAL::parameters::number_of_iterations(kRelaxations).edge_is_constrained_map(boundary_edges(mesh)));
  return surface_of(mesh);
}

}  // namespace lissom
