#pragma once
/// Colours of numbers. All maps keep their order for readers with colour vision deficiencies; pictures never use
/// colour alone (the legend carries numbers).

#include <array>
#include <cstdint>
#include <span>

#include "lissom/view/rod_drawing.h"

namespace lissom {

/// sRGB, 0 to 1.
struct Color {
  double r = 0, g = 0, b = 0;
  bool operator==(const Color&) const = default;
};

/// a at weight 0, b at weight 1.
Color mix(const Color& a, const Color& b, double weight);

/// Rounded to 0..255.
std::array<uint8_t, 3> to_bytes(const Color& color);

/// `at` in 0..1, clamped. Sequential: viridis, by van der Walt and Smith, released as CC0 1.0, sampled at 17 places.
/// Diverging: blue, near-white at 1/2, red; our own. Pale: cream to deep teal, lightness falling evenly; our own.
Color map_color(Field::Colors colors, double at);

/// Colour of places without a value (NaN).
inline constexpr Color kNoValueColor{0.55, 0.55, 0.55};

/// Values at the two ends of a colour map, in the unit of the field as stored.
struct ColorRange {
  double low = 0, high = 0;

  /// Fits the finite values; diverging ranges are symmetric about zero. {0, 0} when there are none.
  static ColorRange fitting(Field::Colors colors, std::span<const double> values);

  /// Smallest range that contains both.
  ColorRange including(const ColorRange& other) const;

  /// Colour of a value; a range without extent takes the middle of the map. Above 0 `steps`: in that many even steps.
  Color color(Field::Colors colors, double value, int steps = 0) const;
};

}  // namespace lissom
