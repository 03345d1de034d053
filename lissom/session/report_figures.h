#pragma once
/// Figures of the report of an inverse design, as HTML with the pictures inside.

#include <string>

#include "lissom/session/design_report.h"

namespace lissom {

/// Objective, root mean squares, gradient and active bounds over the iterations.
Result<std::string> report_convergence(const DesignReport& report);

/// The shapes of every pose over each other, what is left of the deviation, and how it is spread.
Result<std::string> report_shapes(const DesignReport& report);

/// One histogram per kind of parameter, with its bounds.
Result<std::string> report_histograms(const DesignReport& report);

}  // namespace lissom
