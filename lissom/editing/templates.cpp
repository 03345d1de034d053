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
  return sketch.done();
}

/// Corners and the middles of the sides: mm, half of the extents.
Model frame(const char* title, double x, double y) {
  Sketch sketch(title);
  const int sw = sketch.point("south-west", -x, -y), s = sketch.point("south", 0, -y),
            se = sketch.point("south-east", x, -y), e = sketch.point("east", x, 0),
            ne = sketch.point("north-east", x, y), n = sketch.point("north", 0, y),
            nw = sketch.point("north-west", -x, y), w = sketch.point("west", -x, 0);
  sketch.ring("frame", {sw, s, se, e, ne, n, nw, w}, PlanCurve::kStraight);
  return sketch.done();
}

Model square() { return frame("Square", 60, 60); }
Model rectangle() { return frame("Rectangle", 85, 50); }

Model triangle() {
  Sketch sketch("Triangle");
  const std::vector<int> corners = sketch.circle("corner", 75, 3, 90), sides = sketch.circle("side", 37.5, 3, 150);
  sketch.ring("frame", {corners[0], sides[0], corners[1], sides[1], corners[2], sides[2]}, PlanCurve::kStraight);
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
    const int right = at("right", 52, -24), shoulder = at("shoulder", 74, -15), tip = at("tip", 84, 0),
              other = at("other", 74, 15), left = at("left", 52, 24);
    const std::size_t i = static_cast<std::size_t>(k);
    sketch.rod(fmt::format("petal{}", k + 1), {heart[i], right, shoulder, tip, other, left, heart[(i + 1) % kPetals]});
  }
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
  return sketch.done();
}

Model crossed_strips() {
  Sketch sketch("Crossed strips");
  constexpr double kHalf = 70, kStrip = 12;  // mm
  const auto names = [](const char* what, int a, int b) { return fmt::format("{}{}{}", what, a, b); };
  const double stations[] = {-kHalf, -kStrip, kStrip, kHalf};
  int grid[4][4];
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) grid[i][j] = sketch.point(names("g", i + 1, j + 1), stations[i], stations[j]);
  }
  sketch.ring("frame",
              {grid[0][0], grid[1][0], grid[2][0], grid[3][0], grid[3][1], grid[3][2], grid[3][3], grid[2][3],
               grid[1][3], grid[0][3], grid[0][2], grid[0][1]},
              PlanCurve::kStraight);
  for (const int k : {1, 2}) {
    sketch.rod(fmt::format("across{}", k), {grid[0][k], grid[1][k], grid[2][k], grid[3][k]}, PlanCurve::kStraight);
    sketch.rod(fmt::format("up{}", k), {grid[k][0], grid[k][1], grid[k][2], grid[k][3]}, PlanCurve::kStraight);
  }
  return sketch.done();
}

Model star() {
  Sketch sketch("Star");
  constexpr int kArms = 5;
  const std::vector<int> tips = sketch.circle("tip", 80, kArms, 90), dents = sketch.circle("dent", 36, kArms, 126);
  const int middle = sketch.point("middle", 0, 0);
  std::vector<int> rim;
  for (std::size_t k = 0; k < kArms; ++k) {
    rim.push_back(tips[k]);
    rim.push_back(dents[k]);
    sketch.rod(fmt::format("ray{}", k + 1), {middle, tips[k]}, PlanCurve::kStraight);
  }
  sketch.ring("rim", rim, PlanCurve::kStraight);
  return sketch.done();
}

Model sheet() {
  Sketch sketch("Empty sheet");
  constexpr double kHalf = 70;  // mm
  const int sw = sketch.point("south-west", -kHalf, -kHalf), se = sketch.point("south-east", kHalf, -kHalf),
            ne = sketch.point("north-east", kHalf, kHalf), nw = sketch.point("north-west", -kHalf, kHalf);
  sketch.ring("edge", {sw, se, ne, nw}, PlanCurve::kStraight);
  sketch.ghost_last();
  const int a = sketch.point("a", -40, 0), b = sketch.point("b", 40, 0);
  sketch.rod("rod1", {a, b}, PlanCurve::kStraight);
  return sketch.done();
}

constexpr Template kTemplates[] = {
    {"disc", "Disc", "A ring, 120 mm across, which pops up to a saddle.", disc},
    {"square", "Square", "A frame of 120 mm.", square},
    {"rectangle", "Rectangle", "A frame of 170 by 100 mm.", rectangle},
    {"triangle", "Triangle", "A frame with three corners, 150 mm high.", triangle},
    {"leaf", "Leaf", "An outline with a rib and veins, 155 mm long.", leaf},
    {"flower", "Flower", "Six petals around a ring, 170 mm across.", flower},
    {"ring", "Ring with a hole", "Two rings with spokes between them, 150 mm across.", ring_with_hole},
    {"strips", "Crossed strips", "Two narrow strips that cross on a square of 140 mm.", crossed_strips},
    {"star", "Star", "Five rays and their outline, 160 mm across.", star},
    {"sheet", "Empty sheet", "Fabric of 140 mm without a frame, and one rod to begin with.", sheet},
};

}  // namespace

std::span<const Template> templates() { return kTemplates; }

}  // namespace lissom
