#pragma once
/// `optimize`: the design that a document asks for, with checkpoints to go on from, a document of what was found, and a
/// report.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "lissom/core/context.h"
#include "lissom/core/result.h"
#include "lissom/design/optimizer_state.h"
#include "lissom/design/structure_problem.h"
#include "lissom/session/design_report.h"
#include "lissom/session/document_file.h"

namespace lissom {

struct OptimizeCommand {
  enum class Begin { kAnew, kResume };
  std::filesystem::path folder;       ///< for files
  std::optional<std::string> method;  ///< instead of that of the document
  std::optional<int> iterations;      ///< instead of those of the document
  Begin begin = Begin::kAnew;
  std::string line;     ///< that was typed, for the report
  std::string version;  ///< of lissom, for the report
};

/// How one of the stages of a design ended.
struct StageOutcome {
  int iterations = 0;
  double seconds = 0;       ///< of all stages up to its end
  std::vector<double> rms;  ///< of each goal, SI
};

struct OptimizedDesign {
  DesignVerdict verdict = DesignVerdict::kBadStart;
  std::string message;  ///< the verdict in a sentence, with its reason
  int iterations = 0;
  std::vector<GoalMeasure> before, after;  ///< one per goal, in the same order
  std::vector<StageOutcome> stages;        ///< those that were worked on
  Model model;                             ///< the design that was found
  DesignReport report;                     ///< what the page among the files says
  std::vector<std::string> notes;
  std::vector<std::filesystem::path> files;  ///< written
  std::string summary;                       ///< JSON, one line
};

/// Works until there is a verdict or the context is cancelled; what was found so far is written in any case. Nothing is
/// written before the design has started well. Same document, same bytes, however often it was stopped, but for the report
/// and the checkpoint, which tell time.
Result<OptimizedDesign> optimize_command(const Document& document, const OptimizeCommand& command,
                                         const Context& context);

/// Exit code of a verdict; docs/guide/command-line.md lists them.
int exit_code(DesignVerdict verdict);

}  // namespace lissom
