#pragma once
/// Methods of inverse design, by name.

#include <array>
#include <string_view>

namespace lissom {

/// Names of design/optimize_options.h, which a test compares.
constexpr std::array<std::string_view, 7> kBriefMethods{
    "gauss_newton",        "bfgs",   "structured_bfgs",      "dennis_gay_welsch",
    "levenberg_marquardt", "newton", "gauss_newton_products"};

}  // namespace lissom
