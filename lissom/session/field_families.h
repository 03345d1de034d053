#pragma once
/// Values of the list in fields.cpp that have a file of their own, by subject.

#include <vector>

#include "lissom/mechanics/membrane_strain.h"
#include "lissom/session/fields.h"

namespace lissom {

// Per triangle of the structure.
std::vector<double> largest_stretch(const FieldSource& source);
std::vector<double> smallest_stretch(const FieldSource& source);
std::vector<double> largest_tension(const FieldSource& source);
std::vector<double> smallest_tension(const FieldSource& source);
std::vector<double> slack(const FieldSource& source);
std::vector<double> membrane_energy_density(const FieldSource& source);

// Per node; NaN where there is no joint.
std::vector<double> joint_force(const FieldSource& source);
std::vector<double> joint_moment(const FieldSource& source);

/// Positions of all nodes, m.
std::vector<Vec3> node_positions(const FieldSource& source);
/// Of every triangle.
std::vector<TriangleStretch> triangle_stretches(const FieldSource& source);
std::vector<TriangleTension> triangle_tensions(const FieldSource& source);

}  // namespace lissom
