#pragma once
/// Shapes side by side under one camera, with one scale for each field: states of a motion, stable shapes of one design,
/// members of a family.

#include <string>
#include <vector>

#include "lissom/view/picture.h"

namespace lissom {

struct PictureStrip {
  std::string title;
  std::string field = {};           ///< that colours it; empty: plain
  std::string membrane_field = {};  ///< that colours membranes in its stead; empty: `field` does when it can
  Viewpoint view;
  int width = 0;  ///< px; the height follows from what is seen
  Theme theme = Theme::kLight;
  Visibility shadow = Visibility::kHidden;
  Visibility tension = Visibility::kHidden;
};

/// Arranges the panels in as many columns as make a page of a good shape.
Result<std::string> draw_panels(const PictureStrip& strip, const std::vector<Panel>& panels, ImageFormat format);

}  // namespace lissom
