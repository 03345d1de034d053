#pragma once
/// `solve`: equilibria of poses, with result files.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lissom/core/context.h"
#include "lissom/equilibrium/equilibrium.h"
#include "lissom/equilibrium/options.h"
#include "lissom/session/paraview.h"
#include "lissom/session/result_file.h"
#include "lissom/session/totals.h"
#include "lissom/session/warnings.h"
#include "lissom/view/canvas.h"

namespace lissom {

struct SolveCommand {
  std::vector<std::string> poses;  ///< names; empty: all
  SolveOptions options;
  double load_factor = 1;
  std::optional<SavedResult> resume;  ///< start from this state; then one pose, that of the result unless named
  std::filesystem::path folder;       ///< for files
  ParaView vtu = ParaView::kNo;
  std::optional<ImageFormat> picture;
  std::string field = "stress";  ///< that colours the picture
};

struct SolvedPose {
  std::string pose;
  int nodes = 0, unknowns = 0;     ///< unknowns: free ones
  std::vector<std::string> notes;  ///< on the structure
  std::vector<std::string> removed_motions;
  double largest_displacement = 0;  ///< m
  double largest_stress = 0;        ///< Pa
  std::optional<Totals> totals;     ///< of structures with membranes
  std::vector<Warning> warnings;
  Equilibrium equilibrium;
  std::vector<std::filesystem::path> files;  ///< written
  std::string summary;                       ///< JSON, one line
};

/// Solves and writes pose by pose. A pose that ends badly is a result too; only bad input and files are errors.
Result<std::vector<SolvedPose>> solve_command(const Document& document, const SolveCommand& command,
                                              const Context& context);

}  // namespace lissom
