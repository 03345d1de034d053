#include "lissom/editing/people_units.h"

#include <cmath>
#include <numbers>
#include <string>

#include "lissom/model/decimal.h"
#include "lissom/model/units.h"

namespace lissom {

namespace {

constexpr int kMilli = 3;           // decimals between m and mm
constexpr double kGrain = 1e6;      // parts of a mm that computed lengths keep
constexpr double kCoarsest = 1e12;  // mm: beyond, doubles have no such parts

Unit degree() {
  Result<Unit> unit = parse_unit("deg");
  LISSOM_ASSERT(unit.ok());
  return std::move(unit).value();
}

}  // namespace

std::optional<double> metres_of(double mm) {
  if (!std::isfinite(mm)) return std::nullopt;
  if (mm == 0) return 0;  // without a sign
  return to_double(shortest_decimal(mm), -kMilli);
}

double millimetres_of(double metres) {
  if (metres == 0 || !std::isfinite(metres)) return 0;
  return to_double(shortest_decimal(metres), kMilli).value_or(metres * 1e3);
}

double radians_of(double degrees) {
  const Result<double> angle = to_si(number_text(degrees), degree());
  return angle ? angle.value() : degrees * std::numbers::pi / 180;
}

double degrees_of(double radians) {
  const std::string text = in_unit(radians, degree());
  std::string_view rest = text;
  const std::optional<Decimal> decimal = take_decimal(rest);
  const std::optional<double> exact = decimal ? to_double(*decimal, 0) : std::nullopt;
  return exact.value_or(radians * 180 / std::numbers::pi);
}

double rounded_length(double metres) {
  const double mm = metres * 1e3;
  if (!(std::abs(mm) < kCoarsest)) return metres;
  return metres_of(std::round(mm * kGrain) / kGrain).value_or(metres);
}

}  // namespace lissom
