/// Objectives against closed forms.

#include <cmath>
#include <numbers>

#include "lissom/design/section_strain.h"
#include "tests/derivatives/objective_cases.h"

namespace lissom {
namespace {

using namespace objective_tests;
constexpr double kPi = std::numbers::pi;

/// A structure of points and triangles without anything else, for objectives of places alone.
struct Bare {
  Design design;
  StaticProblem problem{nullptr, Potential(0, {}), {}, {}, false, {}};
  State state;
  Pose pose;

  explicit Bare(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles = {}) {
    Structure& structure = design.system.structure;
    structure.nodes = points;
    structure.size = 1;
    for (const auto& t : triangles) structure.triangles.push_back({t, 0, {Vec2::Zero(), Vec2::Zero(), Vec2::Zero()}});
    StructureMembrane membrane;
    membrane.triangles = static_cast<int>(triangles.size());
    structure.membranes.push_back(membrane);
    design.system.layout = DofLayout(structure);
    state.q.resize(3 * static_cast<int>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i) state.q.segment<3>(3 * static_cast<int>(i)) = points[i];
  }
  VecX values(const Objective& objective) const {
    VecX c;
    objective.values({design, pose, problem, state}, c);
    return c;
  }
};

TEST(ObjectiveValues, AreaOfAFlatSheet) {
  const Bare sheet({{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {0, 3, 0}}, {{0, 1, 2}, {0, 2, 3}});
  EXPECT_NEAR(sheet.values(*make_membrane_area())[0], 6, 1e-15);
}

/// Five faces of a box, open below.
Bare box(double a, double b, double h) {
  std::vector<Vec3> x;
  for (const double z : {0.0, h}) {
    for (const auto& [u, v] : {std::pair{0.0, 0.0}, {a, 0.0}, {a, b}, {0.0, b}}) x.emplace_back(u, v, z);
  }
  std::vector<std::array<int, 3>> t = {{4, 5, 6}, {4, 6, 7}};
  for (int i = 0; i < 4; ++i) {
    const int j = (i + 1) % 4;
    t.push_back({i, j, j + 4});
    t.push_back({i, j + 4, i + 4});
  }
  return Bare(x, t);
}

TEST(ObjectiveValues, VolumeOfABoxWithoutItsFloor) {
  Bare shape = box(2, 3, 4);
  const auto volume = taken(make_enclosed_volume(shape.design.system.structure));
  EXPECT_NEAR(shape.values(*volume)[0], 24, 1e-13);
  // With a tip in the plane of the rim it is the same, with one below the pyramid comes on top.
  const auto flat = taken(make_enclosed_volume(shape.design.system.structure, {}, Vec3(9, 1, 0)));
  EXPECT_NEAR(shape.values(*flat)[0], 24, 1e-13);
  const auto deep = taken(make_enclosed_volume(shape.design.system.structure, {}, Vec3(1, 1, -1)));
  EXPECT_NEAR(shape.values(*deep)[0], 24 + 2, 1e-13);
  for (StructureTriangle& t : shape.design.system.structure.triangles) std::swap(t.node[0], t.node[1]);
  EXPECT_NEAR(shape.values(*taken(make_enclosed_volume(shape.design.system.structure)))[0], -24, 1e-13);
}

TEST(ObjectiveValues, VolumeOfABall) {
  const int around = 96, up = 48;
  std::vector<Vec3> x = {{0, 0, -1}, {0, 0, 1}};
  for (int j = 1; j < up; ++j) {
    for (int i = 0; i < around; ++i) {
      const double u = 2 * kPi * i / around, v = kPi * j / up;
      x.emplace_back(std::sin(v) * std::cos(u), std::sin(v) * std::sin(u), -std::cos(v));
    }
  }
  const auto at = [&](int j, int i) { return 2 + (j - 1) * around + i % around; };
  std::vector<std::array<int, 3>> t;
  for (int i = 0; i < around; ++i) {
    t.push_back({0, at(1, i + 1), at(1, i)});
    t.push_back({1, at(up - 1, i), at(up - 1, i + 1)});
    for (int j = 1; j + 1 < up; ++j) {
      t.push_back({at(j, i), at(j, i + 1), at(j + 1, i + 1)});
      t.push_back({at(j, i), at(j + 1, i + 1), at(j + 1, i)});
    }
  }
  const Bare ball(x, t);
  const auto volume = taken(make_enclosed_volume(ball.design.system.structure));
  EXPECT_NEAR(ball.values(*volume)[0], 4 * kPi / 3, 0.003 * 4 * kPi / 3);
}

TEST(ObjectiveValues, SurfacesWithoutOneOutsideHaveNoVolume) {
  const Bare turned({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 2, 3}});
  const auto refused = make_enclosed_volume(turned.design.system.structure);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().code, ErrorCode::kUnsupported);
  EXPECT_FALSE(make_enclosed_volume(Bare({{0, 0, 0}}).design.system.structure).ok());
  EXPECT_FALSE(make_enclosed_volume(box(1, 1, 1).design.system.structure, {}, Vec3(NAN, 0, 0)).ok());
}

TEST(ObjectiveValues, TurnsOfASet) {
  const std::vector<Vec3> points = {{0, 0, 0}, {1, 0.1, 0}, {0.2, 2, 0}, {0.4, 0.3, 0}, {5, 5, 5}};
  Eigen::Matrix3Xd places(3, 4);
  for (int i = 0; i < 4; ++i) places.col(i) = points[i];
  const auto orientation = taken(make_set_orientation({0, 1, 2, 3}, places));
  const auto position = make_set_position({0, 1, 2, 3});
  for (const Vec3& r : {Vec3(0, 0, 0), Vec3(0.3, -0.2, 0.9), Vec3(-2, 1.5, 1), Vec3(0, 0, 3.1)}) {
    Bare shape(points);
    for (int i = 0; i < 5; ++i) {
      shape.state.q.segment<3>(3 * i) = rotation_from_vector(r) * points[i] + Vec3(7, -8, 9);
    }
    EXPECT_LT((shape.values(*orientation) - r).norm(), 1e-12);
    const Vec3 mean = rotation_from_vector(r) * places.rowwise().mean() + Vec3(7, -8, 9);
    EXPECT_LT((shape.values(*position) - mean).norm(), 1e-13);
  }
  EXPECT_FALSE(make_set_orientation({0, 1}, places.leftCols(2)).ok());
  places << 0, 1, 2, 3, 0, 1, 2, 3, 0, 0, 0, 0;
  const auto line = make_set_orientation({0, 1, 2, 3}, places);
  ASSERT_FALSE(line.ok());
  EXPECT_EQ(line.error().code, ErrorCode::kGeometry);
}

TEST(ObjectiveValues, Angles) {
  const double c = std::cos(kPi / 3), s = std::sin(kPi / 3);
  const Bare shape({{0, 0, 0}, {2, 0, 0}, {1, 1, 1}, {1 + c, 1 + s, 1}, {3, 0, 0}});
  EXPECT_NEAR(shape.values(*make_angle({0, 1, 2, 3}))[0], kPi / 3, 1e-15);
  EXPECT_NEAR(shape.values(*make_angle({2, 3, 0, 1}))[0], kPi / 3, 1e-15);
  EXPECT_NEAR(shape.values(*make_angle({1, 0, 2, 3}))[0], 2 * kPi / 3, 1e-15);
  EXPECT_NEAR(shape.values(*make_angle({0, 1, 2, 3}, Vec3(0, 0, 5)))[0], kPi / 3, 1e-15);
  EXPECT_NEAR(shape.values(*make_angle({0, 1, 2, 3}, Vec3(0, 0, -1)))[0], -kPi / 3, 1e-15);
  // Where directions are parallel there is a kink without an axis, and a slope with one.
  SparseRows by_q, by_numbers;
  EXPECT_EQ(shape.values(*make_angle({0, 1, 0, 4}))[0], 0);
  make_angle({0, 1, 0, 4})->jacobian({shape.design, shape.pose, shape.problem, shape.state}, by_q, by_numbers);
  EXPECT_EQ(by_q.norm(), 0);
  make_angle({0, 1, 0, 4}, Vec3(0, 0, 1))
      ->jacobian({shape.design, shape.pose, shape.problem, shape.state}, by_q, by_numbers);
  EXPECT_NEAR(by_q.coeff(0, 3 * 4 + 1), 1.0 / 3, 1e-15);
}

TEST(ObjectiveValues, DistancesFromAnOctahedron) {
  const auto surface = octahedron({1, 2, 3}, 1);
  const double h = 1 / std::sqrt(3);  // of the faces from the centre
  const Bare shape({Vec3(1, 2, 3) + Vec3(1, 1, 1), Vec3(1, 2, 3), Vec3(1, 2, 5), Vec3(2, 3, 3), Vec3(1, 2, 3.9)});
  const VecX c = shape.values(*make_surface_distance(surface, {0, 1, 2, 3, 4}, DistanceKind::kSigned));
  EXPECT_NEAR(c[0], std::sqrt(3) - h, 1e-15);  // over a face
  EXPECT_NEAR(c[1], -h, 1e-15);                // the centre
  EXPECT_NEAR(c[2], 1, 1e-15);                 // over a corner
  EXPECT_NEAR(c[3], std::sqrt(0.5), 1e-15);    // over an edge
  EXPECT_NEAR(c[4], -0.1 * h, 1e-15);          // under a corner
  const VecX v = shape.values(*make_surface_distance(surface, {0, 1, 2, 3, 4}, DistanceKind::kVector));
  for (int k = 0; k < 5; ++k) EXPECT_NEAR(v.segment<3>(3 * k).norm(), std::abs(c[k]), 1e-15);
  EXPECT_LT((v.segment<3>(6) - Vec3(0, 0, 1)).norm(), 1e-15);
  SparseRows by_q, by_numbers;
  make_surface_distance(surface, {0, 2, 3}, DistanceKind::kVector)
      ->jacobian({shape.design, shape.pose, shape.problem, shape.state}, by_q, by_numbers);
  const MatX dense(by_q);
  EXPECT_NEAR(dense.block(0, 0, 3, 3).trace(), 1, 1e-14);
  EXPECT_NEAR(dense.block(3, 6, 3, 3).trace(), 3, 1e-14);
  EXPECT_NEAR(dense.block(6, 9, 3, 3).trace(), 2, 1e-14);
}

TEST(ObjectiveValues, SurfacesThatAreNone) {
  const std::vector<Vec3> x = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}};
  const auto place = [&](const std::vector<Vec3>& vertices, std::vector<std::array<int, 3>> t) {
    const auto made = TriangleSurface::make(vertices, std::move(t), "/s");
    return made ? std::string() : made.error().where;
  };
  EXPECT_EQ(place(x, {{0, 1, 2}}), "");
  EXPECT_EQ(place(x, {}), "/s");
  EXPECT_EQ(place(x, {{0, 1, 2}, {0, 1, 4}}), "/s/triangles/1");
  EXPECT_EQ(place(x, {{0, 1, 2}, {0, 1, 3}}), "/s/triangles/1");
  EXPECT_EQ(place({{0, 0, 0}, {1, NAN, 0}, {0, 1, 0}}, {{0, 1, 2}}), "/s/vertices/1");
}

/// Over an edge between triangles of one plane, and on the surface, only what is across the plane counts.
TEST(ObjectiveValues, PlanesHaveNoEdges) {
  const auto made =
      TriangleSurface::make({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}, "plane");
  ASSERT_TRUE(made.ok());
  for (const double z : {0.5, 0.0, -1e-12}) {
    const NearestPoint near = made.value().nearest({0.25, 0.25, z});
    EXPECT_LT((near.across - Mat3(Vec3(0, 0, 1).asDiagonal())).norm(), 1e-15);
    EXPECT_LT((near.normal - Vec3::UnitZ()).norm(), 1e-15);
  }
}

/// A straight round rod along x, every node of it held.
Model one_rod(int edges) {
  Model model;
  model.rods.push_back(rod("rod", Polyline{{Vec3::Zero(), Vec3(0.1, 0, 0)}}, SectionShape::kEllipse, 1e-3, 1e-3));
  model.rods[0].edges = edges;
  Pose pose;
  pose.name = "held";
  pose.gravity = Gravity{};
  pose.frozen = true;
  model.poses.push_back(pose);
  return model;
}

TEST(ObjectiveValues, AStretchedRod) {
  const auto shape = make_shape(one_rod(10), 0);
  ASSERT_NE(shape, nullptr);
  const System& system = shape->design.system;
  VecX dq = VecX::Zero(shape->unknowns());
  for (int i = 0; i < system.layout.nodes(); ++i) dq[3 * i] = 0.01 * system.structure.nodes[i].x();
  State stretched;
  ASSERT_TRUE(advance(system, shape->state, dq, stretched));
  shape->state = stretched;
  VecX c;
  make_strain_energy()->values(shape->pose_shape(), c);
  const double area = kPi * 1e-6, stiffness = shape->design.model.material("PLA")->youngs_modulus * area;
  EXPECT_NEAR(c[0], 0.5 * stiffness * 0.1 * 1e-4, 1e-12 * stiffness);
  make_rod_strain(system)->values(shape->pose_shape(), c);
  ASSERT_EQ(c.size(), 9);
  for (const double strain : c) EXPECT_NEAR(strain, 0.01, 3 * kStrainRounding);
  make_material_volume(shape->design.model, system.structure).value()->values(shape->pose_shape(), c);
  EXPECT_NEAR(c[0], area * 0.1, 1e-14 * area);
  make_mass()->values(shape->pose_shape(), c);
  const double mass = area * 0.1 * shape->design.model.material("PLA")->density;
  EXPECT_NEAR(c[0], mass, 1e-14 * mass);
  // Internal forces cancel in the sum over all nodes: the supports carry the weight.
  std::vector<int> all;
  for (int i = 0; i < system.layout.nodes(); ++i) all.push_back(i);
  make_reaction_force(all, {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()})->values(shape->pose_shape(), c);
  EXPECT_NEAR(c[2], mass * 9.81, 1e-9 * mass);
  EXPECT_NEAR(c.head(2).norm(), 0, 1e-12 * stiffness);
  // Its first node alone carries what pulls at it.
  make_reaction_force({0}, {Vec3::UnitX()})->values(shape->pose_shape(), c);
  EXPECT_NEAR(c[0], -0.01 * stiffness, 1e-9 * stiffness);
}

TEST(ObjectiveValues, ABentRod) {
  const int edges = 40;
  const auto shape = make_shape(one_rod(edges), 0);
  ASSERT_NE(shape, nullptr);
  const System& system = shape->design.system;
  const double l = 0.1 / edges, radius = 0.08, turn = 2 * std::asin(l / (2 * radius));
  VecX x(3 * system.layout.nodes());
  for (int i = 0; i <= edges; ++i) x.segment<3>(3 * i) = radius * Vec3(std::sin(i * turn), 0, 1 - std::cos(i * turn));
  const std::vector<Vec3> normals(edges, Vec3::UnitZ());
  shape->state = state_of_shape(system, x, normals, {}, 1);
  VecX c;
  make_rod_bending(system.structure)->values(shape->pose_shape(), c);
  ASSERT_EQ(c.size(), 3 * (edges - 1));
  for (int k = 0; k < edges - 1; ++k) EXPECT_NEAR(c.segment<3>(3 * k).norm(), 1 / radius, 1e-9 / radius);
  make_rod_strain(system)->values(shape->pose_shape(), c);
  // The bending energy takes 2 tan(turn / 2) for the turn.
  for (const double strain : c) EXPECT_NEAR(strain, 1e-3 * 2 * std::tan(turn / 2) / l, 4 * kStrainRounding);
}

TEST(ObjectiveValues, StrainsOfSections) {
  const auto strain = [](SectionShape shape, const SectionState<double>& s) { return section_strain(shape, s, 0.3); };
  const double few = 4 * kStrainRounding;
  EXPECT_NEAR(strain(SectionShape::kEllipse, {-0.02, 0, 0, 0, 1e-3, 2e-3}), 0.02, few);
  EXPECT_NEAR(strain(SectionShape::kEllipse, {0.01, 3, 4, 0, 1e-3, 1e-3}), 0.015, few);
  EXPECT_NEAR(strain(SectionShape::kRectangle, {0.01, -3, 4, 0, 1e-3, 1e-3}), 0.017, few);
  EXPECT_NEAR(strain(SectionShape::kTube, {0, 0, 0, 20, 1e-3, 1e-3}), 0.02 * std::sqrt(0.75) / 1.3, few);
  EXPECT_EQ(strain(SectionShape::kEllipse, {0, 0, 0, 0, 1e-3, 1e-3}), 0);
  EXPECT_NEAR(twist_lever(SectionShape::kEllipse, 1.0, 1.0), 1, 1e-3);
  EXPECT_NEAR(twist_lever(SectionShape::kEllipse, 3.0, 1.0), 2 * 9 / 10.0, 1e-5);
  EXPECT_NEAR(twist_lever(SectionShape::kEllipse, 1.0, 3.0), 2 * 9 / 10.0, 1e-5);
  // Timoshenko and Goodier: 0.675 and 0.930 times the shorter side, for sides of 1 : 1 and 1 : 2.
  EXPECT_NEAR(twist_lever(SectionShape::kRectangle, 1.0, 1.0), 2 * 0.6753, 2e-3);
  EXPECT_NEAR(twist_lever(SectionShape::kRectangle, 2.0, 1.0), 2 * 0.9301, 2e-3);
  EXPECT_NEAR(twist_lever(SectionShape::kRectangle, 1.0, 30.0), 2, 1e-4);
}

TEST(ObjectiveValues, AStretchedTriangle) {
  Bare shape({{0, 0, 0}, {1.3 * 2, 0, 0}, {0, 0, 0.9 * 3}}, {{0, 1, 2}});
  shape.design.system.rest.triangles.resize(1);
  shape.design.system.rest.triangles[0].corner = {Vec2(1, 1), Vec2(3, 1), Vec2(1, 4)};
  const auto stretch = make_smallest_stretch(shape.design.system.structure);
  EXPECT_NEAR(shape.values(*stretch)[0], 0.9, 1e-7);
  // Even stretch reads a little too low, and has derivatives.
  shape.state.q[8] = 1.3 * 3;
  EXPECT_NEAR(shape.values(*stretch)[0], 1.3, 5e-5);
  SparseRows by_q, by_numbers;
  stretch->jacobian({shape.design, shape.pose, shape.problem, shape.state}, by_q, by_numbers);
  EXPECT_TRUE(MatX(by_q).allFinite());
  EXPECT_NEAR(by_q.coeff(0, 8), 0.5 / 3, 1e-3);
}

}  // namespace
}  // namespace lissom
