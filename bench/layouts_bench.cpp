/// Random plans of rods on pre-stretched fabric, from the plan to the shape: how they end.
///
///     layouts_bench [FIRST] [LAST] [all] [coarse]      seeds, both included; default 0 to 39; all: a line for each of
///                                                      them; coarse: at most 14 rods on 120 to 260 nodes of fabric

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "bench/shape_check.h"
#include "bench/timing.h"
#include "lissom/equilibrium/solve.h"
#include "lissom/mechanics/membrane_strain.h"
#include "scenes/random_plans.h"

namespace lissom {
namespace {

struct Ending {
  unsigned seed = 0;
  std::string verdict;  // or "refused"
  std::string text;     // of it
  bool wrong = false;
  int nodes = 0, unknowns = 0, factorizations = 0;
  double milliseconds = 0, smallest_stretch = 0, compression = 0, height = 0, size = 0;
};

Ending refused(Ending ending, const Error& error) {
  ending.verdict = "refused";
  ending.text = error.text();
  return ending;
}

void describe_shape(const System& system, const Equilibrium& e, Ending& ending) {
  ending.smallest_stretch = INFINITY;
  for (const TriangleStretch& t : triangle_stretches(system, e.state, 1)) {
    ending.smallest_stretch = std::min(ending.smallest_stretch, t.smallest);
  }
  for (int i = 0; i < system.edge_count(); ++i) {
    ending.compression = std::max(ending.compression, 1 - e.state.edges[i].length / system.rest.edges[i].length);
  }
  double low = INFINITY, high = -INFINITY;
  for (int i = 0; i < system.layout.nodes(); ++i) {
    low = std::min(low, e.state.position(i).z());
    high = std::max(high, e.state.position(i).z());
  }
  ending.height = high - low;
  ending.size = system.structure.size;
}

Ending run(unsigned seed, const Model& model) {
  Ending ending;
  ending.seed = seed;
  const double begin = now_ms();
  if (const Status s = model.validate(); !s) return refused(ending, s.error());
  const Result<System> system = make_system(model);
  if (!system) return refused(ending, system.error());
  ending.nodes = system.value().layout.nodes();
  const Pose& pose = model.poses[0];
  const Result<StaticProblem> problem = make_static_problem(model, system.value(), pose, "/poses/0");
  if (!problem) return refused(ending, problem.error());
  ending.unknowns = problem.value().supports.unknowns();
  const Equilibrium e = solve(problem.value(), start_state(problem.value(), pose), 1, {});
  ending.milliseconds = now_ms() - begin;
  ending.factorizations = e.factorizations;
  ending.verdict = verdict_info(e.verdict).name;
  ending.text = e.message;
  ending.wrong = !verdict_is_true(problem.value(), e);
  if (e.verdict != Verdict::kBadStart) describe_shape(system.value(), e, ending);
  return ending;
}

void print(const Model& model, const Ending& e) {
  std::printf(
      "%s%s, %d nodes, %d unknowns: %s, %d factorizations, %.0f ms, smallest stretch %.3f, compression %.3f, "
      "height / size %.3f\n    %s\n",
      e.wrong ? "WRONG: " : "", model.title.c_str(), e.nodes, e.unknowns, e.verdict.c_str(), e.factorizations,
      e.milliseconds, e.smallest_stretch, e.compression, e.size > 0 ? e.height / e.size : 0, e.text.c_str());
  std::fflush(stdout);
}

void report(std::vector<Ending> endings) {
  std::map<std::string, int> verdicts;
  int wrong = 0, slack = 0, flat = 0, least_nodes = 1 << 30, most_nodes = 0;
  double time = 0;
  for (const Ending& e : endings) {
    ++verdicts[e.verdict];
    wrong += e.wrong;
    time += e.milliseconds;
    if (e.verdict == "refused") continue;
    slack += e.smallest_stretch < 1;
    flat += e.height < 1e-3 * e.size;
    least_nodes = std::min(least_nodes, e.nodes);
    most_nodes = std::max(most_nodes, e.nodes);
  }
  const std::string name = "layouts";
  row(name, "layouts", static_cast<double>(endings.size()), "");
  for (const auto& [verdict, count] : verdicts) row(name, verdict.c_str(), count, "");
  row(name, "wrong verdicts", wrong, "");
  row(name, "with slack fabric", slack, "");
  row(name, "flat", flat, "");
  row(name, "fewest nodes", least_nodes, "");
  row(name, "most nodes", most_nodes, "");
  std::sort(endings.begin(), endings.end(),
            [](const Ending& a, const Ending& b) { return a.factorizations < b.factorizations; });
  const std::size_t half = endings.size() / 2, nine_of_ten = endings.size() * 9 / 10;
  row(name, "factorizations, median", endings[half].factorizations, "");
  row(name, "factorizations, nine of ten", endings[nine_of_ten].factorizations, "");
  row(name, "factorizations, most", endings.back().factorizations, "");
  row(name, "time per layout", time / static_cast<double>(endings.size()), "ms");
  for (std::size_t k = 0; k < std::min<std::size_t>(5, endings.size()); ++k) {
    const Ending& e = endings[endings.size() - 1 - k];
    row(name + ", seed " + std::to_string(e.seed), "factorizations", e.factorizations, "");
  }
}

}  // namespace
}  // namespace lissom

int main(int argc, char** argv) {
  using namespace lissom;
  std::vector<unsigned> seeds;
  bool all = false;
  scene_models::RandomPlanSize size;
  for (int i = 1; i < argc; ++i) {
    if (argv[i] == std::string_view("all")) all = true;
    if (argv[i] == std::string_view("coarse")) size = {120, 260, 3, 14};
    if (argv[i][0] >= '0' && argv[i][0] <= '9') seeds.push_back(static_cast<unsigned>(std::atoi(argv[i])));
  }
  const unsigned first = seeds.empty() ? 0 : seeds[0], last = seeds.size() < 2 ? first + 39 : seeds[1];
  std::vector<Ending> endings;
  bool good = true;
  for (unsigned seed = first; seed <= last; ++seed) {
    const Model model = scene_models::random_plan(seed, size);
    endings.push_back(run(seed, model));
    const Ending& e = endings.back();
    good = good && !e.wrong;
    if (all || e.wrong || e.verdict != "stable") print(model, e);
  }
  report(std::move(endings));
  return good ? 0 : 1;
}
