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
  return (static_cast<std::ptrdiff_t>(stencil / kLanes) * entries + entry) * kLanes + stencil % kLanes;
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
  const auto for_stencils = [&](bool only_hessian, const auto& body) {
    for (int t = 0; t < static_cast<int>(terms_.size()); ++t) {
      const EnergyTerm& term = *terms_[t];
      if (only_hessian && !term.has_hessian()) continue;
      for (int s = 0; s < term.stencils(); ++s) {
        body(t, s, term.indices().subspan(static_cast<size_t>(s) * term.dofs(), term.dofs()));
      }
    }
  };
  gradient_lists_ = GatherLists(dofs(), [&](const auto& emit) {
    for_stencils(false, [&](int t, int s, std::span<const int> dof) {
      for (int i = 0; i < static_cast<int>(dof.size()); ++i) {
        emit(dof[i], gradient_start_[t] + block_entry(s, terms_[t]->dofs(), i));
      }
    });
  });
  hessian_lists_ = GatherLists(pattern_.nonzeros(), [&](const auto& emit) {
    for_stencils(true, [&](int t, int s, std::span<const int> dof) {
      for (int i = 0, k = 0; i < static_cast<int>(dof.size()); ++i) {
        for (int j = 0; j <= i; ++j, ++k) {
          emit(pattern_.slot(dof[i], dof[j]), hessian_start_[t] + block_entry(s, terms_[t]->hessian_entries(), k));
        }
      }
    });
  });
}

double Potential::value(const State& state, AssemblyBuffers& buffers, ThreadPool* threads,
                        std::span<double> by_term) const {
  buffers.energy.resize(energy_start_.back());
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
  buffers.gradient.resize(gradient_start_.back());
  if (with_hessian) buffers.hessian.resize(hessian_start_.back());
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
  gradient.resize(dofs());
  gradient_lists_.sum(buffers.gradient.data(), gradient.data(), threads);
}

void Potential::hessian(const State& state, VecX& gradient, std::vector<double>& values, AssemblyBuffers& buffers,
                        ThreadPool* threads) const {
  evaluate_blocks(state, buffers, true, threads);
  gradient.resize(dofs());
  gradient_lists_.sum(buffers.gradient.data(), gradient.data(), threads);
  values.resize(pattern_.nonzeros());
  hessian_lists_.sum(buffers.hessian.data(), values.data(), threads);
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
