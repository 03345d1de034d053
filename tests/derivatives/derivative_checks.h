#pragma once
/// Checks of energies against each other, shared by the tests of all terms: hand-written against automatic derivatives,
/// automatic derivatives against differences, total energy against its Taylor polynomial.

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "lissom/core/pack.h"
#include "lissom/mechanics/potential.h"

namespace lissom::checks {

/// Largest deviation found, relative to the size of the compared block, and how many numbers were compared.
struct Deviation {
  double worst = 0;
  long compared = 0;

  void add(const MatX& got, const MatX& expected, double scale) {
    worst = std::max(worst, (got - expected).cwiseAbs().maxCoeff() / scale);
    compared += got.size();
    if (!got.allFinite() || !expected.allFinite()) worst = INFINITY;
  }
};

struct TermReport {
  Deviation energy, gradient, hessian;  ///< hand-written against automatic
  Deviation mixed;                    ///< derivative of the hand-written gradient by rest quantities, against automatic
  Deviation gradient_by_differences;  ///< automatic gradient against differences of values
  Deviation hessian_by_differences;   ///< Hessian against differences of fixed-anchor gradients
  Deviation mixed_by_differences;     ///< mixed block against differences of gradients over rest quantities
};

/// Size of a stencil's Hessian, row by column, for a relative comparison that respects the units of the unknowns.
inline double scale_of(const MatX& m) { return std::max(m.cwiseAbs().maxCoeff(), 1e-300); }

inline TermReport check_term(EnergyTerm& term, const DofLayout& layout, const State& state, double length,
                             int most_stencils = 40) {
  TermReport report;
  const int n = term.dofs();
  std::vector<double> energy(term.groups() * Pack::kLanes), gradient(energy.size() * n),
      hessian(energy.size() * term.hessian_entries());
  term.energies(state, 0, term.groups(), energy.data());
  term.derivatives(state, 0, term.groups(), gradient.data(), term.has_hessian() ? hessian.data() : nullptr);
  const auto at = [&](int stencil, int entries, int e) { return stencil * entries + e; };
  const int stride = std::max(1, term.stencils() / most_stencils);
  VecX zero = VecX::Zero(state.q.size());
  for (int s = 0; s < term.stencils(); s += stride) {
    const StencilDerivatives exact = term.automatic(state, zero, s);
    // Unknowns are made dimensionless with a length, so that positions and angles are of the same size.
    VecX unit(n);
    const std::span<const int> unknowns = term.indices();
    for (int i = 0; i < n; ++i) {
      unit[i] = layout.dof_class(unknowns[s * n + i]) == DofClass::kPosition ? length : 1;
    }
    const MatX h = unit.asDiagonal() * exact.hessian * unit.asDiagonal();
    const VecX g = unit.asDiagonal() * exact.gradient;
    const double g_scale = std::max(scale_of(g), 1e-3 * scale_of(h)),
                 h_scale = std::max(scale_of(h), 1e-3 * scale_of(g));
    VecX g_hand(n);
    MatX h_hand = MatX::Zero(n, n);
    for (int i = 0, k = 0; i < n; ++i) {
      g_hand[i] = unit[i] * gradient[at(s, n, i)];
      for (int j = 0; j <= i && term.has_hessian(); ++j, ++k) {
        h_hand(i, j) = h_hand(j, i) = unit[i] * unit[j] * hessian[at(s, term.hessian_entries(), k)];
      }
    }
    report.energy.add(VecX::Constant(1, energy[s]), VecX::Constant(1, exact.energy),
                      std::max(std::abs(exact.energy), g_scale));
    report.gradient.add(g_hand, g, g_scale);
    report.hessian.add(h_hand, h, h_scale);

    VecX g_difference(n);
    MatX h_difference(n, n);
    const double step = 1e-5;
    for (int i = 0; i < n; ++i) {
      VecX dq = zero;
      dq[unknowns[s * n + i]] = step * unit[i];
      const StencilDerivatives plus = term.automatic(state, dq, s), minus = term.automatic(state, -dq, s);
      g_difference[i] = (plus.energy - minus.energy) / (2 * step);
      h_difference.col(i) = unit.asDiagonal() * (plus.gradient - minus.gradient) / (2 * step);
    }
    report.gradient_by_differences.add(g_difference, g, std::max(g_scale, h_scale));
    report.hessian_by_differences.add(h_difference, h, h_scale);

    const VecX rest = term.rest(s);
    MatX mixed_hand(n, term.rests());
    term.mixed(state, s, mixed_hand.data());
    for (int r = 0; r < term.rests(); ++r) {
      // Relative to the quantity where it has a size, so that the step stays small against stiffnesses of 1e-5 N m^2.
      const double size = std::abs(rest[r]) > 1e-8 ? std::abs(rest[r]) : 1e-2, h_rest = 1e-5 * size;
      VecX changed = rest;
      changed[r] = rest[r] + h_rest;
      term.set_rest(s, changed);
      const VecX plus = term.automatic(state, zero, s).gradient;
      changed[r] = rest[r] - h_rest;
      term.set_rest(s, changed);
      const VecX minus = term.automatic(state, zero, s).gradient;
      const VecX difference = unit.asDiagonal() * (plus - minus) / (2 * h_rest);
      const VecX mixed = unit.asDiagonal() * exact.mixed.col(r);
      report.mixed_by_differences.add(difference, mixed, std::max(scale_of(mixed), 1e-3 * g_scale / size));
      report.mixed.add(unit.asDiagonal() * mixed_hand.col(r), mixed, std::max(scale_of(mixed), 1e-3 * g_scale / size));
    }
    term.set_rest(s, rest);
  }
  return report;
}

/// Slopes of the Taylor remainders of the total energy along a direction: at least 2 and 3 for exact derivatives.
struct TaylorSlopes {
  double gradient = 0, hessian = 0;
};

inline TaylorSlopes taylor_slopes(const System& system, const Potential& potential, const State& state,
                                  const VecX& direction, double first_step) {
  AssemblyBuffers buffers;
  VecX g, hd;
  std::vector<double> h;
  potential.hessian(state, g, h, buffers);
  multiply(potential.pattern(), h, direction, hd);
  const double v0 = potential.value(state, buffers);
  std::vector<double> log_step, log_first, log_second;
  State moved;
  VecX global = direction;
  potential.to_global(global);
  for (int k = 0; k < 6; ++k) {
    const double step = first_step * std::pow(0.5, k);
    if (!advance(system, state, step * global, moved)) return {};
    const double v = potential.value(moved, buffers);
    const double first = std::abs(v - v0 - step * g.dot(direction));
    const double second = std::abs(v - v0 - step * g.dot(direction) - 0.5 * step * step * direction.dot(hd));
    // Remainders below the rounding of the energy say nothing.
    if (second < 1e-12 * std::abs(v0)) break;
    log_step.push_back(std::log(step));
    log_first.push_back(std::log(first));
    log_second.push_back(std::log(second));
  }
  if (log_step.size() < 3) return {};
  const auto slope = [&](const std::vector<double>& y) {
    const size_t n = y.size();
    return (y[n - 3] - y[n - 1]) / (log_step[n - 3] - log_step[n - 1]);
  };
  return {slope(log_first), slope(log_second)};
}

/// A random smooth-ish increment: every node moves by up to `amplitude` edge lengths, rolls and rotations by as many rad.
inline VecX random_increment(const System& system, std::mt19937& random, double amplitude) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  VecX dq(system.layout.size());
  for (int i = 0; i < dq.size(); ++i) {
    const bool position = system.layout.dof_class(i) == DofClass::kPosition;
    dq[i] = amplitude * uniform(random) * (position ? system.rest.mean_edge_length : 1);
  }
  return dq;
}

}  // namespace lissom::checks
