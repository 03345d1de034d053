#pragma once
/// Which edges and triangles belong to some rods and membranes: what objectives of a part of a structure sum over.

#include <span>
#include <vector>

#include "lissom/model/structure.h"

namespace lissom {

/// Triangles of these membranes, ascending within each; of all when none is given.
inline std::vector<int> triangles_of(const Structure& structure, std::span<const int> membranes) {
  std::vector<int> triangles;
  const auto add = [&](const StructureMembrane& membrane) {
    for (int t = 0; t < membrane.triangles; ++t) triangles.push_back(membrane.first_triangle + t);
  };
  if (membranes.empty()) {
    for (const StructureMembrane& membrane : structure.membranes) add(membrane);
  }
  for (const int m : membranes) add(structure.membranes[m]);
  return triangles;
}

/// Numbers of these rods; of all when none is given.
inline std::vector<int> rods_or_all(const Structure& structure, std::span<const int> rods) {
  if (!rods.empty()) return {rods.begin(), rods.end()};
  std::vector<int> all;
  for (int r = 0; r < static_cast<int>(structure.rods.size()); ++r) all.push_back(r);
  return all;
}

}  // namespace lissom
