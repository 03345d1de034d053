#pragma once
/// From the curves of the description to points: how many edges, and where the nodes lie.

#include <string>

#include "lissom/core/result.h"
#include "lissom/geometry/curve_sampling.h"
#include "lissom/model/model.h"

namespace lissom {

/// Length, turning and least number of edges of a curve; errors as in geometry/curve_sampling.h.
Result<CurveMeasure> measure(const Curve& curve, const std::string& where);

/// The curve cut into `edges`.
Result<CurveSamples> sample(const Curve& curve, int edges, const std::string& where);

/// Number of edges of a rod: `edges`, else length / `edge_length`, else enough that the curve turns by at most 10 degrees
/// per edge and at least 10; times `refine`, rounded, never below what the curve needs.
Result<int> edge_count(const Rod& rod, double refine, const std::string& where);

}  // namespace lissom
