#pragma once
/// Better places for the inner vertices of a flat triangle mesh; the triangles stay the same and stay anticlockwise.

#include <array>
#include <vector>

#include "lissom/core/types.h"

namespace lissom {

/// Smallest angle of the triangle, rad; negative when it is clockwise.
double smallest_angle(const Vec2& a, const Vec2& b, const Vec2& c);

/// Moves every vertex from number `fixed` on to the mean of its neighbours, one after the other, unless that makes a
/// triangle worse than the worst around it.
void even_out(std::vector<Vec2>& points, std::size_t fixed, const std::vector<std::array<int, 3>>& triangles);

/// Moves the vertices around triangles with an angle below `angle` (rad) so that the smallest angle around each vertex
/// grows. Does nothing where all angles are larger.
void open_worst_angles(std::vector<Vec2>& points, std::size_t fixed, const std::vector<std::array<int, 3>>& triangles,
                       double angle);

}  // namespace lissom
