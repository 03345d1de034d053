#include "lissom/view/color_map.h"

#include <algorithm>
#include <cmath>

namespace lissom {
namespace {

// viridis: Stefan van der Walt, Nathaniel Smith, 2015; CC0 1.0 (public domain dedication). Every 16th of 256 entries.
constexpr std::array<Color, 17> kViridis = {{{0.267004, 0.004874, 0.329415},
                                             {0.282327, 0.094955, 0.417331},
                                             {0.278826, 0.175490, 0.483397},
                                             {0.258965, 0.251537, 0.524736},
                                             {0.229739, 0.322361, 0.545706},
                                             {0.199430, 0.387607, 0.554642},
                                             {0.172719, 0.448791, 0.557885},
                                             {0.149039, 0.508051, 0.557250},
                                             {0.127568, 0.566949, 0.550556},
                                             {0.120638, 0.625828, 0.533488},
                                             {0.157851, 0.683765, 0.501686},
                                             {0.246070, 0.738910, 0.452024},
                                             {0.369214, 0.788888, 0.382914},
                                             {0.515992, 0.831158, 0.294279},
                                             {0.678489, 0.863742, 0.189503},
                                             {0.845561, 0.887322, 0.099702},
                                             {0.993248, 0.906157, 0.143936}}};

constexpr std::array<Color, 7> kBlueRed = {{{0.05, 0.24, 0.58},
                                            {0.22, 0.49, 0.79},
                                            {0.58, 0.76, 0.91},
                                            {0.94, 0.94, 0.94},
                                            {0.95, 0.68, 0.56},
                                            {0.83, 0.34, 0.27},
                                            {0.58, 0.04, 0.12}}};

constexpr std::array<Color, 6> kCream = {{{0.98, 0.96, 0.90},
                                          {0.82, 0.90, 0.81},
                                          {0.60, 0.81, 0.76},
                                          {0.35, 0.68, 0.71},
                                          {0.17, 0.52, 0.62},
                                          {0.10, 0.36, 0.50}}};

}  // namespace

Color mix(const Color& a, const Color& b, double weight) {
  return {a.r + (b.r - a.r) * weight, a.g + (b.g - a.g) * weight, a.b + (b.b - a.b) * weight};
}

std::array<uint8_t, 3> to_bytes(const Color& color) {
  const auto byte = [](double x) { return static_cast<uint8_t>(std::lround(255 * std::clamp(x, 0.0, 1.0))); };
  return {byte(color.r), byte(color.g), byte(color.b)};
}

Color map_color(Field::Colors colors, double at) {
  const std::span<const Color> table = colors == Field::Colors::kSequential ? std::span<const Color>(kViridis)
                                       : colors == Field::Colors::kPale     ? std::span<const Color>(kCream)
                                                                            : std::span<const Color>(kBlueRed);
  const double place = std::clamp(at, 0.0, 1.0) * static_cast<double>(table.size() - 1);
  const size_t index = std::min(static_cast<size_t>(place), table.size() - 2);
  return mix(table[index], table[index + 1], place - static_cast<double>(index));
}

ColorRange ColorRange::fitting(Field::Colors colors, std::span<const double> values) {
  ColorRange range;
  bool found = false;
  for (double v : values) {
    if (!std::isfinite(v)) continue;
    range.low = found ? std::min(range.low, v) : v;
    range.high = found ? std::max(range.high, v) : v;
    found = true;
  }
  if (colors == Field::Colors::kDiverging) {
    range.high = std::max(std::abs(range.low), std::abs(range.high));
    range.low = -range.high;
  }
  return range;
}

ColorRange ColorRange::including(const ColorRange& other) const {
  return {std::min(low, other.low), std::max(high, other.high)};
}

Color ColorRange::color(Field::Colors colors, double value, int steps) const {
  if (std::isnan(value)) return kNoValueColor;
  const double at = high > low ? std::clamp((value - low) / (high - low), 0.0, 1.0) : 0.5;
  return map_color(colors, steps > 0 ? (std::min(std::floor(at * steps), steps - 1.0) + 0.5) / steps : at);
}

}  // namespace lissom
