#pragma once
/// Four doubles that are computed with at once. Kernels written for a scalar type run on packs of stencils unchanged.
/// Uses the vector extension that GCC and Clang share (x86-64, ARM, WebAssembly); the compiler lowers it to what is there.

#include <Eigen/Core>
#include <cmath>
#include <cstring>

#include "lissom/core/types.h"

namespace lissom {

class Pack {
  typedef double Lanes __attribute__((vector_size(lissom::kLanes * sizeof(double))));

 public:
  static constexpr int kLanes = lissom::kLanes;

  Pack() = default;
  Pack(double x) : lanes_{x, x, x, x} {}  // NOLINT(google-explicit-constructor): constants mix freely with packs

  double operator[](int lane) const { return lanes_[lane]; }
  void set(int lane, double x) { lanes_[lane] = x; }
  void store(double* p) const { std::memcpy(p, &lanes_, sizeof lanes_); }
  static Pack load(const double* p) {
    Pack x;
    std::memcpy(&x.lanes_, p, sizeof x.lanes_);
    return x;
  }

  Pack& operator+=(const Pack& o) { return *this = *this + o; }
  Pack& operator-=(const Pack& o) { return *this = *this - o; }
  Pack& operator*=(const Pack& o) { return *this = *this * o; }
  Pack& operator/=(const Pack& o) { return *this = *this / o; }
  friend Pack operator+(const Pack& a, const Pack& b) { return Pack(a.lanes() + b.lanes()); }
  friend Pack operator-(const Pack& a, const Pack& b) { return Pack(a.lanes() - b.lanes()); }
  friend Pack operator*(const Pack& a, const Pack& b) { return Pack(a.lanes() * b.lanes()); }
  friend Pack operator/(const Pack& a, const Pack& b) { return Pack(a.lanes() / b.lanes()); }
  friend Pack operator-(const Pack& a) { return Pack(-a.lanes()); }
  friend Pack atan2(const Pack& y, const Pack& x);
  friend void store_lanes(const Pack* x, int n, double* out);

 private:
  // Always inlined: a call would pass the vector differently in sources compiled for other processors.
  [[gnu::always_inline]] explicit Pack(Lanes lanes) : lanes_(lanes) {}
  [[gnu::always_inline]] Lanes lanes() const { return lanes_; }

  // As loosely aligned as a double: Eigen's matrices of packs promise no more.
  typedef Lanes LooseLanes __attribute__((aligned(alignof(double))));
  LooseLanes lanes_ = {};
};

/// The n numbers of each lane one after the other, lane by lane.
inline void store_lanes(const Pack* x, int n, double* out) {
  static_assert(Pack::kLanes == 4);
  int i = 0;
  for (; i + 4 <= n; i += 4) {
    const auto a = x[i].lanes(), b = x[i + 1].lanes(), c = x[i + 2].lanes(), d = x[i + 3].lanes();
    const auto ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6), ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const auto cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6), cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
    Pack(__builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5)).store(out + i);
    Pack(__builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5)).store(out + n + i);
    Pack(__builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7)).store(out + 2 * n + i);
    Pack(__builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7)).store(out + 3 * n + i);
  }
  for (; i < n; ++i) {
    for (int lane = 0; lane < 4; ++lane) out[lane * n + i] = x[i][lane];
  }
}

inline Pack sqrt(const Pack& x) {
  Pack r;
  for (int i = 0; i < Pack::kLanes; ++i) r.set(i, std::sqrt(x[i]));
  return r;
}

/// Within 2 units in the last place. The arctangent of a quotient below 0.66 by a rational function (Cephes, S. Moshier); others are
/// turned by an eighth or a quarter first.
inline Pack atan2(const Pack& y_pack, const Pack& x_pack) {
  using Lanes = Pack::Lanes;
  const Lanes x = x_pack.lanes(), y = y_pack.lanes(), zero = {};
  const Lanes ax = x < 0 ? -x : x, ay = y < 0 ? -y : y;
  const auto steep = ay > ax;
  const Lanes large = steep ? ay : ax, small = steep ? ax : ay;
  const auto high = small > 0.66 * large;
  const Lanes a = (high ? small - large : small) / (large == 0 ? zero + 1 : high ? small + large : large);
  const Lanes z = a * a;
  const Lanes p =
      ((((-8.750608600031904122785e-1 * z - 1.615753718733365076637e1) * z - 7.500855792314704667340e1) * z -
        1.228866684490136173410e2) *
           z -
       6.485021904942025371773e1);
  const Lanes q =
      (((((z + 2.485846490142306297962e1) * z + 1.650270098316988542046e2) * z + 4.328810604912902668951e2) * z +
        4.853903996359136964868e2) *
           z +
       1.945506571482613964425e2);
  constexpr double kQuarter = 1.57079632679489661923, kQuarterRest = 6.123233995736765886130e-17;
  Lanes angle = a * (z * (p / q)) + a;
  angle = high ? 0.5 * kQuarter + (angle + 0.5 * kQuarterRest) : angle;
  angle = steep ? kQuarter - (angle - kQuarterRest) : angle;
  angle = x < 0 ? 2 * kQuarter - (angle - 2 * kQuarterRest) : angle;
  return Pack(y < 0 ? -angle : angle);
}

}  // namespace lissom

namespace Eigen {
template <>
struct NumTraits<lissom::Pack> : GenericNumTraits<double> {
  using Real = lissom::Pack;
  using NonInteger = lissom::Pack;
  using Nested = lissom::Pack;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 0,
    ReadCost = 1,
    AddCost = 1,
    MulCost = 1
  };
};
}  // namespace Eigen
