#pragma once
/// Pictures of a calibration: what was measured over what was fitted, and what is left.

#include <string>

#include "lissom/session/calibration_words.h"
#include "lissom/view/chart.h"

namespace lissom {

/// Force over length: measured points, the fitted curve through the steps and that of the start. Of pairs only.
Chart fitted_chart(const CalibrationFit& fit, const MeasuredSet& set, const std::string& title);

/// Measured minus fitted, over what was set, or over the number of the row for places, and the residual standard deviation.
Chart residual_chart(const CalibrationFit& fit, const MeasuredSet& set, const std::string& title);

}  // namespace lissom
