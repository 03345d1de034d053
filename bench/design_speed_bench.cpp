/// How fast the three designs of the gallery come to rest: cold, and after changes of many sizes; and what the time goes
/// into, on two threads. Medians; rows of name, metric, value, unit.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "bench/timing.h"
#include "lissom/core/file_io.h"
#include "lissom/design/live_design.h"
#include "lissom/equilibrium/newton_workspace.h"
#include "lissom/model/document.h"

namespace lissom {
namespace {

constexpr int kRepeats = 5;       // of changes
constexpr int kPartRepeats = 25;  // of parts of an iteration, which take milliseconds

struct Change {
  const char* name;
  void (*apply)(Plan&, double sign);
};

/// A point well inside of the plan: the one nearest to the middle of all.
PlanPoint& middle_point(Plan& plan) {
  Vec2 middle = Vec2::Zero();
  for (const PlanPoint& point : plan.points) middle += point.at / static_cast<double>(plan.points.size());
  return *std::min_element(plan.points.begin(), plan.points.end(), [&](const PlanPoint& a, const PlanPoint& b) {
    return (a.at - middle).squaredNorm() < (b.at - middle).squaredNorm();
  });
}

void scale_radii(Plan& plan, double factor) {
  for (PlanPoint& point : plan.points) point.r_n *= factor;
}

constexpr Change kChanges[] = {
    {"a control point 1 mm", [](Plan& p, double sign) { middle_point(p).at.x() += sign * 1e-3; }},
    {"r_n at a point 2 %", [](Plan& p, double sign) { middle_point(p).r_n *= 1 + sign * 0.02; }},
    {"r_n 2 %", [](Plan& p, double sign) { scale_radii(p, 1 + sign * 0.02); }},
    {"pre-stretch 0.01", [](Plan& p, double sign) { p.fabric.pre_stretch.array() += sign * 0.01; }},
    {"r_n 10 %", [](Plan& p, double sign) { scale_radii(p, 1 + sign * 0.1); }},
    {"pre-stretch 0.05", [](Plan& p, double sign) { p.fabric.pre_stretch.array() += sign * 0.05; }},
};

/// One iteration taken apart at an equilibrium: what factorisation and solve cost, and all else.
void measure_parts(const std::string& name, const LiveDesign& design, const Context& context) {
  NewtonWorkspace workspace(design.problem(), context);
  const State& state = design.equilibrium().state;
  VecX x;
  const double assembly = median_ms(kPartRepeats, [&] { workspace.assemble(state); });
  const double factor = median_ms(kPartRepeats, [&] { workspace.factorize(0); });
  const double solve = median_ms(kPartRepeats, [&] { workspace.factor().solve(workspace.free_gradient(), x); });
  const double energy = median_ms(kPartRepeats, [&] { workspace.energy(state); });
  row(name, "assembly of the Hessian", assembly, "ms");
  row(name, "factorisation", factor, "ms");
  row(name, "solve", solve, "ms");
  row(name, "energy of a trial", energy, "ms");
  row(name, "plain iteration over factorisation and solve", (assembly + factor + solve + energy) / (factor + solve),
      "");
}

void measure(const std::string& name, const Context& context) {
  const Result<std::string> text = read_file("scenes/data/fabric/" + name + ".lissom");
  const Result<Model> model = text ? read_document(text.value()) : Result<Model>(text.error());
  if (!model) {
    std::fprintf(stderr, "%s: %s\n", name.c_str(), model.error().text().c_str());
    return;
  }
  LiveDesign::Options options;
  options.solve.modes = 0;
  std::unique_ptr<LiveDesign> design;
  const double cold =
      median_ms(3, [&] { design = std::move(LiveDesign::make(model.value(), 0, options, context)).value(); });
  row(name, "fabric nodes", static_cast<double>(design->mesh()->as_made().mesh().points.size()), "");
  row(name, "unknowns", design->problem().supports.unknowns(), "");
  row(name + ", cold", "time with meshing", cold, "ms");
  row(name + ", cold", "factorizations", design->equilibrium().factorizations, "");
  row(name + ", cold", "stable", design->equilibrium().verdict == Verdict::kStable, "");
  measure_parts(name, *design, context);
  for (const Change& change : kChanges) {
    std::vector<double> times, factorizations;
    int jumps = 0, meshes = 0;
    for (int k = 0; k < kRepeats; ++k) {
      for (const double sign : {1.0, 0.0}) {  // there, and back to the start
        Model changed = model.value();
        change.apply(*changed.plan, sign);
        const double begin = now_ms();
        const Result<DesignChange> result = design->change(changed);
        const double time = now_ms() - begin;
        if (!result) {
          std::fprintf(stderr, "%s, %s: %s\n", name.c_str(), change.name, result.error().text().c_str());
          continue;
        }
        times.push_back(time);
        factorizations.push_back(design->equilibrium().factorizations);
        jumps += result.value().following.jumped;
        meshes += result.value().remeshed;
      }
    }
    if (times.empty()) continue;
    std::sort(times.begin(), times.end());
    const std::string label = name + ", " + change.name;
    row(label, "time", times[times.size() / 2], "ms");
    row(label, "factorizations, most", *std::max_element(factorizations.begin(), factorizations.end()), "");
    row(label, "jumps", jumps, "");
    row(label, "new meshes", meshes, "");
  }
}

}  // namespace
}  // namespace lissom

int main() {
  lissom::ThreadPool threads(2);
  lissom::Context context;
  context.threads = &threads;
  for (const char* name : {"butterfly", "mask", "car"}) lissom::measure(name, context);
  return 0;
}
