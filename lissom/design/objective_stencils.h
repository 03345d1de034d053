#pragma once
/// Objectives whose components are sums of functions of a few unknowns and rest numbers each: the function is written once,
/// as a template, and all derivatives follow by automatic differentiation.
///
///   struct Function {
///     static constexpr int kDofs, kRest;
///     struct Stencil : ObjectiveStencil<kDofs, kRest> { ... };  // besides, whatever is constant while unknowns vary
///     template <class T>
///     static T value(const T* x, const T* rest, const Stencil&);
///   };

#include <array>
#include <span>
#include <vector>

#include "lissom/core/dual.h"
#include "lissom/design/objective.h"
#include "lissom/mechanics/rest_numbers.h"

namespace lissom {

template <int Dofs, int Rest>
struct ObjectiveStencil {
  int component = 0;                 ///< that the value adds to
  std::array<int, Dofs> dofs{};      ///< unknowns; may repeat
  std::array<int, Rest> numbers{};   ///< in the order of RestNumbers
  std::array<double, Rest> rest{};   ///< their values
};

/// Triplets of the two blocks of a Jacobian.
struct JacobianEntries {
  std::vector<Eigen::Triplet<double>> by_q, by_numbers;

  void write(const PoseShape& shape, int rows, SparseRows& q, SparseRows& numbers) const {
    q.resize(rows, shape.design.system.layout.size());
    q.setFromTriplets(by_q.begin(), by_q.end());
    numbers.resize(rows, RestNumbers(shape.design.system.structure).size());
    numbers.setFromTriplets(by_numbers.begin(), by_numbers.end());
  }
};

template <class F>
void add_values(std::span<const typename F::Stencil> stencils, const State& state, VecX& c) {
  for (const auto& s : stencils) {
    std::array<double, F::kDofs> x;
    for (int i = 0; i < F::kDofs; ++i) x[i] = state.q[s.dofs[i]];
    c[s.component] += F::template value<double>(x.data(), s.rest.data(), s);
  }
}

/// One stencil's value in duals of unknowns, then rest numbers.
template <class F, class Dual>
Dual stencil_dual(const typename F::Stencil& s, const State& state) {
  std::array<Dual, F::kDofs> x;
  std::array<Dual, F::kRest> rest;
  for (int i = 0; i < F::kDofs; ++i) x[i] = Dual::variable(state.q[s.dofs[i]], i);
  for (int i = 0; i < F::kRest; ++i) rest[i] = Dual::variable(s.rest[i], F::kDofs + i);
  return F::template value<Dual>(x.data(), rest.data(), s);
}

template <class F>
void add_jacobian(std::span<const typename F::Stencil> stencils, const State& state, JacobianEntries& entries) {
  for (const auto& s : stencils) {
    const auto v = stencil_dual<F, Dual1<F::kDofs + F::kRest>>(s, state);
    for (int i = 0; i < F::kDofs; ++i) entries.by_q.emplace_back(s.component, s.dofs[i], v.g[i]);
    for (int i = 0; i < F::kRest; ++i) entries.by_numbers.emplace_back(s.component, s.numbers[i], v.g[F::kDofs + i]);
  }
}

template <class F>
void add_curvature(std::span<const typename F::Stencil> stencils, const State& state, const VecX& y, const VecX& dq,
                   const VecX& dn, VecX& by_q, VecX& by_numbers) {
  constexpr int kAll = F::kDofs + F::kRest;
  for (const auto& s : stencils) {
    if (y[s.component] == 0) continue;
    const auto v = stencil_dual<F, Dual2<kAll>>(s, state);
    std::array<double, kAll> d, change{};
    for (int i = 0; i < F::kDofs; ++i) d[i] = dq[s.dofs[i]];
    for (int i = 0; i < F::kRest; ++i) d[F::kDofs + i] = dn[s.numbers[i]];
    for (int i = 0; i < kAll; ++i) {
      for (int j = 0; j < kAll; ++j) change[i] += v.hessian(i, j) * d[j];
    }
    for (int i = 0; i < F::kDofs; ++i) by_q[s.dofs[i]] += y[s.component] * change[i];
    for (int i = 0; i < F::kRest; ++i) by_numbers[s.numbers[i]] += y[s.component] * change[F::kDofs + i];
  }
}

/// An objective of one function. `F` derives from it and has, besides the above,
///   std::vector<Stencil> stencils(const PoseShape&) const;
template <class F>
class StencilObjective : public Objective {
 public:
  void values(const PoseShape& shape, VecX& c) const final {
    c.setZero(size());
    const auto stencils = own().stencils(shape);
    add_values<F>(stencils, shape.state, c);
  }
  void jacobian(const PoseShape& shape, SparseRows& by_q, SparseRows& by_numbers) const final {
    JacobianEntries entries;
    const auto stencils = own().stencils(shape);
    add_jacobian<F>(stencils, shape.state, entries);
    entries.write(shape, size(), by_q, by_numbers);
  }
  void curvature(const PoseShape& shape, const VecX& y, const VecX& dq, const VecX& dn, VecX& by_q,
                 VecX& by_numbers) const final {
    const auto stencils = own().stencils(shape);
    add_curvature<F>(stencils, shape.state, y, dq, dn, by_q, by_numbers);
  }

 private:
  const F& own() const { return static_cast<const F&>(*this); }
};

}  // namespace lissom
