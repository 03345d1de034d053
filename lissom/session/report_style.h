#pragma once
/// Looks of the report of an inverse design.

#include <string>

namespace lissom {

/// The style sheet: light, dark and on paper.
std::string report_style();

}  // namespace lissom
