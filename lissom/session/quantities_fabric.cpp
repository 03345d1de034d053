// Moduli fitted to fabric tests.

#include <cmath>

#include "lissom/design/fabric_fit.h"
#include "lissom/model/json_value.h"
#include "lissom/session/quantity_families.h"

namespace lissom {

namespace {

template <class Of>
Result<double> fitted(const Measurement& m, const Of& of) {
  for (const FabricTest& test : m.study.model().fabric_tests) {
    if (test.name != m.expectation.fabric_test) continue;
    const Result<FabricFit> fit = fit_fabric(test, "/fabric_tests/" + pointer_step(test.name));
    if (!fit) return fit.error();
    return of(fit.value());
  }
  return Error{ErrorCode::kUnknown, m.where + "/fabric_test",
               "there is no fabric test \"" + m.expectation.fabric_test + "\"", "describe it under \"fabric_tests\""};
}

}  // namespace

Result<double> fitted_stiffness_1(const Measurement& m) {
  return fitted(m, [](const FabricFit& fit) { return fit.stiffness_1; });
}
Result<double> fitted_stiffness_2(const Measurement& m) {
  return fitted(m, [](const FabricFit& fit) { return fit.stiffness_2; });
}
Result<double> fitted_poisson_ratio(const Measurement& m) {
  return fitted(m, [](const FabricFit& fit) { return fit.poisson_ratio; });
}
Result<double> fitted_shear(const Measurement& m) {
  return fitted(m, [](const FabricFit& fit) { return fit.shear(); });
}
Result<double> fitted_modulus(const Measurement& m) {
  const Vec3& axis = *m.expectation.axis;
  return fitted(m, [&](const FabricFit& fit) { return fit.modulus(std::atan2(axis.y(), axis.x())); });
}

}  // namespace lissom
