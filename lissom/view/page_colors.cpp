#include "lissom/view/page_colors.h"

#include <array>
#include <fmt/format.h>
#include <map>
#include <vector>

#include "lissom/view/theme.h"

namespace lissom {
namespace {

/// From eight-bit channels, 0xrrggbb.
constexpr Color rgb(unsigned hex) { return {(hex >> 16 & 255) / 255.0, (hex >> 8 & 255) / 255.0, (hex & 255) / 255.0}; }

// Lightness falls evenly on white and rises evenly on black; blue to purple, which no colour vision deficiency folds.
constexpr std::array<Color, kPageSteps> kLightSteps = {rgb(0xb4c6d8), rgb(0x92b3d2), rgb(0x7a9ac6), rgb(0x7480b8),
                                                       rgb(0x7763a5), rgb(0x77448c), rgb(0x6d236c), rgb(0x4b0a3c)};
constexpr std::array<Color, kPageSteps> kDarkSteps = {rgb(0x43536b), rgb(0x53658f), rgb(0x6c75b2), rgb(0x8d85cc),
                                                      rgb(0xb297dc), rgb(0xd3abe2), rgb(0xecc5e6), rgb(0xffe6f0)};

std::vector<PageColor> make_colors() {
  const ThemeColors light = theme_colors(Theme::kLight), dark = theme_colors(Theme::kDark);
  std::vector<PageColor> colors{{"page", light.page, light.page, dark.page},
                                {"ink", light.ink, light.ink, dark.ink},
                                {"faint", light.faint_ink, light.faint_ink, dark.faint_ink},
                                {"rule", light.rule, light.rule, dark.rule},
                                {"rod", light.rod, light.rod, dark.rod},
                                {"ghost", light.ghost, light.ghost, dark.ghost},
                                {"shadow", light.shadow, light.shadow, dark.shadow}};
  for (size_t i = 0; i < kSeriesInk.size(); ++i) {
    colors.push_back({fmt::format("series-{}", i), kSeriesInk[i], kSeriesInk[i], mix(kSeriesInk[i], {1, 1, 1}, 0.25)});
  }
  for (int k = 0; k < kPageSteps; ++k) {
    colors.push_back({fmt::format("step-{}", k), page_step(k), kLightSteps[k], kDarkSteps[k]});
  }
  return colors;
}

using Bytes = std::array<uint8_t, 3>;

std::map<Bytes, std::string> make_paints() {
  std::map<Bytes, std::string> paints;
  for (const PageColor& c : page_colors()) paints.emplace(to_bytes(c.drawn), fmt::format("var(--{})", c.name));
  return paints;
}

}  // namespace

std::span<const PageColor> page_colors() {
  static const std::vector<PageColor> colors = make_colors();
  return colors;
}

Color page_step(int step) { return map_color(Field::Colors::kSequential, (step + 0.5) / kPageSteps); }

std::string hex_color(const Color& color) {
  const Bytes bytes = to_bytes(color);
  return fmt::format("#{:02x}{:02x}{:02x}", bytes[0], bytes[1], bytes[2]);
}

std::string page_paint(const Color& color) {
  static const std::map<Bytes, std::string> paints = make_paints();
  const auto found = paints.find(to_bytes(color));
  return found == paints.end() ? hex_color(color) : found->second;
}

}  // namespace lissom
