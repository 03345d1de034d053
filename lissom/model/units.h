#pragma once
/// Units at the border to people: "0.8 mm" <-> 0.0008. Decimal prefixes are moved as decimals, so "0.8 mm" is the double
/// nearest to 0.0008 and a value written in mm reads back to the same bits.

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "lissom/core/result.h"

namespace lissom {

/// Exponents of metre, kilogram, second and radian.
struct Dimension {
  std::int8_t length = 0, mass = 0, time = 0, angle = 0;
  bool operator==(const Dimension&) const = default;
};

/// One unit or a product of powers of units: SI value = number * factor * 10^exponent.
struct Unit {
  Dimension dimension;
  double factor = 1;  ///< what is left besides the power of ten: 254 for in, pi/180 for deg
  int exponent = 0;
  std::string text;  ///< as written
};

/// What the numbers of a document measure.
enum class Measure {
  kLength,
  kForce,
  kStress,
  kAngle,
  kTime,
  kMass,
  kDensity,
  kAreaDensity,
  kAcceleration,
  kVelocity,
  kMoment,
  kForcePerLength,
  kCurvature,
  kTwistRate,
  kRate,
  kRatio,
};
constexpr int kMeasures = 16;

struct MeasureInfo {
  Measure measure;
  std::string_view key;           ///< in the `units` of a document
  std::string_view name;          ///< "length"
  std::string_view article;       ///< "a length"
  std::string_view example;       ///< "0.8 mm"
  std::string_view default_unit;  ///< of a bare number; empty: a number other than 0 needs its unit
  std::string_view si_unit;
  std::array<std::string_view, 4>
      written;  ///< units that the writer chooses from, the first that gives the shortest text
};

const MeasureInfo& info(Measure measure);
Dimension dimension(Measure measure);

/// "mm", "kg/m^3", "N mm", "N*mm", "1/m", "m s^-2", "%". After a slash only the next unit is divided; mixing a slash with a
/// product after it ("J/kg K") is refused because people read it in two ways. Errors have no `where`.
Result<Unit> parse_unit(std::string_view text);

/// A number with its unit, in SI.
struct Quantity {
  double value = 0;
  Unit unit;
};
Result<Quantity> parse_quantity(std::string_view text);

/// Decimal text in `unit`, as the nearest SI double. Refuses what is no number, not finite or too large or small.
Result<double> to_si(std::string_view number, const Unit& unit);

/// The shortest decimal that to_si(..., unit) turns into exactly `si`; empty when there is none (some angles in degrees).
std::string in_unit(double si, const Unit& unit);

/// `si` with a unit that suits it, exact: "0.8 mm".
std::string write_quantity(double si, Measure measure);

/// Whether a value of dimension `got` may stand where `expected` is asked for. Radians may be left out of rates ("1/m" for
/// rad/m, "1/s" for rad/s), nowhere else.
bool compatible(Dimension expected, Dimension got);

/// "a length", or "a quantity in m^2 kg" where there is no word for it.
std::string in_words(Dimension dimension);

/// The SI unit of a dimension: "m^2 kg s^-2", "1".
std::string si_unit(Dimension dimension);

/// "expected a length such as "0.8 mm", got a stress".
Error wrong_dimension(Measure expected, Dimension got);

/// Shortest decimal text that reads back to the same double ("0.1", "-0.0", "1e-09").
std::string number_text(double value);

}  // namespace lissom
