#pragma once
/// Four doubles that are computed with at once. Kernels written for a scalar type run on packs of stencils unchanged.
/// Uses the vector extension that GCC and Clang share (x86-64, ARM, WebAssembly); the compiler lowers it to what is there.

#include <cmath>

#include <Eigen/Core>

namespace lissom {

struct Pack {
  static constexpr int kLanes = 4;
  typedef double Lanes __attribute__((vector_size(kLanes * sizeof(double))));
  Lanes v{};

  Pack() = default;
  Pack(double x) : v{x, x, x, x} {}  // NOLINT(google-explicit-constructor): constants mix freely with packs
  explicit Pack(Lanes lanes) : v(lanes) {}

  double operator[](int lane) const { return v[lane]; }
  void set(int lane, double x) { v[lane] = x; }

  static Pack load(const double* p) {
    return Pack(Lanes{p[0], p[1], p[2], p[3]});
  }
  void store(double* p) const {
    for (int i = 0; i < kLanes; ++i) p[i] = v[i];
  }

  Pack& operator+=(const Pack& o) {
    v += o.v;
    return *this;
  }
  Pack& operator-=(const Pack& o) {
    v -= o.v;
    return *this;
  }
  Pack& operator*=(const Pack& o) {
    v *= o.v;
    return *this;
  }
  Pack& operator/=(const Pack& o) {
    v /= o.v;
    return *this;
  }
  friend Pack operator+(const Pack& a, const Pack& b) { return Pack(a.v + b.v); }
  friend Pack operator-(const Pack& a, const Pack& b) { return Pack(a.v - b.v); }
  friend Pack operator*(const Pack& a, const Pack& b) { return Pack(a.v * b.v); }
  friend Pack operator/(const Pack& a, const Pack& b) { return Pack(a.v / b.v); }
  friend Pack operator-(const Pack& a) { return Pack(-a.v); }
};

inline Pack sqrt(const Pack& x) {
  Pack r;
  for (int i = 0; i < Pack::kLanes; ++i) r.v[i] = std::sqrt(x.v[i]);
  return r;
}

}  // namespace lissom

namespace Eigen {
template <>
struct NumTraits<lissom::Pack> : GenericNumTraits<double> {
  using Real = lissom::Pack;
  using NonInteger = lissom::Pack;
  using Nested = lissom::Pack;
  enum { IsComplex = 0, IsInteger = 0, IsSigned = 1, RequireInitialization = 0, ReadCost = 1, AddCost = 1, MulCost = 1 };
};
}  // namespace Eigen
