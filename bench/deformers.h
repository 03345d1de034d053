#pragma once
/// What surfaces are posed by: a toy of rubber (tetrahedra) and a hat of felt (a shell), both soft in places and pulled far.

#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>
#include <vector>

#include "lissom/model/model.h"

namespace lissom::deformers {

struct Box {
  std::array<int, 3> low, high;  ///< of cells, the high ones not included
  double stiffness;
};

/// Cubes of side `cell` (m) in boxes, later boxes over earlier ones, six tetrahedra each.
inline Solid of_boxes(const std::vector<Box>& boxes, double cell) {
  constexpr std::array<std::array<int, 3>, 6> kPaths{
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
  std::map<std::array<int, 3>, double> cubes;
  for (const Box& box : boxes) {
    for (int i = box.low[0]; i < box.high[0]; ++i) {
      for (int j = box.low[1]; j < box.high[1]; ++j) {
        for (int k = box.low[2]; k < box.high[2]; ++k) cubes[{i, j, k}] = box.stiffness;
      }
    }
  }
  Solid solid;
  std::map<std::array<int, 3>, int> number;
  const auto point = [&](const std::array<int, 3>& at) {
    const auto [place, fresh] = number.emplace(at, static_cast<int>(solid.points.size()));
    if (fresh) solid.points.push_back(cell * Vec3(at[0], at[1], at[2]));
    return place->second;
  };
  for (const auto& [cube, stiffness] : cubes) {
    for (std::size_t p = 0; p < kPaths.size(); ++p) {
      std::array<int, 3> at = cube;
      std::array<int, 4> corner{point(at), 0, 0, 0};
      for (std::size_t step = 0; step < 3; ++step) {
        ++at[static_cast<std::size_t>(kPaths[p][step])];
        corner[step + 1] = point(at);
      }
      if (p >= 3) std::swap(corner[1], corner[2]);
      solid.tetrahedra.push_back(corner);
      solid.stiffness.push_back(stiffness);
    }
  }
  return solid;
}

inline Selector in_box(const Vec3& low, const Vec3& high) {
  Selector selector;
  selector.kind = Selector::Kind::kBox;
  selector.low = low;
  selector.high = high;
  return selector;
}

inline Support held(Selector at, const Vec3& move = Vec3::Zero()) {
  Support support;
  support.at = std::move(at);
  support.move = move;
  return support;
}

/// An animal of rubber on four legs, 0.2 m long: E = 1 MPa, a tenth of that in neck and tail; it stands on its feet under its
/// weight, and the end of its tail is pulled up and aside by a quarter of its length. `cells`: along the body, at least 8.
inline Model toy(int cells) {
  const int n = cells / 8;  // of the leg's width
  const double cell = 0.2 / (21 * n);
  const auto box = [&](std::array<int, 3> low, std::array<int, 3> high, double stiffness) {
    for (int k = 0; k < 3; ++k) {
      low[k] *= n;
      high[k] *= n;
    }
    return Box{low, high, stiffness};
  };
  Model model;
  Solid solid = of_boxes({box({7, 0, 3}, {15, 5, 7}, 1),                                   // body
                          box({7, 0, 0}, {9, 2, 3}, 1), box({7, 3, 0}, {9, 5, 3}, 1),      // hind legs
                          box({13, 0, 0}, {15, 2, 3}, 1), box({13, 3, 0}, {15, 5, 3}, 1),  // fore legs
                          box({15, 1, 5}, {17, 4, 10}, 0.1),                               // neck
                          box({16, 1, 8}, {21, 4, 11}, 1),                                 // head
                          box({0, 2, 5}, {7, 3, 7}, 0.1)},                                 // tail
                         cell);
  solid.name = "toy";
  solid.material = "rubber";
  model.materials.push_back({"rubber", 1e6, 0.4, 1000, 1, "soft natural rubber"});
  model.solids.push_back(std::move(solid));
  Pose pose;
  pose.name = "tail up";
  pose.gravity = Gravity{};
  const double e = 0.1 * cell;
  pose.supports.push_back(held(in_box(Vec3(-1, -1, -e), Vec3(1, 1, e))));
  pose.supports.push_back(held(in_box(Vec3(-e, -1, -1), Vec3(e, 1, 1)), Vec3(0.015, 0.03, 0.037)));
  model.poses.push_back(pose);
  return model;
}

/// A hat of felt, open below: a crown of half a sphere on a brim, `rings` from the top to the rim, twice as many triangles around.
/// The band above the brim is ten times as stiff. Half of the brim is held, the other half is pulled up, the top aside.
inline Model hat(int rings) {
  const double crown = 0.09, brim = 0.07;  // m, radius and width
  const int around = 2 * rings;
  MembraneMesh mesh;
  mesh.points.emplace_back(0, 0, crown);
  const auto place = [&](int ring, double turn) -> Vec3 {
    const double way = (0.5 * std::numbers::pi * crown + brim) * ring / rings, arc = way / crown;
    const double quarter = 0.5 * std::numbers::pi;
    const double radius = arc < quarter ? crown * std::sin(arc) : crown + (way - crown * quarter);
    return {radius * std::cos(turn), radius * std::sin(turn), arc < quarter ? crown * std::cos(arc) : 0};
  };
  for (int ring = 1; ring <= rings; ++ring) {
    for (int i = 0; i < around; ++i)
      mesh.points.push_back(place(ring, 2 * std::numbers::pi * (i + 0.5 * (ring % 2)) / around));
  }
  const auto at = [&](int ring, int i) { return 1 + (ring - 1) * around + (i + around) % around; };
  for (int i = 0; i < around; ++i) mesh.triangles.push_back({0, at(1, i), at(1, i + 1)});
  for (int ring = 1; ring < rings; ++ring) {
    const int shift = ring % 2;  // the next ring is turned by half a side
    for (int i = 0; i < around; ++i) {
      mesh.triangles.push_back({at(ring, i), at(ring + 1, i + shift), at(ring, i + 1)});
      mesh.triangles.push_back({at(ring + 1, i + shift), at(ring + 1, i + shift + 1), at(ring, i + 1)});
    }
  }
  for (const std::array<int, 3>& t : mesh.triangles) {
    const Vec3 middle = (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3;
    mesh.stiffness.push_back(middle.z() > 0.002 && middle.z() < 0.03 ? 10 : 1);
  }
  Model model;
  model.membrane_materials.push_back(
      {"felt", 2e6 * 0.002, 2e6 * 0.002, 0.3, 0.002, 0.4, "2 mm of wool felt, about 2 MPa"});
  Membrane shell;
  shell.name = "hat";
  shell.material = "felt";
  shell.shape = std::move(mesh);
  model.membranes.push_back(std::move(shell));
  Pose pose;
  pose.name = "turned up";
  pose.gravity = Gravity{};
  const double rim = crown + brim;
  pose.supports.push_back(held(in_box(Vec3(-1, -1, -0.001), Vec3(-0.8 * rim, 1, 0.001))));
  pose.supports.push_back(held(in_box(Vec3(0.9 * rim, -1, -0.001), Vec3(1, 1, 0.001)), Vec3(-0.04, 0, 0.07)));
  pose.supports.push_back(held(in_box(Vec3(-0.01, -0.01, 0.08), Vec3(0.01, 0.01, 1)), Vec3(0.03, 0.03, -0.02)));
  model.poses.push_back(pose);
  return model;
}

}  // namespace lissom::deformers
