/// Solves from starts far from any shape and counts how they end, over ten networks of up to 5,000 unknowns.
///
///     robustness_bench [STARTS]      STARTS: per network, half of them smooth fields, half noise; default 20

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "bench/disturbed.h"
#include "bench/networks.h"
#include "bench/timing.h"
#include "lissom/equilibrium/solve.h"

namespace lissom {
namespace {

struct Tally {
  int starts = 0, stable = 0, critical = 0, silent = 0;
  std::vector<int> factorizations;
  double milliseconds = 0;

  void add(const Tally& other) {
    starts += other.starts;
    stable += other.stable;
    critical += other.critical;
    silent += other.silent;
    factorizations.insert(factorizations.end(), other.factorizations.begin(), other.factorizations.end());
    milliseconds += other.milliseconds;
  }
};

void report(const std::string& name, Tally& tally) {
  std::sort(tally.factorizations.begin(), tally.factorizations.end());
  row(name, "starts", tally.starts, "");
  row(name, "stable", tally.stable, "");
  row(name, "critical", tally.critical, "");
  row(name, "other verdicts", tally.starts - tally.stable - tally.critical, "");
  row(name, "wrong verdicts", tally.silent, "");
  row(name, "factorizations, median", tally.factorizations[tally.factorizations.size() / 2], "");
  row(name, "factorizations, most", tally.factorizations.back(), "");
  row(name, "time per start", tally.milliseconds / tally.starts, "ms");
}

Tally run(const std::string& name, const StaticProblem& problem, const Pose& pose, Disturbance kind, int starts) {
  Tally tally;
  for (int seed = 0; seed < starts; ++seed) {
    const State start = disturbed_state(problem, pose, static_cast<unsigned>(seed), kind);
    const double begin = now_ms();
    const Equilibrium e = solve(problem, start, 1, {});
    tally.milliseconds += now_ms() - begin;
    tally.factorizations.push_back(e.factorizations);
    ++tally.starts;
    const bool settled = e.verdict == Verdict::kStable || e.verdict == Verdict::kCritical;
    if (e.verdict == Verdict::kStable) ++tally.stable;
    if (e.verdict == Verdict::kCritical) ++tally.critical;
    // What a verdict promises has to be true.
    if (!e.state.q.allFinite() || (settled && !(e.residual <= e.tolerance)) || (settled && e.negative_modes > 0)) {
      ++tally.silent;
      std::printf("%s, seed %d: the verdict is wrong: %s\n", name.c_str(), seed, e.message.c_str());
    } else if (!settled) {
      std::printf("%s, seed %d: %s\n", name.c_str(), seed, e.message.c_str());
    }
  }
  return tally;
}

/// False when a verdict was wrong.
bool measure(const std::string& name, const Model& model, int starts, Tally& all) {
  const Result<System> system = make_system(model);
  if (!system) return std::printf("%s: %s\n", name.c_str(), system.error().text().c_str()), false;
  const Pose& pose = model.poses[0];
  const Result<StaticProblem> problem = make_static_problem(model, system.value(), pose, "/poses/0");
  if (!problem) return std::printf("%s: %s\n", name.c_str(), problem.error().text().c_str()), false;
  row(name, "unknowns", problem.value().supports.unknowns(), "");
  bool good = true;
  for (const auto& [kind, word] :
       {std::pair{Disturbance::kSmooth, "smooth"}, std::pair{Disturbance::kNoise, "noise"}}) {
    const std::string label = name + ", " + word;
    Tally tally = run(label, problem.value(), pose, kind, (starts + 1) / 2);
    report(label, tally);
    all.add(tally);
    good = good && tally.silent == 0;
  }
  return good;
}

}  // namespace
}  // namespace lissom

int main(int argc, char** argv) {
  using namespace lissom;
  int starts = 20;
  for (int i = 1; i < argc; ++i) {
    if (argv[i][0] != '-') starts = std::max(1, std::atoi(argv[i]));
  }
  Tally all;
  bool good = true;
  for (const char* name :
       {"cantilever", "ring", "frame", "helix", "grid", "quad_sheet", "triangle_sheet", "gridshell"}) {
    good = measure(name, networks::scene(name), starts, all) && good;
  }
  good = measure("small honeycomb", networks::hanging_honeycomb(6, 6, 8), starts, all) && good;
  good = measure("coarse honeycomb", networks::hanging_honeycomb(10, 10, 3), starts, all) && good;
  report("all", all);
  return good ? 0 : 1;
}
