#pragma once
/// `design`: from a project with its surface, or from a structure with a brief, to the rods that take the poses best and to a
/// file for a printer. Every step leaves files that a later run goes on from.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lissom/core/context.h"
#include "lissom/session/command_optimize.h"
#include "lissom/session/command_print.h"
#include "lissom/session/project_file.h"

namespace lissom {

struct DesignCommand {
  enum class Begin { kAnew, kResume };
  std::filesystem::path folder;  ///< for files
  Begin begin = Begin::kAnew;
  std::string line;     ///< that was typed, for the report
  std::string version;  ///< of lissom, for the report
};

/// How one pose comes out.
struct PoseOutcome {
  std::string name;
  bool held_back = false;
  double moved = 0, farthest = 0;  ///< m, root mean square and largest way of the nodes from the drawing to the target
  double before = 0, after = 0;    ///< m, root mean square miss; NaN where the pose has no stable shape
  double radii_only = 0;           ///< m, after the stages that change nothing but radii; NaN where there was none
};

struct DesignedProject {
  OptimizedDesign design;
  std::vector<PoseOutcome> poses;  ///< those that have a target for every node
  int rods = 0, joints = 0, nodes = 0, edges = 0;
  std::vector<std::string> notes;
  std::optional<PrintOutcome> print;
  std::vector<std::filesystem::path> files;  ///< written
  std::string summary;                       ///< JSON, one line

  /// Root mean square miss over the nodes of all poses that were, or were not, designed for, m.
  double rms_before(bool held_back) const;
  double rms_after(bool held_back) const;
  double rms_radii_only() const;  ///< NaN where no stage changes nothing but radii
};

/// Lays rods, poses them, works on the brief, prints. Resuming takes the rods and poses that an earlier run left in the folder
/// where neither the project nor its files have changed since, and its checkpoint.
Result<DesignedProject> design_command(const Project& project, const DesignCommand& command, const Context& context);

/// The same for a structure that has its brief already: works on it, prints.
Result<DesignedProject> design_command(const Document& document, const DesignCommand& command, const Context& context);

}  // namespace lissom
