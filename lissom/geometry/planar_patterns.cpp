#include "lissom/geometry/planar_patterns.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lissom {

namespace {

/// Closes the band between two rings of points by advancing on the one that lags behind.
void add_band(PlanarTriangles& mesh, int inner_first, int inner, int outer_first, int outer) {
  for (int i = 0, o = 0; i < inner || o < outer;) {
    const int a = inner_first + i % inner, b = outer_first + o % outer;
    // Both rings are uniform: compare the places of the middles of the next edges.
    const bool outwards = o < outer && (i == inner || (2 * o + 1) * inner <= (2 * i + 1) * outer);
    if (outwards) {
      mesh.triangles.push_back({a, b, outer_first + (o + 1) % outer});
      ++o;
    } else {
      mesh.triangles.push_back({a, b, inner_first + (i + 1) % inner});
      ++i;
    }
  }
}

/// Two triangles of the quadrilateral a, b, c, d (anticlockwise).
void add_cell(PlanarTriangles& mesh, int a, int b, int c, int d, bool rising) {
  if (rising) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({a, c, d});
  } else {
    mesh.triangles.push_back({a, b, d});
    mesh.triangles.push_back({b, c, d});
  }
}

}  // namespace

PlanarTriangles grid_triangles(const Vec2& corner, const Vec2& size, int cells_x, int cells_y) {
  PlanarTriangles mesh;
  for (int j = 0; j <= cells_y; ++j) {
    for (int i = 0; i <= cells_x; ++i) {
      mesh.points.push_back(corner + Vec2(size.x() * i / cells_x, size.y() * j / cells_y));
    }
  }
  const int row = cells_x + 1;
  for (int j = 0; j < cells_y; ++j) {
    for (int i = 0; i < cells_x; ++i) {
      const int a = j * row + i;
      add_cell(mesh, a, a + 1, a + 1 + row, a + row, (i + j) % 2 == 0);
    }
  }
  return mesh;
}

PlanarTriangles disc_triangles(const Vec2& centre, double inner_radius, double radius, int rings, int sectors) {
  PlanarTriangles mesh;
  const bool full = inner_radius == 0;
  std::vector<int> first, count;
  const auto add_ring = [&](double r, int n) {
    first.push_back(static_cast<int>(mesh.points.size()));
    count.push_back(n);
    for (int k = 0; k < n; ++k) {
      const double angle = 2 * std::numbers::pi * k / n;
      mesh.points.push_back(centre + r * Vec2(std::cos(angle), std::sin(angle)));
    }
  };
  if (full) {
    mesh.points.push_back(centre);
    for (int k = 1; k <= rings; ++k) {
      add_ring(radius * k / rings, std::max(3, static_cast<int>(std::lround(double(sectors) * k / rings))));
    }
    for (int k = 0; k < count[0]; ++k) mesh.triangles.push_back({0, 1 + k, 1 + (k + 1) % count[0]});
  } else {
    for (int k = 0; k <= rings; ++k) add_ring(inner_radius + (radius - inner_radius) * k / rings, sectors);
  }
  for (size_t k = 0; k + 1 < count.size(); ++k) {
    if (count[k] != count[k + 1]) {
      add_band(mesh, first[k], count[k], first[k + 1], count[k + 1]);
      continue;
    }
    for (int i = 0; i < count[k]; ++i) {
      const int next = (i + 1) % count[k];
      add_cell(mesh, first[k] + i, first[k + 1] + i, first[k + 1] + next, first[k] + next,
               (i + static_cast<int>(k)) % 2 == 0);
    }
  }
  return mesh;
}

PlanarTriangles equilateral_triangles(const Vec2& corner, double edge, int columns, int rows) {
  PlanarTriangles mesh;
  const double height = edge * std::numbers::sqrt3 / 2;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      mesh.points.push_back(corner + Vec2(edge * (i + 0.5 * (j % 2)), height * j));
    }
  }
  const int row = columns + 1;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const int a = j * row + i;
      add_cell(mesh, a, a + 1, a + 1 + row, a + row, j % 2 == 1);
    }
  }
  return mesh;
}

}  // namespace lissom
