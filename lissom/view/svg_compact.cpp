#include "lissom/view/svg_compact.h"

#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace lissom {
namespace {

// stroke-linecap and stroke-linejoin keep their values: only butt and miter are defaults, and miter is never used.
constexpr std::string_view kDefaults[] = {" fill-rule:nonzero;", "fill-rule:nonzero;", "fill-opacity:1;",
                                          "stroke:none;",        "stroke-opacity:1;",  "stroke-miterlimit:10;",
                                          "stroke-linecap:butt;"};

/// "rgb(10%,20%,30%)" at the front of `text` as "#1a334d"; `used` is its length.
std::optional<std::string> short_color(std::string_view text, size_t& used) {
  const size_t end = text.find(')');
  if (end == std::string_view::npos) return std::nullopt;
  std::string color = "#";
  const char* at = text.data() + 4;
  const char* stop = text.data() + end;
  for (int channel = 0; channel < 3; ++channel) {
    double percent = 0;
    const auto [next, error] = std::from_chars(at, stop, percent);
    if (error != std::errc() || next == stop || *next != '%') return std::nullopt;
    color += fmt::format("{:02x}", static_cast<int>(std::lround(percent * 2.55)));
    at = next + 2;
  }
  used = end + 1;
  return color;
}

}  // namespace

std::string compact_svg(std::string_view svg) {
  std::string compact;
  compact.reserve(svg.size());
  while (!svg.empty()) {
    size_t used = 0;
    if (svg.starts_with("rgb(")) {
      if (const std::optional<std::string> color = short_color(svg, used)) compact += *color;
    } else if (svg.starts_with("\"surface")) {
      compact += "\"surface";
      used = svg.find_first_not_of("0123456789", 8);
    } else if (svg[0] == 'f' || svg[0] == 's' || svg[0] == ' ') {
      for (std::string_view property : kDefaults) {
        if (used == 0 && svg.starts_with(property)) used = property.size();
      }
    }
    if (used == 0) {
      compact += svg[0];
      used = 1;
    }
    svg.remove_prefix(used);
  }
  return compact;
}

}  // namespace lissom
