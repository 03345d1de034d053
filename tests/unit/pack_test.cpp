#include "lissom/core/pack.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <vector>

namespace lissom {
namespace {

void expect_arctangents(const std::array<double, 4>& y, const std::array<double, 4>& x) {
  const Pack angle = atan2(Pack::load(y.data()), Pack::load(x.data()));
  for (int i = 0; i < 4; ++i) {
    const double exact = std::atan2(y[i], x[i]);
    EXPECT_LE(std::abs(angle[i] - exact), 4.5e-16 * std::abs(exact)) << y[i] << ' ' << x[i];
  }
}

TEST(Pack, ArctangentsAreExactToTheLastPlaces) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-9, 9), sign(-1, 1);
  const auto number = [&] { return std::copysign(std::pow(10.0, exponent(random)), sign(random)); };
  for (int i = 0; i < 20000; ++i) {
    std::array<double, 4> y{}, x{};
    for (int k = 0; k < 4; ++k) {
      y[k] = number();
      x[k] = number();
    }
    expect_arctangents(y, x);
  }
  for (int i = -4000; i < 4000; ++i) {  // around every limit between two formulas
    const double angle = i * 1e-3;
    const std::array<double, 4> y{std::sin(angle), 2 * std::sin(angle), 1e-3 * std::sin(angle), std::sin(angle) / 3};
    const std::array<double, 4> x{std::cos(angle), 2 * std::cos(angle), 1e-3 * std::cos(angle), std::cos(angle) / 3};
    expect_arctangents(y, x);
  }
}

TEST(Pack, ArctangentsOnTheAxes) {
  expect_arctangents({0, 1, 0, -1}, {1, 0, -1, 0});
  expect_arctangents({1, 1, -1, -1}, {1, -1, 1, -1});
  expect_arctangents({0, 1e-300, 1e300, -1e300}, {0, 1e300, 1e-300, -1e300});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Pack angle =
      atan2(Pack::load(std::array{nan, 1.0, nan, 0.0}.data()), Pack::load(std::array{1.0, nan, nan, 2.0}.data()));
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(std::isnan(angle[i])) << i;
  EXPECT_EQ(angle[3], 0);
}

TEST(Pack, LanesAreStoredOneAfterTheOther) {
  for (const int n : {1, 2, 3, 4, 5, 7, 8, 78}) {
    std::vector<Pack> x(n);
    for (int i = 0; i < n; ++i) {
      for (int lane = 0; lane < 4; ++lane) x[i].set(lane, 100 * lane + i);
    }
    std::vector<double> out(4 * n, -1);
    store_lanes(x.data(), n, out.data());
    for (int lane = 0; lane < 4; ++lane) {
      for (int i = 0; i < n; ++i) EXPECT_EQ(out[lane * n + i], 100 * lane + i) << n << ' ' << lane << ' ' << i;
    }
  }
}

}  // namespace
}  // namespace lissom
