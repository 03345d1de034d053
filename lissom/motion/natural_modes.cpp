#include "lissom/motion/natural_modes.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "lissom/core/eigen_solver.h"
#include "lissom/equilibrium/newton_workspace.h"
#include "lissom/motion/mode_shares.h"

namespace lissom {

namespace {

constexpr int kMaxShifts = 80;

/// Twice the largest H_ii / m_i: about the largest eigenvalue, whose rounding all others share.
double largest_eigenvalue(NewtonWorkspace& workspace, const VecX& free_mass) {
  const std::span<const int> kept = workspace.problem().supports.kept();
  double largest = 0;
  for (int i = 0; i < static_cast<int>(kept.size()); ++i) {
    if (kept[i] < 0 || free_mass[kept[i]] <= 0) continue;
    const double diagonal = std::abs(workspace.hessian()[workspace.problem().potential.pattern().diagonal_slot(i)]);
    largest = std::max(largest, 2 * diagonal / free_mass[kept[i]]);
  }
  return largest;
}

/// The largest entry is positive, so that the sign does not depend on the solver.
void fix_sign(VecX& shape) {
  Eigen::Index largest = 0;
  shape.cwiseAbs().maxCoeff(&largest);
  if (shape[largest] < 0) shape = -shape;
}

bool belongs(const NaturalMode& mode, const ModeFilter& filter) {
  if (filter.kind != ModeKind::kAny && mode.share(filter.kind) <= 0.5) return false;
  return filter.axis.isZero() || mode.share_along(filter.axis.normalized()) > 0.5;
}

}  // namespace

double NaturalMode::share(ModeKind kind) const {
  switch (kind) {
    case ModeKind::kBending:
      return bending;
    case ModeKind::kAxial:
      return axial;
    case ModeKind::kTorsional:
      return torsional;
    case ModeKind::kAny:
      break;
  }
  return 1;
}

Result<std::vector<NaturalMode>> natural_modes(const StaticProblem& problem, const State& state, int count,
                                               RollInertia roll_inertia, const Context& context) {
  const System& system = *problem.system;
  const VecX all_mass = lumped_mass(system, roll_inertia);
  VecX mass;
  problem.supports.restrict(all_mass, mass);
  if (mass.size() == 0 || !(mass.maxCoeff() > 0)) {
    return Error{ErrorCode::kConflict, "", "nothing that has mass can move, so there are no natural frequencies",
                 "give the material a density and leave something free"};
  }
  NewtonWorkspace workspace(problem, context);
  workspace.assemble(state);
  const double largest = largest_eigenvalue(workspace, mass);
  const double band = 20 * std::numeric_limits<double>::epsilon() * largest;
  const std::span<const double> metric(mass.data(), mass.size());

  // The eigen solver wants a positive definite factor: rigid motions and unstable modes are lifted by a shift.
  double shift = 0;
  bool definite = workspace.factorize_with(0, metric).positive_definite;
  for (int attempt = 0; attempt < kMaxShifts && !definite; ++attempt) {
    shift = attempt == 0 ? 1e3 * band : 4 * shift;
    definite = workspace.factorize_with(shift, metric).positive_definite;
  }
  if (!definite) {
    return Error{ErrorCode::kConflict, "", "the state is unstable in unknowns that have no mass",
                 "start from a stable equilibrium, or give the rolls their inertia"};
  }
  const EigenPairs pairs = lowest_eigenpairs(workspace.factor(), shift, metric, count);
  if (!pairs.converged && pairs.values.size() < std::min<Eigen::Index>(count, (mass.array() > 0).count())) {
    return Error{ErrorCode::kUnsupported, "", "the eigenvalue iteration did not converge", "ask for fewer modes"};
  }
  std::vector<NaturalMode> modes;
  for (Eigen::Index k = 0; k < pairs.values.size(); ++k) {
    NaturalMode mode;
    const double square = pairs.values[k];  // omega^2
    if (square > band + 1e-9 * shift) mode.frequency = std::sqrt(square) / (2 * std::numbers::pi);
    if (square < -band - 1e-9 * shift) mode.growth_rate = std::sqrt(-square);
    VecX shape = pairs.vectors.col(k);
    fix_sign(shape);
    workspace.to_increment(shape, mode.shape);
    measure_shares(system, state, roll_inertia, mode);
    modes.push_back(std::move(mode));
  }
  return modes;
}

std::vector<NaturalMode> separated(const System& system, const State& state, std::vector<NaturalMode> modes,
                                   RollInertia roll_inertia, const ModeFilter& filter, double spread) {
  for (size_t first = 0; first < modes.size();) {
    size_t last = first + 1;
    while (last < modes.size() && modes[last].growth_rate == 0 && modes[first].growth_rate == 0 &&
           modes[last].frequency <= modes[last - 1].frequency * (1 + spread)) {
      ++last;
    }
    const int n = static_cast<int>(last - first);
    if (n > 1) {
      MatX shapes(system.layout.size(), n);
      for (int k = 0; k < n; ++k) shapes.col(k) = modes[first + k].shape;
      // The share of the filter is a quadratic form over the group: its principal axes separate best.
      MatX form(n, n);
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j <= i; ++j) {
          form(i, j) = form(j, i) = filter_product(system, state, roll_inertia, filter, shapes.col(i), shapes.col(j));
        }
      }
      const Eigen::SelfAdjointEigenSolver<MatX> axes(form);
      const MatX turned = shapes * axes.eigenvectors().rowwise().reverse();  // those that belong come first
      for (int k = 0; k < n; ++k) {
        NaturalMode& mode = modes[first + k];
        mode.shape = turned.col(k);
        fix_sign(mode.shape);
        measure_shares(system, state, roll_inertia, mode);
      }
    }
    first = last;
  }
  return modes;
}

int find_mode(const std::vector<NaturalMode>& modes, const ModeFilter& filter, int k) {
  for (size_t i = 0; i < modes.size(); ++i) {
    if (belongs(modes[i], filter) && k-- == 0) return static_cast<int>(i);
  }
  return -1;
}

}  // namespace lissom
