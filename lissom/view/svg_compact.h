#pragma once
/// Smaller SVG with the same meaning.

#include <string>
#include <string_view>

namespace lissom {

/// Rewrites what cairo writes: drops style properties that state SVG's defaults, writes colours as #rrggbb instead of
/// percentages, and forgets the number of the surface, which counts over the life of the process.
std::string compact_svg(std::string_view svg);

}  // namespace lissom
