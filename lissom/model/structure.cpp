#include "lissom/model/structure.h"

#include <cmath>

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
  // Averaging two normals that differ by the twist shortens them by cos(twist / 2), and turns them half-way.
  const double c = std::cos(strain.twist / 2), s = std::sin(strain.twist / 2);
  const Vec3 b = c * first.b + s * first.n, n = c * first.n - s * first.b;
  const Vec3 kb = (strain.kappa_1 * n - strain.kappa_2 * b) / c;
  const double size = kb.norm();
  const Vec3 bend = size > 0 ? Vec3(kb * (2 * std::atan(size / 2) / size)) : Vec3::Zero();
  const Frame bent = rotated(rotation_from_vector(bend), first);
  return rotated(rotation_from_vector(strain.twist * bent.t), bent);
}

}  // namespace lissom
