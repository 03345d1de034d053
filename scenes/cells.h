#pragma once
/// Single cells of rods, a triangle, a square and a hexagon: how easily a corner moves [thesis, figure 5.2].

#include <span>
#include <string_view>
#include <vector>

#include "lissom/model/model.h"

namespace lissom::scene_models {

struct CellShape {
  std::string_view name;
  int corners = 0;
  int moved = 0;  ///< the corner that is moved, from the left end of the lower side on, anticlockwise
};
/// Triangle, square, hexagon.
std::span<const CellShape> cell_shapes();

constexpr double kCellSide = 0.03;  // m

/// Corners of a cell whose sides are kCellSide long, its lower side about the origin, m.
std::vector<Vec2> cell_corners(const CellShape& shape);

/// Round rods of TPU, 2 mm thick, joined at the corners, kept in their plane. Both ends of the lower side are held, and the
/// corner to be moved is moved by `by` (m).
Model moved_cell(const CellShape& shape, const Vec2& by);

/// Holds everything in the x-y plane.
Support held_in_plane();

}  // namespace lissom::scene_models
