#include "lissom/editing/templates.h"

#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "lissom/editing/people_units.h"

namespace lissom {

namespace {

constexpr double kMm = 1e-3;

/// A plan in the making: materials and radii are those of the butterfly.
class Sketch {
 public:
  explicit Sketch(const char* title) {
    model_.title = title;
    model_.poses.emplace_back().name = "released";
    Plan& plan = model_.plan.emplace();
    plan.material = "PLA";
    plan.edge_length = 4 * kMm;
    plan.fabric.material = "elastane-cotton knit";
    plan.fabric.pre_stretch = Vec2(1.4, 1.4);
    plan.fabric.edge_length = 7 * kMm;
  }

  /// x, y: mm.
  int point(const std::string& name, double x, double y) {
    constexpr double kHigh = 0.42 * kMm, kWide = 0.9 * kMm;
    const auto place = [](double mm) { return rounded_length(mm * kMm); };
    model_.plan->points.push_back({name, {place(x), place(y)}, kHigh, kWide, false});
    return static_cast<int>(model_.plan->points.size()) - 1;
  }
  /// At `angle` degrees, anticlockwise from x; radius: mm.
  int polar(const std::string& name, double radius, double angle) {
    const double turn = angle * std::numbers::pi / 180;
    return point(name, radius * std::cos(turn), radius * std::sin(turn));
  }
  void rod(const std::string& name, std::vector<int> points, PlanCurve curve = PlanCurve::kSpline) {
    model_.plan->rods.push_back({name, std::move(points), curve, PlanRole::kRod, false});
  }
  void ring(const std::string& name, std::vector<int> points, PlanCurve curve = PlanCurve::kSpline) {
    model_.plan->rods.push_back({name, std::move(points), curve, PlanRole::kRod, true});
  }
  void ghost_last() { model_.plan->rods.back().role = PlanRole::kGhost; }
  /// Makes all rods so many times as thick.
  void thicken(double factor) {
    for (PlanPoint& point : model_.plan->points) {
      point.r_n = rounded_length(factor * point.r_n);
      point.r_b = rounded_length(factor * point.r_b);
    }
  }
  /// Points of a ring of rods at even angles.
  std::vector<int> circle(const std::string& name, double radius, int count, double first = 0) {
    std::vector<int> points;
    for (int k = 0; k < count; ++k)
      points.push_back(polar(fmt::format("{}{}", name, k + 1), radius, first + 360.0 * k / count));
    return points;
  }
  Plan& plan() { return *model_.plan; }
  Model done() { return std::move(model_); }

 private:
  Model model_;
};

Model disc() {
  Sketch sketch("Disc");
  sketch.ring("rim", sketch.circle("rim", 60, 8));
  sketch.thicken(1.15);
  return sketch.done();
}

/// A frame of straight sides between corners, which are rods of their own: a rod that turned by a right angle from edge to
/// edge would be bent wrongly there. mm, anticlockwise.
void add_frame(Sketch& sketch, const std::vector<Vec2>& corners) {
  std::vector<int> points;
  for (const Vec2& corner : corners) {
    points.push_back(sketch.point(fmt::format("corner{}", points.size() + 1), corner.x(), corner.y()));
  }
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const std::size_t next = (k + 1) % corners.size();
    const Vec2 middle = (corners[k] + corners[next]) / 2;
    const int half = sketch.point(fmt::format("side{}", k + 1), middle.x(), middle.y());
    sketch.rod(fmt::format("side{}", k + 1), {points[k], half, points[next]});
  }
}

Model rectangle_of(const char* title, double x, double y, double thicker) {
  Sketch sketch(title);
  add_frame(sketch, {{-x, -y}, {x, -y}, {x, y}, {-x, y}});
  sketch.thicken(thicker);
  return sketch.done();
}

Model square() { return rectangle_of("Square", 60, 60, 1.6); }
Model rectangle() { return rectangle_of("Rectangle", 80, 50, 1.75); }

Model triangle() {
  Sketch sketch("Triangle");
  add_frame(sketch, {{-65, -37.5}, {65, -37.5}, {0, 75}});
  sketch.thicken(1.4);
  return sketch.done();
}

Model leaf() {
  Sketch sketch("Leaf");
  const int stem = sketch.point("stem", -75, 0), tip = sketch.point("tip", 80, 0);
  const int r1 = sketch.point("rib1", -38, 0), r2 = sketch.point("rib2", 0, 0), r3 = sketch.point("rib3", 36, 0);
  sketch.rod("rib", {stem, r1, r2, r3, tip});
  for (const int side : {1, -1}) {
    const char* mark = side > 0 ? "l" : "r";
    const auto at = [&](int number, double x, double y) {
      return sketch.point(fmt::format("edge{}-{}", number, mark), x, side * y);
    };
    const int e1 = at(1, -52, 26), e2 = at(2, -14, 40), e3 = at(3, 24, 34), e4 = at(4, 56, 17);
    sketch.rod(fmt::format("edge-{}", mark), {stem, e1, e2, e3, e4, tip});
    sketch.rod(fmt::format("vein1-{}", mark), {r1, e2}, PlanCurve::kStraight);
    sketch.rod(fmt::format("vein2-{}", mark), {r2, e3}, PlanCurve::kStraight);
    sketch.rod(fmt::format("vein3-{}", mark), {r3, e4}, PlanCurve::kStraight);
  }
  return sketch.done();
}

Model flower() {
  Sketch sketch("Flower");
  constexpr int kPetals = 6;
  constexpr double kStep = 360.0 / kPetals;
  const std::vector<int> heart = sketch.circle("heart", 22, kPetals, -kStep / 2);
  sketch.ring("heart", heart);
  for (int k = 0; k < kPetals; ++k) {
    const double middle = kStep * k;
    const auto at = [&](const char* part, double radius, double angle) {
      return sketch.polar(fmt::format("{}{}", part, k + 1), radius, middle + angle);
    };
    const int right = at("right", 55, -23), shoulder = at("shoulder", 80, -16), tip = at("tip", 92, 0),
              other = at("other", 80, 16), left = at("left", 55, 23);
    const std::size_t i = static_cast<std::size_t>(k);
    sketch.rod(fmt::format("petal{}", k + 1), {heart[i], right, shoulder, tip, other, left, heart[(i + 1) % kPetals]});
  }
  sketch.thicken(0.8);
  return sketch.done();
}

Model ring_with_hole() {
  Sketch sketch("Ring with a hole");
  const std::vector<int> rim = sketch.circle("rim", 75, 8), hole = sketch.circle("hole", 32, 8);
  sketch.ring("rim", rim);
  sketch.ring("hole", hole);
  for (std::size_t k = 0; k < rim.size(); k += 2) {
    sketch.rod(fmt::format("spoke{}", k / 2 + 1), {hole[k], rim[k]}, PlanCurve::kStraight);
  }
  sketch.plan().fabric.holes.push_back(Vec2::Zero());
  sketch.thicken(1.15);
  return sketch.done();
}

Model crossed_strips() {
  Sketch sketch("Crossed strips");
  constexpr double kHalf = 70, kStrip = 12;  // mm
  constexpr double kStations[] = {-kHalf, -kStrip, kStrip, kHalf};
  int grid[4][4];
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      grid[i][j] = sketch.point(fmt::format("g{}{}", i + 1, j + 1), kStations[i], kStations[j]);
    }
  }
  constexpr const char* kAcross[] = {"south", "across1", "across2", "north"};
  constexpr const char* kUp[] = {"west", "up1", "up2", "east"};
  for (std::size_t k = 0; k < 4; ++k) {
    sketch.rod(kAcross[k], {grid[0][k], grid[1][k], grid[2][k], grid[3][k]}, PlanCurve::kStraight);
    sketch.rod(kUp[k], {grid[k][0], grid[k][1], grid[k][2], grid[k][3]}, PlanCurve::kStraight);
  }
  return sketch.done();
}

Model star() {
  Sketch sketch("Star");
  constexpr int kArms = 5;
  const std::vector<int> tips = sketch.circle("tip", 80, kArms, 90), dents = sketch.circle("dent", 36, kArms, 126);
  const int middle = sketch.point("middle", 0, 0);
  for (std::size_t k = 0; k < kArms; ++k) {
    sketch.rod(fmt::format("ray{}", k + 1), {middle, tips[k]}, PlanCurve::kStraight);
    sketch.rod(fmt::format("left{}", k + 1), {tips[k], dents[k]}, PlanCurve::kStraight);
    sketch.rod(fmt::format("right{}", k + 1), {dents[k], tips[(k + 1) % kArms]}, PlanCurve::kStraight);
  }
  return sketch.done();
}

/// Fabric beyond the outermost rods would hang slack, so an edge that is not printed needs rods that reach its corners.
Model sheet() {
  Sketch sketch("Empty sheet");
  constexpr double kHalf = 60;  // mm
  const int sw = sketch.point("south-west", -kHalf, -kHalf), se = sketch.point("south-east", kHalf, -kHalf),
            ne = sketch.point("north-east", kHalf, kHalf), nw = sketch.point("north-west", -kHalf, kHalf);
  const int middle = sketch.point("middle", 0, 0);
  sketch.ring("edge", {sw, se, ne, nw}, PlanCurve::kStraight);
  sketch.ghost_last();
  sketch.rod("cross1", {sw, middle, ne}, PlanCurve::kStraight);
  sketch.rod("cross2", {se, middle, nw}, PlanCurve::kStraight);
  sketch.thicken(1.5);
  return sketch.done();
}

constexpr Template kTemplates[] = {
    {"disc", "Disc", "A ring, 120 mm across, which pops up to a saddle.", disc},
    {"square", "Square", "A frame of 120 mm.", square},
    {"rectangle", "Rectangle", "A frame of 160 by 100 mm.", rectangle},
    {"triangle", "Triangle", "A frame with three corners, 130 mm wide.", triangle},
    {"leaf", "Leaf", "An outline with a rib and veins, 155 mm long.", leaf},
    {"flower", "Flower", "Six petals around a ring, 180 mm across.", flower},
    {"ring", "Ring with a hole", "Two rings with spokes between them, 150 mm across.", ring_with_hole},
    {"strips", "Crossed strips", "Two narrow strips that cross on a square of 140 mm.", crossed_strips},
    {"star", "Star", "Five rays and their outline, 160 mm across.", star},
    {"sheet", "Empty sheet", "Fabric of 120 mm without a frame, held at its corners by two crossing rods.", sheet},
};

}  // namespace

std::span<const Template> templates() { return kTemplates; }

}  // namespace lissom
