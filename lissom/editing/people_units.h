#pragma once
/// Lengths and angles between people (mm, degrees) and the model (m, rad). Prefixes are moved as decimals, as in documents:
/// what is typed is what is saved and what is shown.

#include <optional>

namespace lissom {

/// m; nothing where the number is too small or too large.
std::optional<double> metres_of(double mm);
double millimetres_of(double metres);
double radians_of(double degrees);
double degrees_of(double radians);

/// A computed length, rounded to a nanometre: it makes short text in documents, and nobody can tell.
double rounded_length(double metres);

}  // namespace lissom
