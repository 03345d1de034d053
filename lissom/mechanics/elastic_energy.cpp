#include "lissom/mechanics/elastic_energy.h"

#include <vector>

#include "lissom/core/traced_dual.h"
#include "lissom/mechanics/energies.h"

namespace lissom {

namespace {

/// Calls add(place in q or -1, number or -1, factor, derivative) for all derivatives of all stencils, in their order.
template <class Add>
void for_derivatives(const Potential& potential, const State& state, const VecX& dq, const VecX& dn, const Add& add) {
  Tape tape;
  std::vector<double> own_dq, own_dn;
  std::vector<HyperDual> by_q, by_rest;
  for (const auto& term : potential.terms()) {
    if (!is_elastic(term->name())) continue;
    const int dofs = term->dofs(), rests = term->rests();
    const std::span<const int> indices = term->indices();
    own_dq.resize(dofs);
    own_dn.assign(static_cast<std::size_t>(term->stencils()) * rests, 0);
    by_q.resize(dofs);
    by_rest.resize(own_dn.size());
    for (const RestLink& link : term->links()) own_dn[link.entry] += link.factor * dn[link.number];
    for (int s = 0; s < term->stencils(); ++s) {
      const auto first = static_cast<std::size_t>(s) * rests;
      for (int i = 0; i < dofs; ++i) own_dq[i] = dq[indices[s * dofs + i]];
      term->second(state, s, own_dq.data(), own_dn.data() + first, tape, by_q.data(), by_rest.data() + first);
      for (int i = 0; i < dofs; ++i) add(indices[s * dofs + i], -1, 1, by_q[i]);
    }
    for (const RestLink& link : term->links()) add(-1, link.number, link.factor, by_rest[link.entry]);
  }
}

}  // namespace

double elastic_energy(const Potential& potential, const State& state) {
  double sum = 0;
  std::vector<double> energies;
  for (const auto& term : potential.terms()) {
    if (!is_elastic(term->name())) continue;
    energies.resize(static_cast<std::size_t>(term->groups()) * kLanes);
    term->energies(state, 0, term->groups(), energies.data());
    for (int s = 0; s < term->stencils(); ++s) sum += energies[s];
  }
  return sum;
}

void elastic_gradient(const Potential& potential, const State& state, VecX& by_q, VecX& by_numbers) {
  by_q.setZero();
  by_numbers.setZero();
  const VecX still = VecX::Zero(by_q.size()), same = VecX::Zero(by_numbers.size());
  for_derivatives(potential, state, still, same, [&](int dof, int number, double factor, const HyperDual& d) {
    (dof >= 0 ? by_q[dof] : by_numbers[number]) += factor * d.a;
  });
}

void add_elastic_curvature(const Potential& potential, const State& state, double factor, const VecX& dq,
                           const VecX& dn, VecX& by_q, VecX& by_numbers) {
  for_derivatives(potential, state, dq, dn, [&](int dof, int number, double share, const HyperDual& d) {
    (dof >= 0 ? by_q[dof] : by_numbers[number]) += factor * share * d.d2;
  });
}

}  // namespace lissom
