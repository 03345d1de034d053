#pragma once
/// How the rest quantities of stencils hang on the rest numbers of a structure (rest_numbers.h).

#include <vector>

namespace lissom {

/// Adds factor * number to one rest quantity of a stencil.
struct RestLink {
  int entry = 0;   ///< stencil * rests + place among the stencil's rest quantities
  int number = 0;  ///< in the order of RestNumbers, followed by LoadNumbers
  double factor = 1;
};

/// Ascending by entry.
using RestLinks = std::vector<RestLink>;

}  // namespace lissom
