#pragma once
/// The scene functions, one subject per source file.

#include "lissom/model/model.h"

namespace lissom::scene_models {

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

}  // namespace lissom::scene_models
