#include "lissom/model/units.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "lissom/core/nearest_name.h"
#include "lissom/model/decimal.h"

namespace lissom {
namespace {

struct NamedUnit {
  std::string_view name;
  Dimension dimension;
  double factor;
  int exponent;
};

constexpr Dimension kLengthUnit{1, 0, 0, 0}, kMassUnit{0, 1, 0, 0}, kTimeUnit{0, 0, 1, 0}, kAngleUnit{0, 0, 0, 1};
constexpr Dimension kForceUnit{1, 1, -2, 0}, kStressUnit{-1, 1, -2, 0}, kMomentUnit{2, 1, -2, 0}, kNone{};

constexpr NamedUnit kUnits[] = {
    {"m", kLengthUnit, 1, 0},
    {"mm", kLengthUnit, 1, -3},
    {"cm", kLengthUnit, 1, -2},
    {"um", kLengthUnit, 1, -6},
    {"\u00b5m", kLengthUnit, 1, -6},
    {"\u03bcm", kLengthUnit, 1, -6},
    {"km", kLengthUnit, 1, 3},
    {"in", kLengthUnit, 254, -4},
    {"kg", kMassUnit, 1, 0},
    {"g", kMassUnit, 1, -3},
    {"mg", kMassUnit, 1, -6},
    {"t", kMassUnit, 1, 3},
    {"s", kTimeUnit, 1, 0},
    {"ms", kTimeUnit, 1, -3},
    {"us", kTimeUnit, 1, -6},
    {"min", kTimeUnit, 60, 0},
    {"rad", kAngleUnit, 1, 0},
    {"mrad", kAngleUnit, 1, -3},
    {"deg", kAngleUnit, std::numbers::pi / 180, 0},
    {"\u00b0", kAngleUnit, std::numbers::pi / 180, 0},
    {"turn", kAngleUnit, 2 * std::numbers::pi, 0},
    {"N", kForceUnit, 1, 0},
    {"mN", kForceUnit, 1, -3},
    {"uN", kForceUnit, 1, -6},
    {"kN", kForceUnit, 1, 3},
    {"MN", kForceUnit, 1, 6},
    {"gf", kForceUnit, 980665, -8},
    {"kgf", kForceUnit, 980665, -5},
    {"Pa", kStressUnit, 1, 0},
    {"kPa", kStressUnit, 1, 3},
    {"MPa", kStressUnit, 1, 6},
    {"GPa", kStressUnit, 1, 9},
    {"bar", kStressUnit, 1, 5},
    {"J", kMomentUnit, 1, 0},
    {"mJ", kMomentUnit, 1, -3},
    {"uJ", kMomentUnit, 1, -6},
    {"Hz", {0, 0, -1, 0}, 1, 0},
    {"kHz", {0, 0, -1, 0}, 1, 3},
    {"%", kNone, 1, -2},
    {"1", kNone, 1, 0},
    {"-", kNone, 1, 0},
};

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

void skip_spaces(std::string_view& text) {
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
}

/// Whether a character belongs to the name of a unit: letters, %, and everything beyond ASCII except signs of operations.
bool is_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '%' || static_cast<unsigned char>(c) >= 0x80;
}

bool take(std::string_view& text, std::string_view word) {
  if (!text.starts_with(word)) return false;
  text.remove_prefix(word.size());
  return true;
}

Error unit_error(std::string message, std::string hint) {
  return {ErrorCode::kUnit, {}, std::move(message), std::move(hint)};
}

/// Multiplication sign at the beginning of `text`, removed.
bool take_times(std::string_view& text) { return take(text, "*") || take(text, "\u00b7") || take(text, "\u22c5"); }

/// Exponent after the name of a unit; 1 when there is none, nothing when it is malformed.
std::optional<int> take_power(std::string_view& text) {
  if (take(text, "\u00b2")) return 2;
  if (take(text, "\u00b3")) return 3;
  const bool caret = take(text, "^");
  const bool negative = caret && take(text, "-");
  if (text.empty() || text.front() < '1' || text.front() > '9') return caret ? std::nullopt : std::optional<int>(1);
  const int power = text.front() - '0';
  text.remove_prefix(1);
  if (!text.empty() && text.front() >= '0' && text.front() <= '9') return std::nullopt;
  return negative ? -power : power;
}

std::string_view take_name(std::string_view& text) {
  std::size_t n = 0;
  while (n < text.size() && is_name(text[n])) {
    const std::string_view rest = text.substr(n);
    if (rest.starts_with("\u00b2") || rest.starts_with("\u00b3") || rest.starts_with("\u00b7")) break;
    if (rest.starts_with("\u22c5")) break;
    ++n;
  }
  if (n == 0 && (text.starts_with("1") || text.starts_with("-"))) n = 1;
  const std::string_view name = text.substr(0, n);
  text.remove_prefix(n);
  return name;
}

bool accumulate(Unit& unit, const NamedUnit& part, int power) {
  const auto add = [power](std::int8_t& sum, std::int8_t each) {
    const int total = sum + power * each;
    if (total < -32 || total > 32) return false;
    sum = static_cast<std::int8_t>(total);
    return true;
  };
  unit.factor *= std::pow(part.factor, power);
  unit.exponent += power * part.exponent;
  return add(unit.dimension.length, part.dimension.length) && add(unit.dimension.mass, part.dimension.mass) &&
         add(unit.dimension.time, part.dimension.time) && add(unit.dimension.angle, part.dimension.angle);
}

Error unknown_unit(std::string_view name) {
  std::vector<std::string> names;
  for (const NamedUnit& unit : kUnits) {
    if (unit.name != "1" && unit.name != "-") names.emplace_back(unit.name);
  }
  std::string near = nearest_name(name, names);
  return unit_error("unknown unit \"" + std::string(name) + "\"",
                    near.empty()
                        ? "known: m, mm, cm, um, in, g, kg, t, s, ms, N, mN, kN, Pa, kPa, MPa, GPa, rad, deg, turn, "
                          "Hz, J, mJ, %, and their products, quotients and powers"
                        : "did you mean \"" + near + "\"?");
}

Error malformed_number(std::string_view text) {
  return {ErrorCode::kType, {}, "\"" + std::string(text) + "\" is not a number", "write for example 0.8 or 1.2e-3"};
}

Result<double> scaled(const Decimal& decimal, const Unit& unit) {
  constexpr double kLargestWhole = 1e6;
  const bool whole = unit.factor >= 1 && unit.factor < kLargestWhole && unit.factor == std::floor(unit.factor);
  const std::optional<double> value =
      to_double(whole ? times(decimal, static_cast<int>(unit.factor)) : decimal, unit.exponent);
  const double scaled_value = whole ? value.value_or(0) : value.value_or(0) * unit.factor;
  if (!value || !std::isfinite(scaled_value)) {
    return Error{ErrorCode::kRange, {}, "the number is too large or too small to be held", "check its exponent"};
  }
  return scaled_value;
}

}  // namespace

Result<Unit> parse_unit(std::string_view text) {
  Unit unit;
  skip_spaces(text);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  unit.text = text;
  if (text.empty()) return unit_error("the unit is missing", "write for example \"mm\"");
  bool divided = false, divide = false;
  for (;;) {
    const std::string_view name = take_name(text);
    if (name.empty()) {
      return unit_error("\"" + unit.text + "\" is not a unit", "write for example \"mm\", \"kg/m^3\" or \"N mm\"");
    }
    const NamedUnit* part = nullptr;
    for (const NamedUnit& candidate : kUnits) {
      if (candidate.name == name) part = &candidate;
    }
    if (!part) return unknown_unit(name);
    const std::optional<int> power = take_power(text);
    if (!power || !accumulate(unit, *part, divide ? -*power : *power)) {
      return unit_error("the power in \"" + unit.text + "\" is not understood",
                        "powers are written \"m^2\" or \"s^-2\"");
    }
    skip_spaces(text);
    if (text.empty()) break;
    divide = take(text, "/");
    if (!divide) {
      if (divided) {
        return unit_error("\"" + unit.text + "\" can be read in two ways",
                          "write a slash before every unit that divides");
      }
      take_times(text);
    }
    divided = divided || divide;
    skip_spaces(text);
  }
  if (!std::isfinite(unit.factor) || unit.factor == 0) {
    return unit_error("the power in \"" + unit.text + "\" is too large", "check the exponent");
  }
  return unit;
}

Result<double> to_si(std::string_view number, const Unit& unit) {
  std::string_view rest = number;
  const std::optional<Decimal> decimal = take_decimal(rest);
  if (!decimal || !rest.empty()) return malformed_number(number);
  return scaled(*decimal, unit);
}

Result<Quantity> parse_quantity(std::string_view text) {
  const std::string_view whole = text;
  skip_spaces(text);
  if (text.empty()) return Error{ErrorCode::kType, {}, "the text is empty where a quantity is expected", {}};
  std::string_view rest = text;
  const std::optional<Decimal> decimal = take_decimal(rest);
  if (!decimal) return malformed_number(whole);
  if (!rest.empty() && (rest.front() == '.' || rest.front() == ',')) return malformed_number(whole);
  skip_spaces(rest);
  if (rest.empty()) {
    return unit_error("\"" + std::string(whole) + "\" has no unit", "add one, or write the number without quotes");
  }
  Result<Unit> unit = parse_unit(rest);
  if (!unit) return unit.error();
  const Result<double> value = scaled(*decimal, unit.value());
  if (!value) return value.error();
  return Quantity{value.value(), std::move(unit).value()};
}

std::string in_unit(double si, const Unit& unit) {
  if (!std::isfinite(si)) return {};
  if (unit.factor == 1 || si == 0) {
    Decimal decimal = shortest_decimal(si);
    decimal.exponent -= unit.exponent;
    return to_text(decimal);
  }
  const double near = si / unit.factor;
  if (!std::isfinite(near)) return {};
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::string best;
  for (const double candidate : {near, std::nextafter(near, -kInfinity), std::nextafter(near, kInfinity)}) {
    Decimal decimal = shortest_decimal(candidate);
    const std::optional<double> back = to_double(decimal, 0);
    decimal.exponent -= unit.exponent;
    std::string text = to_text(decimal);
    const Result<double> value = to_si(text, unit);
    if (!back || !value || value.value() != si) continue;
    if (best.empty() || text.size() < best.size()) best = std::move(text);
  }
  return best;
}

std::string number_text(double value) { return to_text(shortest_decimal(value)); }

}  // namespace lissom
