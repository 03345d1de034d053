#include "lissom/model/structure.h"

#include "lissom/geometry/frame_strain.h"
#include "lissom/model/discretize_parts.h"

namespace lissom {

int Structure::rod_index(std::string_view name) const {
  for (size_t i = 0; i < rods.size(); ++i) {
    if (rods[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

PairStrain pair_strain(const Frame& first, const Frame& second) {
  const FrameT<double> one{first.t, first.b}, other{second.t, second.b};
  const Curvature<double> k = curvature(one, other);
  return {k.kappa_1, k.kappa_2, twist(one, other, 0)};
}

Frame advanced(const Frame& first, const PairStrain& strain) {
  const FrameT<double> next =
      advanced<double>({first.t, first.b}, Curvature<double>{strain.kappa_1, strain.kappa_2}, strain.twist);
  return {next.t, next.b, next.n()};
}

}  // namespace lissom
