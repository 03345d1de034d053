#pragma once
/// Where the rods of a random plan run.

#include <vector>

#include "scenes/plan_sketch.h"
#include "scenes/random_numbers.h"

namespace lissom::scene_models {

struct RandomRods {
  PlanSketch sketch;
  double extent = 0;       ///< m, larger one of the outline
  double edge_length = 0;  ///< m, with which the fabric has about the nodes asked for
  std::size_t outline_rods = 0;
  const char* outline = "";  ///< what kind it is
  std::vector<Vec2> holes;
};

/// At least three rods, and as many as asked for where there is room for them.
RandomRods draw_random_rods(RandomNumbers& random, double fabric_nodes, int rods);

}  // namespace lissom::scene_models
