#include "lissom/view/color_map.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "lissom/view/ticks.h"

namespace lissom {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// CIE L* of an sRGB colour.
double lightness(const Color& c) {
  const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
  const double y = 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
  return y > 0.008856 ? 116 * std::cbrt(y) - 16 : 903.3 * y;
}

TEST(ColorMap, SequentialLightnessRisesEvenly) {
  double previous = lightness(map_color(Field::Colors::kSequential, 0));
  const double step = (lightness(map_color(Field::Colors::kSequential, 1)) - previous) / 50;
  for (int k = 1; k <= 50; ++k) {
    const double now = lightness(map_color(Field::Colors::kSequential, k / 50.0));
    EXPECT_NEAR(now - previous, step, 0.25 * step) << k;
    previous = now;
  }
}

TEST(ColorMap, DivergingIsBlueWhiteRedAndDarkensToBothEnds) {
  const Color low = map_color(Field::Colors::kDiverging, 0), high = map_color(Field::Colors::kDiverging, 1);
  const Color middle = map_color(Field::Colors::kDiverging, 0.5);
  EXPECT_GT(low.b, low.r + 0.3);
  EXPECT_GT(high.r, high.b + 0.3);
  EXPECT_EQ(middle.r, middle.b);
  for (int k = 0; k < 20; ++k) {
    EXPECT_LT(lightness(map_color(Field::Colors::kDiverging, k / 40.0)),
              lightness(map_color(Field::Colors::kDiverging, (k + 1) / 40.0)));
    EXPECT_LT(lightness(map_color(Field::Colors::kDiverging, 1 - k / 40.0)),
              lightness(map_color(Field::Colors::kDiverging, 1 - (k + 1) / 40.0)));
  }
}

TEST(ColorMap, RangeFitsFiniteValues) {
  const std::vector<double> values = {kNan, -1, 3, kNan, 0.5};
  const ColorRange sequential = ColorRange::fitting(Field::Colors::kSequential, values);
  EXPECT_EQ(sequential.low, -1);
  EXPECT_EQ(sequential.high, 3);
  const ColorRange diverging = ColorRange::fitting(Field::Colors::kDiverging, values);
  EXPECT_EQ(diverging.low, -3);
  EXPECT_EQ(diverging.high, 3);
  EXPECT_EQ(diverging.color(Field::Colors::kDiverging, 0), map_color(Field::Colors::kDiverging, 0.5));
  EXPECT_EQ(diverging.color(Field::Colors::kDiverging, kNan), kNoValueColor);
  EXPECT_EQ(diverging.color(Field::Colors::kDiverging, 99), map_color(Field::Colors::kDiverging, 1));
  const ColorRange none = ColorRange::fitting(Field::Colors::kSequential, std::vector<double>{kNan});
  EXPECT_EQ(none.color(Field::Colors::kSequential, 5), map_color(Field::Colors::kSequential, 0.5));
}

TEST(Ticks, LinearTicksAreRoundAndInside) {
  int checked = 0;
  for (double low : {-3.7, 0.0, 1e-7, 12345.0, -1e9}) {
    for (double extent : {1.0, 0.02, 7e4, 3e-8, 2.2e9}) {
      const double high = low + extent;
      if (!(extent > 1e-9 * std::abs(low))) continue;
      const Ticks ticks = linear_ticks(low, high, 6);
      ASSERT_GE(ticks.at.size(), 3u) << low << " " << high;
      ASSERT_LE(ticks.at.size(), 14u) << low << " " << high;
      ASSERT_EQ(ticks.at.size(), ticks.labels.size());
      for (size_t i = 0; i < ticks.at.size(); ++i) {
        EXPECT_GE(ticks.at[i], low - 1e-6 * extent);
        EXPECT_LE(ticks.at[i], high + 1e-6 * extent);
        if (i > 0) {
          EXPECT_NE(ticks.labels[i], ticks.labels[i - 1]) << low << " " << high;
        }
        ++checked;
      }
    }
  }
  EXPECT_GT(checked, 50);
}

TEST(Ticks, Labels) {
  const Ticks ticks = linear_ticks(-0.1, 0.2, 6);
  EXPECT_EQ(ticks.labels, (std::vector<std::string>{"\u22120.10", "\u22120.05", "0", "0.05", "0.10", "0.15", "0.20"}));
  const Ticks small = linear_ticks(0, 4e-6, 4);
  EXPECT_EQ(small.exponent, -6);
  EXPECT_EQ(small.labels, (std::vector<std::string>{"0", "1", "2", "3", "4"}));
  EXPECT_EQ(linear_ticks(5, 5, 6).labels, (std::vector<std::string>{"5"}));
  EXPECT_EQ(log_ticks(1e-9, 10, 20).labels.front(), "10\u207b\u2079");
  EXPECT_EQ(log_ticks(1, 20, 8).labels, (std::vector<std::string>{"1", "2", "5", "10", "20"}));
}

TEST(Ticks, NumbersAndLengths) {
  EXPECT_EQ(number_text(0), "0");
  EXPECT_EQ(number_text(-1.5), "\u22121.5");
  EXPECT_EQ(number_text(999.9), "1000");
  EXPECT_EQ(number_text(0.0123456), "0.0123");
  EXPECT_EQ(number_text(1.5e-7), "1.5\u00d710\u207b\u2077");
  EXPECT_EQ(number_text(kNan), "no value");
  EXPECT_EQ(length_text(0.05), "50 mm");
  EXPECT_EQ(length_text(2), "2 m");
  EXPECT_EQ(length_text(5e-5), "50 \u00b5m");
  EXPECT_EQ(round_below(0.0499), 0.02);
  EXPECT_NEAR(round_below(0.05), 0.05, 1e-15);
  EXPECT_EQ(round_below(9), 5);
}

}  // namespace
}  // namespace lissom
