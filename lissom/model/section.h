#pragma once
/// Cross-sections of rods and the stiffnesses that follow from them.

#include "lissom/core/result.h"
#include "lissom/model/material.h"

namespace lissom {

enum class SectionShape {
  kEllipse,    ///< half-axes r_n, r_b
  kRectangle,  ///< flat lath: half-thickness r_n, half-width r_b
  kTube,       ///< round tube: outer radius r_n = r_b, wall thickness
};

enum class TorsionModel {
  kSaintVenant,  ///< what a printed rod does (default)
  kPolar,        ///< G times the polar second moment; erratum E6 of the mathematics, needed to match the thesis
};

/// One cross-section. r_n is the half-extent along the material axis n (out of plane), r_b along b (in plane).
struct Section {
  SectionShape shape = SectionShape::kEllipse;
  double r_n = 0;   ///< m
  double r_b = 0;   ///< m
  double wall = 0;  ///< m, tubes only

  Status validate(const std::string& where) const;
};

/// Stiffness and inertia of a rod per unit length at one place. T: double or a dual.
template <class T>
struct SectionStiffnessT {
  T stretch = 0;       ///< E A, N
  T bend_b = 0;        ///< bending whose deflection is along b (kappa_1), N m^2: E A r_b^2 / 4 for an ellipse
  T bend_n = 0;        ///< bending whose deflection is along n (kappa_2), N m^2: E A r_n^2 / 4 for an ellipse
  T twist = 0;         ///< beta, N m^2
  T mass = 0;          ///< rho A, kg/m
  T roll_inertia = 0;  ///< rho times the polar second moment of area, kg m
};
using SectionStiffness = SectionStiffnessT<double>;

/// Erratum E5 (order of the bending stiffnesses), E6 (torsion) and E7 (roll inertia) of the mathematics apply.
SectionStiffness section_stiffness(const Section& section, const Material& material, TorsionModel torsion);

}  // namespace lissom
