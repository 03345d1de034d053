#include "lissom/fabrication/tube_strip.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lissom {

namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr int kFewestSides = 16;
constexpr int kMostSides = 512;

const RodStation& station(const RodPiece& piece, int i) { return piece.stations[i]; }

/// Vertices of a ring, turned such that they begin nearest to an angle, with angles that ascend from there.
VertexRing begun_at(const VertexRing& ring, double angle) {
  const std::size_t n = ring.vertices.size();
  std::size_t first = 0;
  const auto apart = [&](std::size_t i) { return std::abs(std::remainder(ring.angles[i] - angle, kTurn)); };
  for (std::size_t i = 1; i < n; ++i) {
    if (apart(i) < apart(first)) first = i;
  }
  VertexRing turned;
  const double shift = ring.angles[first] - (angle + std::remainder(ring.angles[first] - angle, kTurn));
  for (std::size_t k = 0; k <= n; ++k) {
    const std::size_t at = first + k;
    turned.vertices.push_back(ring.vertices[at % n]);
    turned.angles.push_back(ring.angles[at % n] + (at >= n ? kTurn : 0) - shift);
  }
  return turned;
}

}  // namespace

int ring_sides(const RodPiece& piece, int first, int last, double tolerance) {
  double largest = 0;
  for (int i = first; i <= last; ++i) largest = std::max(largest, station(piece, i).reach(piece.shape));
  // Corners of a polygon of n sides with the area of the circle lie (2 pi / n)^2 / 12 of the radius outside.
  const double wanted = kTurn / std::sqrt(12 * tolerance / largest);
  const int sides = static_cast<int>(std::ceil(std::clamp(wanted, double{kFewestSides}, double{kMostSides})));
  return sides + sides % 2;
}

VertexRing add_ring(const RodStation& s, SectionShape shape, int sides, Surface& surface) {
  VertexRing ring;
  const bool box = shape == SectionShape::kRectangle;
  const int count = box ? 4 : sides;
  const double angle = kTurn / sides;
  const double scale = box ? std::numbers::sqrt2 : std::sqrt(angle / std::sin(angle));
  for (int k = 0; k < count; ++k) {
    const double a = kTurn * (k + 0.5) / count;
    ring.vertices.push_back(static_cast<int>(surface.vertices.size()));
    ring.angles.push_back(a);
    surface.vertices.push_back(s.centre + s.b * (s.r_b * scale * std::cos(a)) + s.n * (s.r_n * scale * std::sin(a)));
  }
  return ring;
}

void add_band(const VertexRing& lower, const VertexRing& upper, Surface& surface) {
  const VertexRing a = begun_at(lower, lower.angles.front()), b = begun_at(upper, a.angles.front());
  std::size_t i = 0, j = 0;
  const std::size_t m = a.vertices.size() - 1, n = b.vertices.size() - 1;
  while (i < m || j < n) {
    // The next triangle stands on the ring whose next side has its middle first.
    const double next_a = i < m ? a.angles[i] + a.angles[i + 1] : INFINITY;
    const double next_b = j < n ? b.angles[j] + b.angles[j + 1] : INFINITY;
    if (next_a <= next_b) {
      surface.triangles.push_back({a.vertices[i], a.vertices[i + 1], b.vertices[j]});
      ++i;
    } else {
      surface.triangles.push_back({a.vertices[i], b.vertices[j + 1], b.vertices[j]});
      ++j;
    }
  }
}

void add_cap(const VertexRing& ring, int step, Surface& surface) {
  const std::size_t n = ring.vertices.size();
  // A strip to and fro, without the needles of a fan.
  std::size_t low = 0, high = n - 1;
  bool up = true;
  while (high - low > 1) {
    const std::size_t third = up ? low + 1 : high - 1;
    const std::array<int, 3> t{ring.vertices[low], ring.vertices[third], ring.vertices[high]};
    surface.triangles.push_back(step > 0 ? t : std::array<int, 3>{t[0], t[2], t[1]});
    (up ? low : high) = third;
    up = !up;
  }
}

}  // namespace lissom
