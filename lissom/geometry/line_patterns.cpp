#include "lissom/geometry/line_patterns.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "lissom/geometry/triangle_finder.h"

namespace lissom {

namespace {

using Cell = std::vector<Vec2>;  // corners in order

constexpr double kResolution = 1e-6;  // m, points closer than this are one
constexpr int kShifts = 12;           // of a pattern along each axis, to find the one with most cells on a sheet

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
  FlatView(const FlatView&) = delete;  // the finder looks at its own lists
  FlatView& operator=(const FlatView&) = delete;
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
    for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
      if (area_vector(surface, t).dot(normal_) <= 0) continue;
      facing_.push_back(t);
      triangles_.push_back(surface.triangles[static_cast<std::size_t>(t)]);
    }
    finder_.emplace(flat_, triangles_);
  }

  bool faces_one_way() const { return normal_.norm() > 0.3 * whole_; }

  /// The point of the sheet seen at a place of the view.
  std::optional<Vec3> lifted(const Vec2& p) const {
    const TriangleFinder::Place place = finder_->find(p);
    if (place.weight.minCoeff() < -kOutside) return {};
    return position(surface_, {facing_[static_cast<std::size_t>(place.triangle)], place.weight});
  }

  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity()), high = -low;  // m, of the view

 private:
  static constexpr double kOutside = 1e-6;  // of a triangle's height: a cell may end at the rim itself

  const Surface& surface_;
  Vec3 normal_ = Vec3::Zero(), x_ = Vec3::UnitX(), y_ = Vec3::UnitY();
  double whole_ = 0;  // m^2, twice the area
  std::vector<Vec2> flat_;
  std::vector<int> facing_;                    // triangles that are seen from the front
  std::vector<std::array<int, 3>> triangles_;  // the same, by vertices
  std::optional<TriangleFinder> finder_;
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

/// By how much the pattern may be shifted along its axes until it is the same again, m.
Vec2 period_of(PatternCell cell, double edge) {
  switch (cell) {
    case PatternCell::kSquare:
      return {edge, edge};
    case PatternCell::kTriangle:
      return {edge, 2 * std::sqrt(0.75) * edge};
    case PatternCell::kHexagon:
      break;
  }
  return {std::sqrt(3.0) * edge, 3 * edge};
}

/// Those that lie wholly on the sheet when the pattern begins at `origin` (m, of the view).
std::vector<Cell> fitting_cells(const FlatView& view, const std::vector<Cell>& cells, const Vec2& origin) {
  std::vector<Cell> fitting;
  for (Cell cell : cells) {
    for (Vec2& x : cell) x += origin;
    if (std::all_of(cell.begin(), cell.end(), [&](const Vec2& x) { return view.lifted(x).has_value(); })) {
      fitting.push_back(std::move(cell));
    }
  }
  return fitting;
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
  const auto count = [&](double extent) { return static_cast<int>(std::ceil(extent / edge)) + 4; };
  const std::vector<Cell> cells = cells_of(cell, edge, count(size[0]), count(size[1]));
  const Vec2 period = period_of(cell, edge);
  std::vector<Cell> best;
  for (int i = 0; i < kShifts; ++i) {
    for (int j = 0; j < kShifts; ++j) {
      const Vec2 shift = Vec2(i, j) / kShifts - Vec2::Constant(2);
      std::vector<Cell> fitting = fitting_cells(view, cells, view.low + shift.cwiseProduct(period));
      if (fitting.size() > best.size()) best = std::move(fitting);
    }
  }
  Drawing drawing;
  for (const Cell& c : best) drawing.add(c);
  ObjLines lines = drawing.take();
  if (lines.segments.empty()) {
    return Error{ErrorCode::kGeometry, where, "no cell of the pattern fits on the sheet", "ask for narrower cells"};
  }
  for (Vec3& x : lines.points) x = *view.lifted(x.head<2>());
  return lines;
}

}  // namespace lissom
