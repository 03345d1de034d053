#pragma once
/// Four doubles that are computed with at once. Kernels written for a scalar type run on packs of stencils unchanged.
/// Uses the vector extension that GCC and Clang share (x86-64, ARM, WebAssembly); the compiler lowers it to what is there.

#include <Eigen/Core>
#include <cmath>
#include <cstring>

#include "lissom/core/types.h"

namespace lissom {

class Pack {
 public:
  static constexpr int kLanes = lissom::kLanes;

  Pack() = default;
  Pack(double x) : lane_{x, x, x, x} {}  // NOLINT(google-explicit-constructor): constants mix freely with packs

  double operator[](int lane) const { return lane_[lane]; }
  void set(int lane, double x) { lane_[lane] = x; }
  void store(double* p) const { std::memcpy(p, lane_, sizeof lane_); }

  Pack& operator+=(const Pack& o) { return *this = *this + o; }
  Pack& operator-=(const Pack& o) { return *this = *this - o; }
  Pack& operator*=(const Pack& o) { return *this = *this * o; }
  Pack& operator/=(const Pack& o) { return *this = *this / o; }
  friend Pack operator+(const Pack& a, const Pack& b) { return Pack(a.lanes() + b.lanes()); }
  friend Pack operator-(const Pack& a, const Pack& b) { return Pack(a.lanes() - b.lanes()); }
  friend Pack operator*(const Pack& a, const Pack& b) { return Pack(a.lanes() * b.lanes()); }
  friend Pack operator/(const Pack& a, const Pack& b) { return Pack(a.lanes() / b.lanes()); }
  friend Pack operator-(const Pack& a) { return Pack(-a.lanes()); }

 private:
  typedef double Lanes __attribute__((vector_size(kLanes * sizeof(double))));
  // Always inlined: a call would pass the vector differently in sources compiled for other processors.
  [[gnu::always_inline]] explicit Pack(Lanes lanes) { std::memcpy(lane_, &lanes, sizeof lane_); }
  [[gnu::always_inline]] Lanes lanes() const {
    Lanes lanes;
    std::memcpy(&lanes, lane_, sizeof lane_);
    return lanes;
  }

  // Stored as an array, so that single lanes are ordinary stores; the copies above become vector loads.
  double lane_[kLanes] = {};
};

inline Pack sqrt(const Pack& x) {
  Pack r;
  for (int i = 0; i < Pack::kLanes; ++i) r.set(i, std::sqrt(x[i]));
  return r;
}

inline Pack atan2(const Pack& y, const Pack& x) {
  Pack r;
  for (int i = 0; i < Pack::kLanes; ++i) r.set(i, std::atan2(y[i], x[i]));
  return r;
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
