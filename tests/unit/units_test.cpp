#include "lissom/model/units.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <random>
#include <string>

namespace lissom {
namespace {

double si(const std::string& text) {
  const Result<Quantity> quantity = parse_quantity(text);
  EXPECT_TRUE(quantity) << text << ": " << (quantity ? "" : quantity.error().text());
  return quantity ? quantity.value().value : std::nan("");
}

/// Finite doubles of all magnitudes and signs, from their bits.
double any_double(std::mt19937_64& random) {
  for (;;) {
    const double value = std::bit_cast<double>(random());
    if (std::isfinite(value)) return value;
  }
}

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

TEST(Units, QuantitiesAreTheNearestSiDouble) {
  EXPECT_EQ(si("0.8 mm"), 0.0008);
  EXPECT_EQ(si("32 MPa"), 32e6);
  EXPECT_EQ(si("1.2e-3 m"), 1.2e-3);
  EXPECT_EQ(si("90 deg"), std::numbers::pi / 2);
  EXPECT_EQ(si("1 turn"), 2 * std::numbers::pi);
  EXPECT_EQ(si("9.81 m/s^2"), 9.81);
  EXPECT_EQ(si("1240 kg/m^3"), 1240);
  EXPECT_EQ(si("1.24 g/cm^3"), 1240);
  EXPECT_EQ(si("1.24 g/cm\u00b3"), 1240);
  EXPECT_EQ(si("0.3 N/m"), 0.3);
  EXPECT_EQ(si("0.3 N/mm"), 300);
  EXPECT_EQ(si("2 N mm"), 0.002);
  EXPECT_EQ(si("2 N*mm"), 0.002);
  EXPECT_EQ(si("2 N\u00b7mm"), 0.002);
  EXPECT_EQ(si("2mJ"), 0.002);
  EXPECT_EQ(si("20 1/m"), 20);
  EXPECT_EQ(si("20 m^-1"), 20);
  EXPECT_EQ(si("10 1/s"), 10);
  EXPECT_EQ(si("12 Hz"), 12);
  EXPECT_EQ(si("5 %"), 0.05);
  EXPECT_EQ(si("1 in"), 0.0254);
  EXPECT_EQ(si("0.1 in"), 0.00254);
  EXPECT_EQ(si("1.5 min"), 90);
  EXPECT_EQ(si("7 um"), 7e-6);
  EXPECT_EQ(si("7 \u00b5m"), 7e-6);
  EXPECT_EQ(si("2 t"), 2000);
  EXPECT_EQ(si("1 kgf"), 9.80665);
  EXPECT_EQ(si("100 gf"), 0.980665);
  EXPECT_EQ(si(" .5 kN "), 500);
  EXPECT_EQ(si("-3. GPa"), -3e9);
  EXPECT_TRUE(same_bits(si("-0 mm"), -0.0));
}

TEST(Units, DimensionsFollowProductsQuotientsAndPowers) {
  EXPECT_EQ(parse_unit("kg m/s^2").value().dimension, dimension(Measure::kForce));
  EXPECT_EQ(parse_unit("kg m s^-2").value().dimension, dimension(Measure::kForce));
  EXPECT_EQ(parse_unit("N/mm^2").value().dimension, dimension(Measure::kStress));
  EXPECT_EQ(parse_unit("J/m/m").value().dimension, dimension(Measure::kForcePerLength));
  EXPECT_EQ(parse_unit("1/s").value().dimension, parse_unit("Hz").value().dimension);
  EXPECT_EQ(parse_unit("-").value().dimension, Dimension{});
  for (int i = 0; i < kMeasures; ++i) {
    const MeasureInfo& entry = info(static_cast<Measure>(i));
    EXPECT_EQ(static_cast<int>(entry.measure), i);
    const Result<Quantity> example = parse_quantity(entry.example);
    ASSERT_TRUE(example) << entry.example;
    EXPECT_TRUE(compatible(dimension(entry.measure), example.value().unit.dimension)) << entry.example;
    for (const std::string_view unit : entry.written) {
      if (unit.empty()) continue;
      EXPECT_TRUE(compatible(dimension(entry.measure), parse_unit(unit).value().dimension)) << unit;
    }
  }
}

TEST(Units, RadiansMayBeLeftOutOfRatesOnly) {
  EXPECT_TRUE(compatible(dimension(Measure::kTwistRate), parse_unit("1/m").value().dimension));
  EXPECT_TRUE(compatible(dimension(Measure::kCurvature), parse_unit("deg/m").value().dimension));
  EXPECT_FALSE(compatible(dimension(Measure::kAngle), Dimension{}));
  EXPECT_FALSE(compatible(Dimension{}, dimension(Measure::kAngle)));
  EXPECT_FALSE(compatible(dimension(Measure::kLength), dimension(Measure::kForce)));
}

TEST(Units, MistakesAreExplained) {
  const auto text = [](const char* quantity) {
    const Result<Quantity> result = parse_quantity(quantity);
    return result ? std::string("accepted") : result.error().text();
  };
  EXPECT_EQ(text("1 mn"), "unknown unit \"mn\" (did you mean \"mN\"?)");
  EXPECT_EQ(text("1 Mpa"), "unknown unit \"Mpa\" (did you mean \"MPa\"?)");
  EXPECT_EQ(text("12"), "\"12\" has no unit (add one, or write the number without quotes)");
  EXPECT_EQ(text("0,8 mm"), "\"0,8 mm\" is not a number (write for example 0.8 or 1.2e-3)");
  EXPECT_EQ(text("nan mm"), "\"nan mm\" is not a number (write for example 0.8 or 1.2e-3)");
  EXPECT_EQ(text("inf mm"), "\"inf mm\" is not a number (write for example 0.8 or 1.2e-3)");
  EXPECT_EQ(text("1e999 mm"), "the number is too large or too small to be held (check its exponent)");
  EXPECT_EQ(text("1e-999 mm"), "the number is too large or too small to be held (check its exponent)");
  EXPECT_EQ(text("1e308 km"), "the number is too large or too small to be held (check its exponent)");
  EXPECT_EQ(text("1 J/kg K"), "\"J/kg K\" can be read in two ways (write a slash before every unit that divides)");
  EXPECT_EQ(text("1 mm^"), "the power in \"mm^\" is not understood (powers are written \"m^2\" or \"s^-2\")");
  EXPECT_EQ(text("1 mm^99"), "the power in \"mm^99\" is not understood (powers are written \"m^2\" or \"s^-2\")");
  EXPECT_EQ(text("1 /m"), "\"/m\" is not a unit (write for example \"mm\", \"kg/m^3\" or \"N mm\")");
  EXPECT_EQ(text(" "), "the text is empty where a quantity is expected");
  EXPECT_FALSE(parse_unit(""));
  EXPECT_FALSE(parse_unit("m/"));
  EXPECT_EQ(wrong_dimension(Measure::kLength, dimension(Measure::kStress)).text(),
            "expected a length such as \"0.8 mm\", got a stress");
  EXPECT_FALSE(to_si("1.2.3", Unit{}));
  EXPECT_FALSE(to_si("", Unit{}));
}

TEST(Units, WrittenQuantitiesReadBackToTheSameBits) {
  std::mt19937_64 random(7);
  int written = 0;
  for (int i = 0; i < kMeasures; ++i) {
    const Measure measure = static_cast<Measure>(i);
    for (int k = 0; k < 2000; ++k) {
      const double value = k == 0 ? -0.0 : any_double(random);
      const std::string text = write_quantity(value, measure);
      ASSERT_FALSE(text.empty());
      EXPECT_TRUE(same_bits(si(text), value)) << text;
      ++written;
    }
  }
  EXPECT_EQ(written, 2000 * kMeasures);
}

TEST(Units, NumbersInAGivenUnitReadBackOrAreRefused) {
  std::mt19937_64 random(8);
  for (const char* name : {"mm", "in", "deg", "turn", "MPa", "kg/m^3", "min"}) {
    const Unit unit = parse_unit(name).value();
    int exact = 0;
    for (int k = 0; k < 1000; ++k) {
      const double value = std::uniform_real_distribution<double>(-10, 10)(random);
      const std::string text = in_unit(value, unit);
      if (text.empty()) continue;
      ++exact;
      EXPECT_TRUE(same_bits(to_si(text, unit).value(), value)) << text << " " << name;
    }
    EXPECT_GT(exact, 500) << name;
  }
  EXPECT_EQ(in_unit(std::nan(""), Unit{}), "");
  EXPECT_EQ(in_unit(std::numeric_limits<double>::infinity(), Unit{}), "");
}

TEST(Units, WrittenQuantitiesAreReadable) {
  EXPECT_EQ(write_quantity(0.0008, Measure::kLength), "0.8 mm");
  EXPECT_EQ(write_quantity(0.1 + 0.2, Measure::kLength), "300.00000000000004 mm");
  EXPECT_EQ(write_quantity(2, Measure::kLength), "2 m");
  EXPECT_EQ(write_quantity(32e6, Measure::kStress), "32 MPa");
  EXPECT_EQ(write_quantity(206e9, Measure::kStress), "206 GPa");
  EXPECT_EQ(write_quantity(std::numbers::pi / 2, Measure::kAngle), "90 deg");
  EXPECT_EQ(write_quantity(1, Measure::kAngle), "1 rad");
  EXPECT_EQ(write_quantity(0.05, Measure::kRatio), "0.05 1");
  EXPECT_EQ(number_text(1e-9), "1e-9");
  EXPECT_EQ(number_text(-0.0), "-0.0");
  EXPECT_EQ(number_text(123456), "123456");
  EXPECT_EQ(number_text(5e-324), "5e-324");
  EXPECT_EQ(number_text(1.5e300), "1.5e300");
}

}  // namespace
}  // namespace lissom
