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

}  // namespace

Potential::Potential(int dofs, std::vector<std::unique_ptr<EnergyTerm>> terms, std::vector<LocalAxes> local_axes,
                     const std::vector<bool>& wanted)
    : terms_(std::move(terms)), local_axes_(std::move(local_axes)) {
  std::vector<int> groups, offsets{0};
  std::vector<int> axes_of(dofs, -1);
  for (int a = 0; a < static_cast<int>(local_axes_.size()); ++a) axes_of[local_axes_[a].first_dof] = a;
  std::ptrdiff_t energy = 0, gradient = 0, hessian = 0;
  for (int t = 0; t < static_cast<int>(terms_.size()); ++t) {
    const EnergyTerm& term = *terms_[t];
    for (int g = 0; g < term.groups(); g += kGroupGrain) {
      pieces_.push_back({t, g, std::min(term.groups(), g + kGroupGrain)});
    }
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
        if (term.has_hessian()) groups.push_back(wanted.empty() || wanted[dof] ? dof : -1);
      }
      if (term.has_hessian()) offsets.push_back(static_cast<int>(groups.size()));
    }
  }
  energy_start_.push_back(energy);
  gradient_start_.push_back(gradient);
  hessian_start_.push_back(hessian);
  LISSOM_ASSERT(hessian < (std::ptrdiff_t{1} << 31) && gradient < (std::ptrdiff_t{1} << 31));
  pattern_ = SparsePattern(dofs, groups, offsets);
  lists_ = AssemblyLists(terms_, pattern_, gradient_start_, hessian_start_);
}

void Potential::replace_terms(std::vector<std::unique_ptr<EnergyTerm>> terms) {
  LISSOM_ASSERT(terms.size() == terms_.size());
  for (size_t t = 0; t < terms.size(); ++t) {
    const std::span<const int> before = terms_[t]->indices(), after = terms[t]->indices();
    LISSOM_ASSERT(terms[t]->name() == terms_[t]->name() && terms[t]->has_hessian() == terms_[t]->has_hessian() &&
                  std::equal(before.begin(), before.end(), after.begin(), after.end()));
  }
  terms_ = std::move(terms);
}

double Potential::value(const State& state, AssemblyBuffers& buffers, ThreadPool* threads,
                        std::span<double> by_term) const {
  grow(buffers.energy, energy_start_.back());
  parallel_for(threads, static_cast<int>(pieces_.size()), 1, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      const Piece& p = pieces_[i];
      terms_[p.term]->energies(state, p.begin, p.end, buffers.energy.data() + energy_start_[p.term]);
    }
  });
  double total = 0;
  for (int t = 0; t < static_cast<int>(terms_.size()); ++t) {
    const double sum = chunked_sum(buffers.energy.data() + energy_start_[t], terms_[t]->stencils());
    if (!by_term.empty()) by_term[t] = sum;
    total += sum;
  }
  return total;
}

void Potential::evaluate_blocks(const State& state, AssemblyBuffers& buffers, bool with_hessian,
                                ThreadPool* threads) const {
  grow(buffers.gradient, gradient_start_.back());
  if (with_hessian) grow(buffers.hessian, hessian_start_.back());
  parallel_for(threads, static_cast<int>(pieces_.size()), 1, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      const Piece& p = pieces_[i];
      const EnergyTerm& term = *terms_[p.term];
      double* hessian = with_hessian && term.has_hessian() ? buffers.hessian.data() + hessian_start_[p.term] : nullptr;
      term.derivatives(state, p.begin, p.end, buffers.gradient.data() + gradient_start_[p.term], hessian);
    }
  });
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
  gradient.resize(dofs());
  lists_.sum_gradient(buffers.gradient.data(), gradient.data(), threads);
}

void Potential::hessian(const State& state, VecX& gradient, std::vector<double>& values, AssemblyBuffers& buffers,
                        ThreadPool* threads) const {
  values.resize(pattern_.nonzeros());
  evaluate_blocks(state, buffers, true, threads);
  gradient.resize(dofs());
  lists_.sum_all(buffers.gradient.data(), gradient.data(), buffers.hessian.data(), values.data(), threads);
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
