#include "lissom/model/validate_parts.h"

namespace lissom {

void check_solid(Checker& check, const Solid& solid, const std::string& where) {
  check.known(solid.material, check.materials, "material", where + "/material");
  if (check.failed()) return;
  check.take(check_solid_material(*check.model.material(solid.material), where + "/material"));
  check.take(check_solid_mesh(solid, where));
}

}  // namespace lissom
