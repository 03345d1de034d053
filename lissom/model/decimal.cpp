#include "lissom/model/decimal.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

#include "lissom/core/assert.h"

namespace lissom {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Exponents beyond this give 0 or infinity whatever the digits of a document are.
constexpr long kLargestExponent = 100'000'000;

}  // namespace

std::optional<Decimal> take_decimal(std::string_view& text) {
  std::size_t i = 0;
  Decimal decimal;
  if (i < text.size() && (text[i] == '-' || text[i] == '+')) decimal.negative = text[i++] == '-';
  while (i < text.size() && is_digit(text[i])) decimal.digits += text[i++];
  if (i < text.size() && text[i] == '.') {
    ++i;
    for (; i < text.size() && is_digit(text[i]); ++i) {
      decimal.digits += text[i];
      --decimal.exponent;
    }
  }
  if (decimal.digits.empty()) return std::nullopt;
  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    std::size_t j = i + 1;
    const bool negative = j < text.size() && text[j] == '-';
    if (j < text.size() && (text[j] == '-' || text[j] == '+')) ++j;
    if (j < text.size() && is_digit(text[j])) {
      long exponent = 0;
      for (; j < text.size() && is_digit(text[j]); ++j) {
        exponent = std::min(kLargestExponent, exponent * 10 + (text[j] - '0'));
      }
      decimal.exponent += negative ? -exponent : exponent;
      i = j;
    }
  }
  text.remove_prefix(i);
  return decimal;
}

Decimal shortest_decimal(double value) {
  LISSOM_ASSERT(std::isfinite(value));
  char buffer[64];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific).ptr;
  std::string_view text(buffer, static_cast<std::size_t>(end - buffer));
  return *take_decimal(text);
}

std::optional<double> to_double(const Decimal& decimal, int shift) {
  if (decimal.digits.find_first_not_of('0') == std::string::npos) return decimal.negative ? -0.0 : 0.0;
  const std::string text =
      (decimal.negative ? "-" : "") + decimal.digits + "e" + std::to_string(decimal.exponent + shift);
  double value = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

Decimal times(const Decimal& decimal, int factor) {
  Decimal product = decimal;
  long carry = 0;
  for (std::size_t i = product.digits.size(); i-- > 0;) {
    carry += static_cast<long>(product.digits[i] - '0') * factor;
    product.digits[i] = static_cast<char>('0' + carry % 10);
    carry /= 10;
  }
  if (carry > 0) product.digits = std::to_string(carry) + product.digits;
  return product;
}

std::string to_text(const Decimal& decimal) {
  const std::string sign = decimal.negative ? "-" : "";
  const std::size_t first = decimal.digits.find_first_not_of('0');
  if (first == std::string::npos) return sign.empty() ? "0" : "-0.0";
  const std::size_t last = decimal.digits.find_last_not_of('0');
  const std::string digits = decimal.digits.substr(first, last - first + 1);
  const long count = static_cast<long>(digits.size());
  const long exponent = decimal.exponent + static_cast<long>(decimal.digits.size() - 1 - last);
  const long point = count + exponent;  // digits before the decimal point
  if (exponent >= 0 && point <= 9) return sign + digits + std::string(static_cast<std::size_t>(exponent), '0');
  if (exponent < 0 && point > 0 && point <= 17) {
    return sign + digits.substr(0, static_cast<std::size_t>(point)) + "." +
           digits.substr(static_cast<std::size_t>(point));
  }
  if (point <= 0 && point > -4) return sign + "0." + std::string(static_cast<std::size_t>(-point), '0') + digits;
  const std::string mantissa = count == 1 ? digits : digits.substr(0, 1) + "." + digits.substr(1);
  return sign + mantissa + "e" + std::to_string(point - 1);
}

}  // namespace lissom
