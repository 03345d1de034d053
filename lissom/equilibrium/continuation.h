#pragma once
/// Paths of equilibria over the load factor: step control, critical points, branches.

#include <functional>
#include <vector>

#include "lissom/core/context.h"
#include "lissom/equilibrium/equilibrium.h"
#include "lissom/equilibrium/options.h"
#include "lissom/equilibrium/static_problem.h"

namespace lissom {

struct PathPoint {
  State state;             ///< state.load_factor is the place on the path
  double energy = 0;       ///< J
  double residual = 0;     ///< N
  int negative_modes = 0;  ///< 0: stable
  double lowest = 0;       ///< N/m, stiffness of the lowest mode
  VecX reaction;           ///< as in Equilibrium
};

enum class CriticalKind {
  kFold,         ///< the load has a maximum or minimum: no equilibrium nearby beyond it
  kBifurcation,  ///< another branch starts here
};

struct CriticalPoint {
  CriticalKind kind = CriticalKind::kBifurcation;
  double load_factor = 0;
  State state;
  Mode mode;  ///< the motion that has lost its stiffness
  int negative_before = 0, negative_after = 0;
};

enum class PathEnd { kReached, kStoppedAtCritical, kStepTooSmall, kIterationLimit, kCancelled, kBadStart };

struct PathResult {
  std::vector<PathPoint> points;  ///< in order; the requested load factors among them when the load is followed
  std::vector<CriticalPoint> critical;
  PathEnd end = PathEnd::kBadStart;
  std::string message;
  int factorizations = 0;
};

struct PathOptions {
  SolveOptions solve;                ///< tolerance and limits of each point
  double critical_tolerance = 1e-7;  ///< of the load factor of a critical point, relative to the range
  int max_points = 2000;
};

/// Follows the branch of `start` as the pose's LoadPath says.
PathResult follow_path(const StaticProblem& problem, const State& start, const LoadPath& path,
                       const PathOptions& options, const Context& context = {});

}  // namespace lissom
