#pragma once
/// Where rods run alone, so that sections can be strung into tubes, and where they are with others, so that the surface of
/// their union has to be looked for.

#include <vector>

#include "lissom/fabrication/rod_field.h"

namespace lissom {

/// Stations first to last of a piece, which nothing else comes near.
struct FreeSpan {
  int piece = 0;
  int first = 0, last = 0;
  /// Clusters that its ends are joined to; -1: a free end, cut off flat. A closed piece that is free all around has none.
  std::array<int, 2> cluster{-1, -1};
};

/// Parts of rods that are near each other.
struct RodCluster {
  double cell = 0;               ///< m
  std::vector<FieldPart> parts;  ///< they reach `kStub` cells into the spans, and end there flat
};

struct SolidPlan {
  std::vector<FreeSpan> spans;
  std::vector<RodCluster> clusters;
  /// At least 1: cells were made so much larger to keep the number of triangles within reason.
  double coarser = 1;
};

inline constexpr double kStub = 2.5;  ///< cells
inline constexpr double kPlay = 0.3;  ///< cells, that its end may be moved by
inline constexpr double kLip = 1;     ///< cells, from there to the first ring

/// Whether tubes are wanted at all; without, everything is one way of finding surfaces.
enum class Tubes { kYes, kNo };

/// `finer` divides all cells. Rotates closed pieces such that a span does not go over their seam.
SolidPlan plan_solid(std::vector<RodPiece>& pieces, double tolerance, double finer, Tubes tubes);

}  // namespace lissom
