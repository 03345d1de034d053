#pragma once
/// What tests of pictures share.

#include <cstdio>
#include <string>

#include "lissom/view/picture.h"
#include "tests/unit/view_samples.h"

namespace lissom::samples {

/// As SVG files write it.
inline std::string hex(const Color& color) {
  char text[8];
  const auto bytes = to_bytes(color);
  std::snprintf(text, sizeof text, "#%02x%02x%02x", bytes[0], bytes[1], bytes[2]);
  return text;
}

inline size_t count(const std::string& text, const std::string& part) {
  size_t n = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

/// One layer, without a caption.
inline Panel panel(Drawing drawing, Layer::Style style = Layer::Style::kSolid) {
  return {{{.drawing = std::move(drawing), .style = style}}, ""};
}

}  // namespace lissom::samples
