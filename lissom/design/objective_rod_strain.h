#pragma once
/// Rods that must not break: the largest strain of their sections.

#include <memory>
#include <vector>

#include "lissom/design/objective.h"

namespace lissom {

/// One component, dimensionless, for every place where these rods (numbers in Structure::rods; none: all) bend: inner nodes
/// between two edges (Structure::pairs), then ends at joints and clamps (System::connections), both in their order. It is the
/// von Mises stress over Young's modulus of section_strain.h, with the strains against rest over the length that the
/// bending energy has there, and the axial strain of the edges beside. Half-extents follow from rest numbers, as roots of the
/// ratio of bending and axial stiffness. A rod of a single edge without joints bends nowhere and has no component.
std::shared_ptr<const Objective> make_rod_strain(const System& system, const std::vector<int>& rods = {});

}  // namespace lissom
