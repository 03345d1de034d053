#include "lissom/session/solved_remedy.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "lissom/equilibrium/branches.h"
#include "lissom/equilibrium/live_solver.h"
#include "lissom/mechanics/membrane_strain.h"
#include "lissom/session/warnings.h"

namespace lissom {

namespace {

constexpr int kRounds = 4;
constexpr double kRadiusStep = 0.16;  // of the radii, in the first round
constexpr double kTautEnough = 0.03;  // so much more stretch than wanted is no reason for another round

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

/// Solves trials from one slack shape.
class Trials {
 public:
  Trials(const Model& model, const Pose& pose, const std::string& where, const Equilibrium& slack,
         const SolveOptions& options, const Context& context)
      : model_(model), pose_(pose), where_(where), slack_(slack), options_(options), context_(context) {
    options_.modes = 0;
  }

  /// Nothing where the changed design does not settle.
  std::optional<SolvedRemedy> solve(const Vec2& present, double pre_stretch_factor, double radius_factor) const {
    const Model changed = remedied(model_, pre_stretch_factor, radius_factor);
    const Result<System> system = make_system(changed);
    if (!system || system.value().layout.size() != slack_.state.q.size()) return std::nullopt;
    const Result<StaticProblem> problem = make_static_problem(changed, system.value(), pose_, where_);
    if (!problem) return std::nullopt;
    const Equilibrium found = LiveSolver(problem.value(), options_, context_).resettle(slack_.state);
    if (found.verdict != Verdict::kStable) return std::nullopt;
    return SolvedRemedy{{pre_stretch_factor * present, radius_factor},
                        slackest_of(system.value(), found.state, 1).stretch,
                        shape_distance(problem.value(), slack_.state, found.state, Image::kItself)};
  }

 private:
  const Model& model_;
  const Pose& pose_;
  const std::string& where_;
  const Equilibrium& slack_;
  SolveOptions options_;
  const Context& context_;
};

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
  const auto balanced = [&](double factor) {
    return std::pow(flat_tension(moduli, factor * fabric.pre_stretch) / flat_tension(moduli, fabric.pre_stretch), 0.25);
  };
  const Trials trials(model, pose, where, slack, options, context);
  const auto solved = [&](double factor, double radii) { return trials.solve(fabric.pre_stretch, factor, radii); };
  // In turns: radii at which the shape moves least, then the pre-stretch that leaves it just taut.
  std::optional<SolvedRemedy> taut;
  double factor = wanted / before.stretch, share = 1, step = kRadiusStep;  // share: of radii, over those in balance
  for (int round = 0; round < kRounds; ++round, step /= 2) {
    std::optional<SolvedRemedy> best = solved(factor, share * balanced(factor));
    if (!best) break;
    for (const double side : {1 + step, 1 / (1 + step)}) {
      const std::optional<SolvedRemedy> other = solved(factor, side * share * balanced(factor));
      if (!other || other->moved >= best->moved) continue;
      best = other;
      share *= side;
      break;
    }
    if (best->smallest_stretch >= enough) taut = best;
    if (taut && best->smallest_stretch < wanted + kTautEnough) break;
    factor *= wanted / best->smallest_stretch;
  }
  return taut;
}

std::string solved_remedy_text(const SolvedRemedy& solved) {
  const Vec2& to = solved.remedy.pre_stretch;
  const std::string stretch =
      to.x() == to.y() ? fmt::format("{:.4g}", to.x()) : fmt::format("{:.4g} x {:.4g}", to.x(), to.y());
  return fmt::format(
      "{}raise the pre-stretch to {} and multiply all radii by {:.4g}: solved so, the smallest stretch is {:.4g} and "
      "the "
      "shape moves by {:.2g} mm",
      kEstimatedRemedy, stretch, solved.remedy.radius_factor, solved.smallest_stretch, 1e3 * solved.moved);
}

}  // namespace lissom
