#include "lissom/design/optimizer_state.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lissom/core/assert.h"

namespace lissom {

namespace {

constexpr std::array<DesignVerdictInfo, 10> kVerdicts = {{
    {DesignVerdict::kConverged, "converged", "done: no change of the parameters promises anything more"},
    {DesignVerdict::kGoodEnough, "good_enough", "done: as close as was asked for"},
    {DesignVerdict::kCancelled, "cancelled", "stopped by you; the best design so far was kept"},
    {DesignVerdict::kLimit, "limit", "at the limit of what the parameters can do: no step brings it closer"},
    {DesignVerdict::kJumped, "jumped", "every step that is left makes the structure snap into another shape"},
    {DesignVerdict::kNoEquilibrium, "no_equilibrium", "every step that is left ends without a stable shape"},
    {DesignVerdict::kIterationLimit, "iteration_limit", "out of iterations; the best design so far was kept"},
    {DesignVerdict::kInfeasible, "infeasible", "the hard constraints cannot be met with these parameters"},
    {DesignVerdict::kConstraintLimit, "constraint_limit", "the hard constraints are not met as precisely as was asked"},
    {DesignVerdict::kBadStart, "bad_start", "the start design has no finite value or gradient"},
}};

}  // namespace

const std::array<DesignVerdictInfo, 10>& design_verdicts() { return kVerdicts; }

const DesignVerdictInfo& design_verdict_info(DesignVerdict verdict) {
  for (const DesignVerdictInfo& info : kVerdicts) {
    if (info.verdict == verdict) return info;
  }
  LISSOM_ASSERT(false);
  return kVerdicts[0];
}

int OutcomeCounts::total() const { return std::accumulate(counts.begin(), counts.end(), 0); }

VecX first_order_promise(const VecX& x, const VecX& gradient, const VecX& lower, const VecX& upper) {
  VecX promise(x.size());
  for (int i = 0; i < x.size(); ++i) {
    const double room = gradient[i] > 0 ? x[i] - lower[i] : upper[i] - x[i];
    promise[i] = gradient[i] * std::clamp(room, 0.0, 1.0);
  }
  return promise;
}

std::vector<ParameterShare> largest_entries(const VecX& values, int count) {
  std::vector<ParameterShare> entries;
  for (int i = 0; i < values.size(); ++i) {
    if (values[i] != 0) entries.push_back({i, values[i]});
  }
  std::stable_sort(entries.begin(), entries.end(), [](const ParameterShare& a, const ParameterShare& b) {
    return std::abs(a.value) > std::abs(b.value);
  });
  if (static_cast<int>(entries.size()) > count) entries.resize(count);
  return entries;
}

}  // namespace lissom
