#include "lissom/geometry/surface_refine.h"

#include <algorithm>
#include <cstdint>
#include <queue>
#include <unordered_map>

#include "lissom/core/assert.h"

namespace lissom {

namespace {

uint64_t edge_key(int a, int b) {
  const auto [low, high] = std::minmax(a, b);
  return (static_cast<uint64_t>(static_cast<uint32_t>(low)) << 32) | static_cast<uint32_t>(high);
}

/// Splits edges of a growing set of triangles.
class Refiner {
 public:
  Refiner(const Surface& surface, const EdgeLimit& limit) : limit_(limit) {
    fine_.surface = surface;
    const auto count = surface.triangles.size();
    fine_.origin.resize(count);
    fine_.corner_weights.assign(count, {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()});
    for (int t = 0; t < static_cast<int>(count); ++t) {
      fine_.origin[static_cast<std::size_t>(t)] = t;
      link(t);
    }
    for (const std::array<int, 3>& corner : surface.triangles) {
      for (std::size_t i = 0; i < 3; ++i) offer(corner[i], corner[(i + 1) % 3]);
    }
  }

  RefinedSurface run() {
    while (!longest_.empty()) {
      const Long edge = longest_.top();
      longest_.pop();
      if (const auto found = triangles_of_.find(edge.key); found != triangles_of_.end()) split(edge.key, found->second);
    }
    return std::move(fine_);
  }

 private:
  /// By how much an edge is longer than wanted; of equal ones the smaller key first.
  struct Long {
    double ratio;
    uint64_t key;
    bool operator<(const Long& other) const { return ratio != other.ratio ? ratio < other.ratio : key > other.key; }
  };

  const Vec3& vertex(int v) const { return fine_.surface.vertices[static_cast<std::size_t>(v)]; }
  double darkness(int v) const {
    const std::vector<double>& all = fine_.surface.darkness;
    return all.empty() ? 0 : all[static_cast<std::size_t>(v)];
  }

  void link(int triangle) {
    const std::array<int, 3>& corner = fine_.surface.triangles[static_cast<std::size_t>(triangle)];
    for (std::size_t i = 0; i < 3; ++i) {
      auto [entry, fresh] =
          triangles_of_.try_emplace(edge_key(corner[i], corner[(i + 1) % 3]), std::array{triangle, -1});
      if (!fresh) entry->second[entry->second[0] < 0 ? 0 : 1] = triangle;
    }
  }

  void unlink(int triangle) {
    const std::array<int, 3>& corner = fine_.surface.triangles[static_cast<std::size_t>(triangle)];
    for (std::size_t i = 0; i < 3; ++i) {
      const auto entry = triangles_of_.find(edge_key(corner[i], corner[(i + 1) % 3]));
      std::array<int, 2>& sides = entry->second;
      sides[sides[0] == triangle ? 0 : 1] = -1;
      if (sides[0] < 0 && sides[1] < 0) triangles_of_.erase(entry);
    }
  }

  void offer(int a, int b) {
    const double wanted = limit_(0.5 * (darkness(a) + darkness(b)));
    LISSOM_ASSERT(wanted > 0);
    if (const double ratio = (vertex(a) - vertex(b)).norm() / wanted; ratio > 1) longest_.push({ratio, edge_key(a, b)});
  }

  void split(uint64_t key, std::array<int, 2> sides) {
    const int a = static_cast<int>(key >> 32), b = static_cast<int>(key & 0xffffffffu);
    const int middle = static_cast<int>(fine_.surface.vertices.size());
    fine_.surface.vertices.push_back(0.5 * (vertex(a) + vertex(b)));
    if (!fine_.surface.darkness.empty()) fine_.surface.darkness.push_back(0.5 * (darkness(a) + darkness(b)));
    std::sort(sides.begin(), sides.end());
    for (const int triangle : sides) {
      if (triangle >= 0) halve(triangle, a, b, middle);
    }
    offer(a, middle);
    offer(middle, b);
  }

  /// The triangle keeps the half at the first of the two corners; the other half is a new one.
  void halve(int triangle, int a, int b, int middle) {
    unlink(triangle);
    const auto t = static_cast<std::size_t>(triangle);
    std::array<int, 3> corner = fine_.surface.triangles[t];
    std::size_t i = 0;
    while (edge_key(corner[i], corner[(i + 1) % 3]) != edge_key(a, b)) ++i;
    const std::size_t j = (i + 1) % 3;
    std::array<Vec3, 3> weights = fine_.corner_weights[t];
    const Vec3 half = 0.5 * (weights[i] + weights[j]);
    std::array<int, 3> other = corner;
    std::array<Vec3, 3> other_weights = weights;
    corner[j] = middle;
    weights[j] = half;
    other[i] = middle;
    other_weights[i] = half;
    fine_.surface.triangles[t] = corner;
    fine_.corner_weights[t] = weights;
    fine_.surface.triangles.push_back(other);
    fine_.corner_weights.push_back(other_weights);
    fine_.origin.push_back(fine_.origin[t]);
    link(triangle);
    link(static_cast<int>(fine_.surface.triangles.size()) - 1);
    offer(middle, corner[(i + 2) % 3]);
  }

  const EdgeLimit& limit_;
  RefinedSurface fine_;
  std::unordered_map<uint64_t, std::array<int, 2>> triangles_of_;
  std::priority_queue<Long> longest_;
};

}  // namespace

SurfacePlace RefinedSurface::on_given(const SurfacePlace& place) const {
  const auto t = static_cast<std::size_t>(place.triangle);
  SurfacePlace given{origin[t], Vec3::Zero()};
  for (std::size_t i = 0; i < 3; ++i) given.weights += place.weights[static_cast<int>(i)] * corner_weights[t][i];
  return given;
}

RefinedSurface refine_surface(const Surface& surface, const EdgeLimit& limit) { return Refiner(surface, limit).run(); }

}  // namespace lissom
