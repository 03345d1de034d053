#pragma once
/// The rods of a plan cut into edges: equidistant parameters between neighbouring points of a rod, so that the points of
/// the plan are nodes [mathematics 6.2].

#include <string>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/model/plan.h"

namespace lissom {

struct PlanSamples {
  /// m, (n x 2): the points of the plan first, in their order, then the inner nodes of each piece, rod by rod.
  std::vector<Vec2> nodes;
  std::vector<std::vector<int>> rods;    ///< nodes of each rod, in order; a closed one does not repeat its first
  std::vector<std::vector<int>> pieces;  ///< edges of each piece of each rod, at least 1

  /// Number of pieces of the plan's rods before this one's, then its own: `use(rod, piece, step, steps, node)` for all
  /// inner nodes in the order of their numbers.
  template <class Use>
  void each_inner(std::size_t points, const Use& use) const {
    std::size_t node = points;
    for (std::size_t r = 0; r < pieces.size(); ++r) {
      for (std::size_t k = 0; k < pieces[r].size(); ++k) {
        for (int step = 1; step < pieces[r][k]; ++step) use(r, static_cast<int>(k), step, pieces[r][k], node++);
      }
    }
  }
};

/// Number of pieces between the points of a rod.
inline int piece_count(const PlanRod& rod) { return static_cast<int>(rod.points.size()) - (rod.closed ? 0 : 1); }

/// Ends of a piece of an arc and the third point of its circle, as places in PlanRod::points. Arcs take turns: points
/// 0, 1, 2, then 2, 3, 4, ...; closed with three points: one circle.
struct ArcPiece {
  std::size_t from = 0, to = 0, other = 0;
};
ArcPiece arc_piece(const PlanRod& rod, int piece);

/// Cuts every rod, ghosts too. `refine` multiplies every number of edges. The plan has passed validate_plan.
Result<PlanSamples> sample_plan(const Plan& plan, double refine);

}  // namespace lissom
