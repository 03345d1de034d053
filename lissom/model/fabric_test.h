#pragma once
/// Stretch tests of a fabric: strips cut at an angle to the warp and pulled lengthwise, from which its moduli are fitted
/// (design/fabric_fit.h).

#include <string>
#include <vector>

namespace lissom {

/// One state of one strip.
struct StripPull {
  double angle = 0;            ///< rad, from the warp direction to the length of the strip
  double stretch = 1;          ///< along the strip
  double force_per_width = 0;  ///< N/m, force over the rest width
  double across = 0;           ///< stretch of rest lines across the strip; 0: not measured
};

struct FabricTest {
  std::string name;
  std::vector<StripPull> pulls;
};

}  // namespace lissom
