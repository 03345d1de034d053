#pragma once
/// Pictures of structures without a display: SVG and PNG from one drawing code. Same input, same bytes.

#include <optional>
#include <string>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/view/camera.h"
#include "lissom/view/canvas.h"
#include "lissom/view/rod_drawing.h"
#include "lissom/view/theme.h"

namespace lissom {

/// One state of the structure within a panel.
struct Layer {
  enum class Style {
    kSolid,   ///< true sections, shaded, coloured by the field; membranes as cloth
    kGhost,   ///< true sections of the rods, light grey, behind everything solid
    kDashed,  ///< dashed centrelines of the rods, behind everything solid
    kTrack,   ///< rods as flat bands in `ink`, behind everything else: what lines are compared with
    kLines,   ///< centrelines of the rods in `ink`, over everything solid, layer by layer: shapes that may coincide
  };
  Drawing drawing;
  Style style = Style::kSolid;
  std::vector<std::vector<Vec3>> guides = {};  ///< m, dashed lines over everything: ghost rods of a plan
  Color ink = {};                              ///< of kTrack, kLines and `dots`
  double weight = 1;                           ///< of kLines, 1: lines of usual width
  std::vector<Vec3> dots = {};                 ///< m, points of interest, over everything
};

struct Panel {
  std::vector<Layer> layers;
  std::string caption;
};

enum class Visibility { kShown, kHidden };

enum class Sections {
  kShaded,  ///< rods as bodies
  kFlat,    ///< rods as flat bands of their width: smaller, and in exactly the colours of the map
};

struct PictureOptions {
  int width = 1600, height = 1200;  ///< px
  Theme theme = Theme::kLight;
  Viewpoint view = Viewpoint::iso();
  std::string title = {};
  std::string field = {};                ///< name of the field that colours solid layers; empty: plain
  std::optional<ColorRange> range = {};  ///< as stored (SI); absent: fits all panels
  std::string membrane_field = {};       ///< colours the membranes in its stead; empty: `field` does when it can
  std::optional<ColorRange> membrane_range = {};
  Sections sections = Sections::kShaded;
  int steps = 0;         ///< of the colours of rods; 0: gliding
  double text_size = 0;  ///< px; 0: follows from the size
  int columns = 0;       ///< of panels; 0: one row up to four panels, then as square as possible
  Visibility supports = Visibility::kShown;
  Visibility forces = Visibility::kShown;
  Visibility ruler = Visibility::kShown;
  Visibility axes = Visibility::kShown;
  Visibility slack = Visibility::kShown;     ///< hatched: cloth whose smallest stretch is below 1
  Visibility tension = Visibility::kHidden;  ///< strokes along the largest tension of cloth
  Visibility shadow = Visibility::kHidden;   ///< on the ground below the lowest point
};

/// Draws all panels with one camera and one scale, so that they can be compared. Rods thinner than a pixel are drawn
/// one pixel wide. Errors: nothing to draw, non-finite shapes (names the rod), unknown field, impossible size.
Result<std::string> draw_picture(const std::vector<Panel>& panels, const PictureOptions& options, ImageFormat format);

}  // namespace lissom
