#include "lissom/model/plan.h"

#include <chrono>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <set>

#include "lissom/geometry/planar_smoothing.h"
#include "lissom/model/document.h"
#include "lissom/model/expand_plan.h"
#include "lissom/model/plan_map.h"
#include "lissom/model/structure.h"

namespace lissom {
namespace {

constexpr double kPi = std::numbers::pi;

int add_point(Plan& plan, const std::string& name, double x, double y, double r_n = 2e-4, double r_b = 4e-4) {
  plan.points.push_back({name, Vec2(x, y), r_n, r_b, false});
  return static_cast<int>(plan.points.size()) - 1;
}

Model empty_plan() {
  Model model;
  Plan& plan = model.plan.emplace();
  plan.material = "PLA";
  plan.edge_length = 2e-3;
  plan.fabric.material = "soft knit";
  return model;
}

/// A square of straight rods with a spline across it, sides 60 mm.
Model square() {
  Model model = empty_plan();
  Plan& plan = *model.plan;
  const int a = add_point(plan, "a", 0, 0), b = add_point(plan, "b", 0.06, 0), c = add_point(plan, "c", 0.06, 0.06),
            d = add_point(plan, "d", 0, 0.06), m = add_point(plan, "m", 0.025, 0.03, 4e-4, 2e-4);
  plan.rods.push_back({"frame", {a, b, c, d}, PlanCurve::kStraight, PlanRole::kRod, true});
  plan.rods.push_back({"across", {a, m, c}, PlanCurve::kSpline, PlanRole::kRod, false});
  return model;
}

/// A disc of 60 mm radius drawn as a circle, with `spokes` splines from its centre.
Model disc(int spokes, PlanRole edge = PlanRole::kRod) {
  Model model = empty_plan();
  Plan& plan = *model.plan;
  std::vector<int> ring;
  for (int i = 0; i < 2 * spokes; ++i) {
    const double angle = kPi * i / spokes;
    ring.push_back(add_point(plan, "r" + std::to_string(i), 0.06 * std::cos(angle), 0.06 * std::sin(angle)));
  }
  const int centre = add_point(plan, "centre", 0, 0);
  plan.rods.push_back({"ring", ring, PlanCurve::kArc, edge, true});
  for (int i = 0; i < spokes; ++i) {
    const double angle = kPi * (2 * i + 1) / spokes + 0.2;
    const int bend =
        add_point(plan, "b" + std::to_string(i), 0.03 * std::cos(angle), 0.03 * std::sin(angle), 3e-4, 5e-4);
    plan.rods.push_back({"spoke " + std::to_string(i),
                         {ring[static_cast<size_t>(2 * i + 1)], bend, centre},
                         PlanCurve::kSpline,
                         PlanRole::kRod,
                         false});
  }
  return model;
}

ExpandedPlan expanded(const Model& model, double refine = 1) {
  Result<ExpandedPlan> plan = expand_plan(model, refine);
  EXPECT_TRUE(plan) << plan.error().text();
  return std::move(plan).value();
}

MatX control_points(const Plan& plan) {
  MatX controls(static_cast<Eigen::Index>(plan.points.size()), 2);
  for (size_t i = 0; i < plan.points.size(); ++i)
    controls.row(static_cast<Eigen::Index>(i)) = plan.points[i].at.transpose();
  return controls;
}

TEST(Plan, PointsAreNodesAndTheFabricConformsToAllRods) {
  const Model model = square();
  const ExpandedPlan plan = expanded(model);
  ASSERT_EQ(plan.rods.size(), 2u);
  EXPECT_EQ(plan.rods[0].name, "frame");
  EXPECT_TRUE(is_closed(plan.rods[0].curve));
  EXPECT_EQ(plan.rods[0].edges, 4 * 30);
  std::set<std::pair<int, int>> edges;
  for (const auto& t : plan.mesh().triangles) {
    for (size_t k = 0; k < 3; ++k) edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
  }
  int seen = 0;
  for (size_t r = 0; r < plan.rods.size(); ++r) {
    const std::vector<Vec3>& points = std::get<Polyline>(plan.rods[r].curve).points;
    const std::vector<int>& vertices = plan.rod_vertices[r];
    ASSERT_EQ(points.size(), vertices.size());
    for (size_t i = 0; i + 1 < points.size(); ++i, ++seen) {
      EXPECT_EQ(points[i], plan.mesh().points[static_cast<size_t>(vertices[i])]);
      EXPECT_TRUE(edges.contains(std::minmax(vertices[i], vertices[i + 1])));
    }
  }
  EXPECT_GT(seen, 150);
  double area = 0;
  for (const auto& [a, b, c] : plan.mesh().triangles) {
    const auto at = [&](int i) -> Vec2 { return plan.mesh().points[static_cast<size_t>(i)].head<2>(); };
    EXPECT_GT(smallest_angle(at(a), at(b), at(c)), 0.3);
    const Vec2 u = at(b) - at(a), v = at(c) - at(a);
    area += (u.x() * v.y() - u.y() * v.x()) / 2;
  }
  EXPECT_NEAR(area, 0.06 * 0.06, 1e-12);
}

TEST(Plan, DiscretisesIntoOneStructure) {
  const Result<Structure> structure = discretize(square());
  ASSERT_TRUE(structure) << structure.error().text();
  EXPECT_EQ(structure.value().components, 1);
  EXPECT_EQ(structure.value().rods.size(), 2u);
  EXPECT_EQ(structure.value().joints.size(), 2u);
  const Result<Structure> fine = discretize(square(), 2);
  ASSERT_TRUE(fine);
  EXPECT_EQ(fine.value().rods[0].edges.size(), 2 * structure.value().rods[0].edges.size());
  Selector at;
  at.kind = Selector::Kind::kPlanPoint;
  at.name = "m";
  const Result<std::vector<int>> nodes = select(square(), structure.value(), at, "here");
  ASSERT_TRUE(nodes);
  EXPECT_EQ(structure.value().nodes[static_cast<size_t>(nodes.value()[0])], Vec3(0.025, 0.03, 0));
}

TEST(Plan, RadiiFollowTheSplineRule) {
  const Model model = square();
  const ExpandedPlan plan = expanded(model);
  const SectionProfile& section = plan.rods[1].section;
  ASSERT_EQ(section.r_n.size(), plan.rod_vertices[1].size());
  EXPECT_EQ(section.r_n.front(), 2e-4);
  EXPECT_EQ(section.r_n.back(), 2e-4);
  EXPECT_EQ(*std::max_element(section.r_n.begin(), section.r_n.end()), 4e-4);
  // Three points: the parabola through them, in a parameter that is 1 in the middle.
  const size_t quarter = static_cast<size_t>(plan.samples.pieces[1][0]) / 2;
  const double u = double(quarter) / plan.samples.pieces[1][0];
  EXPECT_NEAR(section.r_n[quarter], 2e-4 + 2e-4 * u * (2 - u), 1e-15);
}

TEST(Plan, SplitsCutRodsIntoPartsHeldByBalls) {
  Model model = square();
  model.plan->points[1].split = true;
  model.plan->points[4].split = true;
  EXPECT_EQ(plan_rod_names(*model.plan), (std::vector<std::string>{"frame", "across-0", "across-1"}));
  const ExpandedPlan plan = expanded(model);
  ASSERT_EQ(plan.rods.size(), 3u);
  EXPECT_EQ(plan.rods[2].name, "across-1");
  EXPECT_EQ(plan.rod_vertices[1].back(), 4);
  EXPECT_EQ(plan.rod_vertices[2].front(), 4);
  EXPECT_FALSE(is_closed(plan.rods[0].curve));
  EXPECT_EQ(plan.rod_vertices[0].front(), 1);
  EXPECT_EQ(plan.rod_vertices[0].back(), 1);
  ASSERT_EQ(plan.joints.size(), 2u);
  const Result<Structure> structure = discretize(model);
  ASSERT_TRUE(structure) << structure.error().text();
  EXPECT_EQ(structure.value().joints.size(), 2u);  // at a and c; none at b and m
}

TEST(Plan, GhostsShapeTheFabricWithoutBeingRods) {
  const Model model = disc(2, PlanRole::kGhost);
  const ExpandedPlan plan = expanded(model);
  EXPECT_EQ(plan.rods.size(), 2u);
  double area = 0;
  for (const auto& [a, b, c] : plan.mesh().triangles) {
    const auto at = [&](int i) { return plan.mesh().points[static_cast<size_t>(i)]; };
    area += (at(b) - at(a)).cross(at(c) - at(a)).z() / 2;
  }
  EXPECT_NEAR(area, kPi * 0.06 * 0.06, 2e-3 * area);
  for (const Vec2& p : plan.samples.nodes) EXPECT_LT(p.norm(), 0.06 * (1 + 1e-12));
}

TEST(Plan, EdgesTurnByNoMoreThanAsked) {
  Model model = disc(2);
  model.plan->edge_length = 0;
  model.plan->max_turn = 0.05;
  const ExpandedPlan plan = expanded(model);
  const std::vector<int>& ring = plan.samples.rods[0];
  EXPECT_EQ(ring.size(), static_cast<size_t>(4 * std::ceil(kPi / 2 / 0.05)));
}

TEST(Plan, HolesAreLeftOut) {
  Model model = disc(2);
  Plan& plan = *model.plan;
  plan.rods.resize(1);
  plan.points.resize(4);
  std::vector<int> ring;
  for (int i = 0; i < 4; ++i) {
    ring.push_back(
        add_point(plan, "h" + std::to_string(i), 0.02 * std::cos(kPi * i / 2), 0.02 * std::sin(kPi * i / 2)));
  }
  plan.rods.push_back({"hole", ring, PlanCurve::kArc, PlanRole::kRod, true});
  plan.fabric.holes.push_back(Vec2(0.001, 0));
  const ExpandedPlan expansion = expanded(model);
  const MembraneMesh& mesh = expansion.mesh();
  double area = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 p = mesh.points[static_cast<size_t>(a)], q = mesh.points[static_cast<size_t>(b)],
               r = mesh.points[static_cast<size_t>(c)];
    EXPECT_GT(((p + q + r) / 3).norm(), 0.0199);
    area += (q - p).cross(r - p).z() / 2;
  }
  EXPECT_NEAR(area, kPi * (0.06 * 0.06 - 0.02 * 0.02), 2e-3 * area);
}

TEST(PlanMap, ReproducesTheMeshAndTheRadii) {
  for (const Model& model : {square(), disc(2)}) {
    const ExpandedPlan plan = expanded(model);
    Result<PlanMap> made = PlanMap::make(*model.plan, plan);
    ASSERT_TRUE(made);
    const PlanMap& map = made.value();
    EXPECT_EQ(map.vertices(), static_cast<int>(plan.mesh().points.size()));
    const MatX places = map.positions(control_points(*model.plan));
    for (int i = 0; i < map.vertices(); ++i) {
      EXPECT_NEAR((places.row(i).transpose() - plan.mesh().points[static_cast<size_t>(i)].head<2>()).norm(), 0, 1e-13);
    }
    const MeshQuality quality = map.quality(places);
    EXPECT_NEAR(quality.ratio, 1, 1e-9);
    EXPECT_NEAR(quality.smallest_angle, plan.smallest_angle, 1e-9);
    VecX r_n(map.points());
    for (int i = 0; i < map.points(); ++i) r_n[i] = model.plan->points[static_cast<size_t>(i)].r_n;
    const VecX radii = map.radii(r_n);
    for (size_t r = 0; r < plan.rods.size(); ++r) {
      for (size_t i = 0; i < plan.rod_vertices[r].size(); ++i) {
        EXPECT_NEAR(radii[plan.rod_vertices[r][i]], plan.rods[r].section.r_n[i], 1e-18);
      }
    }
  }
}

TEST(PlanMap, JacobiansAgreeWithDifferences) {
  for (const Model& model : {square(), disc(2)}) {
    const ExpandedPlan plan = expanded(model);
    const PlanMap map = PlanMap::make(*model.plan, plan).value();
    MatX controls = control_points(*model.plan);
    controls.row(4) += Eigen::RowVector2d(1e-3, -2e-3);
    const SparseMatrix jacobian = map.position_jacobian(controls);
    const double h = 1e-6;
    for (int j = 0; j < 2 * map.points(); ++j) {
      MatX plus = controls, minus = controls;
      plus(j / 2, j % 2) += h;
      minus(j / 2, j % 2) -= h;
      const MatX slope = (map.positions(plus) - map.positions(minus)) / (2 * h);
      for (int i = 0; i < map.vertices(); ++i) {
        for (int d = 0; d < 2; ++d) EXPECT_NEAR(jacobian.coeff(2 * i + d, j), slope(i, d), 1e-7);
      }
    }
    VecX radii = VecX::Constant(map.points(), 1e-3);
    radii[4] = 2e-5;  // thin next to thick: the spline would dip below zero
    const SparseMatrix thick = map.radius_jacobian(radii);
    EXPECT_GT(map.radii(radii).minCoeff(), 0);
    for (int j = 0; j < map.points(); ++j) {
      VecX plus = radii, minus = radii;
      plus[j] += 1e-9;
      minus[j] -= 1e-9;
      EXPECT_NEAR((VecX(thick.col(j)) - (map.radii(plus) - map.radii(minus)) / 2e-9).cwiseAbs().maxCoeff(), 0, 1e-6);
    }
  }
}

TEST(PlanMap, TurnedAndScaledPointsTurnAndScaleTheMesh) {
  const Model model = disc(2);
  const PlanMap map = PlanMap::make(*model.plan, expanded(model)).value();
  Eigen::Matrix2d turn;
  turn << 0.6, 1.6, -1.6, 0.6;
  const MatX controls = control_points(*model.plan);
  const MatX moved = map.positions(controls * turn), expected = map.positions(controls) * turn;
  EXPECT_NEAR((moved - expected).cwiseAbs().maxCoeff(), 0, 1e-12);
  EXPECT_NEAR(map.quality(moved).ratio, 1, 1e-9);
  MatX squeezed = controls;
  squeezed.row(4) = controls.row(0);
  EXPECT_LT(map.quality(map.positions(squeezed)).ratio, 0.5);
}

TEST(PlanDocument, WritesWhatItReads) {
  Model model = disc(2);
  model.plan->points[1].split = true;
  model.plan->fabric.pre_stretch = Vec2(1.4, 1.3);
  model.plan->fabric.holes.push_back(Vec2(0.01, 0.02));
  model.plan->fabric.outline.push_back("ring");
  const std::string text = write_document(model);
  const Result<Model> again = read_document(text);
  ASSERT_TRUE(again) << again.error().text();
  EXPECT_EQ(write_document(again.value()), text);
  ASSERT_TRUE(again.value().plan);
  EXPECT_EQ(again.value().plan->points[1].at, model.plan->points[1].at);
  EXPECT_TRUE(again.value().plan->points[1].split);
  EXPECT_EQ(again.value().plan->rods[0].curve, PlanCurve::kArc);
}

}  // namespace
}  // namespace lissom
