#pragma once
/// Axial stretch of one rod edge: V = 1/2 k l (|c1 - c0| / l - 1)^2 [Bergou et al. 2010; mathematics (3.10)].

#include "lissom/mechanics/stencil_term.h"
#include "lissom/mechanics/strain.h"

namespace lissom {

struct RodStretch {
  static constexpr std::string_view kName = "rod_stretch";
  static constexpr std::string_view kCitation = "Bergou et al. 2010; mathematics 1.4";
  static constexpr int kDofs = 6;  // c0, c1 (m)
  static constexpr int kRest = 2;  // rest length l (m), stiffness k (N)
  static constexpr bool kHasHessian = true;

  struct Stencil {
    std::array<int, kDofs> dofs;
    std::array<double, kRest> rest;
    int edge;
  };
  struct Frozen {};
  Frozen frozen(const State&, const Stencil&) const { return {}; }

  template <class T>
  static T value(std::span<const T, kDofs> x, std::span<const T, kRest> rest, const Frozen&) {
    using std::sqrt;
    const Vec3T<T> e(x[3] - x[0], x[4] - x[1], x[5] - x[2]);
    return stretch_energy<T>(sqrt(e.dot(e)), rest[0], rest[1]);
  }

  using Lane = Pack;
  template <class T>
  struct Local {
    Vec3T<T> t;
    T length, rest_length, stiffness;
  };

  template <class T, class R>
  void gather(const State& state, const Stencil& s, const R* rest, int lane, Local<T>& local) const {
    const EdgeState& edge = state.edges[s.edge];
    set_lane(local.t, lane, edge.t);
    set_lane(local.length, lane, edge.length);
    set_lane(local.rest_length, lane, rest[0]);
    set_lane(local.stiffness, lane, rest[1]);
  }

  template <class T>
  static T energy(const Local<T>& a) {
    return stretch_energy<T>(a.length, a.rest_length, a.stiffness);
  }

  template <class T>
  static void derivatives(const Local<T>& a, T* gradient, T* hessian) {
    const T strain = a.length / a.rest_length - T(1);
    const T force = a.stiffness * strain;
    for (int i = 0; i < 3; ++i) {
      gradient[3 + i] = force * a.t[i];
      gradient[i] = -gradient[3 + i];
    }
    if (hessian == nullptr) return;
    const T across = force / a.length, along = a.stiffness / a.rest_length - across;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        T k = along * a.t[i] * a.t[j];
        if (i == j) k += across;
        if (j <= i) {
          hessian[i * (i + 1) / 2 + j] = k;
          hessian[(3 + i) * (4 + i) / 2 + 3 + j] = k;
        }
        hessian[(3 + i) * (4 + i) / 2 + j] = -k;
      }
    }
  }

  std::vector<Stencil> stencils;

 private:
  template <class T>
  static T stretch_energy(const T& length, const T& rest_length, const T& stiffness) {
    const T strain = length / rest_length - T(1);
    return T(0.5) * stiffness * rest_length * strain * strain;
  }
};

}  // namespace lissom
