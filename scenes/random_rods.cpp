#include "scenes/random_rods.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace lissom::scene_models {

namespace {

constexpr double kPi = std::numbers::pi;

Vec2 on_circle(double angle) { return {std::cos(angle), std::sin(angle)}; }

enum class OutlineKind { kCircle, kPolygon, kBlob };
constexpr const char* kOutlineNames[] = {"circle", "polygon", "blob"};

/// A closed row of points, and after which of them a new rod begins.
struct Outline {
  std::vector<Vec2> points;
  std::vector<int> breaks;  // empty: one closed rod
  PlanCurve curve = PlanCurve::kSpline;
};

/// Every `step`th point is a place where rods may end.
std::vector<int> some_breaks(RandomNumbers& random, int points, int step, double closed) {
  std::vector<int> breaks;
  if (random.chance(closed)) return breaks;
  for (int i = 0; i < points; i += step) {
    if (random.chance(0.6)) breaks.push_back(i);
  }
  return breaks.size() > 1 ? breaks : std::vector<int>{};
}

Outline circle(RandomNumbers& random, double extent) {
  Outline outline;
  outline.curve = PlanCurve::kArc;
  const int points = 2 * random.whole(3, 6);
  const double turn = random.between(0, 2 * kPi);
  for (int i = 0; i < points; ++i) outline.points.push_back(extent / 2 * on_circle(turn + 2 * kPi * i / points));
  outline.breaks = some_breaks(random, points, 2, 0.5);
  return outline;
}

Outline polygon(RandomNumbers& random, double extent) {
  Outline outline;
  outline.curve = PlanCurve::kStraight;
  const int corners = random.whole(3, 7);
  const double turn = random.between(0, 2 * kPi), narrow = random.between(0.6, 1);
  std::vector<Vec2> corner;
  for (int i = 0; i < corners; ++i) {
    const double angle = turn + 2 * kPi * (i + random.between(-0.2, 0.2)) / corners;
    const Vec2 p = extent / 2 * random.between(0.8, 1) * on_circle(angle);
    corner.emplace_back(p.x(), narrow * p.y());
  }
  const bool sides = random.chance(0.6);
  for (int i = 0; i < corners; ++i) {
    const Vec2 &from = corner[static_cast<std::size_t>(i)], &to = corner[static_cast<std::size_t>((i + 1) % corners)];
    if (sides) outline.breaks.push_back(static_cast<int>(outline.points.size()));
    const int pieces = random.whole(1, 4);
    for (int k = 0; k < pieces; ++k) outline.points.push_back(from + (to - from) * k / pieces);
  }
  return outline;
}

Outline blob(RandomNumbers& random, double extent) {
  Outline outline;
  const int points = random.whole(6, 12);
  const double narrow = random.between(0.5, 1), two = random.between(0, 0.2), three = random.between(0, 0.2);
  const double phase_2 = random.between(0, 2 * kPi), phase_3 = random.between(0, 2 * kPi);
  for (int i = 0; i < points; ++i) {
    const double angle = 2 * kPi * (i + random.between(-0.2, 0.2)) / points;
    const double radius = 1 + two * std::cos(2 * angle + phase_2) + three * std::cos(3 * angle + phase_3);
    const Vec2 p = extent / 2.4 * radius * on_circle(angle);
    outline.points.emplace_back(p.x(), narrow * p.y());
  }
  outline.breaks = some_breaks(random, points, 2, 0.5);
  return outline;
}

double area_of(const std::vector<Vec2>& loop) {
  double twice = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

double extent_of(const std::vector<Vec2>& points) {
  Vec2 low = points[0], high = low;
  for (const Vec2& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).maxCoeff();
}

/// False when the outline does not fit itself.
bool draw_outline(const Outline& outline, PlanSketch& sketch) {
  const int n = static_cast<int>(outline.points.size());
  for (const Vec2& p : outline.points) sketch.add_point(p);
  PlanRod rod;
  rod.curve = outline.curve;
  if (outline.breaks.empty()) {
    rod.closed = true;
    for (int i = 0; i < n; ++i) rod.points.push_back(i);
    sketch.add_outline(rod);
  }
  for (std::size_t k = 0; k < outline.breaks.size(); ++k) {
    const int first = outline.breaks[k], last = outline.breaks[(k + 1) % outline.breaks.size()];
    rod.points.clear();
    for (int i = first; i != last; i = (i + 1) % n) rod.points.push_back(i);
    rod.points.push_back(last);
    sketch.add_outline(rod);
  }
  return sketch.close_outline();
}

/// Adds rods of all kinds to an outline.
class RodDrawer {
 public:
  RodDrawer(RandomNumbers& random, PlanSketch& sketch, double extent)
      : random_(random), sketch_(sketch), extent_(extent), outline_points_(sketch.plan().points.size()) {}

  /// While there is room.
  void draw_rings() {
    const int tries = random_.chance(0.5) ? random_.whole(2, 12) : 0;
    for (int k = 0; k < tries; ++k) ring();
  }

  bool draw_one() {
    const double kind = random_.between(0, 1);
    if (kind < 0.25) return from_to(some_point(outline_points_), some_point(outline_points_));
    if (kind < 0.5) return from_to(some_point(sketch_.plan().points.size()), some_point(sketch_.plan().points.size()));
    if (kind < 0.7) return free_end();
    if (kind < 0.8) return floating();
    return ring();
  }

 private:
  int some_point(std::size_t count) { return random_.whole(0, static_cast<int>(count) - 1); }

  Vec2 place() { return extent_ / 2 * Vec2(random_.between(-1, 1), random_.between(-1, 1)); }

  bool from_to(int from, int to) {
    if (from == to) return false;
    return run(from, to, sketch_.plan().points.size());
  }

  bool free_end() {
    const std::size_t first_new = sketch_.plan().points.size();
    const int from = some_point(first_new);
    const double length = random_.between(0.08, 0.5) * extent_;
    const Vec2 to =
        sketch_.plan().points[static_cast<std::size_t>(from)].at + length * on_circle(random_.between(0, 2 * kPi));
    if (!has_room(to)) return false;
    return run(from, sketch_.add_point(to), first_new);
  }

  bool floating() {
    const std::size_t first_new = sketch_.plan().points.size();
    const Vec2 from = place(), to = from + random_.between(0.1, 0.6) * extent_ * on_circle(random_.between(0, 2 * kPi));
    if (!has_room(from) || !has_room(to)) return false;
    const int first = sketch_.add_point(from);
    return run(first, sketch_.add_point(to), first_new);
  }

  bool has_room(const Vec2& p) const { return sketch_.inside(p) && sketch_.distance_to_rods(p) > sketch_.clearance(); }

  /// Straight, or bowed to one side, or to both.
  bool run(int from, int to, std::size_t first_new) {
    PlanRod rod;
    rod.points.push_back(from);
    const Vec2 a = sketch_.plan().points[static_cast<std::size_t>(from)].at;
    const Vec2 b = sketch_.plan().points[static_cast<std::size_t>(to)].at;
    const int bows = random_.whole(0, 2);
    if (bows == 0) rod.curve = random_.chance(0.7) ? PlanCurve::kStraight : PlanCurve::kSpline;
    for (int k = 1; k <= bows; ++k) {
      const Vec2 across(a.y() - b.y(), b.x() - a.x());
      rod.points.push_back(sketch_.add_point(a + (b - a) * (k + random_.between(-0.1, 0.1)) / (bows + 1) +
                                             random_.between(-0.2, 0.2) * across));
    }
    rod.points.push_back(to);
    return sketch_.add_rod(rod, first_new);
  }

  bool ring() {
    const std::size_t first_new = sketch_.plan().points.size();
    const Vec2 centre = place();
    const double radius = random_.between(0.05, 0.25) * extent_, turn = random_.between(0, 2 * kPi);
    PlanRod rod;
    rod.closed = true;
    rod.curve = random_.chance(0.5) ? PlanCurve::kArc : PlanCurve::kSpline;
    const bool round = rod.curve == PlanCurve::kArc;
    const int points = round ? 4 : random_.whole(5, 8);
    for (int i = 0; i < points; ++i) {
      const double stretched = round ? radius : radius * random_.between(0.85, 1.15);
      const Vec2 p = centre + stretched * on_circle(turn + 2 * kPi * i / points);
      rod.points.push_back(sketch_.add_point(p));
    }
    return sketch_.add_rod(rod, first_new);
  }

  RandomNumbers& random_;
  PlanSketch& sketch_;
  double extent_;
  std::size_t outline_points_;
};

bool in_loop(const std::vector<Vec2>& loop, const Vec2& p) {
  bool in = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    if (p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y())) in = !in;
  }
  return in;
}

/// Holes in rings; only where nothing but the ring and rods straight through it would lose the fabric around it.
std::vector<Vec2> some_holes(RandomNumbers& random, const PlanSketch& sketch) {
  std::vector<Vec2> holes;
  const Plan& plan = sketch.plan();
  for (std::size_t r = 0; r < plan.rods.size(); ++r) {
    const PlanRod& ring = plan.rods[r];
    if (!ring.closed || sketch.is_outline(r) || random.chance(0.4)) continue;
    std::vector<Vec2> loop;
    for (const int point : ring.points) loop.push_back(plan.points[static_cast<std::size_t>(point)].at);
    bool alone = true;
    for (std::size_t i = 0; i < plan.points.size() && alone; ++i) {
      const bool own = std::find(ring.points.begin(), ring.points.end(), static_cast<int>(i)) != ring.points.end();
      alone = own || !in_loop(loop, plan.points[i].at);
    }
    for (std::size_t q = 0; q < plan.rods.size() && alone; ++q) {
      const bool touches = std::any_of(plan.rods[q].points.begin(), plan.rods[q].points.end(), [&](int point) {
        return std::find(ring.points.begin(), ring.points.end(), point) != ring.points.end();
      });
      alone = q == r || !plan.rods[q].closed || !touches;
    }
    if (!alone) continue;
    Vec2 centre = Vec2::Zero();
    for (const Vec2& p : loop) centre += p / static_cast<double>(loop.size());
    if (in_loop(loop, centre) && sketch.distance_to_rods(centre) > sketch.clearance() / 2) holes.push_back(centre);
  }
  return holes;
}

}  // namespace

RandomRods draw_random_rods(RandomNumbers& random, double fabric_nodes, int rods) {
  for (;;) {
    const double extent = random.log_between(0.05, 0.4);
    const OutlineKind kind = static_cast<OutlineKind>(random.whole(0, 2));
    const Outline outline = kind == OutlineKind::kCircle    ? circle(random, extent)
                            : kind == OutlineKind::kPolygon ? polygon(random, extent)
                                                            : blob(random, extent);
    const double edge_length = std::sqrt(area_of(outline.points) / (0.866 * fabric_nodes));
    PlanSketch sketch(random.between(1, 1.6) * edge_length);
    if (!draw_outline(outline, sketch)) continue;
    RodDrawer drawer(random, sketch, extent_of(outline.points));
    const std::size_t outline_rods = sketch.plan().rods.size(), wanted = static_cast<std::size_t>(rods);
    drawer.draw_rings();
    for (int tries = 0; tries < 25 * rods && sketch.plan().rods.size() < wanted; ++tries) drawer.draw_one();
    if (sketch.plan().rods.size() < std::max<std::size_t>(3, outline_rods + 1)) continue;
    std::vector<Vec2> holes = some_holes(random, sketch);
    return {
        std::move(sketch), extent_of(outline.points), edge_length, outline_rods, kOutlineNames[static_cast<int>(kind)],
        std::move(holes)};
  }
}

}  // namespace lissom::scene_models
