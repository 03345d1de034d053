#include "lissom/fabrication/solid_check.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "lissom/fabrication/self_intersection.h"

namespace lissom {

namespace {

/// An edge of a triangle, from one vertex to another.
struct Side {
  int from = 0, to = 0, triangle = 0;
  bool operator<(const Side& o) const { return std::pair(from, to) < std::pair(o.from, o.to); }
};

std::vector<Side> sides_of(const Surface& surface) {
  std::vector<Side> sides;
  sides.reserve(surface.triangles.size() * 3);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const std::array<int, 3>& v = surface.triangles[t];
    for (std::size_t k = 0; k < 3; ++k) sides.push_back({v[k], v[(k + 1) % 3], static_cast<int>(t)});
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

const Vec3& vertex(const Surface& surface, int v) { return surface.vertices[v]; }

/// Something wrong with edges, and where.
std::optional<std::pair<const char*, int>> wrong_edge(const std::vector<Side>& sides) {
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const Side& side = sides[i];
    if (i > 0 && !(sides[i - 1] < side)) return std::pair("an edge has more than two triangles", side.from);
    const auto other = std::lower_bound(sides.begin(), sides.end(), Side{side.to, side.from, 0});
    if (other == sides.end() || other->from != side.to || other->to != side.from) {
      return std::pair("an edge has only one triangle", side.from);
    }
  }
  return std::nullopt;
}

/// A vertex at which more than one fan of triangles meets, or -1. `sides` are without faults.
int pinched_vertex(const Surface& surface, const std::vector<Side>& sides) {
  std::size_t begin = 0;
  while (begin < sides.size()) {
    std::size_t end = begin;
    while (end < sides.size() && sides[end].from == sides[begin].from) ++end;
    // From the triangle left of v -> a to the one left of v -> b, where it is v, a, b.
    std::size_t at = begin, seen = 0;
    do {
      const std::array<int, 3>& t = surface.triangles[sides[at].triangle];
      const std::size_t own = static_cast<std::size_t>(std::find(t.begin(), t.end(), sides[at].from) - t.begin());
      const Side next{sides[at].from, t[(own + 2) % 3], 0};
      at = static_cast<std::size_t>(std::lower_bound(sides.begin(), sides.end(), next) - sides.begin());
      ++seen;
    } while (at != begin && seen <= end - begin);
    if (seen != end - begin) return sides[begin].from;
    begin = end;
  }
  return -1;
}

/// Number of the connected part of every vertex; vertices that no triangle has are parts of their own.
std::vector<int> parts_of(const Surface& surface) {
  std::vector<int> up(surface.vertices.size());
  std::iota(up.begin(), up.end(), 0);
  const auto find = [&](int v) {
    while (up[v] != v) {
      up[v] = up[up[v]];
      v = up[v];
    }
    return v;
  };
  for (const std::array<int, 3>& t : surface.triangles) {
    const int a = find(t[0]), b = find(t[1]), c = find(t[2]);
    const int least = std::min({a, b, c});
    for (const int v : {a, b, c}) up[v] = least;
  }
  for (std::size_t v = 0; v < up.size(); ++v) up[v] = find(static_cast<int>(v));
  return up;
}

/// m^3 of every part, at the number of its first vertex.
std::vector<double> volumes_of(const Surface& surface, const std::vector<int>& part) {
  std::vector<double> volume(surface.vertices.size(), 0);
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const std::array<int, 3>& v = surface.triangles[t];
    const auto p = static_cast<std::size_t>(part[v[0]]);
    const Vec3& origin = surface.vertices[p];
    volume[p] +=
        (vertex(surface, v[0]) - origin).dot((vertex(surface, v[1]) - origin).cross(vertex(surface, v[2]) - origin)) /
        6;
  }
  return volume;
}

/// Takes away the parts whose volume is to go; how many there were.
template <class Goes>
int drop_parts(Surface& surface, const Goes& goes) {
  const std::vector<int> part = parts_of(surface);
  const std::vector<double> volumes = volumes_of(surface, part);
  // Volumes stand at the first vertices of parts; the others have 0, and no triangle names them.
  std::vector<bool> dropped(volumes.size(), false);
  for (const std::array<int, 3>& t : surface.triangles) dropped[part[t[0]]] = goes(volumes[part[t[0]]]);
  const auto count = std::count(dropped.begin(), dropped.end(), true);
  if (count > 0) std::erase_if(surface.triangles, [&](const std::array<int, 3>& t) { return dropped[part[t[0]]]; });
  return static_cast<int>(count);
}

SolidCheck found(const char* problem, const Vec3& place) {
  SolidCheck check;
  check.problem = problem;
  check.place = place;
  return check;
}

}  // namespace

SolidCheck check_solid(const Surface& surface, const Context& context) {
  if (surface.triangles.empty()) return found("it has no triangles", Vec3::Zero());
  const std::vector<Side> sides = sides_of(surface);
  if (const auto wrong = wrong_edge(sides)) return found(wrong->first, vertex(surface, wrong->second));
  if (const int v = pinched_vertex(surface, sides); v >= 0) {
    return found("parts of it touch in a single vertex", vertex(surface, v));
  }
  SolidCheck check;
  const std::vector<int> part = parts_of(surface);
  const std::vector<double> volumes = volumes_of(surface, part);
  std::vector<bool> used(surface.vertices.size(), false);
  for (const std::array<int, 3>& t : surface.triangles) used[part[t[0]]] = true;
  for (std::size_t p = 0; p < volumes.size(); ++p) {
    if (!used[p]) continue;
    ++check.parts;
    check.volume += volumes[p];
    if (!(volumes[p] > 0)) return found("a part of it is inside out", surface.vertices[p]);
  }
  if (const std::optional<Vec3> place = self_intersection(surface, context))
    return found("two of its triangles intersect", *place);
  return check;
}

int fill_cavities(Surface& surface) {
  return drop_parts(surface, [](double volume) { return volume < 0; });
}

int drop_flakes(Surface& surface, double least) {
  return drop_parts(surface, [&](double volume) { return volume >= 0 && volume < least; });
}

}  // namespace lissom
