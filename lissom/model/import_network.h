#pragma once
/// From a line network (OBJ `l` elements) to a model: rods along the lines, a joint at each shared point.

#include <string>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/geometry/obj_lines.h"
#include "lissom/model/model.h"

namespace lissom {

struct NetworkOptions {
  double scale = 1;  ///< m per unit of the file: 0.001 for millimetres
  std::string material = "GFRP";
  SectionProfile section;  ///< of every rod
  MaterialAxes axes;       ///< of every rod
  JointKind joint_kind = JointKind::kExplicit;
  int edges_per_segment = 4;  ///< of each straight piece of the drawing
  NetworkRods rods = NetworkRods::kChains;
  double chain_angle = kChainAngle;  ///< rad
};

struct ImportedNetwork {
  Model model;                     ///< rods r1, r2, ... in the order of the file
  Vec3 extent = Vec3::Zero();      ///< m, sides of the bounding box: check it, a wrong unit shows here
  std::vector<std::string> notes;  ///< what was left out of the drawing
};

/// Points closer than 1e-6 of the size are one; lines without length and repeated lines are left out, with a note.
Result<ImportedNetwork> import_network(const ObjLines& lines, const NetworkOptions& options);

}  // namespace lissom
