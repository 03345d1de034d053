#include "lissom/geometry/surface_cells.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <random>

#include "lissom/core/assert.h"
#include "lissom/geometry/cell_growth.h"
#include "lissom/geometry/surface_topology.h"
#include "lissom/geometry/triangle_point.h"

namespace lissom {

namespace {

constexpr int kEdgesAcross = 5;   // of the fine surface, in the width of a cell
constexpr double kInside = 0.02;  // least weight of a vertex at a point where cells meet
constexpr int kMostAdded = 4;     // cells per cell asked for

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Width of a cell on a surface that is `darkness` dark, by that on white.
double relative_width(double darkness, double contrast) { return 1 - (1 - 1 / contrast) * darkness; }

/// Cells are that wide where density is the fourth power of the inverse width [Du, Faber, Gunzburger 1999, 2.3].
double density(double darkness, double contrast) { return std::pow(relative_width(darkness, contrast), -4); }

double squared_distance(const SurfaceCells& cells, int vertex, int cell) {
  return (cells.fine.surface.vertices[at(vertex)] - cells.site[at(cell)]).squaredNorm();
}

/// Lloyd's iteration over a surface that is cut finely enough.
class Tessellation {
 public:
  Tessellation(const Surface& surface, const CellOptions& options) : options_(options) {
    double area = 0;
    const int count = static_cast<int>(surface.triangles.size());
    for (int t = 0; t < count; ++t) {
      double dark = 0;
      for (const int v : surface.triangles[at(t)]) dark += surface.darkness.empty() ? 0 : surface.darkness[at(v)] / 3;
      area += 0.5 * area_vector(surface, t).norm() / std::pow(relative_width(dark, options.contrast), 2);
    }
    width_ = std::sqrt(area / options.cells);
    cells_.fine = refine_surface(
        surface, [&](double dark) { return width_ * relative_width(dark, options.contrast) / kEdgesAcross; });
    growth_ = CellGrowth(cells_.fine.surface);
    begin();
  }

  SurfaceCells run(const Context& context) {
    relax(context);
    const int wanted = options_.cells;
    while (!context.cancelled() && static_cast<int>(cells_.site.size()) < kMostAdded * wanted && add_cells()) {
      relax(context);
    }
    if (const int added = static_cast<int>(cells_.site.size()) - wanted; added > 0) {
      cells_.notes.push_back(
          fmt::format("{} {} added where a cell went all around a thin part of the surface or a hole", added,
                      added == 1 ? "cell was" : "cells were"));
    }
    if (cells_.movement > options_.tolerance) {
      cells_.notes.push_back(fmt::format("cells still move by {:.2g} of their width after {} iterations",
                                         cells_.movement, cells_.iterations));
    }
    return std::move(cells_);
  }

 private:
  const Surface& fine() const { return cells_.fine.surface; }

  double darkness(int vertex) const { return fine().darkness.empty() ? 0 : fine().darkness[at(vertex)]; }

  /// Random vertices, by area and density.
  void begin() {
    VecX share = VecX::Zero(static_cast<Eigen::Index>(fine().vertices.size()));
    for (int t = 0; t < static_cast<int>(fine().triangles.size()); ++t) {
      const double area = 0.5 * area_vector(fine(), t).norm();
      for (const int v : fine().triangles[at(t)]) {
        share[v] += area / 3 / std::pow(relative_width(darkness(v), options_.contrast), 2);
      }
    }
    for (Eigen::Index v = 1; v < share.size(); ++v) share[v] += share[v - 1];
    std::mt19937 random(options_.seed);
    std::vector<char> taken(fine().vertices.size(), 0);
    while (static_cast<int>(start_.size()) < options_.cells) {
      const double u = share[share.size() - 1] * (static_cast<double>(random()) / 4294967296.0);
      const auto v = static_cast<int>(std::upper_bound(share.data(), share.data() + share.size(), u) - share.data());
      if (std::exchange(taken[at(v)], 1) != 0) continue;
      start_.push_back(v);
      cells_.site.push_back(fine().vertices[at(v)]);
    }
  }

  void relax(const Context& context) {
    cells_.cell = growth_.grow(fine(), cells_.site, start_);
    for (int i = 0; i < options_.iterations && !context.cancelled(); ++i) {
      cells_.movement = move_sites();
      ++cells_.iterations;
      cells_.cell = growth_.grow(fine(), cells_.site, start_);
      context.report({.task = "cells", .iteration = cells_.iterations, .detail = "moving cells to their centroids"});
      if (cells_.movement <= options_.tolerance) break;
    }
  }

  /// To the places of the surface nearest to the centroids. Returns the largest movement by the width of the cell.
  double move_sites() {
    const std::size_t count = cells_.site.size();
    std::vector<Vec3> moment(count, Vec3::Zero());
    std::vector<double> mass(count, 0), area(count, 0);
    for (int t = 0; t < static_cast<int>(fine().triangles.size()); ++t) {
      for (const CellPiece& piece : cell_pieces(cells_, t)) gather(t, piece, moment, mass, area);
    }
    for (std::size_t c = 0; c < count; ++c) moment[c] /= mass[c];
    return settle(moment, area);
  }

  void gather(int triangle, const CellPiece& piece, std::vector<Vec3>& moment, std::vector<double>& mass,
              std::vector<double>& area) const {
    const auto cell = at(piece.cell);
    const std::array<int, 3>& corner = fine().triangles[at(triangle)];
    const auto dark = [&](const Vec3& w) {
      return fine().darkness.empty()
                 ? 0
                 : w[0] * darkness(corner[0]) + w[1] * darkness(corner[1]) + w[2] * darkness(corner[2]);
    };
    const double whole = 0.5 * area_vector(fine(), triangle).norm();
    for (std::size_t k = 2; k < piece.corners.size(); ++k) {
      const std::array<Vec3, 3> w{piece.corners[0], piece.corners[k - 1], piece.corners[k]};
      const double part = whole * std::abs((Mat3() << w[0], w[1], w[2]).finished().determinant());
      area[cell] += part;
      std::array<double, 3> rho;
      for (std::size_t i = 0; i < 3; ++i) rho[i] = density(dark(w[i]), options_.contrast);
      const double sum = rho[0] + rho[1] + rho[2];
      mass[cell] += part * sum / 3;
      for (std::size_t i = 0; i < 3; ++i)
        moment[cell] += part / 12 * (sum + rho[i]) * position(fine(), {triangle, w[i]});
    }
  }

  double settle(const std::vector<Vec3>& centroid, const std::vector<double>& area) {
    const std::size_t count = centroid.size();
    std::vector<double> best(count, std::numeric_limits<double>::infinity());
    std::vector<Vec3> place(count, Vec3::Zero());
    std::vector<int> start(count, -1);
    for (const std::array<int, 3>& corner : fine().triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        const auto c = at(cells_.cell[at(corner[i])]);
        if (i > 0 && cells_.cell[at(corner[i])] == cells_.cell[at(corner[0])]) continue;
        const Vec3 &x0 = fine().vertices[at(corner[0])], &x1 = fine().vertices[at(corner[1])],
                   &x2 = fine().vertices[at(corner[2])];
        const Vec3 w = nearest_in_triangle(x0, x1, x2, centroid[c]);
        const Vec3 x = w[0] * x0 + w[1] * x1 + w[2] * x2;
        const double distance = (x - centroid[c]).squaredNorm();
        if (distance >= best[c]) continue;
        best[c] = distance;
        place[c] = x;
        start[c] = nearest_own_corner(corner, x, static_cast<int>(c));
      }
    }
    double movement = 0;
    for (std::size_t c = 0; c < count; ++c) {
      movement = std::max(movement, (place[c] - cells_.site[c]).norm() / std::sqrt(area[c]));
    }
    cells_.site = std::move(place);
    start_ = std::move(start);
    return movement;
  }

  int nearest_own_corner(const std::array<int, 3>& corner, const Vec3& x, int cell) const {
    int nearest = -1;
    for (const int v : corner) {
      if (cells_.cell[at(v)] != cell) continue;
      if (nearest < 0 || (fine().vertices[at(v)] - x).norm() < (fine().vertices[at(nearest)] - x).norm()) nearest = v;
    }
    return nearest;
  }

  /// One more site in every cell that is no disc, as far from its own site as it goes. False when all are discs.
  bool add_cells() {
    const std::vector<int> euler = growth_.euler_numbers(fine(), cells_.cell, static_cast<int>(cells_.site.size()));
    std::vector<int> farthest(euler.size(), -1);
    for (int v = 0; v < static_cast<int>(fine().vertices.size()); ++v) {
      int& f = farthest[at(cells_.cell[at(v)])];
      const int c = cells_.cell[at(v)];
      if (f < 0 || squared_distance(cells_, v, c) > squared_distance(cells_, f, c)) f = v;
    }
    bool any = false;
    for (std::size_t c = 0; c < euler.size(); ++c) {
      if (euler[c] == 1 || farthest[c] == start_[c]) continue;
      start_.push_back(farthest[c]);
      cells_.site.push_back(fine().vertices[at(farthest[c])]);
      any = true;
    }
    return any;
  }

  CellOptions options_;
  double width_ = 0;  // m, of a cell on white
  SurfaceCells cells_;
  CellGrowth growth_;
  std::vector<int> start_;  // per cell: the vertex from which it grows
};

}  // namespace

double crossing(const SurfaceCells& cells, int a, int b) {
  if (a > b) return 1 - crossing(cells, b, a);  // the same point from both sides
  const int i = cells.cell[at(a)], j = cells.cell[at(b)];
  const double from = squared_distance(cells, a, i) - squared_distance(cells, a, j);
  const double to = squared_distance(cells, b, i) - squared_distance(cells, b, j);
  return from < to ? std::clamp(-from / (to - from), kInside, 1 - kInside) : 0.5;
}

Vec3 triple_point(const SurfaceCells& cells, int triangle) {
  const std::array<int, 3>& corner = cells.fine.surface.triangles[at(triangle)];
  Mat3 system;
  for (int i = 0; i < 3; ++i) {
    const int v = corner[at(i)];
    const double own = squared_distance(cells, v, cells.cell[at(corner[0])]);
    system.col(i) << squared_distance(cells, v, cells.cell[at(corner[1])]) - own,
        squared_distance(cells, v, cells.cell[at(corner[2])]) - own, 1;
  }
  Vec3 weights = system.fullPivLu().solve(Vec3::UnitZ());
  if (!weights.allFinite()) weights.setConstant(1.0 / 3);
  weights = weights.cwiseMax(kInside);
  return weights / weights.sum();
}

std::vector<CellPiece> cell_pieces(const SurfaceCells& cells, int triangle) {
  const std::array<int, 3>& corner = cells.fine.surface.triangles[at(triangle)];
  std::array<int, 3> cell;
  for (std::size_t i = 0; i < 3; ++i) cell[i] = cells.cell[at(corner[i])];
  if (cell[0] == cell[1] && cell[1] == cell[2]) return {{cell[0], {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}}};
  const auto cut = [&](std::size_t i) {  // on the edge from corner i to the next
    const std::size_t j = (i + 1) % 3;
    const double t = crossing(cells, corner[i], corner[j]);
    Vec3 weights = Vec3::Zero();
    weights[static_cast<int>(i)] = 1 - t;
    weights[static_cast<int>(j)] = t;
    return weights;
  };
  std::vector<CellPiece> pieces;
  if (cell[0] != cell[1] && cell[1] != cell[2] && cell[2] != cell[0]) {
    const Vec3 middle = triple_point(cells, triangle);
    for (std::size_t i = 0; i < 3; ++i) {
      pieces.push_back({cell[i], {Vec3::Unit(static_cast<int>(i)), cut(i), middle, cut((i + 2) % 3)}});
    }
    return pieces;
  }
  std::size_t alone = 0;  // the corner that differs from the other two
  while (cell[alone] == cell[(alone + 1) % 3] || cell[alone] == cell[(alone + 2) % 3]) ++alone;
  const std::size_t next = (alone + 1) % 3, last = (alone + 2) % 3;
  pieces.push_back({cell[alone], {Vec3::Unit(static_cast<int>(alone)), cut(alone), cut(last)}});
  pieces.push_back(
      {cell[next], {cut(alone), Vec3::Unit(static_cast<int>(next)), Vec3::Unit(static_cast<int>(last)), cut(last)}});
  return pieces;
}

Result<SurfaceCells> tessellate(const Surface& surface, const CellOptions& options, const std::string& where,
                                const Context& context) {
  if (options.cells < 4) {
    return Error{ErrorCode::kRange, where + "/cells",
                 fmt::format("{} cells are too few for a mesh of rods", options.cells), "ask for four or more"};
  }
  if (!(options.contrast >= 1) || !std::isfinite(options.contrast)) {
    return Error{ErrorCode::kRange, where + "/contrast", "the contrast of cell widths has to be 1 or more",
                 "1 makes all cells alike, 3 makes cells on black a third as wide as on white"};
  }
  if (surface_pieces(side_mates(surface.triangles)).count != 1) {
    return Error{ErrorCode::kGeometry, where, "cells need one connected surface", "keep one part of it"};
  }
  return Tessellation(surface, options).run(context);
}

}  // namespace lissom
