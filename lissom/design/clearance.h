#pragma once
/// Room between rods: a wish that rods which share no joint keep a gap, so that they can be printed side by side.

#include <vector>

#include "lissom/design/design_space.h"
#include "lissom/design/goal.h"

namespace lissom {

/// Two edges that have to keep apart.
struct EdgePair {
  int edge0 = -1, edge1 = -1;
  double at0 = 0, at1 = 0;         ///< where they are nearest as drawn, 0 to 1 along each
  Vec3 direction = Vec3::UnitX();  ///< of unit length, from there to there
  double distance = 0;             ///< m, between the centrelines
};

/// Places of two rods belong to one joint where the way along the rods, over a single rod between, is at most so many times
/// as long as the half-widths of both: all of it would be joint. The check of prints (fabrication/near_rods.h) counts the gap
/// to the widths.
constexpr double kJointDetour = 1.8;

/// Of every edge the nearest edge of each rod within `within` (m) whose rod shares no node with its own. Left out is what
/// belongs to one joint however thin the rods get, down to a half-width of `least_extent` (m): wherever the check of prints
/// may see two, the pair is there.
std::vector<EdgePair> edges_side_by_side(const Structure& structure, double within, double least_extent);

/// Residuals of pairs that are nearer than `gap` (m), 0 for all others: what is missing over the gap. Distances are taken along
/// the direction in which two edges are nearest as drawn, and the half-width of a section in a direction u is counted as
/// r_n |n u| + r_b |b u|: neither is ever too favourable, and both are linear in radii and places. No rows where nothing
/// can come near.
ParameterGoal make_clearance(const Design& base, const DesignSpace& space, double gap);

}  // namespace lissom
