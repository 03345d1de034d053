#include "lissom/mechanics/gradient_by_rest.h"

#include <vector>

namespace lissom {

namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

void add_blocks(const EnergyTerm& term, const State& state, int numbers, Triplets& entries) {
  const int dofs = term.dofs(), rests = term.rests();
  MatX block(dofs, rests);
  int ready = -1;  // stencil whose block is at hand
  for (const RestLink& link : term.links()) {
    if (link.number >= numbers) continue;
    const int stencil = link.entry / rests, rest = link.entry % rests;
    if (stencil != ready) term.mixed(state, stencil, block.data());
    ready = stencil;
    for (int i = 0; i < dofs; ++i) {
      const double value = link.factor * block(i, rest);
      if (value != 0) entries.emplace_back(term.indices()[stencil * dofs + i], link.number, value);
    }
  }
}

/// The rotation that turns global rows into those along local axes.
SparseMatrix turn_of(const Potential& potential) {
  SparseMatrix turn(potential.dofs(), potential.dofs());
  turn.setIdentity();
  for (const LocalAxes& local : potential.local_axes()) {
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) turn.coeffRef(local.first_dof + i, local.first_dof + j) = local.axes(j, i);
    }
  }
  return turn;
}

}  // namespace

SparseMatrix gradient_by_rest(const Potential& potential, const State& state, int numbers) {
  Triplets entries;
  for (const auto& term : potential.terms()) add_blocks(*term, state, numbers, entries);
  SparseMatrix matrix(potential.dofs(), numbers);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return potential.local_axes().empty() ? matrix : SparseMatrix(turn_of(potential) * matrix);
}

}  // namespace lissom
