#pragma once
/// ALGLIB on a reduced problem (minbc: active sets and limited-memory BFGS), and on quadratic models over boxes (QuickQP).

#include "bench/yardsticks/library_point.h"

namespace lissom {

/// The library knows no undefined values. Where an attempt fails it is shown a steep bowl around the last point instead.
YardstickReport run_alglib(ReducedProblem& problem, const YardstickOptions& options);

/// min 1/2 x'Bx + g'x over lower <= x <= upper.
VecX alglib_box_qp(const MatX& b, const VecX& g, const VecX& lower, const VecX& upper);

}  // namespace lissom
