#pragma once
/// Random rods on random pre-stretched fabric, for asking how often the whole way from a plan to a shape works.

#include "lissom/model/model.h"

namespace lissom::scene_models {

/// What the numbers are drawn from. Rods: 3 to 40, of any material of the library. Outlines: circles, polygons
/// and blobs of 50 to 400 mm, in one or several rods, some of them ghosts. Inside: straight and curved rods from point to
/// point, free ends, rods that float on the fabric by themselves, rings, holes in rings; points that are split; ghosts.
/// Fabrics: those of the library and orthotropic ones of 0.25 to 60 N/m, stretched by 1.05 to 1.8 along each axis. Radii:
/// such that the fabric pulls with 0.5 to 50 times the force that buckles a rod as long as the plan.
struct RandomPlanSize {
  int least_nodes = 250, most_nodes = 1200;  ///< of the fabric, roughly
  int least_rods = 3, most_rods = 40;
};

/// The same for the same seed, on every platform. One pose, "released". The title says what is in it.
Model random_plan(unsigned seed, const RandomPlanSize& size = {});

}  // namespace lissom::scene_models
