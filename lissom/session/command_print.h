#pragma once
/// `print`: rods as a solid, in a file that printers take, after checks.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lissom/core/context.h"
#include "lissom/equilibrium/options.h"
#include "lissom/fabrication/print_checks.h"
#include "lissom/session/document_file.h"
#include "lissom/session/print_strain.h"

namespace lissom {

struct PrintCommand {
  std::filesystem::path file;  ///< its ending decides the format
  std::string process = "fdm";
  // In the place of the numbers of the process, where given.
  std::optional<double> diameter, gap;  ///< m
  std::optional<Vec3> bed;              ///< m
  std::optional<double> cost;           ///< euro per kg
  SolidOptions solid;
  enum class Poses { kSolve, kSkip } poses = Poses::kSolve;  ///< whether strains are looked at
  enum class OnErrors { kRefuse, kWrite } on_errors = OnErrors::kRefuse;
  SolveOptions solve;
};

struct PrintedObject {
  std::string material;
  double volume = 0, mass = 0, cost = 0;  ///< m^3, kg, euro
  int triangles = 0, parts = 0, tubes = 0, joints = 0, cavities = 0;
};

struct PrintOutcome {
  std::vector<PrintedObject> objects;
  Vec3 size = Vec3::Zero();  ///< m
  double tolerance = 0;      ///< m, reached; above the one asked for when triangles would have been too many
  std::vector<PoseStrain> strains;
  std::vector<PrintFinding> findings;
  int errors = 0;              ///< among them
  std::filesystem::path file;  ///< that was written; empty when errors forbade it
  std::string summary;         ///< JSON, one line
};

/// Errors are bad input and files; what speaks against printing is in the outcome.
Result<PrintOutcome> print_command(const Document& document, const PrintCommand& command, const Context& context);

}  // namespace lissom
