#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "lissom/view/picture_parts.h"

namespace lissom {
namespace {

constexpr double kPiece = 9;       // px, side of the pieces that cloth is cut into
constexpr int kMostCuts = 24;      // along the side of a triangle
constexpr double kCrease = 0.6;    // rad; the shading of cloth is smooth up to this angle between triangles
constexpr double kBackSide = 0.9;  // brightness of the side that the normals do not point to
constexpr double kFieldContrast = 0.8;
constexpr double kHatchWidth = 1.0 / 7;  // of the distance of the lines

using Place = std::array<double, 3>;
Place place_of(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

/// Unit normals of the triangles, and of every corner the mean over the triangles that meet there without a crease.
struct Normals {
  std::vector<Vec3> triangle;
  std::vector<std::array<Vec3, 3>> corner;
};

Normals make_normals(const MembraneSheet& sheet) {
  const int triangles = static_cast<int>(sheet.triangles.size());
  std::vector<std::vector<int>> around(sheet.points.size());
  std::vector<Vec3> cross;
  Normals normals;
  for (int t = 0; t < triangles; ++t) {
    cross.push_back(triangle_cross(sheet, t));
    const double size = cross[t].norm();
    normals.triangle.push_back(size > 0 ? Vec3(cross[t] / size) : Vec3::UnitZ());
    for (int i : sheet.triangles[t]) around[i].push_back(t);
  }
  for (int t = 0; t < triangles; ++t) {
    std::array<Vec3, 3> corner;
    for (int k = 0; k < 3; ++k) {
      Vec3 sum = Vec3::Zero();
      for (int other : around[sheet.triangles[t][k]]) {
        if (normals.triangle[other].dot(normals.triangle[t]) >= std::cos(kCrease)) sum += cross[other];
      }
      corner[k] = sum.norm() > 0 ? sum.normalized() : normals.triangle[t];
    }
    normals.corner.push_back(corner);
  }
  return normals;
}

/// Cuts along each side so that pieces are about `size` px.
int cuts(const MembraneSheet& sheet, int t, const Camera& camera, double size) {
  double longest = 0;
  for (int k = 0; k < 3; ++k) {
    const Vec3 &a = sheet.points[sheet.triangles[t][k]], &b = sheet.points[sheet.triangles[t][(k + 1) % 3]];
    longest = std::max(longest, (camera.project(a) - camera.project(b)).norm());
  }
  return std::clamp(static_cast<int>(std::ceil(longest / size)), 1, kMostCuts);
}

/// Size of pieces (px) that keeps all membranes within the budget.
double piece_size(const Drawing& drawing, const Camera& camera, int budget) {
  double size = kPiece;
  for (int attempt = 0; attempt < 10; ++attempt) {
    int64_t count = 0;
    for (const MembraneSheet& sheet : drawing.membranes) {
      for (int t = 0; t < static_cast<int>(sheet.triangles.size()); ++t) {
        const int n = cuts(sheet, t, camera, size);
        count += static_cast<int64_t>(n) * n;
      }
    }
    if (count <= budget) break;
    size *= 1.4;
  }
  return size;
}

/// Lines at equal distances across the page, from lower left to upper right, where they cross a triangle.
void add_hatch(Scene& scene, const std::array<Vec2, 3>& page, double depth, double distance, const Color& ink) {
  const auto along = [](const Vec2& p) { return (p.x() + p.y()) * std::numbers::sqrt2 / 2; };
  const std::array<double, 3> u{along(page[0]), along(page[1]), along(page[2])};
  const double low = *std::min_element(u.begin(), u.end()), high = *std::max_element(u.begin(), u.end());
  for (double line = std::ceil(low / distance) * distance; line <= high; line += distance) {
    std::array<Vec2, 2> ends;
    int found = 0;
    for (int k = 0; k < 3 && found < 2; ++k) {
      const double a = u[k] - line, b = u[(k + 1) % 3] - line;
      if ((a < 0) == (b < 0)) continue;
      ends[found++] = page[k] + (page[(k + 1) % 3] - page[k]) * (a / (a - b));
    }
    if (found == 2) scene.add_mark(ends[0], ends[1], depth, ink, distance * kHatchWidth);
  }
}

/// Draws one membrane.
class ClothPainter {
 public:
  ClothPainter(Scene& scene, const Camera& camera, const MembraneSheet& sheet, const Paint& paint,
               const ClothMarks& marks, double piece)
      : scene_(scene), camera_(camera), sheet_(sheet), paint_(paint), marks_(marks), piece_(piece) {}

  /// The first of the values of the field that belong to this membrane.
  void run(const Normals& normals, size_t first_point, size_t first_triangle) {
    for (int t = 0; t < static_cast<int>(sheet_.triangles.size()); ++t) {
      add_triangle(t, normals, first_point, first_triangle);
    }
  }

  /// One stroke per cell of a grid on the page, at the first triangle whose middle is there.
  void add_strokes(const Normals& normals) {
    if (marks_.stroke <= 0 || sheet_.tension.empty()) return;
    const double cell = 1.4 * marks_.stroke;
    std::set<std::pair<int, int>> taken;
    for (size_t t = 0; t < sheet_.triangles.size(); ++t) {
      const Vec3& pull = sheet_.tension[t];
      if (pull.isZero()) continue;
      const Vec3 middle = middle_of(static_cast<int>(t));
      const Vec2 at = camera_.project(middle);
      const std::pair<int, int> place(static_cast<int>(std::floor(at.x() / cell)),
                                      static_cast<int>(std::floor(at.y() / cell)));
      if (!taken.insert(place).second) continue;
      const Vec3 half = pull.normalized() * (marks_.stroke / 2 / camera_.scale(middle));
      scene_.add_mark(camera_.project(middle - half), camera_.project(middle + half),
                      camera_.depth(middle) + lift(normals.triangle[t], middle, half.norm()), marks_.ink,
                      marks_.stroke / 12);
    }
  }

  /// The edge of the cloth where no rod holds it.
  void add_hem(const Normals& normals, const std::set<std::pair<Place, Place>>& rod_edges) {
    if (marks_.hem <= 0) return;
    std::map<std::pair<int, int>, int> sides;  // the triangle of each edge that has one only, else -1
    for (int t = 0; t < static_cast<int>(sheet_.triangles.size()); ++t) {
      for (int k = 0; k < 3; ++k) {
        const int a = sheet_.triangles[t][k], b = sheet_.triangles[t][(k + 1) % 3];
        const auto [edge, is_new] = sides.try_emplace(std::minmax(a, b), t);
        if (!is_new) edge->second = -1;
      }
    }
    for (const auto& [edge, triangle] : sides) {
      if (triangle < 0) continue;
      const Vec3 &a = sheet_.points[edge.first], &b = sheet_.points[edge.second];
      if (rod_edges.contains(std::minmax(place_of(a), place_of(b)))) continue;
      const Vec3 middle = (a + b) / 2;
      scene_.add_line(std::array{a, b}, marks_.ink, marks_.hem,
                      lift(normals.triangle[triangle], middle, piece_ / camera_.scale(middle)));
    }
  }

 private:
  Vec3 middle_of(int t) const {
    const std::array<int, 3>& corner = sheet_.triangles[t];
    return (sheet_.points[corner[0]] + sheet_.points[corner[1]] + sheet_.points[corner[2]]) / 3;
  }

  /// How far the depth of cloth changes over this distance (m) on the page.
  double lift(const Vec3& normal, const Vec3& at, double distance) const {
    const double facing = std::abs(normal.dot(camera_.towards_eye(at)));
    return distance * std::min(std::sqrt(std::max(0.0, 1 - facing * facing)) / std::max(facing, 0.1), 3.0);
  }

  void add_triangle(int t, const Normals& normals, size_t first_point, size_t first_triangle) {
    const std::array<int, 3>& corner = sheet_.triangles[t];
    const std::array<Vec3, 3> at{sheet_.points[corner[0]], sheet_.points[corner[1]], sheet_.points[corner[2]]};
    const Vec3 middle = middle_of(t);
    const bool back = normals.triangle[t].dot(camera_.towards_eye(middle)) < 0;
    const bool slack = marks_.hatch > 0 && !sheet_.smallest_stretch.empty() && sheet_.smallest_stretch[t] < 1;
    const int n = cuts(sheet_, t, camera_, piece_);
    const auto piece = [&](const std::array<Vec3, 3>& weights) {
      std::array<Vec3, 3> points;
      Vec3 normal = Vec3::Zero(), share = Vec3::Zero();
      for (int k = 0; k < 3; ++k) {
        points[k] = at[0] * weights[k][0] + at[1] * weights[k][1] + at[2] * weights[k][2];
        share += weights[k] / 3;
      }
      for (int k = 0; k < 3; ++k) normal += normals.corner[t][k] * share[k];
      Color color = paint_.plain;
      if (paint_.field != nullptr && paint_.field->place == Field::Place::kTriangle) {
        color = paint_.range.color(paint_.field->colors, paint_.field->values[first_triangle + t]);
      } else if (paint_.field != nullptr && paint_.field->place == Field::Place::kNode) {
        double value = 0;
        for (int k = 0; k < 3; ++k) value += share[k] * paint_.field->values[first_point + corner[k]];
        color = paint_.range.color(paint_.field->colors, value);
      } else if (back) {
        color = {color.r * kBackSide, color.g * kBackSide, color.b * kBackSide};
      }
      scene_.add_cloth(points, color, normal.normalized(), paint_.field ? kFieldContrast : paint_.contrast);
      if (!slack) return;
      const std::array<Vec2, 3> page{camera_.project(points[0]), camera_.project(points[1]),
                                     camera_.project(points[2])};
      const Vec3 centre = (points[0] + points[1] + points[2]) / 3;
      const double above = lift(normals.triangle[t], centre, piece_ / camera_.scale(centre));
      add_hatch(scene_, page, camera_.depth(centre) + above, marks_.hatch, marks_.ink);
    };
    const auto weight = [n](int i, int j) -> Vec3 { return Vec3(n - i - j, i, j) / n; };
    for (int i = 0; i < n; ++i) {
      for (int j = 0; i + j < n; ++j) {
        piece({weight(i, j), weight(i + 1, j), weight(i, j + 1)});
        if (i + j + 1 < n) piece({weight(i + 1, j), weight(i + 1, j + 1), weight(i, j + 1)});
      }
    }
  }

  Scene& scene_;
  const Camera& camera_;
  const MembraneSheet& sheet_;
  const Paint& paint_;
  const ClothMarks& marks_;
  double piece_;  // px
};

}  // namespace

Bed add_membranes(Scene& scene, const Camera& camera, const Drawing& drawing, const Paint& paint,
                  const ClothMarks& marks, int budget) {
  if (drawing.membranes.empty()) return {};
  const double piece = piece_size(drawing, camera, budget);
  std::set<std::pair<Place, Place>> rod_edges;
  for (const RodStrip& rod : drawing.rods) {
    for (int e = 0; e < rod.edge_count(); ++e) {
      rod_edges.insert(std::minmax(place_of(rod.points[e]), place_of(rod.points[rod.end_point(e)])));
    }
  }
  std::map<Place, Vec3> normal_at;
  size_t first_point = static_cast<size_t>(drawing.rod_point_count()), first_triangle = 0;
  for (const MembraneSheet& sheet : drawing.membranes) {
    const Normals normals = make_normals(sheet);
    ClothPainter painter(scene, camera, sheet, paint, marks, piece);
    painter.run(normals, first_point, first_triangle);
    painter.add_hem(normals, rod_edges);
    painter.add_strokes(normals);
    for (size_t t = 0; t < sheet.triangles.size(); ++t) {
      const Vec3 cross = triangle_cross(sheet, static_cast<int>(t));
      for (int i : sheet.triangles[t])
        normal_at.try_emplace(place_of(sheet.points[i]), Vec3::Zero()).first->second += cross;
    }
    first_point += sheet.points.size();
    first_triangle += sheet.triangles.size();
  }
  Bed bed{.normal = {}, .reach = piece / camera.scale()};
  for (const RodStrip& rod : drawing.rods) {
    for (const Vec3& p : rod.points) {
      const auto found = normal_at.find(place_of(p));
      const bool lies = found != normal_at.end() && found->second.norm() > 0;
      bed.normal.push_back(lies ? Vec3(found->second.normalized()) : Vec3(Vec3::Zero()));
    }
  }
  return bed;
}

}  // namespace lissom
