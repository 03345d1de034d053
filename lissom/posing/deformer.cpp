#include "lissom/posing/deformer.h"

#include <algorithm>
#include <fmt/format.h>

#include "lissom/equilibrium/settled.h"
#include "lissom/geometry/tetrahedra.h"
#include "lissom/geometry/triangle_point.h"
#include "lissom/geometry/triangle_surface.h"
#include "lissom/posing/stiffness_map.h"

namespace lissom {

namespace {

constexpr double kCellsAcross = 12;  // tetrahedra along the longest side of a body
constexpr char kName[] = "surface";

std::size_t at(int i) { return static_cast<std::size_t>(i); }

double darkness_at(const Surface& surface, const SurfacePlace& place) {
  if (surface.darkness.empty()) return 0;
  double sum = 0;
  for (int i = 0; i < 3; ++i) {
    sum += place.weights[i] * surface.darkness[at(surface.triangles[at(place.triangle)][at(i)])];
  }
  return sum;
}

/// The inside is as the surface nearest to it is painted.
PartPlace place_inside(const Surface& surface, const TriangleSurface& distances, const Vec3& x) {
  const NearestPoint nearest = distances.nearest(x);
  const auto& corner = surface.triangles[at(nearest.triangle)];
  const Vec3 weights = nearest_in_triangle(surface.vertices[at(corner[0])], surface.vertices[at(corner[1])],
                                           surface.vertices[at(corner[2])], x);
  return {x, darkness_at(surface, {nearest.triangle, weights}), (x - nearest.point).norm()};
}

/// A membrane of the surface's triangles that bends as a plate of that thickness does.
Membrane shell_of(const DeformerBrief& brief, const Surface& surface) {
  Membrane membrane;
  membrane.name = kName;
  membrane.material = brief.name;
  MembraneMesh mesh;
  mesh.points = surface.vertices;
  mesh.triangles = surface.triangles;
  for (int t = 0; !brief.regions.empty() && t < static_cast<int>(surface.triangles.size()); ++t) {
    const SurfacePlace middle{t, Vec3::Constant(1.0 / 3)};
    const PartFactors factors = factors_at(brief.regions, {position(surface, middle), darkness_at(surface, middle), 0});
    mesh.stiffness.push_back(factors.stiffness);
    mesh.density.push_back(factors.density);
  }
  membrane.shape = std::move(mesh);
  return membrane;
}

MembraneMaterial shell_material(const DeformerBrief& brief) {
  MembraneMaterial material;
  material.name = brief.name;
  material.stiffness_1 = material.stiffness_2 = brief.modulus * brief.thickness;
  material.poisson_ratio = brief.poisson_ratio;
  material.thickness = brief.thickness;
  material.area_density = brief.density * brief.thickness;
  return material;
}

Result<Solid> body_of(const DeformerBrief& brief, const Surface& surface, TetrahedralMesh mesh,
                      const std::string& where) {
  Solid solid;
  solid.name = kName;
  solid.material = brief.name;
  if (!brief.regions.empty()) {
    const Result<TriangleSurface> distances = TriangleSurface::make(surface.vertices, surface.triangles, where);
    if (!distances) return distances.error();
    for (const auto& tetrahedron : mesh.tetrahedra) {
      Vec3 centre = Vec3::Zero();
      for (const int p : tetrahedron) centre += mesh.points[at(p)] / 4;
      const PartFactors factors = factors_at(brief.regions, place_inside(surface, distances.value(), centre));
      solid.stiffness.push_back(factors.stiffness);
      solid.density.push_back(factors.density);
    }
  }
  solid.points = std::move(mesh.points);
  solid.tetrahedra = std::move(mesh.tetrahedra);
  return solid;
}

Material body_material(const DeformerBrief& brief) {
  Material material;
  material.name = brief.name;
  material.youngs_modulus = brief.modulus;
  material.poisson_ratio = brief.poisson_ratio;
  material.density = brief.density;
  return material;
}

double extent(const Surface& surface) {
  Vec3 low = surface.vertices.front(), high = low;
  for (const Vec3& x : surface.vertices) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  return (high - low).maxCoeff();
}

}  // namespace

Result<Deformer> Deformer::make(const DeformerBrief& brief, const Surface& surface, const std::string& where) {
  Deformer deformer;
  Model& model = deformer.model_;
  model.title = brief.name;
  if (brief.kind == DeformerBrief::Kind::kShell) {
    model.membrane_materials.push_back(shell_material(brief));
    model.membranes.push_back(shell_of(brief, surface));
  } else {
    TetrahedralOptions options;
    options.cell_size = brief.cell.value_or(extent(surface) / kCellsAcross);
    Result<TetrahedralMesh> mesh = fill_surface(surface, options);
    if (!mesh) {
      Error error = mesh.error();
      error.where = error.where.empty() ? where : where + ": " + error.where;
      return error;
    }
    deformer.embedding_.emplace(mesh.value(), surface.vertices);
    model.materials.push_back(body_material(brief));
    Result<Solid> body = body_of(brief, surface, std::move(mesh).value(), where);
    if (!body) return body.error();
    model.solids.push_back(std::move(body).value());
  }
  if (Status s = model.validate(); !s) {
    Error error = s.error();
    error.where = where;
    return error;
  }
  Result<System> system = make_system(model);
  if (!system) return system.error();
  deformer.system_ = std::move(system).value();
  return deformer;
}

std::vector<Vec3> Deformer::on_surface(const std::vector<Vec3>& nodes) const {
  const Structure& structure = system_.structure;
  const std::vector<int>& numbers = embedding_ ? structure.solids[0].nodes : structure.membranes[0].nodes;
  std::vector<Vec3> own;
  for (const int node : numbers) own.push_back(nodes[at(node)]);
  return embedding_ ? embedding_->carried(own) : own;
}

Result<std::vector<Vec3>> Deformer::posed(const Pose& pose, const std::string& where, const Context& context) const {
  const Result<Equilibrium> found = settled(model_, system_, pose, where, context);
  if (!found) return found.error();
  if (found.value().verdict != Verdict::kStable) {
    return Error{ErrorCode::kConflict, where,
                 fmt::format("the deformer \"{}\" takes no stable shape in pose \"{}\": {}", model_.title, pose.name,
                             found.value().message),
                 "pull less, hold more, or make the deformer stiffer"};
  }
  std::vector<Vec3> nodes;
  for (int i = 0; i < static_cast<int>(system_.structure.nodes.size()); ++i) {
    nodes.push_back(found.value().state.position(i));
  }
  return on_surface(nodes);
}

Result<VecX> Deformer::selected(const Selector& selector, const std::string& where) const {
  const Result<std::vector<int>> nodes = select(model_, system_.structure, selector, where);
  if (!nodes) return nodes.error();
  std::vector<Vec3> marks(system_.structure.nodes.size(), Vec3::Zero());
  for (const int node : nodes.value()) marks[at(node)][0] = 1;
  const std::vector<Vec3> carried = on_surface(marks);
  VecX share(static_cast<Eigen::Index>(carried.size()));
  for (Eigen::Index v = 0; v < share.size(); ++v) share[v] = carried[static_cast<std::size_t>(v)][0];
  return share;
}

}  // namespace lissom
