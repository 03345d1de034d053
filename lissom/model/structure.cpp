#include "lissom/model/structure.h"

#include <cmath>
#include <numbers>

#include "lissom/model/discretize_parts.h"

namespace lissom {

int Structure::rod_index(std::string_view name) const {
  for (size_t i = 0; i < rods.size(); ++i) {
    if (rods[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

PairStrain pair_strain(const Frame& first, const Frame& second) {
  const Vec3 kb = 2 * first.t.cross(second.t) / (1 + first.t.dot(second.t));
  const double twist = signed_angle(second.t, parallel_transport(first.t, second.t, first.b), second.b);
  return {kb.dot(first.n + second.n) / 2, -kb.dot(first.b + second.b) / 2,
          twist == -std::numbers::pi ? std::numbers::pi : twist};
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
