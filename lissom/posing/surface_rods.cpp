#include "lissom/posing/surface_rods.h"

#include "lissom/geometry/surface_locate.h"

namespace lissom {

SurfaceRods rods_on_surface(const Surface& surface, const SurfaceNetwork& network, const MeshRods& rods) {
  const std::vector<Vec3> normals = vertex_normals(surface);
  SurfaceRods made;
  for (const SurfaceLine& line : network.lines) {
    std::vector<SurfacePlace> places = sample_path(surface, line.path, rods.edges);
    // The very place of the joint, so that rods which meet there have the same point.
    places.front() = network.joints[static_cast<std::size_t>(line.joint[0])].place;
    places.back() = network.joints[static_cast<std::size_t>(line.joint[1])].place;
    Rod& rod = made.rods.emplace_back();
    rod.name = "rod " + std::to_string(made.rods.size());
    Polyline polyline;
    rod.axes.kind = MaterialAxes::Kind::kPerPoint;
    for (const SurfacePlace& place : places) {
      polyline.points.push_back(position(surface, place));
      rod.axes.normals.push_back(smooth_normal(surface, normals, place));
    }
    rod.curve = std::move(polyline);
    rod.material = rods.material;
    rod.section.r_n = {rods.r_n};
    rod.section.r_b = {rods.r_b};
    rod.edges = rods.edges;
    made.places.push_back(std::move(places));
  }
  return made;
}

}  // namespace lissom
