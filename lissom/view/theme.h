#pragma once
/// Colours of pages.

#include <array>

#include "lissom/view/color_map.h"

namespace lissom {

enum class Theme { kLight, kDark };

struct ThemeColors {
  Color page, ink, faint_ink, rule, rod, ghost, shadow, support, force, fabric;
};

constexpr ThemeColors theme_colors(Theme theme) {
  if (theme == Theme::kDark) {
    return {.page = {0.085, 0.098, 0.118},
            .ink = {0.92, 0.93, 0.95},
            .faint_ink = {0.62, 0.65, 0.69},
            .rule = {0.24, 0.26, 0.30},
            .rod = {0.50, 0.72, 0.86},
            .ghost = {0.30, 0.33, 0.37},
            .shadow = {0.045, 0.052, 0.065},
            .support = {0.72, 0.74, 0.77},
            .force = {0.96, 0.68, 0.25},
            .fabric = {0.80, 0.76, 0.70}};
  }
  return {.page = {1, 1, 1},
          .ink = {0.11, 0.13, 0.16},
          .faint_ink = {0.40, 0.43, 0.47},
          .rule = {0.86, 0.87, 0.89},
          .rod = {0.27, 0.52, 0.70},
          .ghost = {0.82, 0.84, 0.87},
          .shadow = {0.90, 0.91, 0.925},
          .support = {0.45, 0.48, 0.52},
          .force = {0.80, 0.40, 0.05},
          .fabric = {0.975, 0.945, 0.89}};
}

// Okabe and Ito, "Color universal design" (2008): told apart with any common colour vision.
inline constexpr std::array<Color, 6> kSeriesInk = {{{0.00, 0.45, 0.70},
                                                     {0.84, 0.37, 0.00},
                                                     {0.00, 0.62, 0.45},
                                                     {0.80, 0.47, 0.65},
                                                     {0.90, 0.62, 0.00},
                                                     {0.34, 0.71, 0.91}}};

}  // namespace lissom
