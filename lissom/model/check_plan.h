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

/// Remarks on what is possible but unusual: slack fabric, and printed rods that overlap for a while, away from the points
/// that they share. `r_b` (m) by node.
void note_plan(const Plan& plan, const PlanSamples& samples, const std::vector<double>& r_b,
               std::vector<std::string>& notes);

}  // namespace lissom
