#pragma once
/// Ipopt on a reduced problem: interior points, exact gradients, limited-memory Hessians [Waechter & Biegler 2006].

#include "bench/yardsticks/library_point.h"

namespace lissom {

/// Attempts that fail are reported as undefined, upon which Ipopt shortens its step.
YardstickReport run_ipopt(ReducedProblem& problem, const YardstickOptions& options);

}  // namespace lissom
