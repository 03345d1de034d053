#pragma once
/// A block of tetrahedra, as several tests deform it.

#include <array>
#include <utility>

#include "lissom/model/solid.h"

namespace lissom {

/// Of `cells` along x, y, z with the corner at the origin, each cut into six tetrahedra around its diagonal. Point
/// (i, j, k) has the number i + (cells x + 1) (j + (cells y + 1) k).
inline Solid block(const std::array<int, 3>& cells, const Vec3& size, const char* material = "gum") {
  constexpr std::array<std::array<int, 3>, 6> kPaths{
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};  // three even permutations, three odd ones
  Solid solid;
  solid.name = "block";
  solid.material = material;
  for (int k = 0; k <= cells[2]; ++k) {
    for (int j = 0; j <= cells[1]; ++j) {
      for (int i = 0; i <= cells[0]; ++i) {
        solid.points.push_back(size.cwiseProduct(Vec3(1.0 * i / cells[0], 1.0 * j / cells[1], 1.0 * k / cells[2])));
      }
    }
  }
  const auto number = [&](const std::array<int, 3>& at) {
    return at[0] + (cells[0] + 1) * (at[1] + (cells[1] + 1) * at[2]);
  };
  for (int k = 0; k < cells[2]; ++k) {
    for (int j = 0; j < cells[1]; ++j) {
      for (int i = 0; i < cells[0]; ++i) {
        for (size_t p = 0; p < kPaths.size(); ++p) {
          std::array<int, 3> at{i, j, k};
          std::array<int, 4> corner{number(at), 0, 0, 0};
          for (size_t step = 0; step < 3; ++step) {
            ++at[static_cast<size_t>(kPaths[p][step])];
            corner[step + 1] = number(at);
          }
          if (p >= 3) std::swap(corner[1], corner[2]);
          solid.tetrahedra.push_back(corner);
        }
      }
    }
  }
  return solid;
}

/// Multipliers that differ from element to element.
inline std::vector<double> uneven_map(size_t elements) {
  std::vector<double> map;
  for (size_t i = 0; i < elements; ++i) map.push_back(0.6 + 0.3 * static_cast<double>(i * i % 5));
  return map;
}

}  // namespace lissom
