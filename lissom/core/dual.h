#pragma once
/// Forward automatic differentiation of first and second order with a fixed number of active variables: value, gradient
/// and Hessian of one scalar expression. Used where derivatives follow from a value that is written once, and to check those that
/// are written by hand.

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <concepts>

/// Arithmetic on duals is loops over hundreds of numbers: inlining it buys nothing and costs minutes of compilation.
#if defined(__GNUC__)
#define LISSOM_NOINLINE __attribute__((noinline))
#else
#define LISSOM_NOINLINE
#endif

namespace lissom {

/// a + g.d + 1/2 d'H d for N active variables d; H is stored as its lower triangle, row by row.
template <int N>
struct Dual2 {
  static constexpr int kHessian = N * (N + 1) / 2;
  double a = 0;
  std::array<double, N> g{};
  std::array<double, kHessian> h{};

  Dual2() = default;
  Dual2(double value) : a(value) {}  // NOLINT(google-explicit-constructor): constants mix freely with duals

  /// The i-th active variable at this value.
  static Dual2 variable(double value, int i) {
    Dual2 x(value);
    x.g[i] = 1;
    return x;
  }

  double hessian(int i, int j) const { return i >= j ? h[i * (i + 1) / 2 + j] : h[j * (j + 1) / 2 + i]; }

  LISSOM_NOINLINE Dual2& operator+=(const Dual2& o) {
    a += o.a;
    for (int i = 0; i < N; ++i) g[i] += o.g[i];
    for (int i = 0; i < kHessian; ++i) h[i] += o.h[i];
    return *this;
  }
  LISSOM_NOINLINE Dual2& operator-=(const Dual2& o) {
    a -= o.a;
    for (int i = 0; i < N; ++i) g[i] -= o.g[i];
    for (int i = 0; i < kHessian; ++i) h[i] -= o.h[i];
    return *this;
  }
  Dual2& operator*=(const Dual2& o) { return *this = *this * o; }
  Dual2& operator/=(const Dual2& o) { return *this = *this / o; }

  LISSOM_NOINLINE friend Dual2 operator+(Dual2 x, const Dual2& y) { return x += y; }
  LISSOM_NOINLINE friend Dual2 operator-(Dual2 x, const Dual2& y) { return x -= y; }
  LISSOM_NOINLINE friend Dual2 operator-(const Dual2& x) { return chain(x, -x.a, -1, 0); }
  LISSOM_NOINLINE friend Dual2 operator*(const Dual2& x, const Dual2& y) {
    Dual2 r(x.a * y.a);
    for (int i = 0, k = 0; i < N; ++i) {
      r.g[i] = x.a * y.g[i] + y.a * x.g[i];
      for (int j = 0; j <= i; ++j, ++k) r.h[k] = x.a * y.h[k] + y.a * x.h[k] + x.g[i] * y.g[j] + x.g[j] * y.g[i];
    }
    return r;
  }
  LISSOM_NOINLINE friend Dual2 operator/(const Dual2& x, const Dual2& y) {
    const double inverse = 1 / y.a;
    return x * chain(y, inverse, -inverse * inverse, 2 * inverse * inverse * inverse);
  }
  friend bool operator<(const Dual2& x, const Dual2& y) { return x.a < y.a; }
  friend bool operator>(const Dual2& x, const Dual2& y) { return x.a > y.a; }
  friend bool operator<=(const Dual2& x, const Dual2& y) { return x.a <= y.a; }
  friend bool operator>=(const Dual2& x, const Dual2& y) { return x.a >= y.a; }

  /// f(x) from f, f' and f'' at x.a.
  LISSOM_NOINLINE static Dual2 chain(const Dual2& x, double f, double f1, double f2) {
    Dual2 r(f);
    for (int i = 0, k = 0; i < N; ++i) {
      r.g[i] = f1 * x.g[i];
      for (int j = 0; j <= i; ++j, ++k) r.h[k] = f1 * x.h[k] + f2 * x.g[i] * x.g[j];
    }
    return r;
  }
  static Dual2 chain(const Dual2& x, double f, double f1, double f2, double) { return chain(x, f, f1, f2); }
};

/// a + g.d: the same to first order.
template <int N>
struct Dual1 {
  double a = 0;
  std::array<double, N> g{};

  Dual1() = default;
  Dual1(double value) : a(value) {}  // NOLINT(google-explicit-constructor): constants mix freely with duals

  /// The i-th active variable at this value.
  static Dual1 variable(double value, int i) {
    Dual1 x(value);
    x.g[i] = 1;
    return x;
  }

  Dual1& operator+=(const Dual1& o) {
    a += o.a;
    for (int i = 0; i < N; ++i) g[i] += o.g[i];
    return *this;
  }
  Dual1& operator-=(const Dual1& o) {
    a -= o.a;
    for (int i = 0; i < N; ++i) g[i] -= o.g[i];
    return *this;
  }
  Dual1& operator*=(const Dual1& o) { return *this = *this * o; }
  Dual1& operator/=(const Dual1& o) { return *this = *this / o; }
  friend Dual1 operator+(Dual1 x, const Dual1& y) { return x += y; }
  friend Dual1 operator-(Dual1 x, const Dual1& y) { return x -= y; }
  friend Dual1 operator-(const Dual1& x) { return chain(x, -x.a, -1); }
  friend Dual1 operator*(const Dual1& x, const Dual1& y) {
    Dual1 r(x.a * y.a);
    for (int i = 0; i < N; ++i) r.g[i] = x.a * y.g[i] + y.a * x.g[i];
    return r;
  }
  friend Dual1 operator/(const Dual1& x, const Dual1& y) {
    const double inverse = 1 / y.a;
    return x * chain(y, inverse, -inverse * inverse);
  }
  friend bool operator<(const Dual1& x, const Dual1& y) { return x.a < y.a; }
  friend bool operator>(const Dual1& x, const Dual1& y) { return x.a > y.a; }

  /// f(x) from f and f' at x.a.
  static Dual1 chain(const Dual1& x, double f, double f1) {
    Dual1 r(f);
    for (int i = 0; i < N; ++i) r.g[i] = f1 * x.g[i];
    return r;
  }
  static Dual1 chain(const Dual1& x, double f, double f1, double, double) { return chain(x, f, f1); }
};

/// Has f(x) from f and its first three derivatives at x.a, of which it takes those that it needs.
template <class D>
concept AnyDual = requires(const D& x) {
  { D::chain(x, 0.0, 0.0, 0.0, 0.0) } -> std::same_as<D>;
};

template <AnyDual D>
D sqrt(const D& x) {
  const double s = std::sqrt(x.a);
  return D::chain(x, s, 0.5 / s, -0.25 / (s * x.a), 0.375 / (s * x.a * x.a));
}

template <AnyDual D>
D sin(const D& x) {
  const double s = std::sin(x.a), c = std::cos(x.a);
  return D::chain(x, s, c, -s, -c);
}

template <AnyDual D>
D cos(const D& x) {
  const double s = std::sin(x.a), c = std::cos(x.a);
  return D::chain(x, c, -s, -c, s);
}

template <AnyDual D>
D tanh(const D& x) {
  const double t = std::tanh(x.a), f1 = 1 - t * t;
  return D::chain(x, t, f1, -2 * t * f1, f1 * (6 * t * t - 2));
}

/// Angle of the point (x, y); differentiable everywhere but at the origin.
template <AnyDual D>
D atan2(const D& y, const D& x) {
  // With (X, Y) the constant values, the angle is atan2(Y, X) + atan((X y - Y x) / (X x + Y y)): the second part is 0
  // at the point itself, with derivatives 1, 0, -2 of the arctangent.
  const D cross = D(x.a) * y - D(y.a) * x;
  const D dot = D(x.a) * x + D(y.a) * y;
  return D::chain(cross / dot, std::atan2(y.a, x.a), 1, 0, -2);
}

inline double primal(double x) { return x; }
template <AnyDual D>
double primal(const D& x) {
  return x.a;
}

}  // namespace lissom

namespace Eigen {
template <lissom::AnyDual D>
struct NumTraits<D> : GenericNumTraits<double> {
  using Real = D;
  using NonInteger = D;
  using Nested = D;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 8,
    AddCost = 64,
    MulCost = 256
  };
};
}  // namespace Eigen
