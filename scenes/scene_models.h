#pragma once
/// The scene functions, one subject per source file.

#include <span>
#include <string>

#include "lissom/model/model.h"

namespace lissom::scene_models {

struct WindmillAxis {
  std::string name;   ///< of the windmill, and of the set of its blades
  double radius = 0;  ///< m
};
/// Side by side, each with a set that holds its blades, and a motion "release".
Model windmills(std::span<const WindmillAxis> axes);

Model gridshell();
Model hexagon_sheet();
Model quad_sheet();
Model triangle_sheet();
Model honeycomb();
Model ring();
Model square_frame();
Model grid();
Model helix();
Model cantilever();
Model sphere();
/// `lean`: rad by which the meridians lean. Without any the sphere has no reason to turn one way or the other.
Model sphere_leaning(double lean);
Model windmill();

}  // namespace lissom::scene_models
