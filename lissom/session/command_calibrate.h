#pragma once
/// `calibrate`: numbers of materials from measurements, with their intervals, a document that has them, charts and a page.

#include <filesystem>
#include <string>
#include <vector>

#include "lissom/core/context.h"
#include "lissom/core/result.h"
#include "lissom/design/optimizer_state.h"
#include "lissom/session/calibration_words.h"
#include "lissom/session/document_file.h"
#include "lissom/view/canvas.h"

namespace lissom {

struct CalibrateCommand {
  std::filesystem::path folder;  ///< for files
  ImageFormat picture = ImageFormat::kSvg;
  std::string line;     ///< that was typed, for the page
  std::string version;  ///< of lissom, for the page
};

struct CalibratedDocument {
  DesignVerdict verdict = DesignVerdict::kBadStart;
  std::string message;  ///< the verdict in a sentence, with its reason
  int iterations = 0;
  std::vector<CertaintyWords> parameters;
  std::string counts;             ///< count_words
  std::string confidence;         ///< "95 %"
  std::vector<std::string> sets;  ///< one sentence for each file
  std::vector<std::string> notes;
  std::vector<std::filesystem::path> files;  ///< written
  std::string summary;                       ///< JSON, one line
  int code = 0;                              ///< exit code
};

/// Exit code where the verdict is good but some parameter is at a bound or not determined.
constexpr int kNotDetermined = 20;

/// Works until there is a verdict or the context is cancelled; what was found so far is written in any case. Nothing is
/// written where the start has no equilibrium.
Result<CalibratedDocument> calibrate_command(const Document& document, const CalibrateCommand& command,
                                             const Context& context);

}  // namespace lissom
