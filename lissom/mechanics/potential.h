#pragma once
/// Total potential energy: a sum of terms with one fixed sparsity pattern, assembled by gathering in a fixed order.

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "lissom/core/parallel.h"
#include "lissom/core/sparse_pattern.h"
#include "lissom/mechanics/assembly_lists.h"
#include "lissom/mechanics/energy_term.h"

namespace lissom {

/// Coordinates of three consecutive unknowns (a position or a joint rotation) along other axes than x, y, z:
/// global increment = axes * local increment. Used where a support holds an oblique direction.
struct LocalAxes {
  int first_dof = 0;
  Mat3 axes = Mat3::Identity();
};

/// Buffers for the stencil blocks of one evaluation; reuse them to avoid allocation. Not shared between threads.
struct AssemblyBuffers {
  std::vector<double> energy, gradient, hessian;
};

class Potential {
 public:
  /// Gradients and Hessians come out in the local axes given. Unless `wanted` is empty, the pattern has rows and columns of
  /// the marked unknowns alone, and diagonal entries without meaning for the others.
  Potential(int dofs, std::vector<std::unique_ptr<EnergyTerm>> terms, std::vector<LocalAxes> local_axes = {},
            const std::vector<bool>& wanted = {});
  Potential(Potential&&) noexcept = default;
  Potential& operator=(Potential&&) noexcept = default;

  /// Takes terms with other rest numbers over; they have to be the same terms on the same unknowns. The pattern stays.
  void replace_terms(std::vector<std::unique_ptr<EnergyTerm>> terms);

  int dofs() const { return pattern_.size(); }
  std::span<const std::unique_ptr<EnergyTerm>> terms() const { return terms_; }
  EnergyTerm& term(int i) { return *terms_[i]; }
  const SparsePattern& pattern() const { return pattern_; }
  std::span<const LocalAxes> local_axes() const { return local_axes_; }

  /// Energy, J. `by_term`, unless empty, receives one energy per term.
  double value(const State& state, AssemblyBuffers& buffers, ThreadPool* threads = nullptr,
               std::span<double> by_term = {}) const;

  /// Gradient (N, N m), one entry per unknown, of the energy anchored at `state`.
  void gradient(const State& state, VecX& gradient, AssemblyBuffers& buffers, ThreadPool* threads = nullptr) const;

  /// Gradient and the values of the Hessian in the order of pattern().
  void hessian(const State& state, VecX& gradient, std::vector<double>& values, AssemblyBuffers& buffers,
               ThreadPool* threads = nullptr) const;

  /// Increment in global axes from one in local axes, in place.
  void to_global(VecX& dq) const;
  void to_local(VecX& dq) const;

 private:
  /// Where a stencil block has to be turned into local axes.
  struct Turned {
    int term, stencil, offset, axes;
  };

  /// Groups of one term that one thread takes.
  struct Piece {
    int term, begin, end;
  };

  /// Blocks of all stencils; those of the Hessian only where they are wanted.
  void evaluate_blocks(const State& state, AssemblyBuffers& buffers, bool with_hessian, ThreadPool* threads) const;
  void turn_block(const Turned& turned, AssemblyBuffers& buffers, bool with_hessian) const;

  std::vector<std::unique_ptr<EnergyTerm>> terms_;
  std::vector<LocalAxes> local_axes_;
  std::vector<Turned> turned_;
  SparsePattern pattern_;
  std::vector<std::ptrdiff_t> energy_start_, gradient_start_, hessian_start_;  // per term, into the buffers
  std::vector<Piece> pieces_;
  AssemblyLists lists_;
};

}  // namespace lissom
