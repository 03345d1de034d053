#include "lissom/session/quantities.h"

#include "lissom/core/nearest_name.h"
#include "lissom/session/quantity_families.h"

namespace lissom {

namespace {

constexpr QuantityInfo kQuantities[] = {
    {"position", "m", "position along an axis", kAt | kAxis, kAxis, node_position, node_position_rate},
    {"displacement", "m", "distance from the drawn place, or its part along an axis", kAt | kAxis, 0, node_displacement,
     node_displacement_rate},
    {"distance", "m", "distance between two places", kAt | kTo, kTo, node_distance, node_distance_rate},
    {"distance_change", "m", "distance between two places, minus what it was when drawn", kAt | kTo, kTo,
     node_distance_change, node_distance_rate},
    {"slope", "rad", "angle between the tangent and an axis, or the drawn tangent", kAt | kAxis | kRod, 0, node_slope},
    {"rotation", "rad", "rotation vector of a joint or clamp, part along an axis", kAt | kAxis, kAxis, node_rotation,
     node_rotation_rate},
    {"reaction_force", "N", "force of the supports on the structure", kAt | kAxis, 0, reaction_force,
     reaction_force_rate},
    {"reaction_moment", "N m", "moment of the supports on the structure, each about its own node", kAt | kAxis, 0,
     reaction_moment, reaction_moment_rate},

    {"curvature", "1/m", "curvature of a rod at a place", kRod | kFraction, kRod | kFraction, rod_curvature},
    {"twist_rate", "rad/m", "twist of a rod per length at a place", kRod | kFraction, kRod | kFraction, rod_twist_rate},
    {"bending_moment", "N m", "bending moment in a rod at a place", kRod | kFraction, kRod | kFraction,
     rod_bending_moment},
    {"torque", "N m", "twisting moment in a rod at a place", kRod | kFraction, kRod | kFraction, rod_torque},
    {"axial_strain", "1", "strain of the edge at a place, positive when stretched", kRod | kFraction, kRod | kFraction,
     rod_axial_strain},
    {"axial_force", "N", "force along a rod at a place, positive in tension", kRod | kFraction, kRod | kFraction,
     rod_axial_force},
    {"largest_slope", "rad", "largest angle between the tangents of a rod and an axis, or the drawn tangents",
     kRod | kAxis, kRod, rod_largest_slope},
    {"length", "m", "length of a rod, or of all rods", kRod, 0, rod_length},
    {"rest_length", "m", "rest length of a rod, or of all rods", kRod, 0, rod_rest_length, nullptr, PoseUse::kNone},
    {"mass", "kg", "mass of a rod, or of all rods", kRod, 0, rod_mass, nullptr, PoseUse::kNone},

    {"line_stretch", "1", "stretch of rest lines of a membrane along an axis of the drawing, mean", kAt | kAxis, kAxis,
     membrane_line_stretch},
    {"line_angle", "rad", "angle between rest lines of a membrane along and across an axis of the drawing, mean",
     kAt | kAxis, kAxis, membrane_angle},
    {"largest_stretch", "1", "largest principal stretch of membranes", kAt, 0, membrane_largest_stretch},
    {"smallest_stretch", "1", "smallest principal stretch of membranes", kAt, 0, membrane_smallest_stretch},
    {"film_tension", "N/m", "Cauchy tension of membranes, mean of all directions or along an axis of the drawing",
     kAt | kAxis, 0, membrane_tension},
    {"area", "m^2", "area of membranes", kAt, 0, membrane_area},
    {"rest_area", "m^2", "rest area of membranes", kAt, 0, membrane_rest_area},
    {"surface_height", "m", "where a line along an axis through a point meets a membrane", kAt | kAxis, kAt | kAxis,
     membrane_height},
    {"membrane_energy", "J", "elastic energy of membranes", kAt, 0, membrane_energy},
    {"energy_density", "J/m^2", "elastic energy of membranes per rest area", kAt, 0, membrane_energy_density},
    {"bending_energy_density", "J/m^2", "elastic energy of bending of membranes per rest area", kAt, 0,
     membrane_bending_density},
    {"pre_stretch", "1", "pre-stretch of a membrane along its warp", kMembrane, kMembrane, membrane_pre_stretch},
    {"bending_stiffness", "N m", "bending stiffness of a membrane by its width", kMembrane, kMembrane,
     membrane_bending_stiffness, nullptr, PoseUse::kNone},

    {"fitted_stiffness_1", "N/m", "stiffness along the warp that fits a fabric test", kFabricTest, kFabricTest,
     fitted_stiffness_1, nullptr, PoseUse::kNone},
    {"fitted_stiffness_2", "N/m", "stiffness along the weft that fits a fabric test", kFabricTest, kFabricTest,
     fitted_stiffness_2, nullptr, PoseUse::kNone},
    {"fitted_poisson_ratio", "1", "Poisson ratio that fits a fabric test", kFabricTest, kFabricTest,
     fitted_poisson_ratio, nullptr, PoseUse::kNone},
    {"fitted_shear", "N/m", "shear modulus that follows from the three", kFabricTest, kFabricTest, fitted_shear,
     nullptr, PoseUse::kNone},
    {"fitted_modulus", "N/m", "fitted modulus of a strip cut along an axis; x is the warp", kFabricTest | kAxis,
     kFabricTest | kAxis, fitted_modulus, nullptr, PoseUse::kNone},
    {"designed_parameter", "", "what a parameter becomes in the design of the document", kParameter, 0,
     designed_parameter, nullptr, PoseUse::kNone},
    {"design_sensitivity", "", "change of a coordinate of a node over that of a parameter, at the start of the design",
     kAt | kAxis | kParameter, kAt | kAxis, design_sensitivity},

    {"cut_force", "N", "force across a plane, positive in tension", kAt | kAxis, kAt | kAxis, cut_force_all},
    {"membrane_cut_force", "N", "the part of it that membranes carry", kAt | kAxis, kAt | kAxis, cut_force_membranes},
    {"rod_cut_force", "N", "the part of it that rods carry", kAt | kAxis, kAt | kAxis, cut_force_rods},
    {"ring_stiffness", "N/m", "stiffness of a closed rod, with all around it, against a wave of the radius",
     kRod | kMode, kRod | kMode, ring_stiffness},

    {"energy", "J", "elastic energy", kAt, 0, energy_total},
    {"stretch_energy", "J", "elastic energy of stretching", kAt, 0, energy_stretch},
    {"bending_energy", "J", "elastic energy of bending", kAt, 0, energy_bending},
    {"twist_energy", "J", "elastic energy of twisting", kAt, 0, energy_twist},

    {"critical_load_factor", "1", "load factor of the first critical point of the path", 0, 0, critical_load_factor},
    {"critical_load", "N", "load on the selected nodes at the first critical point of the path", kAt, 0, critical_load},
    {"mode_stiffness", "N/m", "stiffness of a mode, 0 is the lowest", kMode, kMode, mode_stiffness},
    {"principal_stiffness", "N/m", "principal stiffness of a place that the poses move in different directions",
     kAt | kMode, kMode, principal_stiffness, nullptr, PoseUse::kTogether},
    {"frequency", "Hz", "natural frequency, mode 0 is the lowest", kMode | kModeKind | kAxis, kMode, natural_frequency},
};

constexpr std::string_view kRateEnding = "_rate";

struct FieldName {
  QuantityField field;
  std::string_view name;
};
constexpr FieldName kFieldNames[] = {{kAt, "at"},
                                     {kTo, "to"},
                                     {kAxis, "axis"},
                                     {kRod, "rod"},
                                     {kFraction, "fraction"},
                                     {kMode, "mode"},
                                     {kModeKind, "mode_kind"},
                                     {kMembrane, "membrane"},
                                     {kFabricTest, "fabric_test"},
                                     {kParameter, "parameter"}};

/// Which fields an entry gives. `at` of all nodes is the same as none.
unsigned given_fields(const Expectation& e) {
  unsigned given = 0;
  if (e.at.kind != Selector::Kind::kAll) given |= kAt;
  // A place that is subtracted or divided by belongs to the combination.
  if (e.to && e.combine.empty()) given |= kTo;
  if (e.axis) given |= kAxis;
  // Resolutions are counted on a rod.
  if (!e.rod.empty() && e.edges.empty()) given |= kRod;
  if (e.fraction >= 0) given |= kFraction;
  if (e.mode >= 0) given |= kMode;
  if (!e.mode_kind.empty()) given |= kModeKind;
  if (!e.membrane.empty()) given |= kMembrane;
  if (!e.fabric_test.empty()) given |= kFabricTest;
  if (!e.parameter.empty()) given |= kParameter;
  return given;
}

}  // namespace

std::span<const QuantityInfo> quantities() { return kQuantities; }

Result<NamedQuantity> find_quantity(std::string_view name) {
  std::vector<std::string> names;
  for (const QuantityInfo& info : kQuantities) {
    if (info.name == name) return NamedQuantity{&info, info.measure};
    names.emplace_back(info.name);
    if (info.rate == nullptr) continue;
    names.push_back(std::string(info.name) + std::string(kRateEnding));
    if (names.back() == name) return NamedQuantity{&info, info.rate};
  }
  return Error{ErrorCode::kUnknown, "quantity", "there is no quantity \"" + std::string(name) + "\"",
               suggestion(name, names)};
}

Status check_expectation(const Expectation& e) {
  const Result<NamedQuantity> found = find_quantity(e.quantity);
  if (!found) return found.error();
  const QuantityInfo& info = *found.value().info;
  const unsigned given = given_fields(e);
  for (const FieldName& f : kFieldNames) {
    const std::string quoted = "\"" + std::string(f.name) + "\"";
    const bool counts_edges = f.field == kRod && !e.rod.empty();
    if ((given & f.field) != 0 && (info.reads & f.field) == 0) {
      return Error{ErrorCode::kConflict, std::string(f.name), "\"" + e.quantity + "\" does not read " + quoted,
                   "leave it out"};
    }
    if ((info.needs & f.field) != 0 && (given & f.field) == 0 && !counts_edges) {
      return Error{ErrorCode::kType, std::string(f.name), "\"" + e.quantity + "\" needs " + quoted, "add it"};
    }
  }
  return {};
}

}  // namespace lissom
