#include "lissom/session/fields.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lissom/session/field_families.h"
#include "lissom/session/rod_places.h"
#include "lissom/view/pose_markers.h"

namespace lissom {

namespace {

template <class Of>
std::vector<double> per_edge_of(const FieldSource& s, const Of& of) {
  std::vector<double> values;
  for (int e = 0; e < s.system.edge_count(); ++e) values.push_back(of(e));
  return values;
}

template <class Of>
std::vector<double> per_node_of(const FieldSource& s, const Of& of) {
  std::vector<double> values;
  for (int i = 0; i < s.system.layout.nodes(); ++i) values.push_back(of(i));
  return values;
}

/// Calls visit(edge, place, strain) for every edge at both of its ends where it bends.
template <class Visit>
void for_each_end(const FieldSource& s, const Visit& visit) {
  for (const RodPlace& place : rod_places(s.system)) {
    const PairStrain strain = strain_at(s.system, s.state, place);
    if (place.edge0 >= 0) visit(place.edge0, place, strain);
    if (place.edge1 >= 0) visit(place.edge1, place, strain);
  }
}

/// Mean over the ends of each edge.
template <class Of>
std::vector<double> mean_of_ends(const FieldSource& s, const Of& of) {
  std::vector<double> sum(s.system.structure.edges.size(), 0), count(sum.size(), 0);
  for_each_end(s, [&](int e, const RodPlace& place, const PairStrain& strain) {
    sum[e] += of(place, strain);
    count[e] += 1;
  });
  for (size_t e = 0; e < sum.size(); ++e) sum[e] = count[e] > 0 ? sum[e] / count[e] : 0;
  return sum;
}

/// Energy of the places at an edge per rest length of the edge: a place between two edges is shared evenly.
template <class Of>
std::vector<double> density(const FieldSource& s, const Of& energy) {
  std::vector<double> sum(s.system.structure.edges.size(), 0);
  for_each_end(s, [&](int e, const RodPlace& place, const PairStrain& strain) {
    sum[e] += energy(strain, place.rest) * (place.pair >= 0 ? 0.5 : 1.0) / s.system.rest.edges[e].length;
  });
  return sum;
}

std::vector<double> axial_strain(const FieldSource& s) {
  return per_edge_of(s, [&](int e) { return s.state.edges[e].length / s.system.rest.edges[e].length - 1; });
}

std::vector<double> axial_force(const FieldSource& s) {
  return per_edge_of(s, [&](int e) {
    const EdgeRest& rest = s.system.rest.edges[e];
    return rest.stretch * (s.state.edges[e].length / rest.length - 1);
  });
}

std::vector<double> curvature(const FieldSource& s) {
  return mean_of_ends(s, [](const RodPlace& place, const PairStrain& strain) {
    return std::hypot(strain.kappa_1, strain.kappa_2) / place.rest.length;
  });
}

std::vector<double> twist_rate(const FieldSource& s) {
  return mean_of_ends(s,
                      [](const RodPlace& place, const PairStrain& strain) { return strain.twist / place.rest.length; });
}

std::vector<double> stretch_density(const FieldSource& s) {
  return per_edge_of(s, [&](int e) { return stretch_energy(s.system, s.state, e) / s.system.rest.edges[e].length; });
}
std::vector<double> bending_density(const FieldSource& s) { return density(s, bending_energy); }
std::vector<double> twist_density(const FieldSource& s) { return density(s, twist_energy); }

/// Largest normal stress of bending and stretching at the surface, linear over the section, at the worse end.
std::vector<double> surface_stress(const FieldSource& s) {
  const Structure& structure = s.system.structure;
  std::vector<double> modulus(structure.rods.size(), 0), worst(structure.edges.size(), 0);
  for (size_t r = 0; r < structure.rods.size(); ++r) {
    if (const Material* material = s.model.material(structure.rods[r].material)) modulus[r] = material->youngs_modulus;
  }
  for_each_end(s, [&](int e, const RodPlace& place, const PairStrain& strain) {
    const Section& section = structure.edges[e].section;
    const double towards_b = std::abs(strain.kappa_1 - place.rest.kappa_1) / place.rest.length * section.r_b;
    const double towards_n = std::abs(strain.kappa_2 - place.rest.kappa_2) / place.rest.length * section.r_n;
    const bool corners = section.shape == SectionShape::kRectangle;
    worst[e] = std::max(worst[e], corners ? towards_b + towards_n : std::hypot(towards_b, towards_n));
  });
  return per_edge_of(s, [&](int e) {
    const double stretch = std::abs(s.state.edges[e].length / s.system.rest.edges[e].length - 1);
    return modulus[structure.edges[e].rod] * (worst[e] + stretch);
  });
}

std::vector<double> displacement(const FieldSource& s) {
  return per_node_of(s, [&](int i) { return (s.state.position(i) - s.system.structure.nodes[i]).norm(); });
}

std::vector<double> reaction_force(const FieldSource& s) {
  if (s.reaction == nullptr || s.reaction->size() != s.system.layout.size()) {
    return std::vector<double>(static_cast<size_t>(s.system.layout.nodes()), std::numeric_limits<double>::quiet_NaN());
  }
  return per_node_of(s, [&](int i) { return s.reaction->segment<3>(3 * i).norm(); });
}

std::vector<double> radius_n(const FieldSource& s) {
  return per_edge_of(s, [&](int e) { return s.system.structure.edges[e].section.r_n; });
}
std::vector<double> radius_b(const FieldSource& s) {
  return per_edge_of(s, [&](int e) { return s.system.structure.edges[e].section.r_b; });
}

constexpr auto kEdge = Field::Place::kEdge;
constexpr auto kNode = Field::Place::kNode;
constexpr auto kTriangle = Field::Place::kTriangle;
constexpr auto kMembranes = FieldNeeds::kMembranes;
constexpr auto kPlain = Field::Colors::kSequential;
constexpr auto kSigned = Field::Colors::kDiverging;
constexpr auto kPale = Field::Colors::kPale;

constexpr FieldInfo kFields[] = {
    {"axial strain", "", "%", 100, kEdge, kSigned, "stretch of each edge", axial_strain},
    {"axial force", "N", "N", 1, kEdge, kSigned, "force along each edge, positive in tension", axial_force},
    {"curvature", "1/m", "1/m", 1, kEdge, kPlain, "curvature, natural part included, mean of both ends", curvature},
    {"twist rate", "rad/m", "rad/m", 1, kEdge, kSigned, "twist per length, mean of both ends", twist_rate},
    {"stretch energy", "J/m", "mJ/m", 1000, kEdge, kPlain, "elastic energy of stretching per rest length",
     stretch_density},
    {"bending energy", "J/m", "mJ/m", 1000, kEdge, kPlain, "elastic energy of bending per rest length",
     bending_density},
    {"twist energy", "J/m", "mJ/m", 1000, kEdge, kPlain, "elastic energy of twisting per rest length", twist_density},
    {"stress", "Pa", "MPa", 1e-6, kEdge, kPlain, "largest normal stress at the surface from bending and stretching",
     surface_stress},
    {"radius n", "m", "mm", 1000, kEdge, kPlain, "half-extent of the section along n (out of plane)", radius_n},
    {"radius b", "m", "mm", 1000, kEdge, kPlain, "half-extent of the section along b (in plane)", radius_b},
    {"displacement", "m", "mm", 1000, kNode, kPlain, "distance of each node from where it is drawn", displacement},
    {"reaction", "N", "N", 1, kNode, kPlain, "force of the supports on each node", reaction_force},
    {"joint force", "N", "N", 1, kNode, kPlain, "largest force that a rod passes on to the joint", joint_force,
     kMembranes},
    {"joint moment", "N m", "N mm", 1000, kNode, kPlain, "largest moment that a rod passes on to the joint",
     joint_moment, kMembranes},
    {"largest stretch", "", "", 1, kTriangle, kPale, "larger principal stretch of the fabric, 1: as long as at rest",
     largest_stretch, kMembranes},
    {"smallest stretch", "", "", 1, kTriangle, kPale, "smaller principal stretch of the fabric, below 1: slack",
     smallest_stretch, kMembranes},
    {"largest tension", "N/m", "N/m", 1, kTriangle, kSigned, "larger principal tension of the fabric, per length",
     largest_tension, kMembranes},
    {"smallest tension", "N/m", "N/m", 1, kTriangle, kSigned, "smaller principal tension of the fabric, per length",
     smallest_tension, kMembranes},
    {"slack", "", "", 1, kTriangle, kPale, "1 where the smallest stretch is below 1, else 0", slack, kMembranes},
    {"fabric energy", "J/m^2", "mJ/m²", 1000, kTriangle, kPale, "elastic energy of the fabric per unstretched area",
     membrane_energy_density, kMembranes},
};

/// What pictures mark on membranes whatever colours them.
void add_marks(const FieldSource& source, Drawing& drawing) {
  const Structure& structure = source.system.structure;
  if (structure.triangles.empty()) return;
  const std::vector<TriangleStretch> stretches = triangle_stretches(source);
  const std::vector<TriangleTension> tensions = triangle_tensions(source);
  for (size_t m = 0; m < structure.membranes.size(); ++m) {
    const int first = structure.membranes[m].first_triangle;
    for (int t = first; t < first + structure.membranes[m].triangles; ++t) {
      drawing.membranes[m].smallest_stretch.push_back(stretches[t].smallest);
      drawing.membranes[m].tension.push_back(tensions[t].direction * std::max(0.0, tensions[t].largest));
    }
  }
}

Drawing bare_drawing(const System& system, const State& state) {
  std::vector<Vec3> positions;
  for (int i = 0; i < system.layout.nodes(); ++i) positions.push_back(state.position(i));
  std::vector<Frame> frames;
  for (const EdgeState& edge : state.edges) frames.push_back(edge.material());
  return make_drawing(system.structure, positions, frames);
}

}  // namespace

std::span<const FieldInfo> field_list() { return kFields; }

Result<Drawing> draw_state(const FieldSource& source, const Pose* pose) {
  Drawing drawing = bare_drawing(source.system, source.state);
  add_marks(source, drawing);
  for (const FieldInfo& info : kFields) {
    if (info.needs == FieldNeeds::kMembranes && source.system.structure.triangles.empty()) continue;
    drawing.fields.push_back({std::string(info.name), std::string(info.unit), std::string(info.display_unit),
                              info.display_scale, info.place, info.colors,
                              field_values(source.system.structure, info.place, info.values(source))});
  }
  if (pose == nullptr) return drawing;
  Result<std::vector<Marker>> markers =
      pose_markers(source.model, source.system.structure, *pose, node_positions(source));
  if (!markers) return markers.error();
  drawing.markers = std::move(markers).value();
  return drawing;
}

std::string field_of_membranes(const Drawing& drawing, const std::string& field) {
  const Field* rods = field.empty() ? nullptr : drawing.field(field);
  if (drawing.membranes.empty() || rods == nullptr || rods->place != Field::Place::kEdge) return {};
  return "smallest stretch";
}

Drawing draw_rest(const System& system) { return bare_drawing(system, drawn_state(system)); }

}  // namespace lissom
