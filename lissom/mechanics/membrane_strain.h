#pragma once
/// Stretch and tension of one triangle of a membrane in a state, as people ask for them: principal stretches and Cauchy
/// tensions [mathematics 3.1]. The energy that a solver uses is in the energy terms; this is for reports and pictures.

#include <array>
#include <vector>

#include "lissom/core/types.h"
#include "lissom/model/membrane.h"
#include "lissom/model/structure.h"

namespace lissom {

/// Singular values of the deformation gradient F from the unstretched cloth to space.
struct TriangleStretch {
  Eigen::Matrix<double, 3, 2> gradient;  ///< F, columns along the material axes
  double largest = 1, smallest = 1;      ///< principal stretches; smallest < 1: slack
  double rest_area = 0, area = 0;        ///< m^2, unstretched and now
};

/// Principal tensions per length as it is now (Cauchy), and the elastic energy.
struct TriangleTension {
  double largest = 0, smallest = 0;  ///< N/m, negative: compressed
  Vec3 direction = Vec3::UnitX();    ///< of the largest, unit
  double energy = 0;                 ///< J/m^2, per unstretched area
};

/// Corners of the unstretched triangle along the material axes, m: those of the drawing divided by the pre-stretch.
std::array<Vec2, 3> rest_corners(const Structure& structure, const StructureTriangle& triangle);

/// `positions`: of all nodes, m.
TriangleStretch triangle_stretch(const Structure& structure, const StructureTriangle& triangle,
                                 const std::vector<Vec3>& positions);

TriangleTension triangle_tension(const MembraneMaterial& material, const TriangleStretch& stretch);

}  // namespace lissom
