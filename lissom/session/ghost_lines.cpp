#include "lissom/session/ghost_lines.h"

#include <algorithm>

#include "lissom/model/expand_plan.h"

namespace lissom {

std::vector<std::vector<Vec3>> ghost_lines(const Model& model, const System& system, const State& state) {
  std::vector<std::vector<Vec3>> lines;
  if (!model.plan) return lines;
  const std::vector<StructureMembrane>& membranes = system.structure.membranes;
  const auto fabric = std::find_if(membranes.begin(), membranes.end(),
                                   [](const StructureMembrane& m) { return m.name == kFabricName; });
  const Result<PlanSamples> samples = sample_plan(*model.plan, 1);
  if (!samples || fabric == membranes.end()) return lines;
  for (size_t r = 0; r < model.plan->rods.size(); ++r) {
    const PlanRod& rod = model.plan->rods[r];
    if (rod.role != PlanRole::kGhost) continue;
    std::vector<Vec3> line;
    for (const int node : samples.value().rods[r]) line.push_back(state.position(fabric->nodes[node]));
    if (rod.closed) line.push_back(line.front());
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace lissom
