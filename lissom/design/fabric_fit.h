#pragma once
/// Moduli of a fabric from stretch tests of strips. A strip whose ends carry a uniform dead force is in a homogeneous state
/// that has a closed form [mathematics 3.1]: with S = f / lambda the second Piola-Kirchhoff tension along the strip,
///   lambda^2 = 1 + 2 S / Y(angle),   Y(angle)^(-1/2) = cos^2 Y1^(-1/2) + sin^2 Y2^(-1/2),
/// and the stretch across from the compliance. The pull does not depend on the Poisson ratio: only what is measured across
/// the strips determines it. Least squares in (log Y1, log Y2, mu) by Levenberg's method.

#include "lissom/core/result.h"
#include "lissom/model/fabric_test.h"

namespace lissom {

struct FabricFit {
  double stiffness_1 = 0, stiffness_2 = 0;  ///< N/m
  double poisson_ratio = 0;
  double rms = 0;      ///< of all measured stretches against the fitted ones
  double largest = 0;  ///< deviation of a stretch
  int iterations = 0;

  double shear() const;  ///< N/m
  /// Modulus of a strip at this angle (rad) to the warp, N/m.
  double modulus(double angle) const;
};

/// `where` is the place of the test in the document, for errors.
Result<FabricFit> fit_fabric(const FabricTest& test, const std::string& where);

/// The homogeneous state of a strip.
struct StripState {
  double stretch = 1, across = 1;
};
StripState strip_state(const FabricFit& fabric, double angle, double force_per_width);

}  // namespace lissom
