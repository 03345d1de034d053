/// Solves of deformers: a toy of about 10,000 tetrahedra and a hat of about 1,500 vertices, pulled far. Rows of name, metric,
/// value, unit.

#include <string>

#include "bench/deformers.h"
#include "bench/first_pose.h"
#include "bench/timing.h"
#include "lissom/equilibrium/solve.h"
#include "lissom/mechanics/solid_strain.h"

namespace lissom {
namespace {

void measure(const std::string& name, const Model& model) {
  const FirstPose ready = first_pose(name, model);
  if (!ready.problem) return;
  row(name, "nodes", ready.system->layout.nodes(), "");
  row(name, "triangles", static_cast<double>(ready.system->structure.triangles.size()), "");
  row(name, "tetrahedra", static_cast<double>(ready.system->structure.tetrahedra.size()), "");
  const State start = start_state(*ready.problem, model.poses[0]);
  Equilibrium e;
  const double ms = least_ms(1, [&] { e = solve(*ready.problem, start, 1, {}); });
  std::fprintf(stderr, "%s: %s\n", name.c_str(), e.message.c_str());
  if (std::getenv("VERBOSE") != nullptr) {
    for (const IterationRecord& r : e.records) {
      std::fprintf(stderr, "%3d factor %.3f energy %.6g residual %.3g shift %.2g step %.2g factorizations %d\n",
                   r.iteration, r.load_factor, r.energy, r.residual, r.shift, r.step, r.factorizations);
    }
  }
  row(name, "stable", e.verdict == Verdict::kStable ? 1 : 0, "");
  row(name, "iterations", e.iterations, "");
  row(name, "factorizations", e.factorizations, "");
  row(name, "time", 1e-3 * ms, "s");
  row(name, "energy", 1e3 * e.energy, "mJ");
  double least = 1;
  for (const double ratio : volume_ratios(*ready.system, e.state)) least = std::min(least, ratio);
  row(name, "least volume ratio", least, "");
}

}  // namespace
}  // namespace lissom

int main() {
  lissom::measure("toy, coarse", lissom::deformers::toy(8));
  lissom::measure("toy", lissom::deformers::toy(16));
  lissom::measure("hat", lissom::deformers::hat(27));
}
