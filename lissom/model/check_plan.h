#pragma once
/// What can be wrong with a plan, in three steps: as written, as drawn, as meshed. Places are JSON pointers.

#include <string>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/geometry/planar_mesh.h"
#include "lissom/model/model.h"
#include "lissom/model/plan_sampling.h"

namespace lissom {

/// As written: names resolve, numbers are possible, rods have enough points, points do not coincide.
Status check_plan(const Model& model);

/// As drawn: rods meet at common points only and keep apart elsewhere, holes lie in openings.
Status check_plan_drawing(const Plan& plan, const PlanSamples& samples);

/// As meshed: every rod lies on the fabric, and the fabric is in one piece.
Status check_plan_mesh(const Plan& plan, const PlanSamples& samples, const PlanarMesh& mesh);

/// Remarks on what is possible but unusual.
void note_plan(const Plan& plan, std::vector<std::string>& notes);

}  // namespace lissom
