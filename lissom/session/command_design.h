#pragma once
/// `design`: a project from its surface to the rods that take its poses best, step by step, each of which leaves a file that a
/// later run goes on from.

#include <filesystem>
#include <string>
#include <vector>

#include "lissom/core/context.h"
#include "lissom/session/command_optimize.h"
#include "lissom/session/project_file.h"

namespace lissom {

struct DesignCommand {
  enum class Begin { kAnew, kResume };
  std::filesystem::path folder;  ///< for files
  Begin begin = Begin::kAnew;
  std::string line;     ///< that was typed, for the report
  std::string version;  ///< of lissom, for the report
};

/// How one pose of a project comes out.
struct PoseOutcome {
  std::string name;
  bool held_back = false;
  double deformation = 0;        ///< m, root mean square way of the nodes from rest to target
  double before = 0, after = 0;  ///< m, root mean square miss; NaN where the pose has no stable shape
};

struct DesignedProject {
  OptimizedDesign design;
  std::vector<PoseOutcome> poses;
  int rods = 0, joints = 0, nodes = 0, edges = 0;
  std::vector<std::string> notes;
  std::vector<std::filesystem::path> files;  ///< written
  std::string summary;                       ///< JSON, one line
};

/// The structure of a project, with the poses and the brief, as a document of its own. Reads it from `folder` where an earlier
/// run left it and neither the project nor its files have changed since; makes and writes it otherwise.
Result<DesignedProject> design_command(const Project& project, const DesignCommand& command, const Context& context);

}  // namespace lissom
