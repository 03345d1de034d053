#include "lissom/session/report_words.h"

#include <cmath>
#include <fmt/format.h>

#include "lissom/view/text.h"
#include "lissom/view/ticks.h"

namespace lissom {

namespace {

constexpr const char* kDash = "\u2013";
constexpr const char* kThin = "\u202f";  // between number and unit, never broken

}  // namespace

std::string report_number(double value, int digits) {
  return std::isfinite(value) ? number_text(value, digits) : kDash;
}

std::string report_value(double value, const DesignReport::Measure& measure) {
  return report_number(value * measure.display_scale);
}

std::string report_quantity(double value, const DesignReport::Measure& measure) {
  std::string number = report_value(value, measure);
  if (!std::isfinite(value) || measure.unit.empty()) return number;
  return number + kThin + xml_escaped(measure.unit);
}

std::string report_unit(const DesignReport::Measure& measure) {
  return measure.unit.empty() ? std::string() : " (" + xml_escaped(measure.unit) + ")";
}

std::string report_time(double seconds) {
  if (!std::isfinite(seconds) || seconds < 0) return kDash;
  if (seconds < 60) return number_text(seconds, seconds < 10 ? 2 : 3) + kThin + "s";
  if (seconds > 1e9) return report_number(seconds / 3600) + kThin + "h";
  const long whole = std::lround(seconds);
  if (whole < 3600) return fmt::format("{0}{2}min {1}{2}s", whole / 60, whole % 60, kThin);
  return fmt::format("{0}{2}h {1}{2}min", whole / 3600, whole % 3600 / 60, kThin);
}

std::string report_count(int count, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string report_gain(double before, double after) {
  if (!std::isfinite(before) || !std::isfinite(after) || !(before > 0) || after < 0) return {};
  if (after == 0) return "reached";
  const double ratio = after / before;
  if (ratio < 0.5) return number_text(before / after, before / after < 10 ? 2 : 3) + " times closer";
  if (std::abs(ratio - 1) < 0.005) return "unchanged";
  const std::string percent = number_text(100 * std::abs(1 - ratio), 2) + kThin + "%";
  return percent + (ratio < 1 ? " closer" : " farther");
}

}  // namespace lissom
