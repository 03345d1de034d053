#include "lissom/geometry/line_patterns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

namespace lissom {

namespace {

using Cell = std::vector<Vec2>;  // corners in order

constexpr double kResolution = 1e-6;  // m, points closer than this are one

std::vector<Cell> hexagon_cells(double edge, int columns, int rows) {
  std::vector<Cell> cells;
  const double width = std::sqrt(3.0) * edge;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const Vec2 centre(width * (column + 0.5 * (row % 2)), 1.5 * edge * row);
      Cell& cell = cells.emplace_back();
      for (int k = 0; k < 6; ++k) {
        const double angle = std::numbers::pi / 6 + k * std::numbers::pi / 3;
        cell.push_back(centre + edge * Vec2(std::cos(angle), std::sin(angle)));
      }
    }
  }
  return cells;
}

std::vector<Cell> square_cells(double edge, int columns, int rows) {
  std::vector<Cell> cells;
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      const double x0 = i * edge, x1 = (i + 1) * edge, y0 = j * edge, y1 = (j + 1) * edge;
      cells.push_back({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
    }
  }
  return cells;
}

/// Between lines of columns + 1 points, every other one shifted by half an edge.
std::vector<Cell> triangle_cells(double edge, int columns, int rows) {
  std::vector<Cell> cells;
  const double height = std::sqrt(0.75) * edge;
  const auto point = [&](int i, int j) { return Vec2(edge * (i + 0.5 * (j % 2)), j * height); };
  for (int j = 0; j < rows; ++j) {
    const int shift = j % 2;  // of the line above, to the left
    for (int i = 0; i < columns; ++i) {
      cells.push_back({point(i, j), point(i + 1, j), point(i + shift, j + 1)});
      cells.push_back({point(i + 1 - shift, j), point(i + 1, j + 1), point(i, j + 1)});
    }
  }
  return cells;
}

/// Sides of cells, each once; points closer than kResolution are one.
class Drawing {
 public:
  void add(const Cell& cell) {
    for (std::size_t k = 0; k < cell.size(); ++k) line(cell[k], cell[(k + 1) % cell.size()]);
  }
  ObjLines take() { return std::move(drawn_); }

 private:
  void line(const Vec2& from, const Vec2& to) {
    const int a = point(from), b = point(to);
    const std::pair<int, int> key = std::minmax(a, b);
    if (a != b && lines_.emplace(key, true).second) drawn_.segments.push_back({a, b});
  }
  int point(const Vec2& x) {
    const std::pair<long, long> key{std::lround(x[0] / kResolution), std::lround(x[1] / kResolution)};
    const auto [found, fresh] = numbers_.emplace(key, static_cast<int>(drawn_.points.size()));
    if (fresh) drawn_.points.emplace_back(x[0], x[1], 0);
    return found->second;
  }

  ObjLines drawn_;
  std::map<std::pair<long, long>, int> numbers_;
  std::map<std::pair<int, int>, bool> lines_;
};

ObjLines centred(const std::vector<Cell>& cells) {
  Drawing drawing;
  for (const Cell& cell : cells) drawing.add(cell);
  ObjLines lines = drawing.take();
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Vec3& p : lines.points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  for (Vec3& p : lines.points) p -= 0.5 * (low + high);
  return lines;
}

/// A sheet seen along its mean normal.
class FlatView {
 public:
  explicit FlatView(const Surface& surface) : surface_(surface) {
    for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
      const Vec3 area = area_vector(surface, t);
      normal_ += area;
      whole_ += area.norm();
    }
    if (!faces_one_way()) return;
    normal_.normalize();
    x_ = std::abs(normal_[0]) < 0.9 ? Vec3::UnitX() : Vec3::UnitY();
    x_ = (x_ - x_.dot(normal_) * normal_).normalized();
    y_ = normal_.cross(x_);
    for (const Vec3& p : surface.vertices) {
      flat_.emplace_back(p.dot(x_), p.dot(y_));
      low = low.cwiseMin(flat_.back());
      high = high.cwiseMax(flat_.back());
    }
  }

  bool faces_one_way() const { return normal_.norm() > 0.3 * whole_; }

  /// The point of the sheet seen at a place of the view, on the first triangle there.
  std::optional<Vec3> lifted(const Vec2& p) const {
    for (int t = 0; t < static_cast<int>(surface_.triangles.size()); ++t) {
      const std::array<int, 3>& corner = surface_.triangles[static_cast<std::size_t>(t)];
      const Vec2 &a = at(corner[0]), ab = at(corner[1]) - a, ac = at(corner[2]) - a, ap = p - a;
      const double twice = ab[0] * ac[1] - ab[1] * ac[0];
      if (twice == 0) continue;
      const double v = (ap[0] * ac[1] - ap[1] * ac[0]) / twice, w = (ab[0] * ap[1] - ab[1] * ap[0]) / twice;
      if (std::min({v, w, 1 - v - w}) < -kOutside) continue;
      return position(surface_, {t, Vec3(1 - v - w, v, w)});
    }
    return {};
  }

  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity()), high = -low;  // m, of the view

 private:
  static constexpr double kOutside = 1e-6;  // of a triangle's height: a cell may end at the rim itself

  const Vec2& at(int vertex) const { return flat_[static_cast<std::size_t>(vertex)]; }

  const Surface& surface_;
  Vec3 normal_ = Vec3::Zero(), x_ = Vec3::UnitX(), y_ = Vec3::UnitY();
  double whole_ = 0;  // m^2, twice the area
  std::vector<Vec2> flat_;
};

std::vector<Cell> cells_of(PatternCell cell, double edge, int columns, int rows) {
  switch (cell) {
    case PatternCell::kSquare:
      return square_cells(edge, columns, rows);
    case PatternCell::kTriangle:
      return triangle_cells(edge, columns, rows);
    case PatternCell::kHexagon:
      break;
  }
  return hexagon_cells(edge, columns, rows);
}

}  // namespace

ObjLines hexagon_pattern(double edge, int columns, int rows) { return centred(hexagon_cells(edge, columns, rows)); }
ObjLines square_pattern(double edge, int columns, int rows) { return centred(square_cells(edge, columns, rows)); }
ObjLines triangle_pattern(double edge, int columns, int rows) { return centred(triangle_cells(edge, columns, rows)); }

Result<ObjLines> pattern_on_sheet(const Surface& surface, PatternCell cell, double edge, const std::string& where) {
  const FlatView view(surface);
  if (!view.faces_one_way()) {
    return Error{ErrorCode::kGeometry, where, "a pattern needs a sheet, and this surface faces all ways",
                 "lay cells or the dual on it"};
  }
  const Vec2 size = view.high - view.low;
  const auto count = [&](double extent) { return static_cast<int>(std::ceil(extent / edge)) + 2; };
  std::vector<Cell> cells = cells_of(cell, edge, count(size[0]), count(size[1]));
  Vec2 reach = Vec2::Zero();
  for (const Cell& c : cells) {
    for (const Vec2& x : c) reach = reach.cwiseMax(x);
  }
  Drawing drawing;
  const Vec2 shift = 0.5 * (view.low + view.high) - 0.5 * reach;
  for (Cell& c : cells) {
    bool fits = true;
    for (Vec2& x : c) {
      x += shift;
      fits = fits && view.lifted(x).has_value();
    }
    if (fits) drawing.add(c);
  }
  ObjLines lines = drawing.take();
  if (lines.segments.empty()) {
    return Error{ErrorCode::kGeometry, where, "no cell of the pattern fits on the sheet", "ask for narrower cells"};
  }
  for (Vec3& x : lines.points) x = *view.lifted(x.head<2>());
  return lines;
}

}  // namespace lissom
