#pragma once
/// Pictures inside of pages that are light or dark as their reader likes: the colours of the light theme become CSS variables,
/// which the page sets for either theme. Steps of the sequential map (PictureOptions::steps) become steps from faint to
/// strong, so that large values stand out on white and on black alike.

#include <span>
#include <string>

#include "lissom/view/color_map.h"

namespace lissom {

inline constexpr int kPageSteps = 8;  ///< of the sequential map

struct PageColor {
  std::string name;   ///< of the variable, without its dashes
  Color drawn;        ///< as pictures of the light theme draw it
  Color light, dark;  ///< on the page
};

/// "page", "ink", "faint", "rule", "rod", "ghost", "shadow", "series-0" to "series-5", "step-0" to "step-7".
std::span<const PageColor> page_colors();

/// Middle of a step of the sequential map.
Color page_step(int step);

/// "#1a2b3c".
std::string hex_color(const Color& color);

/// What a picture inside of a page says for a colour: "var(--ink)", or the colour itself.
std::string page_paint(const Color& color);

}  // namespace lissom
