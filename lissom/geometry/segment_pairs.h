#pragma once
/// Which of many segments in the plane come near each other: a grid instead of all pairs.

#include <array>
#include <span>
#include <vector>

#include "lissom/core/types.h"

namespace lissom {

/// Shortest distance between the segments a b and c d, m; 0 when they cross or touch.
double segment_distance(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d);

/// Pairs (i, j), i < j, ascending, of segments whose distance is at most `distance` (m). Segments are pairs of points; those
/// that share one are pairs too.
std::vector<std::array<int, 2>> near_segments(std::span<const Vec2> points,
                                              std::span<const std::array<int, 2>> segments, double distance);

}  // namespace lissom
