#pragma once
/// A project as a structure: rods on the surface, held in each pose where the surface ends, with the wanted shapes as goals.

#include <map>
#include <string>
#include <vector>

#include "lissom/core/context.h"
#include "lissom/geometry/obj_lines.h"
#include "lissom/geometry/surface_network.h"
#include "lissom/model/model.h"
#include "lissom/model/rod_mesh.h"

namespace lissom {

/// What the files of a project hold, m.
struct ProjectFiles {
  Surface surface;
  std::map<std::string, std::vector<Vec3>> posed;  ///< vertices of posed surfaces, by the file's name
  std::optional<ObjLines> drawn;
};

struct PosedMesh {
  /// Rods, a pose for each of the project, and the brief with a goal for each that is not held back.
  Model model;
  std::vector<std::vector<Vec3>> targets;  ///< per pose and node of the structure, m
  int joints = 0;
  std::vector<std::string> notes;
};

/// Where a pose of the surface is held or pulled, rods are held at the places where it ends; supports that hold some directions
/// only, such as a table on which everything slides, hold the rods themselves.
/// Errors are those of the parts, with the place in the project.
Result<PosedMesh> pose_rod_mesh(const RodMeshProject& project, const ProjectFiles& files, const Context& context);

}  // namespace lissom
