#pragma once
/// Turns an energy struct into an EnergyTerm. The struct gives its sizes, stencils and a templated `value`; derivatives
/// follow by automatic differentiation unless it also gives hand-written ones, which tests compare with its `value`.
///
///   struct Energy {
///     static constexpr std::string_view kName, kCitation;
///     static constexpr int kDofs, kRest;
///     static constexpr bool kHasHessian;
///     struct Stencil { std::array<int, kDofs> dofs; std::array<double, kRest> rest; ... };
///     struct Frozen { ... };                               // history held constant while the unknowns vary
///     Frozen frozen(const State&, const Stencil&) const;
///     template <class T> static T value(std::span<const T, kDofs> x, std::span<const T, kRest> rest, const Frozen&);
///     std::vector<Stencil> stencils;
///     // optional fast path at the anchor, on Pack or double; on Pack it serves duals in the rest quantities too:
///     template <class T> struct Local { ... };
///     template <class T> void gather(const State&, const Stencil&, const R* rest, int lane, Local<T>&) const;
///     template <class T> static T energy(const Local<T>&);
///     template <class T> static void derivatives(const Local<T>&, T* gradient, T* hessian_or_null);
///     using Lane = Pack or double;
///   };

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>
#include <vector>

#include "lissom/core/dual.h"
#include "lissom/core/pack.h"
#include "lissom/core/traced_dual.h"
#include "lissom/mechanics/energy_term.h"

namespace lissom {

template <class E>
concept HasFastPath = requires {
  typename E::Lane;
};

/// Up to this many rest quantities are differentiated in one go.
inline constexpr int kRestAtOnce = 10;

template <class E>
class StencilTerm final : public EnergyTerm {
 public:
  explicit StencilTerm(E energy, RestLinks links = {}) : energy_(std::move(energy)), links_(std::move(links)) {
    for (const auto& s : energy_.stencils) indices_.insert(indices_.end(), s.dofs.begin(), s.dofs.end());
  }

  std::string_view name() const override { return E::kName; }
  std::string_view citation() const override { return E::kCitation; }
  int stencils() const override { return static_cast<int>(energy_.stencils.size()); }
  int dofs() const override { return E::kDofs; }
  int rests() const override { return E::kRest; }
  bool has_hessian() const override { return has_hessian_; }
  std::span<const int> indices() const override { return indices_; }

  void energies(const State& state, int begin, int end, double* energy) const override {
    if constexpr (HasFastPath<E>) {
      for_lanes(state, begin, end, [&](const auto& local, int group, int lane) {
        const auto energy_of = E::energy(local);
        write(&energy_of, 1, energy + static_cast<std::ptrdiff_t>(group) * kLanes, lane);
      });
    } else {
      for (int g = begin; g < end; ++g) {
        double* out = energy + static_cast<std::ptrdiff_t>(g) * kLanes;
        for (int lane = 0; lane < kLanes; ++lane) {
          const auto& s = stencil(g, lane);
          std::array<double, E::kDofs> x;
          for (int i = 0; i < E::kDofs; ++i) x[i] = state.q[s.dofs[i]];
          out[lane] = E::template value<double>(x, s.rest, energy_.frozen(state, s));
        }
      }
    }
  }

  void derivatives(const State& state, int begin, int end, double* gradient, double* hessian) const override {
    constexpr int kEntries = E::kDofs * (E::kDofs + 1) / 2;
    const auto gradient_of = [&](int group) {
      return gradient + static_cast<std::ptrdiff_t>(group) * E::kDofs * kLanes;
    };
    const auto hessian_of = [&](int group) { return hessian + static_cast<std::ptrdiff_t>(group) * kEntries * kLanes; };
    if constexpr (HasFastPath<E>) {
      using Lane = typename E::Lane;
      for_lanes(state, begin, end, [&](const auto& local, int group, int lane) {
        std::array<Lane, E::kDofs> lane_gradient;
        std::array<Lane, kEntries> lane_hessian;
        E::derivatives(local, lane_gradient.data(), hessian == nullptr ? nullptr : lane_hessian.data());
        write(lane_gradient.data(), E::kDofs, gradient_of(group), lane);
        if (hessian != nullptr) write(lane_hessian.data(), kEntries, hessian_of(group), lane);
      });
    } else {
      // Linear terms have no Hessian to look for.
      using Dual = std::conditional_t<E::kHasHessian, Dual2<E::kDofs>, Dual1<E::kDofs>>;
      for (int g = begin; g < end; ++g) {
        for (int lane = 0; lane < kLanes; ++lane) {
          const auto& s = stencil(g, lane);
          std::array<Dual, E::kDofs> x;
          std::array<Dual, E::kRest> rest;
          for (int i = 0; i < E::kDofs; ++i) x[i] = Dual::variable(state.q[s.dofs[i]], i);
          for (int i = 0; i < E::kRest; ++i) rest[i] = s.rest[i];
          const Dual v = E::template value<Dual>(x, rest, energy_.frozen(state, s));
          std::copy_n(v.g.data(), E::kDofs, gradient_of(g) + lane * E::kDofs);
          if constexpr (E::kHasHessian) {
            if (hessian != nullptr) std::copy_n(v.h.data(), kEntries, hessian_of(g) + lane * kEntries);
          }
        }
      }
    }
  }

  StencilDerivatives automatic(const State& state, const VecX& dq, int index) const override {
    const auto& s = energy_.stencils[index];
    StencilDerivatives d{0, VecX(E::kDofs), MatX(E::kDofs, E::kDofs), MatX(E::kDofs, E::kRest), VecX(E::kRest)};
    // Rest quantities are made active a few at a time: the size of a dual grows with the square of its variables.
    for (int begin = 0; begin < E::kRest; begin += kRestChunk) {
      using Dual = Dual2<dual_size()>;
      std::array<Dual, E::kDofs> x;
      std::array<Dual, E::kRest> rest;
      for (int i = 0; i < E::kDofs; ++i) x[i] = Dual::variable(state.q[s.dofs[i]] + dq[s.dofs[i]], i);
      for (int i = 0; i < E::kRest; ++i) rest[i] = s.rest[i];
      const int end = std::min(E::kRest, begin + kRestChunk);
      for (int i = begin; i < end; ++i) rest[i] = Dual::variable(s.rest[i], E::kDofs + i - begin);
      const Dual v = E::template value<Dual>(x, rest, energy_.frozen(state, s));
      d.energy = v.a;
      for (int i = 0; i < E::kDofs; ++i) {
        d.gradient[i] = v.g[i];
        for (int j = 0; j < E::kDofs; ++j) d.hessian(i, j) = v.hessian(i, j);
        for (int j = begin; j < end; ++j) d.mixed(i, j) = v.hessian(i, E::kDofs + j - begin);
      }
      for (int j = begin; j < end; ++j) d.rest_gradient[j] = v.g[E::kDofs + j - begin];
    }
    return d;
  }

  void mixed(const State& state, int index, double* block) const override {
    if constexpr (kMixesFast) {
      using Variable = Dual1<E::kRest>;
      const auto& s = energy_.stencils[index];
      std::array<Variable, E::kRest> rest;
      for (int i = 0; i < E::kRest; ++i) rest[i] = Variable::variable(s.rest[i], i);
      typename E::template Local<Variable> local{};
      energy_.gather(state, s, rest.data(), 0, local);
      std::array<Variable, E::kDofs> gradient;
      E::derivatives(local, gradient.data(), static_cast<Variable*>(nullptr));
      for (int j = 0; j < E::kRest; ++j) {
        for (int i = 0; i < E::kDofs; ++i) block[j * E::kDofs + i] = gradient[i].g[j];
      }
    } else {
      // Two unknowns at a time are the directions of a sweep back: large duals cost a hundred times as much.
      constexpr std::array<double, E::kRest> kNothing{};
      Tape tape;
      for (int i = 0; i < E::kDofs; i += 2) {
        std::array<double, E::kDofs> one{}, next{};
        const bool both = i + 1 < E::kDofs;
        one[i] = 1;
        if (both) next[i + 1] = 1;
        trace(state, index, {one.data(), next.data(), kNothing.data()}, tape, [&](const auto&, const auto& rest) {
          for (int j = 0; j < E::kRest; ++j) {
            const HyperDual& by = tape.by(rest[j]);
            block[j * E::kDofs + i] = by.d1;
            if (both) block[j * E::kDofs + i + 1] = by.d2;
          }
        });
      }
    }
  }

  void third(const State& state, int index, const StencilDirections& along, Tape& tape, double* by_q,
             double* by_rest) const override {
    trace(state, index, along, tape, [&](const auto& x, const auto& rest) {
      for (int i = 0; i < E::kDofs; ++i) by_q[i] = tape.by(x[i]).d12;
      for (int i = 0; i < E::kRest; ++i) by_rest[i] = tape.by(rest[i]).d12;
    });
  }

  void second(const State& state, int index, const double* dq, const double* dn, Tape& tape, HyperDual* by_q,
              HyperDual* by_rest) const override {
    constexpr std::array<double, E::kDofs> kNothing{};
    trace(state, index, {kNothing.data(), dq, dn}, tape, [&](const auto& x, const auto& rest) {
      for (int i = 0; i < E::kDofs; ++i) by_q[i] = tape.by(x[i]);
      for (int i = 0; i < E::kRest; ++i) by_rest[i] = tape.by(rest[i]);
    });
  }

  const RestLinks& links() const override { return links_; }

  VecX rest(int index) const override {
    const auto& r = energy_.stencils[index].rest;
    return Eigen::Map<const VecX>(r.data(), E::kRest);
  }
  void set_rest(int index, const VecX& rest) override {
    for (int i = 0; i < E::kRest; ++i) energy_.stencils[index].rest[i] = rest[i];
  }
  std::unique_ptr<EnergyTerm> touching(const std::vector<bool>& unknown, bool with_hessian) const override {
    E part = energy_;
    std::erase_if(part.stencils, [&](const typename E::Stencil& s) {
      return std::none_of(s.dofs.begin(), s.dofs.end(), [&](int dof) { return unknown[dof]; });
    });
    auto term = std::make_unique<StencilTerm>(std::move(part));
    term->has_hessian_ = term->has_hessian_ && with_hessian;
    return term;
  }

 private:
  /// Whether the hand-written gradient can be differentiated by the rest quantities.
  static constexpr bool kMixesFast = [] {
    if constexpr (HasFastPath<E>) return std::is_same_v<typename E::Lane, Pack>;
    return false;
  }();
  static constexpr int kRestChunk = E::kRest <= kRestAtOnce ? E::kRest : 5;

  static constexpr int dual_size() {
    if constexpr (requires { E::kDualSize; }) {
      return E::kDualSize;
    } else {
      return E::kDofs + kRestChunk;
    }
  }

  /// Sweeps back over one stencil's value; `read` gets its variables.
  template <class Read>
  void trace(const State& state, int index, const StencilDirections& along, Tape& tape, const Read& read) const {
    const auto& s = energy_.stencils[index];
    std::array<TracedDual, E::kDofs> x;
    std::array<TracedDual, E::kRest> rest;
    tape.clear();
    for (int i = 0; i < E::kDofs; ++i) x[i] = tape.variable({state.q[s.dofs[i]], along.lambda[i], along.dq[i], 0});
    for (int i = 0; i < E::kRest; ++i) rest[i] = tape.variable({s.rest[i], 0, along.dn[i], 0});
    tape.add_result(E::template value<TracedDual>(x, rest, energy_.frozen(state, s)), 1);
    tape.sweep();
    read(x, rest);
  }

  const typename E::Stencil& stencil(int group, int lane) const {
    return energy_.stencils[std::min(group * kLanes + lane, stencils() - 1)];
  }
  static void write(const Pack* x, int n, double* out, int) { store_lanes(x, n, out); }
  static void write(const double* x, int n, double* out, int lane) { std::copy(x, x + n, out + lane * n); }

  /// Calls f(local, group, lane) for the groups [begin, end): once for a whole pack, or lane by lane for kernels on doubles.
  template <class F>
  void for_lanes(const State& state, int begin, int end, const F& f) const {
    using Lane = typename E::Lane;
    if constexpr (std::is_same_v<Lane, Pack>) {
      // The next group is gathered before this one is computed: packs that were written lane by lane can be read at
      // full speed only a while later.
      std::array<typename E::template Local<Pack>, 2> local{};
      const auto gather = [&](int group) {
        for (int lane = 0; lane < kLanes; ++lane) {
          const auto& s = stencil(group, lane);
          energy_.gather(state, s, s.rest.data(), lane, local[group % 2]);
        }
      };
      if (begin < end) gather(begin);
      for (int group = begin; group < end; ++group) {
        if (group + 1 < end) gather(group + 1);
        f(local[group % 2], group, 0);
      }
    } else {
      for (int group = begin; group < end; ++group) {
        for (int lane = 0; lane < kLanes; ++lane) {
          typename E::template Local<double> local{};
          const auto& s = stencil(group, lane);
          energy_.gather(state, s, s.rest.data(), 0, local);
          f(local, group, lane);
        }
      }
    }
  }

  E energy_;
  RestLinks links_;
  std::vector<int> indices_;
  bool has_hessian_ = E::kHasHessian;
};

template <class E>
std::unique_ptr<EnergyTerm> make_term(E energy, RestLinks links = {}) {
  return std::make_unique<StencilTerm<E>>(std::move(energy), std::move(links));
}

/// Sets one lane of a scalar that may be a pack; others have one lane.
inline void set_lane(Pack& x, int lane, double value) { x.set(lane, value); }
inline void set_lane(double& x, int, double value) { x = value; }
template <AnyDual D>
void set_lane(D& x, int, const std::type_identity_t<D>& value) {
  x = value;
}

template <class T>
void set_lane(Eigen::Matrix<T, 3, 1>& x, int lane, const Vec3& value) {
  for (int i = 0; i < 3; ++i) set_lane(x[i], lane, value[i]);
}

}  // namespace lissom
