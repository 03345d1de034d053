#include "lissom/mechanics/assembly_lists.h"

#include <algorithm>
#include <utility>

namespace lissom {

namespace {

std::ptrdiff_t block_entry(int stencil, int entries, int entry) {
  return static_cast<std::ptrdiff_t>(stencil) * entries + entry;
}

/// Whether the unknowns i, i + 1, i + 2 of every stencil are three in a row, no others of it, and nowhere in another three:
/// blocks write their targets, so they must not overlap. `first_of_three`, per unknown, is what was found so far.
bool stands_in_threes(const EnergyTerm& term, int i, std::vector<int>& first_of_three) {
  if (i + 2 >= term.dofs() || term.stencils() == 0) return false;
  const auto stencil = [&](int s) { return term.indices().subspan(static_cast<size_t>(s) * term.dofs(), term.dofs()); };
  for (int s = 0; s < term.stencils(); ++s) {
    const std::span<const int> dof = stencil(s);
    if (dof[i + 1] != dof[i] + 1 || dof[i + 2] != dof[i] + 2) return false;
    for (int j = 0; j < term.dofs(); ++j) {
      if (j != i && dof[j] == dof[i]) return false;
    }
  }
  std::vector<int> marked = first_of_three;
  for (int s = 0; s < term.stencils(); ++s) {
    const int first = stencil(s)[i];
    for (int k = 0; k < 3; ++k) {
      int& mark = marked[first + k];
      if (mark >= 0 && mark != first) return false;
      mark = first;
    }
  }
  first_of_three = std::move(marked);
  return true;
}

/// Which of `count` targets the blocks write.
std::vector<bool> targets_of(const BlockLists& blocks, int count) {
  std::vector<bool> written(count, false);
  blocks.mark_targets(written);
  return written;
}

/// The pieces of two lists in one go.
template <class A, class B>
void sum_both(const A& a, const double* a_from, double* a_to, const B& b, const double* b_from, double* b_to,
              ThreadPool* threads) {
  parallel_for(threads, a.pieces() + b.pieces(), 1, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      if (i < a.pieces()) {
        a.sum_piece(i, a_from, a_to);
      } else {
        b.sum_piece(i - a.pieces(), b_from, b_to);
      }
    }
  });
}

}  // namespace

AssemblyLists::AssemblyLists(std::span<const std::unique_ptr<EnergyTerm>> terms, const SparsePattern& pattern,
                             std::span<const std::ptrdiff_t> gradient_start,
                             std::span<const std::ptrdiff_t> hessian_start) {
  // Blocks first, so that lists of single entries are told what is left to them.
  struct Layout {
    std::vector<int> block, single;  // offsets within a stencil
  };
  std::vector<Layout> layouts;
  std::vector<int> first_of_three(pattern.size(), -1);
  for (const auto& term : terms) {
    Layout& layout = layouts.emplace_back();
    for (int i = 0; i < term->dofs();) {
      if (stands_in_threes(*term, i, first_of_three)) {
        layout.block.push_back(i);
        i += 3;
      } else {
        layout.single.push_back(i++);
      }
    }
  }
  const auto for_stencils = [&](bool only_hessian, const auto& body) {
    for (int t = 0; t < static_cast<int>(terms.size()); ++t) {
      const EnergyTerm& term = *terms[t];
      if (only_hessian && !term.has_hessian()) continue;
      for (int s = 0; s < term.stencils(); ++s) {
        body(t, s, term.indices().subspan(static_cast<size_t>(s) * term.dofs(), term.dofs()));
      }
    }
  };
  for_stencils(false, [&](int t, int s, std::span<const int> dof) {
    for (const int i : layouts[t].block) {
      const std::ptrdiff_t first = gradient_start[t] + block_entry(s, terms[t]->dofs(), i);
      gradient_blocks_.add(BlockLists::Part::kRow, {dof[i], 0, 0}, {static_cast<int>(first), {0, 0}});
    }
  });
  gradient_blocks_.arrange();
  gradient_lists_ = GatherLists(targets_of(gradient_blocks_, pattern.size()), [&](const auto& emit) {
    for_stencils(false, [&](int t, int s, std::span<const int> dof) {
      for (const int i : layouts[t].single) {
        emit(dof[i], gradient_start[t] + block_entry(s, terms[t]->dofs(), i));
      }
    });
  });
  const auto row_start = [](int i) { return i * (i + 1) / 2; };
  for_stencils(true, [&](int t, int s, std::span<const int> dof) {
    for (const int i : layouts[t].block) {
      for (const int j : layouts[t].block) {
        if (j > i) break;
        const std::ptrdiff_t first = hessian_start[t] + block_entry(s, terms[t]->hessian_entries(), row_start(i) + j);
        const BlockSource source{static_cast<int>(first),
                                 {row_start(i + 1) - row_start(i), row_start(i + 2) - row_start(i)}};
        const int high = std::max(dof[i], dof[j]), low = std::min(dof[i], dof[j]);
        if (pattern.slot(high, low + 1) < 0) continue;  // not wanted
        if (i == j) {
          hessian_blocks_.add(BlockLists::Part::kLower,
                              {pattern.slot(low, low), pattern.slot(low + 1, low + 1), pattern.slot(low + 2, low + 2)},
                              source);
        } else {
          hessian_blocks_.add(dof[i] > dof[j] ? BlockLists::Part::kFull : BlockLists::Part::kTransposed,
                              {pattern.slot(high, low), pattern.slot(high, low + 1), pattern.slot(high, low + 2)},
                              source);
        }
      }
    }
  });
  hessian_blocks_.arrange();
  hessian_lists_ = GatherLists(targets_of(hessian_blocks_, pattern.nonzeros()), [&](const auto& emit) {
    for_stencils(true, [&](int t, int s, std::span<const int> dof) {
      const auto pair = [&](int i, int j) {
        const int slot = pattern.slot(dof[i], dof[j]);
        if (slot < 0) return;
        emit(slot, hessian_start[t] +
                       block_entry(s, terms[t]->hessian_entries(), row_start(std::max(i, j)) + std::min(i, j)));
      };
      for (const int i : layouts[t].single) {
        for (const int j : layouts[t].single) {
          if (j <= i) pair(i, j);
        }
        for (const int j : layouts[t].block) {
          for (int c = 0; c < 3; ++c) pair(i, j + c);
        }
      }
    });
  });
}

void AssemblyLists::sum_gradient(const double* from, double* gradient, ThreadPool* threads) const {
  parallel_for(threads, gradient_blocks_.pieces(), 1, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) gradient_blocks_.sum_piece(i, from, gradient);
  });
  parallel_for(threads, gradient_lists_.pieces(), 1, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) gradient_lists_.sum_piece(i, from, gradient);
  });
}

// Blocks before single entries, which are added where blocks have written.
void AssemblyLists::sum_all(const double* gradient_from, double* gradient, const double* hessian_from, double* hessian,
                            ThreadPool* threads) const {
  sum_both(hessian_blocks_, hessian_from, hessian, gradient_blocks_, gradient_from, gradient, threads);
  sum_both(hessian_lists_, hessian_from, hessian, gradient_lists_, gradient_from, gradient, threads);
}

}  // namespace lissom
