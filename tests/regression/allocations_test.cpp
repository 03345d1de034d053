/// Iterations of a solve take no memory after the first one.

#include <algorithm>
#include <gtest/gtest.h>
#include <vector>

#include "bench/disturbed.h"
#include "bench/networks.h"
#include "lissom/equilibrium/solve.h"
#include "tests/count_allocations.h"

#ifdef LISSOM_COUNTS_ALLOCATIONS

namespace lissom {
namespace {

/// Requests for memory between reports of iterations of one solve.
std::vector<long> requests_per_iteration(const Model& model, const SolveOptions& options, bool disturbed) {
  const System system = make_system(model).value();
  const StaticProblem problem = make_static_problem(model, system, model.poses[0], "/poses/0").value();
  const State start = disturbed ? disturbed_state(problem, model.poses[0], 3, Disturbance::kSmooth)
                                : start_state(problem, model.poses[0]);
  std::vector<long> at_report;
  at_report.reserve(10000);
  Context context;
  context.progress = [&](const Progress&) { at_report.push_back(allocations.load()); };
  const Equilibrium e = solve(problem, start, 1, options, context);
  EXPECT_EQ(e.verdict, Verdict::kStable) << e.message;
  std::vector<long> requests;
  for (size_t i = 1; i < at_report.size(); ++i) requests.push_back(at_report[i] - at_report[i - 1]);
  return requests;
}

TEST(Allocations, NoneInAnIterationAfterTheFirst) {
  const long before = allocations.load();
  ASSERT_NE(std::vector<int>(1000).data(), nullptr);
  ASSERT_GT(allocations.load(), before) << "the counter counts";
  SolveOptions plain;
  plain.path = StepPath::kStraight;
  plain.shift = ShiftRule::kRemembered;
  plain.expansion = Expansion::kOff;
  SolveOptions relaxed;
  relaxed.frames = Relaxation::kOn;
  SolveOptions root;
  root.method = Method::kFindRoot;
  for (const char* name : {"cantilever", "hexagon_sheet"}) {
    for (const SolveOptions& options : {SolveOptions(), plain, relaxed, root}) {
      const std::vector<long> requests = requests_per_iteration(networks::scene(name), options, false);
      ASSERT_GE(requests.size(), 2u) << name;
      EXPECT_EQ(*std::max_element(requests.begin(), requests.end()), 0) << name;
    }
  }
  // Shifts, expansions and short steps: a start far away.
  std::vector<long> requests = requests_per_iteration(networks::scene("grid"), {}, true);
  ASSERT_GE(requests.size(), 10u);
  EXPECT_EQ(std::count_if(requests.begin(), requests.end(), [](long n) { return n != 0; }), 0);
}

}  // namespace
}  // namespace lissom

#endif
