#pragma once
/// A folded sheet with a warp direction, pre-stretches and maps of its own, as several derivative tests load it.

#include <utility>

#include "lissom/model/model.h"
#include "tests/derivatives/solid_block.h"

namespace lissom {

/// Columns x 4 vertices of the fabric "cloth", row by row.
inline Membrane folded_sheet(int columns, double bending) {
  Membrane sheet;
  sheet.name = "sheet";
  sheet.material = "cloth";
  sheet.pre_stretch = {1.3, 1.15};
  sheet.warp_angle = 0.4;
  sheet.bending = bending;
  MembraneMesh mesh;
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < columns; ++i) mesh.points.emplace_back(0.02 * i, 0.021 * j + 0.002 * i, 0.004 * ((i * j) % 3));
  }
  for (int j = 0; j < 3; ++j) {
    for (int i = 0; i + 1 < columns; ++i) {
      const int a = columns * j + i;
      mesh.triangles.push_back({a, a + 1, a + columns + 1});
      mesh.triangles.push_back({a, a + columns + 1, a + columns});
    }
  }
  mesh.stiffness = uneven_map(mesh.triangles.size());
  mesh.density = uneven_map(mesh.triangles.size() + 1);
  mesh.density.pop_back();
  sheet.shape = std::move(mesh);
  return sheet;
}

}  // namespace lissom
