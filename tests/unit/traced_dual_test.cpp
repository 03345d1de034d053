/// Third derivatives by a sweep back: closed forms of single functions, and an expression of them all against other duals.

#include "lissom/core/traced_dual.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>

namespace lissom {
namespace {

/// f''' of f(x) at x: both directions and the variable are the same one.
template <class F>
double third_of(double x, const F& f) {
  Tape tape;
  const TracedDual v = tape.variable({x, 1, 1, 0});
  tape.add_result(f(v), 1);
  tape.sweep();
  return tape.by(v).d12;
}

TEST(TracedDual, SingleFunctionsHaveTheirThirdDerivatives) {
  const double x = 0.7, t = std::tanh(x), slope = 1 - t * t;
  EXPECT_NEAR(third_of(x, [](const TracedDual& v) { return v * v * v; }), 6, 1e-14);
  EXPECT_NEAR(third_of(x, [](const TracedDual& v) { return TracedDual(2) / v; }), -12 / std::pow(x, 4), 1e-12);
  EXPECT_NEAR(third_of(x, [](const TracedDual& v) { return v / TracedDual(2) * v * v; }), 3, 1e-14);
  EXPECT_NEAR(third_of(x, [](const TracedDual& v) { return sqrt(v); }), 0.375 * std::pow(x, -2.5), 1e-14);
  EXPECT_NEAR(third_of(x, [](const TracedDual& v) { return sin(v); }), -std::cos(x), 1e-15);
  EXPECT_NEAR(third_of(x, [](const TracedDual& v) { return cos(v); }), std::sin(x), 1e-15);
  EXPECT_NEAR(third_of(x, [](const TracedDual& v) { return -tanh(v); }), slope * (2 - 6 * t * t), 1e-14);
  const auto arctangent = [](const TracedDual& v) { return atan2(v, TracedDual(1)); };
  EXPECT_NEAR(third_of(0, arctangent), -2, 1e-15);
  EXPECT_NEAR(third_of(x, arctangent), (6 * x * x - 2) / std::pow(1 + x * x, 3), 1e-14);
  // Through the vertical, and behind it.
  EXPECT_NEAR(third_of(1e-9, [](const TracedDual& v) { return atan2(TracedDual(1), v); }), 2, 1e-8);
  EXPECT_NEAR(third_of(-x, [](const TracedDual& v) { return atan2(TracedDual(-1), v); }),
              (6 * x * x - 2) / std::pow(1 + x * x, 3), 1e-14);
}

template <class T>
T mixture(const std::array<T, 4>& x) {
  using std::atan2, std::cos, std::sin, std::sqrt, std::tanh;
  T sum = x[0] * x[1] - x[2] / x[3];
  sum += sin(x[0] * x[3]) * sqrt(x[1] + T(2)) * T(0.5);
  sum -= atan2(x[2] + x[1], cos(x[0]) - x[3]) * 3.0;
  sum *= tanh(x[1] - x[2]) + T(2);
  sum /= x[3] * x[3] + x[0];
  return -sum + sum * sum;
}

constexpr std::array<double, 4> kPlace{0.4, 1.1, -0.7, 1.6}, kFirst{1, -0.3, 0.5, 0.8}, kSecond{-0.2, 0.9, 0.6, 0.4};

/// Hessian times the first direction, at a place moved along the second.
std::array<double, 4> hessian_product(double step) {
  std::array<Dual2<4>, 4> x;
  for (int i = 0; i < 4; ++i) x[i] = Dual2<4>::variable(kPlace[i] + step * kSecond[i], i);
  const Dual2<4> value = mixture(x);
  std::array<double, 4> product{};
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) product[i] += value.hessian(i, j) * kFirst[j];
  }
  return product;
}

TEST(TracedDual, MixtureAgreesWithOtherDuals) {
  Tape tape;
  // A tape serves again after it is cleared.
  for (int run = 0; run < 2; ++run) {
    tape.clear();
    std::array<TracedDual, 4> x;
    for (int i = 0; i < 4; ++i) x[i] = tape.variable({kPlace[i], kFirst[i], kSecond[i], 0});
    const TracedDual value = mixture(x);
    EXPECT_NEAR(value.a, mixture(kPlace), 1e-14);
    // Results add with their weights, constants among them add nothing.
    tape.add_result(value, 2);
    tape.add_result(value, -1);
    tape.add_result(TracedDual(5), 1);
    tape.sweep();
    const std::array<double, 4> at_place = hessian_product(0);
    const auto slope = [](double h, int i) { return (hessian_product(h)[i] - hessian_product(-h)[i]) / (2 * h); };
    double first = 0;
    for (int i = 0; i < 4; ++i) {
      const double h = 1e-2;
      const double coarse = (4 * slope(h / 2, i) - slope(h, i)) / 3, fine = (4 * slope(h / 4, i) - slope(h / 2, i)) / 3;
      const double expected = (16 * fine - coarse) / 15;
      EXPECT_NEAR(tape.by(x[i]).d1, at_place[i], 1e-12 * std::abs(at_place[i]));
      EXPECT_NEAR(tape.by(x[i]).d12, expected, 1e-9 * std::abs(expected));
      first += tape.by(x[i]).a * kFirst[i];
    }
    EXPECT_NEAR(first, value.d1, 1e-13 * std::abs(value.d1));
  }
}

}  // namespace
}  // namespace lissom
