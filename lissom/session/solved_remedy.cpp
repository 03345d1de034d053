#include "lissom/session/solved_remedy.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "lissom/equilibrium/branches.h"
#include "lissom/equilibrium/live_solver.h"
#include "lissom/mechanics/membrane_strain.h"

namespace lissom {

namespace {

constexpr int kTrials = 4;

struct Slackest {
  double stretch = std::numeric_limits<double>::infinity();
  int triangle = -1;
};

Slackest slackest_of(const System& system, const State& state, double share) {
  Slackest slackest;
  const std::vector<TriangleStretch> stretches = triangle_stretches(system, state, share);
  for (std::size_t t = 0; t < stretches.size(); ++t) {
    if (stretches[t].smallest < slackest.stretch) slackest = {stretches[t].smallest, static_cast<int>(t)};
  }
  return slackest;
}

}  // namespace

Model remedied(const Model& model, double pre_stretch_factor, double radius_factor) {
  Model changed = model;
  for (Membrane& membrane : changed.membranes) membrane.pre_stretch *= pre_stretch_factor;
  for (Rod& rod : changed.rods) {
    for (double& r : rod.section.r_n) r *= radius_factor;
    for (double& r : rod.section.r_b) r *= radius_factor;
    rod.section.wall *= radius_factor;
  }
  if (changed.plan) {
    changed.plan->fabric.pre_stretch *= pre_stretch_factor;
    for (PlanPoint& point : changed.plan->points) {
      point.r_n *= radius_factor;
      point.r_b *= radius_factor;
    }
  }
  return changed;
}

std::optional<SolvedRemedy> solved_remedy(const Model& model, const Pose& pose, const std::string& where,
                                          const Equilibrium& slack, double enough, double wanted,
                                          const SolveOptions& options, const Context& context) {
  if (slack.verdict != Verdict::kStable || model.membranes.size() + (model.plan ? 1 : 0) != 1) return std::nullopt;
  const Result<System> first = make_system(model);
  if (!first || pose.stretch_scaling != Scaling::kConstant) return std::nullopt;
  const Slackest before = slackest_of(first.value(), slack.state, 1);
  const StructureMembrane& fabric = first.value().structure.membranes.front();
  const TriangleRest& moduli = first.value().rest.triangles[before.triangle];
  SolveOptions quick = options;
  quick.modes = 0;
  double factor = wanted / before.stretch;
  for (int trial = 0; trial < kTrials; ++trial) {
    SolvedRemedy solved;
    solved.remedy.pre_stretch = factor * fabric.pre_stretch;
    solved.remedy.radius_factor =
        std::pow(flat_tension(moduli, solved.remedy.pre_stretch) / flat_tension(moduli, fabric.pre_stretch), 0.25);
    if (!std::isfinite(solved.remedy.radius_factor)) return std::nullopt;
    const Model changed = remedied(model, factor, solved.remedy.radius_factor);
    const Result<System> system = make_system(changed);
    if (!system || system.value().layout.size() != first.value().layout.size()) return std::nullopt;
    const Result<StaticProblem> problem = make_static_problem(changed, system.value(), pose, where);
    if (!problem) return std::nullopt;
    LiveSolver solver(problem.value(), quick, context);
    const Equilibrium found = solver.resettle(slack.state);
    if (found.verdict != Verdict::kStable) return std::nullopt;
    solved.smallest_stretch = slackest_of(system.value(), found.state, 1).stretch;
    if (solved.smallest_stretch >= enough) {
      solved.moved = shape_distance(problem.value(), slack.state, found.state, Image::kItself);
      return solved;
    }
    factor *= wanted / solved.smallest_stretch;
  }
  return std::nullopt;
}

std::string solved_remedy_text(const SolvedRemedy& solved) {
  const Vec2& to = solved.remedy.pre_stretch;
  const std::string stretch =
      to.x() == to.y() ? fmt::format("{:.4g}", to.x()) : fmt::format("{:.4g} x {:.4g}", to.x(), to.y());
  return fmt::format(
      "solved with a pre-stretch of {} and all radii times {:.4g}: the smallest stretch is {:.4g} and the shape moves by {:.2g} mm",
      stretch, solved.remedy.radius_factor, solved.smallest_stretch, 1e3 * solved.moved);
}

}  // namespace lissom
