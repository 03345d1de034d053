#pragma once
/// A calibration as one HTML page without any reference to the outside, light or dark as its reader likes.

#include <string>
#include <vector>

#include "lissom/session/calibration_words.h"

namespace lissom {

struct CalibrationPage {
  std::string title;       ///< of the structure
  std::string document;    ///< file
  std::string confidence;  ///< "95 %"
  std::vector<MeasuredSet> sets;
  std::vector<std::string> notes;  ///< sentences
  std::string command;             ///< line that makes this again
  std::string version;             ///< of lissom
};

/// Same fit, same bytes. Errors: shapes that cannot be drawn.
Result<std::string> calibration_page_html(const CalibrationFit& fit, const CalibrationPage& page);

}  // namespace lissom
