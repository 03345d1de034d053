#pragma once
/// Rods as printers see them: smooth centrelines with sections that turn and change evenly, cut where a rod has a kink.

#include <array>
#include <vector>

#include "lissom/model/structure.h"

namespace lissom {

/// A cross-section of a piece. (b, n, t) is right-handed: t x b = n.
struct RodStation {
  Vec3 centre = Vec3::Zero();                                    ///< m
  Vec3 t = Vec3::UnitX(), b = Vec3::UnitY(), n = Vec3::UnitZ();  ///< unit
  double r_b = 0, r_n = 0;                                       ///< m, half-extents along b and n
  double along = 0;                                              ///< m, length of the piece up to here

  /// m, radius of the circle around the section.
  double reach(SectionShape shape) const;
  /// m, the least radius of curvature of an elliptic outline; the thinner half-extent of others.
  double least_radius(SectionShape shape) const;
};

/// How a piece ends: cut off at its last station, or rounded beyond it where it meets others.
enum class PieceEnd { kFlat, kRound };

/// A rod, or the part of one between kinks.
struct RodPiece {
  int rod = -1;  ///< of the structure
  SectionShape shape = SectionShape::kEllipse;
  bool closed = false;  ///< then the last station is the first again, up to half a turn of b and n
  std::array<PieceEnd, 2> end{PieceEnd::kFlat, PieceEnd::kFlat};
  std::vector<RodStation> stations;       ///< at least two, `along` ascending
  std::vector<std::array<int, 2>> nodes;  ///< node of the structure, station; in the order of stations

  double length() const { return stations.back().along; }  ///< m
};

/// m, how far apart cells and stations are where the radius of curvature of a surface is `radius` (m) and chords may be
/// `tolerance` (m) off: two thirds of the chord of a circle with that height, at most half the thinner half-extent.
double surface_spacing(double radius, double thinnest, double tolerance);

/// Of all rods, in their order. Centrelines are C1 through the nodes: each tangent is that of the parabola through a node
/// and its two neighbours; turns above 35 degrees are kinks. Axes and half-extents are those of the edges at their middles
/// and means at the nodes, linear in between.
std::vector<RodPiece> rod_pieces(const Structure& structure, double tolerance);

/// Stations between `first` and `last` (both included) between which the surface is straight within `deviation` (m).
std::vector<int> ring_stations(const RodPiece& piece, int first, int last, double deviation);

}  // namespace lissom
