#pragma once
/// `dynamics`: motions in time.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lissom/motion/motion.h"
#include "lissom/session/document_file.h"
#include "lissom/session/paraview.h"
#include "lissom/session/table.h"
#include "lissom/view/camera.h"
#include "lissom/view/canvas.h"

namespace lissom {

struct DynamicsCommand {
  std::vector<std::string> motions;  ///< names; empty: all
  std::vector<std::string> watches;  ///< places whose turning is recorded
  std::optional<Vec3> watch_point;   ///< m, on the axis of the watches; absent: the middle of each, as drawn
  Vec3 watch_axis = Vec3::UnitZ();
  int panels = 6;     ///< of the strip of pictures; 0: no strip
  std::string field;  ///< that colours it; empty: plain
  Viewpoint view = Viewpoint::iso();
  int strip_width = 1440;  ///< px
  std::filesystem::path folder;
  ParaView vtu = ParaView::kNo;
  ImageFormat picture = ImageFormat::kSvg;
};

struct PlayedMotion {
  std::string motion;
  MotionResult result;
  Table table;  ///< one row per record
  std::vector<std::filesystem::path> files;
  std::string summary;  ///< JSON, one line
};

Result<std::vector<PlayedMotion>> dynamics_command(const Document& document, const DynamicsCommand& command,
                                                   const Context& context);

}  // namespace lissom
