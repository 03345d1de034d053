#pragma once
/// `draw`: a picture of a description or of a result.

#include <filesystem>

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

}  // namespace lissom
