#include "lissom/geometry/implicit_surface.h"

#include <CGAL/Complex_2_in_triangulation_3.h>
#include <CGAL/IO/facets_in_complex_2_to_triangle_mesh.h>
#include <CGAL/Implicit_surface_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_default_triangulation_3.h>
#include <CGAL/make_surface_mesh.h>

#include "lissom/geometry/cgal_surface.h"
#include "lissom/geometry/surface_topology.h"

namespace lissom {

namespace {

using Triangulation = CGAL::Surface_mesh_default_triangulation_3;
using Complex = CGAL::Complex_2_in_triangulation_3<Triangulation>;
using Traits = Triangulation::Geom_traits;
using Function = std::function<double(const Traits::Point_3&)>;
using Mesh = CGAL::Surface_mesh<Traits::Point_3>;

constexpr double kLeastAngle = 30;    // degrees, of triangles: more may not end
constexpr double kZeroSearch = 1e-7;  // of the radius, where zeros are looked for

}  // namespace

Result<Surface> implicit_surface(const ImplicitShape& shape, const ImplicitOptions& options) {
  if (!(options.radius > 0 && options.edge > 0 && options.distance > 0)) {
    return Error{ErrorCode::kRange, {}, "the radius, the edge and the distance have to be above 0", ""};
  }
  if (!(shape(options.inside) < 0)) {
    return Error{ErrorCode::kRange, {}, "the point that should be inside of the shape is not", "name another point"};
  }
  CGAL::get_default_random() = CGAL::Random(1);
  const Function function = [&shape](const Traits::Point_3& p) { return shape(Vec3(p.x(), p.y(), p.z())); };
  const Traits::Point_3 centre(options.inside[0], options.inside[1], options.inside[2]);
  const CGAL::Implicit_surface_3<Traits, Function> surface(
      function, Traits::Sphere_3(centre, options.radius * options.radius), kZeroSearch);
  const CGAL::Surface_mesh_default_criteria_3<Triangulation> criteria(kLeastAngle, options.edge, options.distance);
  Triangulation triangulation;
  Complex complex(triangulation);
  CGAL::make_surface_mesh(complex, surface, criteria, CGAL::Manifold_tag());
  Mesh mesh;
  CGAL::facets_in_complex_2_to_triangle_mesh(complex, mesh);
  if (mesh.number_of_faces() == 0 || !CGAL::is_closed(mesh)) {
    return Error{
        ErrorCode::kGeometry, {}, "the shape has no closed surface inside of the sphere", "take a larger sphere"};
  }
  Surface made = surface_of(mesh);
  if (enclosed_volume(made) < 0) {
    for (std::array<int, 3>& corner : made.triangles) std::swap(corner[1], corner[2]);
  }
  return made;
}

}  // namespace lissom
