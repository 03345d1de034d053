#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "lissom/view/picture_parts.h"
#include "lissom/view/tube.h"

namespace lissom {
namespace {

constexpr double kLineWidth = 2.6;      // px; thinner rods are lines
constexpr double kThinnestLine = 0.9;   // px
constexpr double kLongestLine = 28;     // px; longer lines would be sorted badly where rods cross
constexpr double kSteepest = 3;         // tangent of the angle between cloth and page up to which rods are sorted by it
constexpr double kTurnPerPiece = 0.12;  // rad, of thin rods; wide ones are cut finer

using Place = std::array<double, 3>;
Place place_of(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

double px_width(const RodStrip& rod, const Camera& camera) {
  double r = 0;
  for (int e = 0; e < rod.edge_count(); ++e) r = std::max({r, rod.r_n[e], rod.r_b[e]});
  return 2 * r * camera.scale(rod.points[rod.points.size() / 2]);
}

/// How finely a rod is cut: pieces per edge and faces around.
struct Cut {
  std::vector<int> pieces;
  int sides = 0;  // 0: line

  int count() const {
    int sum = 0;
    for (int p : pieces) sum += p;
    return sum * std::max(1, sides / 2);
  }
};

Cut make_cut(const RodStrip& rod, const Camera& camera, const Paint& paint, double coarseness) {
  Cut cut;
  const double width = px_width(rod, camera);
  if (!paint.line && width * (rod.shape == SectionShape::kRectangle ? 1 : 0.9) >= kLineWidth * std::sqrt(coarseness)) {
    const int wanted = static_cast<int>(std::lround((5 + 0.9 * std::min(width, 70.0)) / coarseness / 2)) * 2;
    cut.sides = rod.shape == SectionShape::kRectangle ? 4 : std::clamp(wanted, 6, 64);
  }
  const double longest = coarseness * (cut.sides > 0 ? std::max(1.4 * width, 7.0) : kLongestLine);
  const int edges = rod.edge_count();
  const double turn_per_piece = kTurnPerPiece * std::clamp(8 / width, 0.25, 1.0);
  double turn_before = 0;
  for (int e = 0; e < edges; ++e) {
    const Vec3 d = rod.points[rod.end_point(e)] - rod.points[e];
    const double px = (camera.project(rod.points[rod.end_point(e)]) - camera.project(rod.points[e])).norm();
    double turn_after = 0;
    if (e + 1 < edges) {
      const Vec3 next = rod.points[rod.end_point(e + 1)] - rod.points[e + 1];
      turn_after = std::atan2(d.cross(next).norm(), d.dot(next));
      if (turn_after > 0.6) turn_after = 0;
      turn_after += std::acos(std::min(1.0, std::abs(rod.n[e].dot(rod.n[e + 1]))));
    }
    const double turn = std::max(turn_before, turn_after);
    turn_before = turn_after;
    const double for_turn = px > 5 * coarseness ? std::min(turn / turn_per_piece, px / (2.5 * coarseness)) : 1;
    cut.pieces.push_back(std::clamp(static_cast<int>(std::ceil(std::max(px / longest, for_turn))), 1, 200));
  }
  return cut;
}

/// Value of the field on one strip.
class Painter {
 public:
  Painter(const RodStrip& rod, const Paint& paint, size_t first_point, size_t first_edge)
      : rod_(rod),
        paint_(paint),
        first_(paint.field && paint.field->place == Field::Place::kNode ? first_point : first_edge) {}

  Color at(int edge, double along) const {
    if (paint_.field == nullptr || paint_.field->place == Field::Place::kTriangle) return paint_.plain;
    const std::vector<double>& values = paint_.field->values;
    double value = values[first_ + edge];
    if (paint_.field->place == Field::Place::kNode) {
      value = value * (1 - along) + values[first_ + rod_.end_point(edge)] * along;
    }
    return paint_.range.color(paint_.field->colors, value, paint_.steps);
  }

 private:
  const RodStrip& rod_;
  const Paint& paint_;
  size_t first_;
};

/// Width on the page of the section as it is seen, px.
double apparent_width(const Ring& ring, const RodStrip& rod, const Vec3& along, const Camera& camera) {
  const Vec3 across = along.cross(camera.towards_eye(ring.centre));
  if (across.norm() < 1e-12) return 2 * std::max(ring.r_b, ring.r_n) * camera.scale(ring.centre);
  const double b = ring.r_b * ring.b.dot(across) / across.norm(), n = ring.r_n * ring.n.dot(across) / across.norm();
  const double half = rod.shape == SectionShape::kRectangle ? std::abs(b) + std::abs(n) : std::hypot(b, n);
  return 2 * half * camera.scale(ring.centre);
}

/// How one rod lies on cloth.
class OnCloth {
 public:
  OnCloth(const Camera& camera, const Bed& bed, size_t first_point)
      : camera_(camera), bed_(bed), first_point_(first_point) {}

  /// How much nearer than it is a piece at `ring` counts (m) when its middle is `out` off the axis of the rod.
  double nearer(const RodStrip& rod, const Ring& ring, const Vec3& out) const {
    if (bed_.normal.empty()) return 0;
    const Vec3& first = bed_.normal[first_point_ + ring.edge];
    const Vec3& second = bed_.normal[first_point_ + rod.end_point(ring.edge)];
    if (first.isZero() || second.isZero()) return 0;
    const Vec3 eye = camera_.towards_eye(ring.centre);
    const Vec3 normal = first * (first.dot(eye) < 0 ? -1 : 1) + second * (second.dot(eye) < 0 ? -1 : 1);
    const double facing = normal.normalized().dot(eye);
    const double steepness = std::min(std::sqrt(std::max(0.0, 1 - facing * facing)) / std::max(facing, 0.1), kSteepest);
    const double shift = (std::max(ring.r_n, ring.r_b) + bed_.reach) * steepness;
    return out.dot(normal) < 0 ? -shift : shift;
  }

 private:
  const Camera& camera_;
  const Bed& bed_;
  size_t first_point_;
};

void add_lines(Scene& scene, const Camera& camera, const RodStrip& rod, const std::vector<Ring>& rings,
               const Painter& painter, const Paint& paint, double longest, const OnCloth& cloth) {
  std::vector<Vec3> run;
  Color run_color;
  double run_width = 0, run_length = 0, run_nearer = 0;
  const auto flush = [&] {
    if (run.size() > 1) scene.add_line(run, run_color, std::max(kThinnestLine, run_width), run_nearer);
    run.clear();
    run_length = 0;
  };
  for (size_t i = 0; i + 1 < rings.size(); ++i) {
    const Ring& a = rings[i];
    const Vec3& end = rings[i + 1].centre;
    const double middle =
        rings[i + 1].edge == a.edge && rings[i + 1].along > 0 ? (a.along + rings[i + 1].along) / 2 : (a.along + 1) / 2;
    const Color color = painter.at(a.edge, middle);
    const double fixed = paint.line.value_or(0);
    const double seen = fixed > 0 ? fixed : apparent_width(a, rod, end - a.centre, camera);
    const double width = std::max(seen, paint.thinnest);
    if (!run.empty() &&
        (to_bytes(color) != to_bytes(run_color) || run_length > longest || std::abs(width - run_width) > 0.3)) {
      flush();
    }
    if (run.empty()) {
      run = {a.centre};
      run_color = color;
      run_width = width;
      run_nearer = cloth.nearer(rod, a, Vec3::Zero());
    }
    run.push_back(end);
    run_length += (camera.project(end) - camera.project(a.centre)).norm();
  }
  flush();
}

std::vector<Vec3> ring_points(const Ring& ring, const std::vector<Vec2>& outline, double scale = 1) {
  std::vector<Vec3> points;
  for (const Vec2& p : outline) points.push_back(ring_point(ring, p, scale, scale));
  return points;
}

/// `nearer(out)` as OnCloth has it.
template <class Nearer>
void add_band(Scene& scene, const std::vector<Vec3>& first, const std::vector<Vec3>& second, const Color& color,
              double contrast, const Nearer& nearer) {
  for (size_t k = 0; k < first.size(); ++k) {
    const size_t next = (k + 1) % first.size();
    const std::array face{first[k], first[next], second[next], second[k]};
    scene.add_face(face, color, contrast, nearer((face[0] + face[1] + face[2] + face[3]) / 4));
  }
}

enum class End { kFlat, kRound };

/// `outwards`: unit tangent leaving the rod.
void add_end(Scene& scene, const Ring& ring, const std::vector<Vec2>& outline, const Vec3& outwards, End end,
             const Color& color, double contrast, const RodStrip& rod, const OnCloth& cloth) {
  const auto nearer = [&](const Vec3& middle) { return cloth.nearer(rod, ring, middle - ring.centre); };
  const bool at_start = ring.b.cross(ring.n).dot(outwards) < 0;
  const double reach = std::min(ring.r_b, ring.r_n);
  const int steps = end == End::kRound ? std::max(2, static_cast<int>(outline.size()) / 6) : 0;
  std::vector<Vec3> previous = ring_points(ring, outline);
  for (int k = 1; k <= steps; ++k) {
    const double angle = k * 1.45 / steps;
    Ring cap = ring;
    cap.centre += outwards * (reach * std::sin(angle));
    std::vector<Vec3> next = ring_points(cap, outline, std::cos(angle));
    at_start ? add_band(scene, next, previous, color, contrast, nearer)
             : add_band(scene, previous, next, color, contrast, nearer);
    previous = std::move(next);
  }
  if (at_start) std::reverse(previous.begin(), previous.end());
  scene.add_face(previous, color, contrast, cloth.nearer(rod, ring, Vec3::Zero()));
}

void add_tube(Scene& scene, const RodStrip& rod, const std::vector<Ring>& rings, int sides, const Painter& painter,
              double contrast, const std::map<Place, int>& shared, const OnCloth& cloth) {
  const std::vector<Vec2> outline = section_outline(rod.shape, std::max(sides, 4));
  std::vector<Vec3> previous = ring_points(rings.front(), outline);
  for (size_t i = 0; i + 1 < rings.size(); ++i) {
    const Ring& next = rings[i + 1];
    const double end = next.edge == rings[i].edge && next.along > 0 ? next.along : 1;
    std::vector<Vec3> points = ring_points(next, outline);
    const Vec3 axis = (rings[i].centre + next.centre) / 2;
    add_band(scene, previous, points, painter.at(rings[i].edge, (rings[i].along + end) / 2), contrast,
             [&](const Vec3& middle) { return cloth.nearer(rod, rings[i], middle - axis); });
    previous = std::move(points);
  }
  if (rod.closed) return;
  const auto end_kind = [&](const Vec3& p) {
    return rod.shape != SectionShape::kRectangle && shared.at(place_of(p)) > 1 ? End::kRound : End::kFlat;
  };
  const Ring& first = rings.front();
  const Ring& last = rings.back();
  add_end(scene, first, outline, -first.b.cross(first.n), end_kind(first.centre), painter.at(0, 0), contrast, rod,
          cloth);
  add_end(scene, last, outline, last.b.cross(last.n), end_kind(last.centre), painter.at(last.edge, 1), contrast, rod,
          cloth);
}

}  // namespace

void add_rods(Scene& scene, const Camera& camera, const Drawing& drawing, const Paint& paint, int budget,
              const Bed& bed) {
  std::vector<Cut> cuts;
  double coarseness = 1;
  for (int attempt = 0; attempt < 8; ++attempt) {
    cuts.clear();
    int64_t count = 0;
    for (const RodStrip& rod : drawing.rods) {
      cuts.push_back(make_cut(rod, camera, paint, coarseness));
      count += cuts.back().count();
    }
    if (count <= budget) break;
    coarseness *= 1.5;
  }
  std::map<Place, int> shared;
  for (const RodStrip& rod : drawing.rods) {
    for (const Vec3& p : rod.points) ++shared[place_of(p)];
  }
  size_t first_point = 0, first_edge = 0;
  for (size_t i = 0; i < drawing.rods.size(); ++i) {
    const RodStrip& rod = drawing.rods[i];
    const std::vector<Ring> rings = tube_rings(rod, cuts[i].pieces);
    const Painter painter(rod, paint, first_point, first_edge);
    const OnCloth cloth(camera, bed, first_point);
    if (cuts[i].sides > 0) {
      add_tube(scene, rod, rings, cuts[i].sides, painter, paint.contrast, shared, cloth);
    } else {
      add_lines(scene, camera, rod, rings, painter, paint, coarseness * kLongestLine, cloth);
    }
    first_point += rod.points.size();
    first_edge += rod.b.size();
  }
}

void draw_centrelines(Canvas& canvas, const Camera& camera, const Drawing& drawing, const Stroke& stroke) {
  for (const RodStrip& rod : drawing.rods) {
    std::vector<Vec2> page;
    for (const Vec3& p : rod.points) page.push_back(camera.project(p));
    if (rod.closed) page.push_back(page.front());
    canvas.polyline(page, stroke);
  }
}

}  // namespace lissom
