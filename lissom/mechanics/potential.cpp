#include "lissom/mechanics/potential.h"

#include <algorithm>
#include <utility>

#include "lissom/core/assert.h"

namespace lissom {

namespace {

constexpr int kGroupGrain = 64;
constexpr int kSumChunk = 256;

/// Sum in chunks of fixed size: smaller rounding than a running sum, same bytes always.
double chunked_sum(const double* x, std::ptrdiff_t n) {
  double total = 0;
  for (std::ptrdiff_t begin = 0; begin < n; begin += kSumChunk) {
    double chunk = 0;
    const std::ptrdiff_t end = std::min(n, begin + kSumChunk);
    for (std::ptrdiff_t i = begin; i < end; ++i) chunk += x[i];
    total += chunk;
  }
  return total;
}

std::ptrdiff_t block_entry(int stencil, int entries, int entry) {
  return static_cast<std::ptrdiff_t>(stencil) * entries + entry;
}

/// Buffers that several potentials share never shrink, which would clear them when they grow again. BlockLists read a
/// little beyond the end.
void grow(std::vector<double>& buffer, std::ptrdiff_t size) {
  if (static_cast<std::ptrdiff_t>(buffer.size()) < size + kLanes) buffer.resize(size + kLanes);
}

/// Whether the unknowns i, i + 1, i + 2 of every stencil are three in a row, and no others of it.
bool stands_in_threes(const EnergyTerm& term, int i) {
  if (i + 2 >= term.dofs() || term.stencils() == 0) return false;
  for (int s = 0; s < term.stencils(); ++s) {
    const std::span<const int> dof = term.indices().subspan(static_cast<size_t>(s) * term.dofs(), term.dofs());
    if (dof[i + 1] != dof[i] + 1 || dof[i + 2] != dof[i] + 2) return false;
    for (int j = 0; j < term.dofs(); ++j) {
      if (j != i && dof[j] == dof[i]) return false;
    }
  }
  return true;
}

}  // namespace

Potential::Potential(int dofs, std::vector<std::unique_ptr<EnergyTerm>> terms, std::vector<LocalAxes> local_axes)
    : terms_(std::move(terms)), local_axes_(std::move(local_axes)) {
  std::vector<int> groups, offsets{0};
  std::vector<int> axes_of(dofs, -1);
  for (int a = 0; a < static_cast<int>(local_axes_.size()); ++a) axes_of[local_axes_[a].first_dof] = a;
  std::ptrdiff_t energy = 0, gradient = 0, hessian = 0;
  for (int t = 0; t < static_cast<int>(terms_.size()); ++t) {
    const EnergyTerm& term = *terms_[t];
    energy_start_.push_back(energy);
    gradient_start_.push_back(gradient);
    hessian_start_.push_back(hessian);
    const std::ptrdiff_t padded = static_cast<std::ptrdiff_t>(term.groups()) * kLanes;
    energy += padded;
    gradient += padded * term.dofs();
    if (term.has_hessian()) hessian += padded * term.hessian_entries();
    const std::span<const int> indices = term.indices();
    for (int s = 0; s < term.stencils(); ++s) {
      for (int i = 0; i < term.dofs(); ++i) {
        const int dof = indices[static_cast<size_t>(s) * term.dofs() + i];
        if (axes_of[dof] >= 0) turned_.push_back({t, s, i, axes_of[dof]});
        if (term.has_hessian()) groups.push_back(dof);
      }
      if (term.has_hessian()) offsets.push_back(static_cast<int>(groups.size()));
    }
  }
  energy_start_.push_back(energy);
  gradient_start_.push_back(gradient);
  hessian_start_.push_back(hessian);
  LISSOM_ASSERT(hessian < (std::ptrdiff_t{1} << 31) && gradient < (std::ptrdiff_t{1} << 31));
  pattern_ = SparsePattern(dofs, groups, offsets);
  build_gather();
}

void Potential::replace_terms(std::vector<std::unique_ptr<EnergyTerm>> terms) {
  LISSOM_ASSERT(terms.size() == terms_.size());
  for (size_t t = 0; t < terms.size(); ++t) {
    const std::span<const int> before = terms_[t]->indices(), after = terms[t]->indices();
    LISSOM_ASSERT(terms[t]->name() == terms_[t]->name() &&
                  std::equal(before.begin(), before.end(), after.begin(), after.end()));
  }
  terms_ = std::move(terms);
}

void Potential::build_gather() {
  // Blocks first, so that lists of single entries are told what is left to them.
  struct Layout {
    std::vector<int> block, single;  // offsets within a stencil
  };
  std::vector<Layout> layouts;
  for (const auto& term : terms_) {
    Layout& layout = layouts.emplace_back();
    for (int i = 0; i < term->dofs();) {
      if (stands_in_threes(*term, i)) {
        layout.block.push_back(i);
        i += 3;
      } else {
        layout.single.push_back(i++);
      }
    }
  }
  const auto for_stencils = [&](bool only_hessian, const auto& body) {
    for (int t = 0; t < static_cast<int>(terms_.size()); ++t) {
      const EnergyTerm& term = *terms_[t];
      if (only_hessian && !term.has_hessian()) continue;
      for (int s = 0; s < term.stencils(); ++s) {
        body(t, s, term.indices().subspan(static_cast<size_t>(s) * term.dofs(), term.dofs()));
      }
    }
  };
  for_stencils(false, [&](int t, int s, std::span<const int> dof) {
    for (const int i : layouts[t].block) {
      const std::ptrdiff_t first = gradient_start_[t] + block_entry(s, terms_[t]->dofs(), i);
      gradient_blocks_.add(BlockLists::Part::kRow, {dof[i], 0, 0}, {static_cast<int>(first), {0, 0}});
    }
  });
  gradient_blocks_.arrange();
  gradient_lists_ = GatherLists(dofs(), [&](const auto& emit) {
    for_stencils(false, [&](int t, int s, std::span<const int> dof) {
      for (const int i : layouts[t].single) {
        emit(dof[i], gradient_start_[t] + block_entry(s, terms_[t]->dofs(), i));
      }
    });
  });
  const auto row_start = [](int i) { return i * (i + 1) / 2; };
  for_stencils(true, [&](int t, int s, std::span<const int> dof) {
    for (const int i : layouts[t].block) {
      for (const int j : layouts[t].block) {
        if (j > i) break;
        const std::ptrdiff_t first = hessian_start_[t] + block_entry(s, terms_[t]->hessian_entries(), row_start(i) + j);
        const BlockSource source{static_cast<int>(first),
                                 {row_start(i + 1) - row_start(i), row_start(i + 2) - row_start(i)}};
        const int high = std::max(dof[i], dof[j]), low = std::min(dof[i], dof[j]);
        if (i == j) {
          hessian_blocks_.add(
              BlockLists::Part::kLower,
              {pattern_.slot(low, low), pattern_.slot(low + 1, low + 1), pattern_.slot(low + 2, low + 2)}, source);
        } else {
          hessian_blocks_.add(dof[i] > dof[j] ? BlockLists::Part::kFull : BlockLists::Part::kTransposed,
                              {pattern_.slot(high, low), pattern_.slot(high, low + 1), pattern_.slot(high, low + 2)},
                              source);
        }
      }
    }
  });
  hessian_blocks_.arrange();
  hessian_lists_ = GatherLists(pattern_.nonzeros(), [&](const auto& emit) {
    for_stencils(true, [&](int t, int s, std::span<const int> dof) {
      const auto pair = [&](int i, int j) {
        emit(pattern_.slot(dof[i], dof[j]),
             hessian_start_[t] +
                 block_entry(s, terms_[t]->hessian_entries(), row_start(std::max(i, j)) + std::min(i, j)));
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

double Potential::value(const State& state, AssemblyBuffers& buffers, ThreadPool* threads,
                        std::span<double> by_term) const {
  grow(buffers.energy, energy_start_.back());
  double total = 0;
  for (int t = 0; t < static_cast<int>(terms_.size()); ++t) {
    const EnergyTerm& term = *terms_[t];
    double* energy = buffers.energy.data() + energy_start_[t];
    parallel_for(threads, term.groups(), kGroupGrain,
                 [&](int begin, int end) { term.energies(state, begin, end, energy); });
    const double sum = chunked_sum(energy, term.stencils());
    if (!by_term.empty()) by_term[t] = sum;
    total += sum;
  }
  return total;
}

void Potential::evaluate_blocks(const State& state, AssemblyBuffers& buffers, bool with_hessian,
                                ThreadPool* threads) const {
  grow(buffers.gradient, gradient_start_.back());
  if (with_hessian) grow(buffers.hessian, hessian_start_.back());
  for (int t = 0; t < static_cast<int>(terms_.size()); ++t) {
    const EnergyTerm& term = *terms_[t];
    double* gradient = buffers.gradient.data() + gradient_start_[t];
    double* hessian = with_hessian && term.has_hessian() ? buffers.hessian.data() + hessian_start_[t] : nullptr;
    parallel_for(threads, term.groups(), kGroupGrain,
                 [&](int begin, int end) { term.derivatives(state, begin, end, gradient, hessian); });
  }
  for (const Turned& turned : turned_) turn_block(turned, buffers, with_hessian);
}

void Potential::turn_block(const Turned& turned, AssemblyBuffers& buffers, bool with_hessian) const {
  const EnergyTerm& term = *terms_[turned.term];
  const Mat3& axes = local_axes_[turned.axes].axes;
  const int n = term.dofs(), at = turned.offset;
  const auto gradient = [&](int i) -> double& {
    return buffers.gradient[gradient_start_[turned.term] + block_entry(turned.stencil, n, i)];
  };
  const Vec3 g = axes.transpose() * Vec3(gradient(at), gradient(at + 1), gradient(at + 2));
  for (int i = 0; i < 3; ++i) gradient(at + i) = g[i];
  if (!with_hessian || !term.has_hessian()) return;
  const auto entry = [&](int i, int j) -> double& {
    const int k = i >= j ? i * (i + 1) / 2 + j : j * (j + 1) / 2 + i;
    return buffers.hessian[hessian_start_[turned.term] + block_entry(turned.stencil, term.hessian_entries(), k)];
  };
  for (int j = 0; j < n; ++j) {
    if (j >= at && j < at + 3) continue;
    const Vec3 h = axes.transpose() * Vec3(entry(at, j), entry(at + 1, j), entry(at + 2, j));
    for (int i = 0; i < 3; ++i) entry(at + i, j) = h[i];
  }
  Mat3 own;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) own(i, j) = entry(at + i, at + j);
  }
  own = axes.transpose() * own * axes;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j <= i; ++j) entry(at + i, at + j) = own(i, j);
  }
}

void Potential::gradient(const State& state, VecX& gradient, AssemblyBuffers& buffers, ThreadPool* threads) const {
  evaluate_blocks(state, buffers, false, threads);
  sum_gradient(buffers, gradient, threads);
}

void Potential::hessian(const State& state, VecX& gradient, std::vector<double>& values, AssemblyBuffers& buffers,
                        ThreadPool* threads) const {
  evaluate_blocks(state, buffers, true, threads);
  sum_gradient(buffers, gradient, threads);
  values.assign(pattern_.nonzeros(), 0.0);
  hessian_blocks_.sum(buffers.hessian.data(), values.data(), threads);
  hessian_lists_.sum(buffers.hessian.data(), values.data(), threads);
}

void Potential::sum_gradient(const AssemblyBuffers& buffers, VecX& gradient, ThreadPool* threads) const {
  gradient.setZero(dofs());
  gradient_blocks_.sum(buffers.gradient.data(), gradient.data(), threads);
  gradient_lists_.sum(buffers.gradient.data(), gradient.data(), threads);
}

void Potential::to_global(VecX& dq) const {
  for (const LocalAxes& local : local_axes_) {
    dq.segment<3>(local.first_dof) = (local.axes * dq.segment<3>(local.first_dof)).eval();
  }
}

void Potential::to_local(VecX& dq) const {
  for (const LocalAxes& local : local_axes_) {
    dq.segment<3>(local.first_dof) = (local.axes.transpose() * dq.segment<3>(local.first_dof)).eval();
  }
}

}  // namespace lissom
