#pragma once
/// Objectives whose components are sums of functions of a few unknowns and rest numbers each: the function is written once,
/// as a template, and all derivatives follow by a sweep back over its operations.
///
///   struct Function {
///     struct Stencil : ObjectiveStencil { ... };  // besides, whatever is constant while unknowns vary
///     template <class T>
///     static T value(const T* x, const T* rest, const Stencil&);
///   };

#include <span>
#include <vector>

#include "lissom/core/traced_dual.h"
#include "lissom/design/objective.h"
#include "lissom/mechanics/rest_numbers.h"

namespace lissom {

struct ObjectiveStencil {
  int component = 0;         ///< that the value adds to
  std::vector<int> dofs;     ///< unknowns; may repeat
  std::vector<int> numbers;  ///< in the order of RestNumbers; may repeat
  std::vector<double> rest;  ///< their values

  void add_node(int node) {
    for (int i = 0; i < 3; ++i) dofs.push_back(3 * node + i);
  }
  void add_number(int number, double value) {
    numbers.push_back(number);
    rest.push_back(value);
  }
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
  std::vector<double> x;
  for (const auto& s : stencils) {
    x.clear();
    for (const int dof : s.dofs) x.push_back(state.q[dof]);
    c[s.component] += F::template value<double>(x.data(), s.rest.data(), s);
  }
}

/// Evaluates stencils on a tape, one at a time. Variables are unknowns, then rest numbers.
class StencilTape {
 public:
  /// Derivatives by all variables, and, unless null, their changes along dq and dn.
  template <class F>
  std::span<const HyperDual> differentiate(const typename F::Stencil& s, const State& state, const VecX* dq,
                                           const VecX* dn) {
    tape_.clear();
    variables_.clear();
    derivatives_.clear();
    for (const int dof : s.dofs) {
      variables_.push_back(tape_.variable({state.q[dof], 0, dq == nullptr ? 0 : (*dq)[dof], 0}));
    }
    for (std::size_t i = 0; i < s.numbers.size(); ++i) {
      variables_.push_back(tape_.variable({s.rest[i], 0, dn == nullptr ? 0 : (*dn)[s.numbers[i]], 0}));
    }
    tape_.add_result(F::template value<TracedDual>(variables_.data(), variables_.data() + s.dofs.size(), s), 1);
    tape_.sweep();
    for (const TracedDual& v : variables_) derivatives_.push_back(tape_.by(v));
    return derivatives_;
  }

 private:
  Tape tape_;
  std::vector<TracedDual> variables_;
  std::vector<HyperDual> derivatives_;
};

template <class F>
void add_jacobian(std::span<const typename F::Stencil> stencils, const State& state, JacobianEntries& entries) {
  StencilTape tape;
  for (const auto& s : stencils) {
    const auto d = tape.differentiate<F>(s, state, nullptr, nullptr);
    const std::size_t dofs = s.dofs.size();
    for (std::size_t i = 0; i < dofs; ++i) entries.by_q.emplace_back(s.component, s.dofs[i], d[i].a);
    for (std::size_t i = dofs; i < d.size(); ++i) {
      entries.by_numbers.emplace_back(s.component, s.numbers[i - dofs], d[i].a);
    }
  }
}

template <class F>
void add_curvature(std::span<const typename F::Stencil> stencils, const State& state, const VecX& y, const VecX& dq,
                   const VecX& dn, VecX& by_q, VecX& by_numbers) {
  StencilTape tape;
  for (const auto& s : stencils) {
    if (y[s.component] == 0) continue;
    const auto d = tape.differentiate<F>(s, state, &dq, &dn);
    const std::size_t dofs = s.dofs.size();
    for (std::size_t i = 0; i < dofs; ++i) by_q[s.dofs[i]] += y[s.component] * d[i].d2;
    for (std::size_t i = dofs; i < d.size(); ++i) by_numbers[s.numbers[i - dofs]] += y[s.component] * d[i].d2;
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
