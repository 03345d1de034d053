#pragma once
/// `path`: equilibria over the load factor, with their critical points.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lissom/equilibrium/continuation.h"
#include "lissom/session/document_file.h"
#include "lissom/session/paraview.h"
#include "lissom/session/table.h"
#include "lissom/view/canvas.h"

namespace lissom {

struct PathCommand {
  std::vector<std::string> poses;  ///< names; empty: all
  SolveOptions options;
  std::optional<double> from, to;  ///< these four replace what the pose says
  std::optional<int> steps;
  std::optional<LoadPath::Follow> follow;
  bool stop_at_critical = false, switch_branch = false;  ///< in addition to what the pose says
  std::string watch;         ///< place whose displacement is plotted; empty: the node that moves most
  std::optional<Vec3> axis;  ///< along which; absent: its size
  std::filesystem::path folder;
  ParaView vtu = ParaView::kNo;
  ImageFormat picture = ImageFormat::kSvg;
};

struct FollowedPose {
  std::string pose;
  std::string watched;  ///< what the displacement is that of
  PathResult path;
  Table table;  ///< load factor, displacement (m), energy (J), lowest stiffness (N/m), ...
  std::vector<std::filesystem::path> files;
  std::string summary;  ///< JSON, one line
};

struct PathEndInfo {
  PathEnd end;
  std::string_view name;
  int exit_code;  ///< that of the verdict which means the same
};
const PathEndInfo& path_end_info(PathEnd end);
std::string_view critical_kind_name(CriticalKind kind);

Result<std::vector<FollowedPose>> path_command(const Document& document, const PathCommand& command,
                                               const Context& context);

}  // namespace lissom
