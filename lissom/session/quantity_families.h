#pragma once
/// Evaluators of the list in quantities.cpp, by subject; names and units are those of docs/guide/quantities.md.

#include "lissom/session/quantities.h"

namespace lissom {

// Places and motions of nodes.
Result<double> node_position(const Measurement& m);
Result<double> node_position_rate(const Measurement& m);
Result<double> node_displacement(const Measurement& m);
Result<double> node_displacement_rate(const Measurement& m);
Result<double> node_distance(const Measurement& m);
Result<double> node_distance_rate(const Measurement& m);
Result<double> node_distance_change(const Measurement& m);
Result<double> node_slope(const Measurement& m);
Result<double> node_rotation(const Measurement& m);
Result<double> node_rotation_rate(const Measurement& m);

// What supports carry.
Result<double> reaction_force(const Measurement& m);
Result<double> reaction_force_rate(const Measurement& m);
Result<double> reaction_moment(const Measurement& m);
Result<double> reaction_moment_rate(const Measurement& m);

// Rods.
Result<double> rod_curvature(const Measurement& m);
Result<double> rod_twist_rate(const Measurement& m);
Result<double> rod_bending_moment(const Measurement& m);
Result<double> rod_torque(const Measurement& m);
Result<double> rod_axial_strain(const Measurement& m);
Result<double> rod_axial_force(const Measurement& m);
Result<double> rod_largest_slope(const Measurement& m);
Result<double> rod_length(const Measurement& m);
Result<double> rod_rest_length(const Measurement& m);
Result<double> rod_mass(const Measurement& m);

// Membranes.
Result<double> membrane_line_stretch(const Measurement& m);
Result<double> membrane_angle(const Measurement& m);
Result<double> membrane_largest_stretch(const Measurement& m);
Result<double> membrane_smallest_stretch(const Measurement& m);
Result<double> membrane_tension(const Measurement& m);
Result<double> membrane_area(const Measurement& m);
Result<double> membrane_rest_area(const Measurement& m);
Result<double> membrane_height(const Measurement& m);
Result<double> membrane_energy(const Measurement& m);
Result<double> membrane_energy_density(const Measurement& m);
Result<double> membrane_bending_density(const Measurement& m);
Result<double> membrane_pre_stretch(const Measurement& m);
Result<double> membrane_bending_stiffness(const Measurement& m);

// What is fitted to fabric tests.
Result<double> fitted_stiffness_1(const Measurement& m);
Result<double> fitted_stiffness_2(const Measurement& m);
Result<double> fitted_poisson_ratio(const Measurement& m);
Result<double> fitted_shear(const Measurement& m);
Result<double> fitted_modulus(const Measurement& m);

// What a design becomes, and how a shape answers to it.
Result<double> designed_parameter(const Measurement& m);
Result<double> design_sensitivity(const Measurement& m);

// Cuts and rings.
Result<double> cut_force_all(const Measurement& m);
Result<double> cut_force_membranes(const Measurement& m);
Result<double> cut_force_rods(const Measurement& m);
Result<double> ring_stiffness(const Measurement& m);

// Elastic energies.
Result<double> energy_total(const Measurement& m);
Result<double> energy_stretch(const Measurement& m);
Result<double> energy_bending(const Measurement& m);
Result<double> energy_twist(const Measurement& m);

// Stability.
Result<double> critical_load_factor(const Measurement& m);
Result<double> critical_load(const Measurement& m);
Result<double> mode_stiffness(const Measurement& m);
Result<double> principal_stiffness(const Measurement& m);

// Vibration.
Result<double> natural_frequency(const Measurement& m);

// Shared by the families.

/// Nodes selected by the place of a measurement.
Result<std::vector<int>> selected_nodes(const Measurement& m, const Selector& at, const System& system);
/// The one node that is selected.
Result<int> selected_node(const Measurement& m, const System& system);
/// Component along the axis of the entry, or the norm without one.
double component_or_norm(const Measurement& m, const Vec3& v);

/// Pre-stretch of a membrane along its axes at the load factor of a situation.
Vec2 present_pre_stretch(const Situation& s, const StructureMembrane& membrane);
/// Elastic energy of the triangles and hinges of membranes whose vertices are all selected, J.
double cloth_energy(const Situation& s, const std::vector<bool>& selected);
/// The same of solids, of tetrahedra with all corners among the selected nodes.
double solid_energy(const Situation& s, const std::vector<bool>& selected);

/// Sums over selected nodes: forces on held positions; moments on held frames and rolls. `reaction` as in Situation.
Vec3 force_sum(const System& system, const VecX& reaction, const std::vector<int>& nodes);

}  // namespace lissom
