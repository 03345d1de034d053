#include "lissom/equilibrium/stability.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "lissom/core/eigen_solver.h"

namespace lissom {

namespace {

/// Sum of |H_ij| over a row bounds the largest eigenvalue; over the metric it bounds that of the pencil.
double largest_stiffness(NewtonWorkspace& workspace) {
  const StaticProblem& problem = workspace.problem();
  double largest = 0;
  const std::span<const int> kept = problem.supports.kept();
  for (int i = 0; i < static_cast<int>(kept.size()); ++i) {
    const int k = kept[i];
    if (k < 0 || problem.mode_metric[k] <= 0) continue;
    if (workspace.system().layout.dof_class(i) != DofClass::kPosition) continue;
    const double diagonal = std::abs(workspace.hessian()[problem.potential.pattern().diagonal_slot(i)]);
    largest = std::max(largest, 2 * diagonal / problem.mode_metric[k]);
  }
  return largest;
}

/// Whether no node moves in a mode: what is left are the rolls of a rod that is straight and held by points alone.
bool is_spin(const StaticProblem& problem, const VecX& shape) {
  constexpr double kMoving = 1e-4;  // of the mode's squared size, which is 1
  const DofLayout& layout = problem.system->layout;
  const std::span<const int> kept = problem.supports.kept();
  double moving = 0;
  for (int i = 0; i < 3 * layout.nodes(); ++i) {
    if (kept[i] >= 0) moving += problem.mode_metric[kept[i]] * shape[kept[i]] * shape[kept[i]];
  }
  return moving < kMoving;
}

/// At least `count` lowest modes, and one that is no spin within `band`.
EigenPairs lowest_modes(NewtonWorkspace& workspace, double shift, int count, double band, int& spins) {
  const StaticProblem& problem = workspace.problem();
  const std::span<const double> metric(problem.mode_metric.data(), problem.mode_metric.size());
  for (;; count *= 2) {
    EigenPairs pairs = lowest_eigenpairs(workspace.factor(), shift, metric, count);
    spins = 0;
    for (int k = 0; k < pairs.values.size(); ++k) {
      if (std::abs(pairs.values[k]) <= band && is_spin(problem, pairs.vectors.col(k))) ++spins;
    }
    if (spins < count || pairs.values.size() < count) return pairs;
  }
}

}  // namespace

Stability examine_stability(NewtonWorkspace& workspace, int modes) {
  const StaticProblem& problem = workspace.problem();
  const int unknowns = problem.supports.unknowns();
  Stability stability;
  if (unknowns == 0) return stability;
  stability.band =
      1e-6 * problem.scales.stiffness + 20 * std::numeric_limits<double>::epsilon() * largest_stiffness(workspace);
  const FactorReport report = workspace.factorize(0);
  const int wanted = std::min(unknowns, std::max(modes, 1));
  if (report.complete && report.positive_definite && modes == 0) return stability;

  // Modes need a positive definite factor: shift by the mode metric until it is one.
  double shift = 0;
  bool definite = report.complete && report.positive_definite;
  const std::span<const double> metric(problem.mode_metric.data(), problem.mode_metric.size());
  if (!definite) {
    shift = std::max(stability.band, 1e-3 * problem.scales.stiffness);
    for (int attempt = 0; attempt < 60; ++attempt) {
      definite = workspace.factorize_with(shift, metric).positive_definite;
      if (definite) break;
      shift *= 8;
    }
  }
  if (!definite) {
    stability.negative = std::max(1, report.negative_pivots);
    return stability;
  }
  const EigenPairs pairs = lowest_modes(workspace, shift, wanted, stability.band, stability.spins);
  stability.free_shapes = pairs.vectors;
  for (int k = 0; k < pairs.values.size(); ++k) {
    Mode mode;
    mode.stiffness = pairs.values[k];
    VecX shape = pairs.vectors.col(k);
    // A sign that does not depend on the solver: the largest entry is positive.
    int largest = 0;
    shape.cwiseAbs().maxCoeff(&largest);
    if (shape[largest] < 0) shape = -shape;
    stability.free_shapes.col(k) = shape;
    workspace.to_increment(shape, mode.shape);
    stability.modes.push_back(std::move(mode));
    if (pairs.values[k] < -stability.band) {
      ++stability.negative;
    } else if (pairs.values[k] <= stability.band && !is_spin(problem, pairs.vectors.col(k))) {
      stability.critical = true;
    }
  }
  // More negative modes than were asked for: the inertia knows.
  if (stability.negative >= wanted && report.negative_pivots > stability.negative) {
    stability.negative = report.negative_pivots;
  }
  return stability;
}

}  // namespace lissom
