#include "lissom/equilibrium/equilibrium.h"

#include "lissom/core/assert.h"

namespace lissom {

namespace {

constexpr VerdictInfo kVerdicts[] = {
    {Verdict::kStable, "stable", "settled: every small motion costs energy", 0},
    {Verdict::kCritical, "critical", "settled, but some motion costs no energy: the shape can change without a force",
     10},
    {Verdict::kUnstable, "unstable", "in balance, but not stable: the smallest push makes it leave", 11},
    {Verdict::kIterationLimit, "iteration_limit", "out of iterations; the best shape so far was kept", 12},
    {Verdict::kStalled, "stalled", "no step lowers the energy although forces are left; the best shape was kept", 13},
    {Verdict::kRunaway, "runaway", "it moves away without bound: something is not held", 14},
    {Verdict::kCancelled, "cancelled", "stopped by you; the best shape so far was kept", 15},
    {Verdict::kBadStart, "bad_start", "the start shape has no finite energy", 16},
};

}  // namespace

const VerdictInfo& verdict_info(Verdict verdict) {
  for (const VerdictInfo& info : kVerdicts) {
    if (info.verdict == verdict) return info;
  }
  LISSOM_ASSERT(false);
  return kVerdicts[0];
}

}  // namespace lissom
