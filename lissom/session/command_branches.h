#pragma once
/// `branches`: all stable shapes of a design, side by side.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lissom/core/context.h"
#include "lissom/equilibrium/branches.h"
#include "lissom/session/document_file.h"
#include "lissom/view/canvas.h"

namespace lissom {

struct BranchesCommand {
  std::vector<std::string> poses;  ///< names; empty: all
  BranchOptions options;
  std::filesystem::path folder;
  std::optional<ImageFormat> picture = ImageFormat::kPng;
};

struct PoseBranches {
  std::string pose;
  BranchSearch search;
  std::vector<double> heights;  ///< m, per branch, across the drawing plane
  std::vector<std::filesystem::path> files;
  std::string summary;  ///< JSON, one line
};

/// Writes one result file per shape, from which `solve --resume` goes on, and one picture of all.
Result<std::vector<PoseBranches>> branches_command(const Document& document, const BranchesCommand& command,
                                                   const Context& context);

}  // namespace lissom
