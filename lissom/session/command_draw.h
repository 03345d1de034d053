#pragma once
/// `draw`: a picture of a description or of a result.

#include <filesystem>
#include <vector>

#include "lissom/session/drawable.h"
#include "lissom/view/picture.h"

namespace lissom {

enum class Shown { kRest, kDeformed, kBoth };

struct DrawCommand {
  Shown shown = Shown::kBoth;  ///< of a description there is only the rest shape
  PictureOptions picture;      ///< title: empty takes that of the document; field: empty for plain rods
  std::filesystem::path file;  ///< .svg or .png
};

/// Draws and writes.
Status draw_command(const Drawable& drawable, const DrawCommand& command);

/// Several shapes side by side under one camera, with the titles of their documents (or, where these are all the same,
/// their poses) as captions. The height of the picture follows from what is seen.
Status draw_strip_command(const std::vector<Drawable>& drawables, const DrawCommand& command);

}  // namespace lissom
