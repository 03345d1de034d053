#pragma once
/// Stretch and tension of one triangle of a membrane in a state, as people ask for them: principal stretches and Cauchy
/// tensions [mathematics 3.1]. The energy that a solver uses is in the energy terms; this is for reports and pictures.

#include <array>
#include <vector>

#include "lissom/core/types.h"
#include "lissom/mechanics/rest_state.h"
#include "lissom/mechanics/state.h"
#include "lissom/mechanics/system.h"
#include "lissom/model/pose.h"

namespace lissom {

/// Singular values of the deformation gradient F from the unstretched cloth to space.
struct TriangleStretch {
  Eigen::Matrix<double, 3, 2> gradient;  ///< F, columns along the material axes
  Eigen::Matrix2d rest_sides;            ///< m, from the first corner to the others, unstretched, along the axes
  double largest = 1, smallest = 1;      ///< principal stretches; smallest < 1: slack
  double rest_area = 0, area = 0;        ///< m^2, unstretched and now
};

/// Principal tensions per length as it is now (Cauchy), and the elastic energy.
struct TriangleTension {
  double largest = 0, smallest = 0;  ///< N/m, negative: compressed
  Vec3 direction = Vec3::UnitX();    ///< of the largest, unit
  double energy = 0;                 ///< J/m^2, per unstretched area
};

/// Part of the pre-stretch s that is there at a load factor: with `share` it is 1 + share (s - 1).
double stretch_share(const Pose& pose, double load_factor);

/// `now`: corners in space, m. `pre_stretch`: the full one, by which the rest corners were divided.
TriangleStretch triangle_stretch(const TriangleRest& rest, const std::array<Vec3, 3>& now, const Vec2& pre_stretch,
                                 double stretch_share = 1);

/// Of all triangles of the structure.
std::vector<TriangleStretch> triangle_stretches(const System& system, const State& state, double stretch_share);

/// Cauchy tension F S F' A / a in the plane of the triangle, as a matrix in space, N/m. `rest` for the moduli.
Mat3 cauchy_tension(const TriangleRest& rest, const TriangleStretch& stretch);

/// `rest` for the moduli.
TriangleTension triangle_tension(const TriangleRest& rest, const TriangleStretch& stretch);

}  // namespace lissom
