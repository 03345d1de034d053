#pragma once
/// Decimal numbers as text, so that a change of prefix (mm -> m) moves the point and loses nothing.

#include <optional>
#include <string>
#include <string_view>

namespace lissom {

/// (-1)^negative * digits * 10^exponent.
struct Decimal {
  bool negative = false;
  std::string digits;  ///< at least one of 0-9
  long exponent = 0;
};

/// The number at the beginning of `text`, whose characters are removed from it: [+-] digits [. digits] [e [+-] digits].
std::optional<Decimal> take_decimal(std::string_view& text);

/// The shortest decimal that reads back to `value` (finite).
Decimal shortest_decimal(double value);

/// Nearest double of decimal * 10^shift; nothing when it is too large or too small to be held.
std::optional<double> to_double(const Decimal& decimal, int shift);

/// The decimal times a whole number of at most six digits, exactly.
Decimal times(const Decimal& decimal, int factor);

/// "0.8", "12000", "3.31e+09", "-0.0".
std::string to_text(const Decimal& decimal);

}  // namespace lissom
