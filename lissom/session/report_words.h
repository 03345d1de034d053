#pragma once
/// Words and numbers of the report of an inverse design. Everything returned is safe inside of HTML.

#include <string>
#include <string_view>

#include "lissom/session/design_report.h"

namespace lissom {

/// "1.25", with three digits; a dash when it is not finite.
std::string report_number(double value, int digits = 3);

/// `value` (SI) as it is shown, "1.25 mm"; a dash when it is not finite.
std::string report_quantity(double value, const DesignReport::Measure& measure);
/// The same without the unit, for columns that name it.
std::string report_value(double value, const DesignReport::Measure& measure);

/// " (mm)", or nothing for pure numbers.
std::string report_unit(const DesignReport::Measure& measure);

/// "0.42 s", "3 min 20 s", "2 h 5 min".
std::string report_time(double seconds);

/// "12 rods", "1 rod".
std::string report_count(int count, std::string_view one, std::string_view many);

/// "30 times closer", "18 % closer", "unchanged", "5 % farther"; nothing where it cannot be said.
std::string report_gain(double before, double after);

}  // namespace lissom
