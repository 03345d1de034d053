#pragma once
/// Tables of the report of an inverse design, as HTML.

#include <string>

#include "lissom/session/design_report.h"

namespace lissom {

/// Goals before and after.
std::string report_goals(const DesignReport& report);

/// Every accepted iteration.
std::string report_history(const DesignReport& report);

/// Parameters that the objective pulls at most, and all of them folded away.
std::string report_parameters(const DesignReport& report);

/// Where the time went, and the size of the problem.
std::string report_effort(const DesignReport& report);

/// Tables as they are.
std::string report_plain_tables(const std::vector<DesignReport::Table>& tables);

}  // namespace lissom
