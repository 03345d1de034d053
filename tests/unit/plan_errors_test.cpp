/// What can be wrong with a plan, and what is said about it.

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <numbers>

#include "lissom/model/expand_plan.h"
#include "lissom/model/structure.h"

namespace lissom {
namespace {

/// A square frame of 60 mm, ghosted or not, and a rod from corner to corner.
Model good() {
  Model model;
  Plan& plan = model.plan.emplace();
  plan.material = "PLA";
  plan.edge_length = 4e-3;
  plan.fabric.material = "soft knit";
  const auto add = [&](const char* name, double x, double y) {
    plan.points.push_back({name, Vec2(x, y), 2e-4, 4e-4, false});
    return static_cast<int>(plan.points.size()) - 1;
  };
  const int a = add("a", 0, 0), b = add("b", 0.06, 0), c = add("c", 0.06, 0.06), d = add("d", 0, 0.06);
  plan.rods.push_back({"frame", {a, b, c, d}, PlanCurve::kStraight, PlanRole::kRod, true});
  plan.rods.push_back({"across", {a, c}, PlanCurve::kStraight, PlanRole::kRod, false});
  return model;
}

int add_point(Plan& plan, const char* name, double x, double y) {
  plan.points.push_back({name, Vec2(x, y), 2e-4, 4e-4, false});
  return static_cast<int>(plan.points.size()) - 1;
}

void add_rod(Plan& plan, const char* name, std::vector<int> points, PlanCurve curve = PlanCurve::kStraight,
             bool closed = false) {
  plan.rods.push_back({name, std::move(points), curve, PlanRole::kRod, closed});
}

struct Case {
  const char* name;
  std::function<void(Plan&)> spoil;
  ErrorCode code;
  const char* where;
  const char* message;  ///< contained in the message
  const char* hint;     ///< contained in the hint
};

const Case kCases[] = {
    {"crossing rods",
     [](Plan& p) {
       add_rod(p, "other", {1, 3});
     },
     ErrorCode::kGeometry, "/plan/rods/2",
     "rod \"across\" and rod \"other\" cross without a common point near (30, 30) mm", "add a point there"},
    {"a rod that crosses itself",
     [](Plan& p) {
       const int e = add_point(p, "e", 0.02, 0.01), f = add_point(p, "f", 0.05, 0.03),
                 g = add_point(p, "g", 0.05, 0.01), h = add_point(p, "h", 0.02, 0.005);
       p.rods.pop_back();
       add_rod(p, "loop", {e, f, g, h});
       p.points[static_cast<size_t>(h)].at = Vec2(0.03, 0.03);
     },
     ErrorCode::kGeometry, "/plan/rods/1", "rod \"loop\" crosses itself", "two rods that share a point"},
    {"a rod that ends on another",
     [](Plan& p) {
       add_rod(p, "stub", {1, add_point(p, "e", 0.03, 0.03)});
     },
     ErrorCode::kGeometry, "/plan/rods/2", "rod \"across\" and rod \"stub\" cross without a common point",
     "add a point there"},
    {"the same path twice",
     [](Plan& p) {
       add_rod(p, "again", {0, 2});
     },
     ErrorCode::kGeometry, "/plan/rods/2", "rod \"across\" and rod \"again\" lie on each other", "draw one rod"},
    {"a point outside",
     [](Plan& p) {
       add_rod(p, "out", {1, add_point(p, "e", 0.08, -0.02)});
     },
     ErrorCode::kGeometry, "/plan/rods/2", "rod \"out\" leaves the fabric at its point \"e\", (80, -20) mm",
     "inside or on it"},
    {"an outline that leaves a rod outside",
     [](Plan& p) {
       const int e = add_point(p, "e", 0.09, 0), f = add_point(p, "f", 0.09, 0.06);
       add_rod(p, "wing", {1, e, f, 2});
       p.fabric.outline = {"frame"};
     },
     ErrorCode::kGeometry, "/plan/rods/2", "rod \"wing\" leaves the fabric", "the fabric ends at its outline"},
    {"no closed loop",
     [](Plan& p) {
       p.rods[0].closed = false;
       p.rods.pop_back();
     },
     ErrorCode::kGeometry, "/plan/fabric", "encloses nothing", "close"},
    {"fabric in two parts",
     [](Plan& p) {
       const int e = add_point(p, "e", 0.1, 0), f = add_point(p, "f", 0.13, 0), g = add_point(p, "g", 0.1, 0.03);
       add_rod(p, "island", {e, f, g}, PlanCurve::kStraight, true);
     },
     ErrorCode::kGeometry, "/plan/fabric", "rod \"frame\" and rod \"island\" are on different ones", "join the parts"},
    {"a spline that turns on the spot",
     [](Plan& p) {
       const int e = add_point(p, "e", 0.02, 0.01), f = add_point(p, "f", 0.05, 0.01),
                 g = add_point(p, "g", 0.05, 0.012), h = add_point(p, "h", 0.02, 0.008);
       add_rod(p, "hook", {e, f, g, h}, PlanCurve::kSpline);
     },
     ErrorCode::kGeometry, "/plan/rods/2", "rod \"hook\" bends around a radius of", "space its points more evenly"},
    {"a straight spline that turns back",
     [](Plan& p) {
       const int e = add_point(p, "e", 0.02, 0.01), f = add_point(p, "f", 0.05, 0.01),
                 g = add_point(p, "g", 0.052, 0.01);
       add_rod(p, "there and back", {e, g, f}, PlanCurve::kSpline);
     },
     ErrorCode::kGeometry, "/plan/rods/2", "bends around a radius of 0 mm", "space its points more evenly"},
    {"slack from the start", [](Plan& p) { p.fabric.pre_stretch = Vec2(0.8, 0.95); }, ErrorCode::kRange,
     "/plan/fabric/pre_stretch", "the pre-stretch is 0.95: the fabric would hang slack",
     "more than 1, for example 1.4"},
    {"percent for a factor", [](Plan& p) { p.fabric.pre_stretch = Vec2(50, 50); }, ErrorCode::kRange,
     "/plan/fabric/pre_stretch", "no fabric can be stretched to 50 times", "40 % more is 1.4"},
    {"no pre-stretch", [](Plan& p) { p.fabric.pre_stretch = Vec2(1.4, 0); }, ErrorCode::kRange,
     "/plan/fabric/pre_stretch", "the pre-stretch is 0", "for example 1.4"},
    {"unknown fabric", [](Plan& p) { p.fabric.material = "soft nit"; }, ErrorCode::kUnknown, "/plan/fabric/material",
     "\"soft nit\"", "did you mean \"soft knit\"?"},
    {"unknown rod material", [](Plan& p) { p.material = "PLO"; }, ErrorCode::kUnknown, "/plan/material", "\"PLO\"",
     "did you mean \"PLA\"?"},
    {"unknown outline", [](Plan& p) { p.fabric.outline = {"fram"}; }, ErrorCode::kUnknown, "/plan/fabric/outline/0",
     "no rod named \"fram\"", "did you mean \"frame\"?"},
    {"two points at one place",
     [](Plan& p) {
       add_rod(p, "stub", {0, add_point(p, "e", 0.06, 0.06)});
     },
     ErrorCode::kGeometry, "/plan/points/e", "the points \"c\" and \"e\" are at the same place", "use one point"},
    {"a point beyond everything, which makes all others one place", [](Plan& p) { p.points[3].at.x() = 1e297; },
     ErrorCode::kRange, "/plan/points/d", "this number is too large: 1e297", "is its unit the right one?"},
    {"one point", [](Plan& p) { p.rods[1].points = {0}; }, ErrorCode::kGeometry, "/plan/rods/1/points",
     "rod \"across\" has 1 points", "at least 2"},
    {"closed with two points", [](Plan& p) { p.rods[1].closed = true; }, ErrorCode::kGeometry, "/plan/rods/1/points",
     "rod \"across\" has 2 points", "at least 3"},
    {"first point repeated",
     [](Plan& p) {
       p.rods[0] = {"frame", {0, 1, 2, 3, 0}, PlanCurve::kStraight, PlanRole::kRod, false};
     },
     ErrorCode::kGeometry, "/plan/rods/0/points/4", "runs through the point \"a\" twice", "\"closed\": true"},
    {"unused point", [](Plan& p) { add_point(p, "lost", 0.01, 0.02); }, ErrorCode::kConflict, "/plan/points/lost",
     "no rod runs through the point \"lost\"", "remove it"},
    {"half an arc",
     [](Plan& p) {
       p.rods[0].curve = PlanCurve::kArc;
       p.rods[0].closed = false;
     },
     ErrorCode::kGeometry, "/plan/rods/0/points", "do not make up whole arcs", "three points"},
    {"an arc without a circle",
     [](Plan& p) {
       add_rod(p, "arc", {1, add_point(p, "e", 0.07, 0), add_point(p, "f", 0.065, 0)}, PlanCurve::kArc);
     },
     ErrorCode::kGeometry, "/plan/rods/2/points", "lie in line", "move one of them"},
    {"all ghosts",
     [](Plan& p) {
       for (PlanRod& rod : p.rods) rod.role = PlanRole::kGhost;
     },
     ErrorCode::kGeometry, "/plan/rods", "all rods of the plan are ghosts", "at least one"},
    {"negative radius", [](Plan& p) { p.points[1].r_b = -1e-3; }, ErrorCode::kRange, "/plan/points/b/r_b",
     "the radius has to be positive", ""},
    {"a hole outside", [](Plan& p) { p.fabric.holes.push_back(Vec2(0.2, 0)); }, ErrorCode::kGeometry,
     "/plan/fabric/holes/0", "outside", "move its point"},
    {"a hole twice",
     [](Plan& p) {
       const int e = add_point(p, "e", 0.04, 0.01), f = add_point(p, "f", 0.05, 0.01),
                 g = add_point(p, "g", 0.05, 0.02);
       add_rod(p, "opening", {e, f, g}, PlanCurve::kStraight, true);
       p.fabric.holes = {Vec2(0.048, 0.012), Vec2(0.047, 0.013)};
     },
     ErrorCode::kGeometry, "/plan/fabric/holes/1", "in another hole", "move its point"},
    {"a hole that is all",
     [](Plan& p) {
       p.fabric.holes = {Vec2(0.03, 0.01), Vec2(0.01, 0.03)};
     },
     ErrorCode::kGeometry, "/plan/fabric", "nothing of the fabric is left", "remove a hole"},
};

TEST(PlanErrors, EachNamesThePlaceAndTheRemedy) {
  ASSERT_TRUE(discretize(good()));
  for (const Case& wrong : kCases) {
    SCOPED_TRACE(wrong.name);
    Model model = good();
    wrong.spoil(*model.plan);
    const Result<Structure> structure = discretize(model);
    ASSERT_FALSE(structure);
    const Error& error = structure.error();
    EXPECT_EQ(error.code, wrong.code) << error.text();
    EXPECT_EQ(error.where, wrong.where) << error.text();
    EXPECT_NE(error.message.find(wrong.message), std::string::npos) << error.text();
    EXPECT_NE(error.hint.find(wrong.hint), std::string::npos) << error.text();
  }
}

TEST(PlanErrors, SlackFabricAndCloseRodsAreRemarkedOn) {
  Model model = good();
  Plan& plan = *model.plan;
  plan.fabric.pre_stretch = Vec2(0.9, 2.6);
  const int e = add_point(plan, "e", 0.011, 0.0104), f = add_point(plan, "f", 0.045, 0.0444);
  add_rod(plan, "beside", {e, f});
  const Result<Structure> structure = discretize(model);
  ASSERT_TRUE(structure) << structure.error().text();
  std::string notes;
  for (const std::string& note : structure.value().notes) notes += note + "\n";
  EXPECT_NE(notes.find("the fabric is slack as printed: its pre-stretch is 0.9"), std::string::npos) << notes;
  EXPECT_NE(notes.find("the pre-stretch of 2.6 is beyond what fabrics bear"), std::string::npos) << notes;
  EXPECT_NE(notes.find("rod \"across\" and rod \"beside\" overlap over"), std::string::npos) << notes;
}

TEST(PlanErrors, AHoleAndFreeEndsAreNoMistake) {
  Model model = good();
  Plan& plan = *model.plan;
  const int e = add_point(plan, "e", 0.04, 0.01), f = add_point(plan, "f", 0.05, 0.01),
            g = add_point(plan, "g", 0.05, 0.02);
  add_rod(plan, "opening", {e, f, g}, PlanCurve::kStraight, true);
  add_rod(plan, "free", {3, add_point(plan, "end", 0.02, 0.04)});
  plan.fabric.holes = {Vec2(0.048, 0.012)};
  EXPECT_TRUE(discretize(model));
}

}  // namespace
}  // namespace lissom
