#pragma once
/// `modes`: what a structure in balance could do next: its softest motions, and its natural vibrations.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lissom/core/context.h"
#include "lissom/equilibrium/equilibrium.h"
#include "lissom/equilibrium/options.h"
#include "lissom/motion/natural_modes.h"
#include "lissom/session/document_file.h"
#include "lissom/session/paraview.h"
#include "lissom/view/canvas.h"

namespace lissom {

struct ModesCommand {
  std::vector<std::string> poses;  ///< names; empty: all
  SolveOptions options;
  int count = 6;
  std::filesystem::path folder;
  std::optional<ImageFormat> picture = ImageFormat::kSvg;
  ParaView vtu = ParaView::kNo;
};

struct PoseModes {
  std::string pose;
  Equilibrium equilibrium;
  std::vector<NaturalMode> vibrations;  ///< empty when the structure has no mass
  std::string remark;                   ///< why there is something missing
  std::vector<std::filesystem::path> files;
  std::string summary;  ///< JSON, one line
};

Result<std::vector<PoseModes>> modes_command(const Document& document, const ModesCommand& command,
                                             const Context& context);

}  // namespace lissom
