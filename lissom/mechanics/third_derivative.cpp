#include "lissom/mechanics/third_derivative.h"

#include <algorithm>
#include <vector>

#include "lissom/core/assert.h"
#include "lissom/core/traced_dual.h"

namespace lissom {

namespace {

constexpr int kStencilGrain = 64;

/// Blocks of all stencils of one term, dofs or rests numbers each. Kept from term to term for their memory.
struct TermBlocks {
  std::vector<double> lambda, dq, by_q;  // dofs
  std::vector<double> dn, by_rest;       // rests
};

void gather(const EnergyTerm& term, const VecX& lambda, const VecX& dq, const VecX& dn, TermBlocks& blocks) {
  const std::span<const int> indices = term.indices();
  blocks.lambda.resize(indices.size());
  blocks.dq.resize(indices.size());
  for (size_t i = 0; i < indices.size(); ++i) {
    blocks.lambda[i] = lambda[indices[i]];
    blocks.dq[i] = dq[indices[i]];
  }
  blocks.dn.assign(static_cast<size_t>(term.stencils()) * term.rests(), 0.0);
  for (const RestLink& link : term.links()) {
    if (link.number >= dn.size()) continue;  // loads, where only rest numbers are asked for
    blocks.dn[link.entry] += link.factor * dn[link.number];
  }
  blocks.by_q.assign(indices.size(), 0.0);
  blocks.by_rest.assign(blocks.dn.size(), 0.0);
}

bool all_zero(const double* x, int n) {
  return std::all_of(x, x + n, [](double value) { return value == 0; });
}

void evaluate(const EnergyTerm& term, const State& state, TermBlocks& blocks, ThreadPool* threads) {
  const int dofs = term.dofs(), rests = term.rests();
  parallel_for(threads, term.stencils(), kStencilGrain, [&](int begin, int end) {
    Tape tape;
    for (int s = begin; s < end; ++s) {
      const size_t q = static_cast<size_t>(s) * dofs, n = static_cast<size_t>(s) * rests;
      const StencilDirections along{&blocks.lambda[q], &blocks.dq[q], blocks.dn.data() + n};
      if (all_zero(along.lambda, dofs) || (all_zero(along.dq, dofs) && all_zero(along.dn, rests))) continue;
      term.third(state, s, along, tape, &blocks.by_q[q], blocks.by_rest.data() + n);
    }
  });
}

}  // namespace

void third_derivative(const Potential& potential, const State& state, const VecX& lambda, const VecX& dq,
                      const VecX& dn, VecX& by_q, VecX& by_numbers, ThreadPool* threads) {
  LISSOM_ASSERT(lambda.size() == potential.dofs() && dq.size() == potential.dofs());
  by_q.setZero(potential.dofs());
  by_numbers.setZero(dn.size());
  TermBlocks blocks;
  for (const auto& term : potential.terms()) {
    gather(*term, lambda, dq, dn, blocks);
    evaluate(*term, state, blocks, threads);
    // Sums in the order of stencils and links, on one thread: they take little of the time.
    const std::span<const int> indices = term->indices();
    for (size_t i = 0; i < indices.size(); ++i) by_q[indices[i]] += blocks.by_q[i];
    for (const RestLink& link : term->links()) {
      if (link.number < by_numbers.size()) by_numbers[link.number] += link.factor * blocks.by_rest[link.entry];
    }
  }
}

}  // namespace lissom
