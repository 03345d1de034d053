#pragma once
/// How the stencil blocks of all terms of a potential add up to a gradient and a Hessian.

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "lissom/core/sparse_pattern.h"
#include "lissom/mechanics/block_lists.h"
#include "lissom/mechanics/energy_term.h"
#include "lissom/mechanics/gather_lists.h"

namespace lissom {

/// Entries that the pattern does not have are left out. Places are those of one buffer for gradients and one for Hessians;
/// where the blocks of each term begin in them is given per term.
class AssemblyLists {
 public:
  AssemblyLists() = default;
  AssemblyLists(std::span<const std::unique_ptr<EnergyTerm>> terms, const SparsePattern& pattern,
                std::span<const std::ptrdiff_t> gradient_start, std::span<const std::ptrdiff_t> hessian_start);

  /// Writes the sums of the blocks in `from` to the gradient (one entry per unknown).
  void sum_gradient(const double* from, double* gradient, ThreadPool* threads) const;
  /// The same together with the Hessian (one entry per slot of the pattern).
  void sum_all(const double* gradient_from, double* gradient, const double* hessian_from, double* hessian,
               ThreadPool* threads) const;

 private:
  // Blocks of three unknowns, and all that is left.
  BlockLists gradient_blocks_, hessian_blocks_;
  GatherLists gradient_lists_, hessian_lists_;
};

}  // namespace lissom
