#include "lissom/mechanics/solid_strain.h"

#include "lissom/mechanics/system.h"

namespace lissom {

std::vector<double> volume_ratios(const System& system, const State& state) {
  std::vector<double> ratios;
  ratios.reserve(system.structure.tetrahedra.size());
  for (size_t t = 0; t < system.structure.tetrahedra.size(); ++t) {
    const std::array<int, 4>& node = system.structure.tetrahedra[t].node;
    const Vec3 a = state.position(node[0]), b = state.position(node[1]) - a, c = state.position(node[2]) - a;
    ratios.push_back(b.cross(c).dot(state.position(node[3]) - a) / (6 * system.rest.tetrahedra[t].volume));
  }
  return ratios;
}

}  // namespace lissom
