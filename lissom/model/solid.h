#pragma once
/// Elastic bodies as the user describes them: tetrahedra of one material, with maps of how stiff and how heavy they are.
/// Rods and membranes share nodes with a solid wherever their nodes and its points coincide.

#include <array>
#include <string>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/core/types.h"
#include "lissom/model/material.h"

namespace lissom {

struct Solid {
  std::string name;
  std::vector<Vec3> points;  ///< m, (n x 3)
  /// (t x 4), each with (b - a) x (c - a) towards d: from d its first three corners run clockwise.
  std::vector<std::array<int, 4>> tetrahedra;
  std::string material;                ///< name in Model::materials or in the library; Poisson's ratio below 0.5
  std::vector<double> stiffness = {};  ///< by tetrahedron, multiplies Young's modulus; empty: 1 everywhere
  std::vector<double> density = {};    ///< by tetrahedron, multiplies the density; empty: 1 everywhere
};

/// Refuses, with the place below `where` of the solid: no tetrahedron, corners that are no points, points that belong to no
/// tetrahedron, tetrahedra without volume or inside out, maps of another length or with impossible numbers.
Status check_solid_mesh(const Solid& solid, const std::string& where);

/// Refuses one tetrahedron (corners, m) without volume or inside out.
Status check_tetrahedron(const std::array<Vec3, 4>& corners, const std::string& where);

/// Refuses a material whose volume cannot change, nu = 0.5; `where`: of its name in the solid.
Status check_solid_material(const Material& material, const std::string& where);

}  // namespace lissom
