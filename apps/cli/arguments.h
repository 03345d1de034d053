#pragma once
/// Words on the command line as values.

#include <optional>
#include <string>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/core/types.h"
#include "lissom/view/camera.h"
#include "lissom/view/canvas.h"

namespace lissom::cli {

/// Unit vector of "x", "y" or "z"; nothing for an empty text.
std::optional<Vec3> axis_named(const std::string& name);

/// Of "iso", "top", "front" or "right".
Viewpoint camera_named(const std::string& name);

/// Of "svg" or "png".
ImageFormat format_named(const std::string& name);

/// Metres of a length with its unit, more than 0; errors name the option.
Result<double> length_of(const std::string& text, const char* option);

/// {"NAME": [entry, ...]} on standard output, one entry per line.
void print_json_list(const std::string& name, const std::vector<std::string>& entries);

}  // namespace lissom::cli
