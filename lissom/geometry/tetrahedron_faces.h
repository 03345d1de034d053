#pragma once
/// The outer surface of a body of tetrahedra.

#include <array>
#include <span>
#include <vector>

namespace lissom {

/// Faces that belong to one tetrahedron only, anticlockwise seen from outside, in the order of the tetrahedra (t x 4), whose
/// corners a, b, c, d have (b - a) x (c - a) towards d.
std::vector<std::array<int, 3>> outer_faces(std::span<const std::array<int, 4>> tetrahedra);

}  // namespace lissom
