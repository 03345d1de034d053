/// A control point dragged through a plan in 200 small steps: how each step ends, what it costs, and what happens to the
/// height where the plan is meshed anew. Rows of name, metric, value, unit.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "bench/timing.h"
#include "lissom/core/file_io.h"
#include "lissom/design/live_design.h"
#include "lissom/model/document.h"

namespace lissom {
namespace {

constexpr int kSteps = 200;

struct Drag {
  const char* scene;
  double edge_length;  ///< m, of rods; 0: as in the document
  const char* point;
  Vec2 way;  ///< m
};

double height(const LiveDesign& design) {
  double low = INFINITY, high = -INFINITY;
  for (int i = 0; i < design.system().layout.nodes(); ++i) {
    const double z = design.equilibrium().state.position(i).z();
    low = std::min(low, z);
    high = std::max(high, z);
  }
  return high - low;
}

double middle(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

void measure(const Drag& drag, const Context& context) {
  const std::string name = std::string("drag, ") + drag.scene;
  const Result<std::string> text = read_file(std::string("scenes/data/fabric/") + drag.scene + ".lissom");
  Result<Model> model = text ? read_document(text.value()) : Result<Model>(text.error());
  if (!model) {
    std::fprintf(stderr, "%s: %s\n", name.c_str(), model.error().text().c_str());
    return;
  }
  if (drag.edge_length > 0) model.value().plan->edge_length = drag.edge_length;
  LiveDesign::Options options;
  options.solve.modes = 0;
  const Result<std::unique_ptr<LiveDesign>> opened = LiveDesign::make(model.value(), 0, options, context);
  if (!opened) {
    std::fprintf(stderr, "%s: %s\n", name.c_str(), opened.error().text().c_str());
    return;
  }
  LiveDesign& design = *opened.value();
  std::vector<double> times, factorizations;
  int there = 0;  // most factorizations at a new mesh
  int meshes = 0, stable = 0, jumps = 0;
  double before = height(design), change_there = 0, change_elsewhere = 0;
  for (int k = 0; k < kSteps; ++k) {
    Model moved = design.model();
    for (PlanPoint& point : moved.plan->points) {
      if (point.name == drag.point) point.at += drag.way / kSteps;
    }
    const double begin = now_ms();
    const Result<DesignChange> change = design.change(moved);
    times.push_back(now_ms() - begin);
    if (!change) {
      std::fprintf(stderr, "%s, step %d: %s\n", name.c_str(), k + 1, change.error().text().c_str());
      break;
    }
    factorizations.push_back(design.equilibrium().factorizations);
    stable += design.equilibrium().verdict == Verdict::kStable;
    meshes += change.value().remeshed;
    if (change.value().remeshed) there = std::max(there, design.equilibrium().factorizations);
    jumps += change.value().following.jumped;
    const double now = height(design), share = std::abs(now / before - 1);
    double& largest = change.value().remeshed ? change_there : change_elsewhere;
    largest = std::max(largest, share);
    before = now;
  }
  row(name, "steps", static_cast<double>(factorizations.size()), "");
  row(name, "stable", stable, "");
  row(name, "jumps", jumps, "");
  row(name, "new meshes", meshes, "");
  row(name, "factorizations at a new mesh, most", there, "");
  row(name, "largest change of height at a new mesh", 100 * change_there, "%");
  row(name, "largest change of height elsewhere", 100 * change_elsewhere, "%");
  row(name, "time of a step", middle(times), "ms");
  row(name, "slowest step", *std::max_element(times.begin(), times.end()), "ms");
  row(name, "factorizations, median", middle(factorizations), "");
  row(name, "factorizations, most", *std::max_element(factorizations.begin(), factorizations.end()), "");
}

}  // namespace
}  // namespace lissom

int main() {
  lissom::ThreadPool threads(2);
  lissom::Context context;
  context.threads = &threads;
  lissom::measure({"disc-crossed", 3e-3, "centre", {-0.055, 0.025}}, context);
  lissom::measure({"butterfly", 0, "b2-l", {-0.024, 0.008}}, context);
  lissom::measure({"mask", 0, "m1-l", {0.0104, 0.0052}}, context);
  return 0;
}
