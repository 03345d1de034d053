#pragma once
/// Flexible rod meshes to be designed, with their surfaces [thesis, chapter 5 and table 5.1].

#include <span>
#include <string>
#include <string_view>

#include "lissom/core/result.h"
#include "lissom/geometry/surface.h"
#include "lissom/model/rod_mesh.h"

namespace lissom::scene_models {

struct RodMeshExample {
  RodMeshProject project;  ///< its surface's file is written in millimetres
  Surface surface;
};

struct RodMeshExampleInfo {
  std::string_view name, description;
  Result<RodMeshExample> (*make)();
};
std::span<const RodMeshExampleInfo> rod_mesh_examples();

/// A hat: soft in front in three poses, even under gravity, soft on the left in the fifth.
Result<RodMeshExample> hat_example();
/// A dinosaur with a soft tail, soft legs and a heavy head.
Result<RodMeshExample> dinosaur_example();
/// A sheet with a serious face that smiles when it is pulled.
Result<RodMeshExample> smiley_example();

}  // namespace lissom::scene_models
