#include "lissom/view/ticks.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace lissom {
namespace {

constexpr const char* kMinus = "\u2212";

std::string with_minus(std::string text) {
  if (!text.empty() && text[0] == '-') text.replace(0, 1, kMinus);
  return text;
}

int decade(double x) { return static_cast<int>(std::floor(std::log10(x) + 1e-12)); }

std::string without_zeros(std::string text) {
  if (text.find('.') == std::string::npos) return text;
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

}  // namespace

std::string power_of_ten(int exponent) {
  static constexpr const char* kDigits[] = {"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                            "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
  std::string text = exponent < 0 ? "10\u207b" : "10";
  for (char digit : fmt::format("{}", std::abs(exponent))) text += kDigits[digit - '0'];
  return text;
}

double round_below(double x) {
  const double base = std::pow(10.0, decade(x));
  for (double factor : {5.0, 2.0}) {
    if (factor * base <= x * (1 + 1e-9)) return factor * base;
  }
  return base;
}

std::string number_text(double value, int digits) {
  if (!std::isfinite(value)) return "no value";
  if (value == 0) return "0";
  const std::string scientific = fmt::format("{:.{}e}", value, digits - 1);
  const size_t e = scientific.find('e');
  const int exponent = std::stoi(scientific.substr(e + 1));
  if (exponent >= -3 && exponent < 5) {
    return with_minus(without_zeros(fmt::format("{:.{}f}", value, std::max(0, digits - 1 - exponent))));
  }
  return with_minus(without_zeros(scientific.substr(0, e))) + "\u00d7" + power_of_ten(exponent);
}

Ticks linear_ticks(double low, double high, int wanted) {
  Ticks ticks;
  const double largest = std::max(std::abs(low), std::abs(high));
  if (!(high - low > 1e-12 * largest)) {
    ticks.at = {low};
    ticks.labels = {number_text(low)};
    return ticks;
  }
  const double rough = (high - low) / std::max(1, wanted);
  double step = round_below(rough);
  if (rough / step > 1.5) step = step / std::pow(10.0, decade(step)) < 1.5 ? 2 * step : round_below(2.51 * step);
  const int top = decade(largest);
  ticks.exponent = top >= 5 || top < -3 ? top : 0;
  const int decimals = std::max(0, ticks.exponent - decade(step));
  const double unit = std::pow(10.0, ticks.exponent);
  const double first = std::ceil(low / step - 1e-9), last = std::floor(high / step + 1e-9);
  for (double k = first; k <= last; ++k) {
    const double at = k * step;
    ticks.at.push_back(at);
    ticks.labels.push_back(k == 0 ? "0" : with_minus(fmt::format("{:.{}f}", at / unit, decimals)));
  }
  return ticks;
}

Ticks log_ticks(double low, double high, int wanted) {
  Ticks ticks;
  const int first = static_cast<int>(std::ceil(std::log10(low) - 1e-9));
  const int last = static_cast<int>(std::floor(std::log10(high) + 1e-9));
  if (std::log10(high / low) < 2) {
    for (int k = first - 1; k <= last; ++k) {
      for (double factor : {1.0, 2.0, 5.0}) {
        const double at = factor * std::pow(10.0, k);
        if (at < low * (1 - 1e-9) || at > high * (1 + 1e-9)) continue;
        ticks.at.push_back(at);
        ticks.labels.push_back(number_text(at));
      }
    }
    return ticks;
  }
  const int stride = std::max(1, (last - first + wanted) / std::max(1, wanted));
  for (int k = first; k <= last; ++k) {
    if (((k % stride) + stride) % stride != 0) continue;
    ticks.at.push_back(std::pow(10.0, k));
    ticks.labels.push_back(k >= -2 && k <= 3 ? number_text(std::pow(10.0, k)) : power_of_ten(k));
  }
  return ticks;
}

std::string length_text(double metres) {
  if (metres < 0.9e-3) return number_text(metres * 1e6) + " \u00b5m";
  if (metres < 0.9) return number_text(metres * 1e3) + " mm";
  if (metres < 900) return number_text(metres) + " m";
  return number_text(metres / 1e3) + " km";
}

}  // namespace lissom
