#include "lissom/equilibrium/report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "lissom/mechanics/membrane_strain.h"

namespace lissom {

namespace {

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", x);
  return text;
}

/// Fabric pulls rods together and may lose its tension: the most compressed edge and the slackest triangle.
void find_worst_of_membranes(const StaticProblem& problem, Equilibrium& result) {
  const System& system = *problem.system;
  const Structure& structure = system.structure;
  WorstElement compression{"compression", "", -1, -1, 0, ""};
  for (int e = 0; e < system.edge_count(); ++e) {
    const double s = 1 - result.state.edges[e].length / system.rest.edges[e].length;
    if (s > compression.value) {
      compression = {compression.what, structure.rods[structure.edges[e].rod].name, -1, e, s, ""};
    }
  }
  if (compression.edge >= 0) result.worst.push_back(compression);
  const double share = problem.stretches_with_load ? result.state.load_factor : 1;
  const std::vector<TriangleStretch> stretches = triangle_stretches(system, result.state, share);
  const auto least = std::min_element(stretches.begin(), stretches.end(),
                                      [](const auto& a, const auto& b) { return a.smallest < b.smallest; });
  WorstElement slackest{"smallest stretch", "", -1, -1, least->smallest, "1"};
  slackest.triangle = static_cast<int>(least - stretches.begin());
  slackest.membrane = structure.membranes[structure.triangles[slackest.triangle].membrane].name;
  result.worst.push_back(slackest);
}

/// Slack fabric can fold in many ways that cost nearly the same, between which a solve may take very long.
std::string slack_reason(const Equilibrium& result) {
  for (const WorstElement& worst : result.worst) {
    if (worst.triangle < 0 || worst.value >= 1) continue;
    return "; the fabric has gone slack, least stretch " + number(worst.value) +
           ": make the rods thicker, or raise the pre-stretch and the radii together";
  }
  return {};
}

void find_worst(const StaticProblem& problem, const VecX& free_gradient, Equilibrium& result) {
  const System& system = *problem.system;
  const Structure& structure = system.structure;
  const auto rod_of = [&](int edge) { return structure.rods[structure.edges[edge].rod].name; };

  int worst_dof = -1;
  double worst_force = 0;
  const std::span<const int> kept = problem.supports.kept();
  for (int i = 0; i < static_cast<int>(kept.size()); ++i) {
    if (kept[i] < 0) continue;
    const bool position = system.layout.dof_class(i) == DofClass::kPosition;
    const double f = std::abs(free_gradient[kept[i]]) / (position ? 1 : system.rest.mean_edge_length);
    if (f > worst_force) {
      worst_force = f;
      worst_dof = i;
    }
  }
  if (worst_dof >= 0) {
    WorstElement worst{"unbalanced force", "", -1, -1, worst_force, "N"};
    if (worst_dof < 3 * system.layout.nodes()) {
      worst.node = worst_dof / 3;
    } else if (worst_dof < 3 * system.layout.nodes() + system.layout.edges()) {
      worst.edge = worst_dof - 3 * system.layout.nodes();
    } else {
      const int k = (worst_dof - 3 * system.layout.nodes() - system.layout.edges()) / 3;
      worst.node = structure.joints[system.layout.joint_of_rotation(k)].node;
    }
    for (int e = 0; e < system.edge_count() && worst.rod.empty(); ++e) {
      const StructureEdge& edge = structure.edges[e];
      if (e == worst.edge || edge.node0 == worst.node || edge.node1 == worst.node) worst.rod = rod_of(e);
    }
    result.worst.push_back(worst);
  }
  WorstElement strain{"axial strain", "", -1, -1, 0, ""}, turn{"turning angle", "", -1, -1, 0, "rad"};
  for (int e = 0; e < system.edge_count(); ++e) {
    const double s = result.state.edges[e].length / system.rest.edges[e].length - 1;
    if (strain.edge < 0 || std::abs(s) > std::abs(strain.value)) strain = {strain.what, rod_of(e), -1, e, s, ""};
  }
  for (const StructurePair& pair : structure.pairs) {
    const Vec3 &a = result.state.edges[pair.edge0].t, &b = result.state.edges[pair.edge1].t;
    const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
    if (turn.node < 0 || angle > turn.value) {
      turn = {turn.what, rod_of(pair.edge0), structure.edges[pair.edge0].node1, -1, angle, "rad"};
    }
  }
  if (strain.edge >= 0) result.worst.push_back(strain);
  if (turn.node >= 0) result.worst.push_back(turn);
  if (!structure.triangles.empty()) find_worst_of_membranes(problem, result);
}

}  // namespace

VecX reactions(const StaticProblem& problem, const VecX& local_gradient) {
  VecX reaction = local_gradient;
  for (int i = 0; i < reaction.size(); ++i) {
    if (!problem.supports.held_by_pose(i)) reaction[i] = 0;
  }
  problem.potential.to_global(reaction);
  return reaction;
}

void describe(const StaticProblem& problem, NewtonWorkspace& workspace, Equilibrium& result) {
  AssemblyBuffers buffers;
  VecX gradient, free_gradient;
  if (result.verdict != Verdict::kBadStart) {
    std::vector<double> shares(problem.potential.terms().size());
    result.energy = problem.potential.value(result.state, buffers, nullptr, shares);
    for (size_t t = 0; t < shares.size(); ++t) {
      result.energy_shares.push_back({std::string(problem.potential.terms()[t]->name()), shares[t]});
    }
    problem.potential.gradient(result.state, gradient, buffers);
    problem.supports.restrict(gradient, free_gradient);
    result.residual = workspace.residual(free_gradient);
    result.reaction = reactions(problem, gradient);
    find_worst(problem, free_gradient, result);
  }
  const VerdictInfo& info = verdict_info(result.verdict);
  result.message = std::string(info.sentence);
  switch (result.verdict) {
    case Verdict::kStable:
    case Verdict::kCritical:
    case Verdict::kUnstable:
      // Spins have next to no stiffness; where nothing worse is found they come first.
      if (const size_t first = result.verdict == Verdict::kStable ? static_cast<size_t>(result.spins) : 0;
          first < result.modes.size()) {
        result.message += "; lowest mode " + number(result.modes[first].stiffness) + " N/m";
      }
      if (result.spins > 0) {
        result.message += "; " + std::to_string(result.spins) +
                          (result.spins > 1 ? " straight rods turn about their" : " straight rod turns about its") +
                          " own axis without a force, which moves nothing";
      }
      break;
    case Verdict::kIterationLimit:
    case Verdict::kStalled:
    case Verdict::kRunaway:
    case Verdict::kCancelled:
      result.message += "; largest unbalanced force " + number(result.residual) + " N against " +
                        number(result.tolerance) + " N wanted";
      if (!result.worst.empty() && !result.worst.front().rod.empty()) {
        result.message += ", at rod " + result.worst.front().rod;
      }
      result.message += slack_reason(result);
      break;
    case Verdict::kBadStart:
      break;
  }
  if (result.start_smoothed) result.message += "; the start was crumpled and was smoothed first";
}

}  // namespace lissom
