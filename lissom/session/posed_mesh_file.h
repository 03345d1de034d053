#pragma once
/// What of a posed rod mesh its document does not hold, so that a later run need not pose it again.

#include <string>

#include "lissom/core/result.h"
#include "lissom/posing/posed_mesh.h"

namespace lissom {

/// Targets, the number of joints and notes; `hash` is that of the project.
std::string posed_mesh_text(const PosedMesh& mesh, const std::string& hash);

/// The other way round, for a model that was read from the document. kConflict where the text belongs to another project;
/// `where`: the file, for errors.
Result<PosedMesh> read_posed_mesh(const std::string& text, const std::string& hash, Model model,
                                  const std::string& where);

}  // namespace lissom
