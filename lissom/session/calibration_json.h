#pragma once
/// A calibration for programs. SI throughout.

#include <nlohmann/json.hpp>
#include <vector>

#include "lissom/session/calibration_words.h"

namespace lissom {

/// Verdict, counts, and every parameter with its certainty; what is not determined has no value.
nlohmann::ordered_json calibration_summary_json(const CalibrationFit& fit, double confidence);

/// Every measured number beside the fitted one, file by file.
nlohmann::ordered_json measured_sets_json(const CalibrationFit& fit, const std::vector<MeasuredSet>& sets);

}  // namespace lissom
