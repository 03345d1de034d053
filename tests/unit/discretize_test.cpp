#include <chrono>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "lissom/model/discretize_parts.h"
#include "lissom/model/structure.h"

namespace lissom {
namespace {

constexpr double kPi = std::numbers::pi;

Rod make_rod(const std::string& name, Curve curve, int edges) {
  Rod rod;
  rod.name = name;
  rod.curve = std::move(curve);
  rod.material = "PLA";
  rod.section = {SectionShape::kEllipse, {1e-3}, {2e-3}, 0};
  rod.edges = edges;
  return rod;
}

Rod straight(const std::string& name, const Vec3& a, const Vec3& b, int edges) {
  return make_rod(name, Polyline{{a, b}, false}, edges);
}

Arc circle(double radius, bool closed) { return {Vec3::Zero(), Vec3(radius, 0, 0), Vec3::UnitZ(), 2 * kPi, closed}; }

Selector at_fraction(const std::string& rod, double fraction) {
  Selector s;
  s.kind = Selector::Kind::kRod;
  s.name = rod;
  s.fraction = fraction;
  return s;
}

Support clamp(const std::string& rod, double fraction) {
  Support s;
  s.at = at_fraction(rod, fraction);
  s.kind = SupportKind::kClamp;
  return s;
}

Structure built(const Model& model, double refine = 1) {
  Result<Structure> result = discretize(model, refine);
  EXPECT_TRUE(result.ok()) << (result.ok() ? "" : result.error().text());
  return result.ok() ? std::move(result).value() : Structure{};
}

Error refused(const Model& model) {
  const Result<Structure> result = discretize(model);
  EXPECT_FALSE(result.ok());
  return result.ok() ? Error{} : result.error();
}

void expect_frame(const Frame& f) {
  EXPECT_NEAR(f.t.norm(), 1, 1e-12);
  EXPECT_NEAR(f.b.norm(), 1, 1e-12);
  EXPECT_LT((f.t.cross(f.b) - f.n).norm(), 1e-12);
}

void expect_sound(const Structure& s) {
  ASSERT_FALSE(s.edges.empty());
  for (const StructureEdge& e : s.edges) {
    expect_frame(e.drawn);
    expect_frame(e.rest);
    const Vec3 d = s.nodes[static_cast<size_t>(e.node1)] - s.nodes[static_cast<size_t>(e.node0)];
    EXPECT_LT((d.normalized() - e.drawn.t).norm(), 1e-12);
    EXPECT_GT(e.rest_length, 0);
  }
  for (const StructureJoint& j : s.joints) {
    for (const JointConnection& c : j.connections) {
      expect_frame(c.rest);
      const StructureEdge& e = s.edges[static_cast<size_t>(c.edge)];
      EXPECT_EQ(c.direction > 0 ? e.node0 : e.node1, j.node);
    }
  }
}

TEST(Discretize, ClosedCircleHasThePolygonsLengthsAndCurvatures) {
  Model model;
  model.rods = {make_rod("ring", circle(0.05, true), 64)};
  const Structure s = built(model);
  expect_sound(s);
  EXPECT_EQ(s.nodes.size(), 64u);
  EXPECT_EQ(s.edges.size(), 64u);
  EXPECT_EQ(s.pairs.size(), 64u);
  EXPECT_TRUE(s.joints.empty());
  double kappa = 0, length = 0;
  for (const StructurePair& p : s.pairs) {
    kappa += p.rest_kappa_1;
    EXPECT_NEAR(p.rest_kappa_1, 2 * std::tan(kPi / 64), 1e-13);  // n = +z, counter-clockwise: bends towards b
    EXPECT_NEAR(p.rest_kappa_2, 0, 1e-13);
    EXPECT_NEAR(p.rest_twist, 0, 1e-13);
  }
  for (const StructureEdge& e : s.edges) length += e.rest_length;
  EXPECT_NEAR(kappa, 64 * 2 * std::tan(kPi / 64), 1e-11);
  EXPECT_NEAR(length, 64 * 2 * 0.05 * std::sin(kPi / 64), 1e-13);
  EXPECT_EQ(s.components, 1);
  EXPECT_NEAR(s.size, 0.1 * std::sqrt(2.0), 1e-12);
}

TEST(Discretize, StraightRodClosedToACircleIsHeldInTheTangentOfTheCircle) {
  Model model;
  Rod rod = make_rod("ring", circle(0.05, false), 100);
  rod.natural.kind = Natural::Kind::kStraight;
  model.rods = {rod};
  model.merge_distance = -1;
  Pose pose;
  pose.name = "closed";
  pose.supports = {clamp("ring", 0), clamp("ring", 1)};
  model.poses = {pose};
  const Structure s = built(model);
  expect_sound(s);
  ASSERT_EQ(s.nodes.size(), 101u);
  EXPECT_LT((s.nodes.front() - s.nodes.back()).norm(), 1e-15);
  ASSERT_EQ(s.joints.size(), 2u);
  for (const StructureJoint& j : s.joints) {
    EXPECT_TRUE(j.from_pose);
    ASSERT_EQ(j.connections.size(), 1u);
    EXPECT_LT((j.connections[0].rest.t - Vec3::UnitY()).norm(), 1e-12);  // tangent at the node, not of the edge
    EXPECT_LT((j.connections[0].rest.n - Vec3::UnitZ()).norm(), 1e-12);
  }
  EXPECT_EQ(s.pairs.size(), 99u);
  for (const StructurePair& p : s.pairs)
    EXPECT_EQ(std::abs(p.rest_kappa_1) + std::abs(p.rest_kappa_2) + std::abs(p.rest_twist), 0);

  model.merge_distance = 0;  // then the ends are one point, joined to itself
  const Structure joined = built(model);
  EXPECT_EQ(joined.nodes.size(), 100u);
  ASSERT_EQ(joined.joints.size(), 1u);
  EXPECT_EQ(joined.joints[0].connections.size(), 2u);
}

TEST(Discretize, ClampOfADrawnArcIsFreeOfStrainAndOfACurvedRodHasHalfAnEdge) {
  const double radius = 0.2;
  for (const bool as_drawn : {true, false}) {
    Model model;
    Rod rod = make_rod("arc", Arc{Vec3::Zero(), Vec3(radius, 0, 0), Vec3::UnitZ(), kPi / 2, false}, 16);
    if (!as_drawn) {
      rod.natural.kind = Natural::Kind::kCurved;
      rod.natural.curvature_b = 1 / radius;
    }
    model.rods = {rod};
    Pose pose;
    pose.supports = {clamp("arc", 0), clamp("arc", 1), clamp("arc", 0.5)};
    model.poses = {pose};
    const Structure s = built(model);
    expect_sound(s);
    ASSERT_EQ(s.joints.size(), 3u);
    EXPECT_EQ(s.pairs.size(), 14u);  // the clamp in the middle replaces its pair
    for (const StructureJoint& j : s.joints) {
      for (const JointConnection& c : j.connections) {
        // Curvature 1/R along the chords instead of the arc: third order in the angle of an edge.
        EXPECT_LT((c.rest.t - s.edges[static_cast<size_t>(c.edge)].drawn.t).norm(), as_drawn ? 1e-15 : 5e-5);
        EXPECT_LT((c.rest.n - Vec3::UnitZ()).norm(), 1e-12);
      }
    }
  }
}

TEST(Discretize, NaturalCurveGivesItsLengthsStrainsAndClampFrames) {
  Model model;
  Rod rod = straight("rod", Vec3::Zero(), Vec3(0.3, 0, 0), 40);
  rod.natural.kind = Natural::Kind::kCurve;
  rod.natural.curve = Arc{Vec3(1, 2, 3), Vec3(1.1, 2, 3), Vec3::UnitZ(), kPi, false};
  model.rods = {rod};
  Pose pose;
  pose.supports = {clamp("rod", 0), clamp("rod", 1)};
  model.poses = {pose};
  const Structure s = built(model);
  expect_sound(s);
  const double phi = kPi / 40;
  for (const StructureEdge& e : s.edges) EXPECT_NEAR(e.rest_length, 2 * 0.1 * std::sin(phi / 2), 1e-14);
  for (const StructurePair& p : s.pairs) EXPECT_NEAR(p.rest_kappa_1, 2 * std::tan(phi / 2), 1e-12);
  ASSERT_EQ(s.joints.size(), 2u);
  // Leaves the clamp turned by half an edge to the left, arrives turned by half an edge to the right.
  EXPECT_LT((s.joints[0].connections[0].rest.t - Vec3(std::cos(phi / 2), std::sin(phi / 2), 0)).norm(), 1e-12);
  EXPECT_LT((s.joints[1].connections[0].rest.t - Vec3(std::cos(phi / 2), -std::sin(phi / 2), 0)).norm(), 1e-12);
}

TEST(Discretize, CurvedAndTwistedRestShapeFollowsItsStrains) {
  Model model;
  Rod rod = straight("rod", Vec3::Zero(), Vec3(0.3, 0, 0), 30);
  rod.natural.kind = Natural::Kind::kCurved;
  rod.natural.curvature_b = 3;
  rod.natural.curvature_n = -4;
  rod.natural.twist = 20;
  model.rods = {rod};
  const Structure s = built(model);
  const double factor = 2 * std::tan(5 * 0.01 / 2) / 5;
  for (const StructurePair& p : s.pairs) {
    EXPECT_NEAR(p.rest_kappa_1, 3 * factor, 1e-13);
    EXPECT_NEAR(p.rest_kappa_2, -4 * factor, 1e-13);
    EXPECT_NEAR(p.rest_twist, 0.2, 1e-13);
    const PairStrain built_strain =
        pair_strain(s.edges[static_cast<size_t>(p.edge0)].rest, s.edges[static_cast<size_t>(p.edge1)].rest);
    EXPECT_NEAR(built_strain.kappa_1, p.rest_kappa_1, 1e-12);
    EXPECT_NEAR(built_strain.kappa_2, p.rest_kappa_2, 1e-12);
    EXPECT_NEAR(built_strain.twist, p.rest_twist, 1e-12);
  }
}

TEST(Discretize, AdvancedFrameGoesBackWithTheNegativeStrain) {
  const Frame f = frame_from_normal(Vec3(1, 2, 3), Vec3(0, -1, 4));
  const PairStrain strain{0.4, -0.7, 1.1};
  const Frame g = advanced(f, strain), back = advanced(g, {-0.4, 0.7, -1.1});
  EXPECT_LT((back.t - f.t).norm() + (back.n - f.n).norm(), 1e-14);
  EXPECT_NEAR(pair_strain(f, g).kappa_2, -0.7, 1e-14);
  EXPECT_NEAR(pair_strain(f, g).twist, 1.1, 1e-14);
}

TEST(Discretize, HelixHasItsPitchAndLength) {
  Model model;
  Rod rod = make_rod("coil", Helix{Vec3::Zero(), Vec3(0.01, 0, 0), Vec3::UnitZ(), 0.004, 5}, 300);
  rod.axes.kind = MaterialAxes::Kind::kTransport;
  model.rods = {rod};
  const Structure s = built(model);
  expect_sound(s);
  EXPECT_LT((s.nodes.back() - Vec3(0.01, 0, 0.02)).norm(), 1e-15);
  EXPECT_LT((s.nodes[60] - Vec3(0.01, 0, 0.004)).norm(), 1e-15);
  double length = 0;
  for (const StructureEdge& e : s.edges) length += e.rest_length;
  EXPECT_NEAR(length, 300 * std::hypot(2 * 0.01 * std::sin(kPi / 60), 0.004 / 60), 1e-13);
  for (const StructurePair& p : s.pairs) EXPECT_NEAR(p.rest_twist, 0, 1e-13);
  EXPECT_TRUE(s.notes.empty()) << s.notes[0];
}

/// Hexagons of side 1 in rows, every side a rod: a columns, b rows.
Model hexagons(int a, int b) {
  Model model;
  const double h = std::sqrt(3.0);
  std::map<std::pair<long, long>, bool> seen;
  for (int i = 0; i < a; ++i) {
    for (int j = 0; j < b; ++j) {
      const Vec3 middle(1.5 * i, h * j + (i % 2 ? h / 2 : 0), 0);
      for (int k = 0; k < 6; ++k) {
        const Vec3 p = middle + Vec3(std::cos(k * kPi / 3), std::sin(k * kPi / 3), 0);
        const Vec3 q = middle + Vec3(std::cos((k + 1) * kPi / 3), std::sin((k + 1) * kPi / 3), 0);
        const Vec3 m = 1000 * (p + q);
        if (seen[{std::lround(m.x()), std::lround(m.y())}]) continue;
        seen[{std::lround(m.x()), std::lround(m.y())}] = true;
        model.rods.push_back(straight("r" + std::to_string(model.rods.size()), p, q, 10));
      }
    }
  }
  return model;
}

TEST(Discretize, HexagonSheetHasTheCountsOfTheTable) {
  const Model model = hexagons(3, 6);  // table 5.1: 71 rods, 54 joints, 693 nodes, 710 edges
  const Structure s = built(model);
  expect_sound(s);
  EXPECT_EQ(s.rods.size(), 71u);
  EXPECT_EQ(s.joints.size(), 54u);
  EXPECT_EQ(s.nodes.size(), 693u);
  EXPECT_EQ(s.edges.size(), 710u);
  EXPECT_EQ(s.pairs.size(), 71u * 9);
  size_t connections = 0;
  for (const StructureJoint& j : s.joints) {
    connections += j.connections.size();
    EXPECT_FALSE(j.from_pose);
  }
  EXPECT_EQ(connections, 2u * 71);
  for (const StructureEdge& e : s.edges) EXPECT_LT((e.drawn.n - Vec3::UnitZ()).norm(), 1e-15);

  Model from_joints = model;
  for (Rod& rod : from_joints.rods) rod.axes.kind = MaterialAxes::Kind::kJoints;
  const Structure t = built(from_joints);
  for (const StructureEdge& e : t.edges) EXPECT_LT((e.drawn.n - Vec3::UnitZ()).norm(), 1e-9);
}

TEST(Discretize, SplitRodHasTheSameNodesAndFrames) {
  Model one, two;
  one.rods = {straight("whole", Vec3::Zero(), Vec3(0.2, 0, 0), 20)};
  two.rods = {straight("left", Vec3::Zero(), Vec3(0.1, 0, 0), 10),
              straight("right", Vec3(0.1, 0, 0), Vec3(0.2, 0, 0), 10)};
  const Structure s = built(one), t = built(two);
  ASSERT_EQ(s.nodes.size(), t.nodes.size());
  for (size_t i = 0; i < s.nodes.size(); ++i) EXPECT_LT((s.nodes[i] - t.nodes[i]).norm(), 1e-16);
  for (size_t i = 0; i < s.edges.size(); ++i) EXPECT_EQ(s.edges[i].drawn.n, t.edges[i].drawn.n);
  EXPECT_EQ(t.joints.size(), 1u);
  EXPECT_EQ(t.pairs.size() + 1, s.pairs.size());
}

TEST(Discretize, JointKindsAndThroughGoingRods) {
  Model model;
  model.rods = {straight("along", Vec3(-1, 0, 0), Vec3(1, 0, 0), 10),
                straight("across", Vec3::Zero(), Vec3(0, 1, 0), 5)};
  Structure s = built(model);
  ASSERT_EQ(s.joints.size(), 1u);
  EXPECT_EQ(s.joints[0].connections.size(), 3u);
  EXPECT_EQ(s.pairs.size(), 8u + 4);

  model.joint_kind = JointKind::kBall;
  s = built(model);
  EXPECT_TRUE(s.joints.empty());
  EXPECT_EQ(s.pairs.size(), 9u + 4);  // the rod that passes through keeps its pair
  EXPECT_EQ(s.nodes.size(), 16u);

  JointChoice choice;
  choice.at.kind = Selector::Kind::kPoint;
  choice.kind = JointKind::kCorotational;
  model.joints = {choice};
  s = built(model);
  ASSERT_EQ(s.joints.size(), 1u);
  EXPECT_EQ(s.joints[0].kind, JointKind::kCorotational);

  Pose pose;
  pose.supports = {clamp("across", 0)};
  model.poses = {pose};
  s = built(model);
  ASSERT_EQ(s.joints.size(), 1u);
  EXPECT_EQ(s.joints[0].kind, JointKind::kExplicit);
  EXPECT_FALSE(s.joints[0].from_pose);
  EXPECT_EQ(s.notes.size(), 1u);

  model.joints[0].at.point = Vec3(1, 0, 0);
  EXPECT_EQ(refused(model).where, "/joints/0");
}

TEST(Discretize, OnlySupportsThatHoldRotationsMakeJoints) {
  Model model;
  model.rods = {straight("rod", Vec3::Zero(), Vec3(1, 0, 0), 10)};
  Pose pose;
  Support pin = clamp("rod", 0), edge = clamp("rod", 1), free = clamp("rod", 0.5), turned = clamp("rod", 0.2);
  pin.kind = SupportKind::kPin;
  edge.kind = SupportKind::kClampEdge;
  free.kind = turned.kind = SupportKind::kFree;
  free.directions = {Vec3::UnitZ()};
  turned.turn_angle = 1;
  PointMoment moment;
  moment.at = at_fraction("rod", 0.8);
  pose.supports = {pin, edge, free, turned};
  pose.moments = {moment};
  model.poses = {pose};
  const Structure s = built(model);
  ASSERT_EQ(s.joints.size(), 2u);
  EXPECT_EQ(s.joints[0].node, 2);
  EXPECT_EQ(s.joints[1].node, 8);
  EXPECT_EQ(s.pairs.size(), 7u);
}

TEST(Discretize, DirectionParallelToTheRodIsSaid) {
  Model model;
  model.rods = {straight("mast", Vec3::Zero(), Vec3(0, 0, 1), 4)};
  const Structure s = built(model);
  expect_sound(s);
  EXPECT_EQ(s.edges[0].drawn.n, Vec3::UnitX());
  ASSERT_EQ(s.notes.size(), 1u);
  EXPECT_NE(s.notes[0].find("mast"), std::string::npos);
}

TEST(Discretize, AxesFromTheEndsTurnEvenly) {
  Model model;
  // Two crosses in planes that differ by 60 degrees about the rod between them.
  const double c = std::cos(kPi / 3), d = std::sin(kPi / 3);
  model.rods = {straight("link", Vec3::Zero(), Vec3(1, 0, 0), 7), straight("a", Vec3::Zero(), Vec3(0, 1, 0), 2),
                straight("b", Vec3(1, 0, 0), Vec3(1, c, d), 2)};
  for (Rod& rod : model.rods) rod.axes.kind = MaterialAxes::Kind::kJoints;
  const Structure s = built(model);
  expect_sound(s);
  for (const StructurePair& p : s.pairs) {
    if (s.edges[static_cast<size_t>(p.edge0)].rod == 0) EXPECT_NEAR(p.rest_twist, kPi / 18, 1e-12);
  }
  EXPECT_LT((s.edges[0].drawn.n - Vec3::UnitZ()).norm(), 1e-12);
  EXPECT_LT((s.edges[6].drawn.n - Vec3(0, -d, c)).norm(), 1e-12);
}

TEST(Discretize, AxesPerPointTwistAClampedStraightRodInFull) {
  Model model;
  Rod rod = straight("ribbon", Vec3::Zero(), Vec3(1, 0, 0), 20);
  rod.axes.kind = MaterialAxes::Kind::kPerPoint;
  for (int i = 0; i <= 90; ++i) rod.axes.normals.push_back(Vec3(0, std::cos(i * kPi / 180), std::sin(i * kPi / 180)));
  rod.natural.kind = Natural::Kind::kStraight;
  model.rods = {rod};
  Pose pose;
  pose.supports = {clamp("ribbon", 0), clamp("ribbon", 1)};
  model.poses = {pose};
  const Structure s = built(model);
  ASSERT_EQ(s.joints.size(), 2u);
  EXPECT_NEAR(signed_angle(Vec3::UnitX(), s.joints[0].connections[0].rest.n, s.joints[1].connections[0].rest.n),
              kPi / 2, 1e-5);
}

TEST(Discretize, SectionsAreLinearBetweenControls) {
  Model model;
  Rod rod = straight("taper", Vec3::Zero(), Vec3(1, 0, 0), 4);
  rod.section = {SectionShape::kRectangle, {1e-3, 3e-3}, {2e-3, 2e-3}, 0};
  model.rods = {rod};
  const Structure s = built(model);
  EXPECT_NEAR(s.edges[0].section.r_n, 1.25e-3, 1e-18);
  EXPECT_NEAR(s.edges[3].section.r_n, 2.75e-3, 1e-18);
  EXPECT_EQ(s.edges[3].section.shape, SectionShape::kRectangle);
}

TEST(Discretize, RefineMultipliesEdgesAndDefaultsAreSafe) {
  Model model;
  Rod rod = straight("rod", Vec3::Zero(), Vec3(1, 0, 0), 10);
  model.rods = {rod};
  EXPECT_EQ(built(model, 2).edges.size(), 20u);
  EXPECT_EQ(built(model, 0.01).edges.size(), 1u);
  model.rods[0].edges = 0;
  EXPECT_EQ(built(model).edges.size(), 10u);
  model.rods[0].edge_length = 0.06;
  EXPECT_EQ(built(model).edges.size(), 17u);
  model.rods = {make_rod("ring", circle(1, true), 0)};
  EXPECT_EQ(built(model).edges.size(), 36u);
  EXPECT_TRUE(built(model).notes.empty());
  EXPECT_EQ(built(model, 1.0 / 3).notes.size(), 1u);  // 12 edges: 30 degrees each
}

TEST(Discretize, BadInputIsRefusedWithItsPlace) {
  Model model;
  EXPECT_EQ(refused(model).where, "/rods");
  model.rods = {straight("a", Vec3::Zero(), Vec3(1, 0, 0), 4), straight("b", Vec3::Zero(), Vec3(0, 1, 0), 4)};
  Model bad = model;
  bad.rods[1].material = "unobtainium";
  EXPECT_EQ(refused(bad).where, "/rods/1/material");
  bad = model;
  bad.rods[1].section.r_n = {-1};
  EXPECT_EQ(refused(bad).code, ErrorCode::kRange);
  bad = model;
  bad.rods[1].section.r_n = {1e-3, 2e-3};
  EXPECT_EQ(refused(bad).code, ErrorCode::kType);
  bad = model;
  bad.rods[1].curve = Polyline{{Vec3::Zero(), Vec3::Zero()}, false};
  EXPECT_EQ(refused(bad).where, "/rods/1/curve");
  bad = model;
  bad.rods[1].curve = Polyline{{Vec3::Zero(), Vec3::UnitX(), Vec3::Zero()}, false};
  EXPECT_EQ(refused(bad).code, ErrorCode::kGeometry);
  bad = model;
  bad.rods[0].edges = 1000;
  bad.merge_distance = 0.01;
  const Error merged = refused(bad);
  EXPECT_EQ(merged.code, ErrorCode::kGeometry);
  EXPECT_NE(merged.message.find("\"a\""), std::string::npos);
  bad = model;
  bad.merge_distance = 5;
  EXPECT_EQ(refused(bad).where, "/merge_distance");
  bad = model;
  bad.rods[0].edges = 2000000000;
  EXPECT_EQ(refused(bad).code, ErrorCode::kRange);
  bad = model;
  bad.rods[0].natural.kind = Natural::Kind::kCurved;
  bad.rods[0].natural.curvature_n = 100;
  EXPECT_EQ(refused(bad).where, "/rods/0/natural");
  bad = model;
  Pose pose;
  pose.supports = {clamp("c", 0)};
  bad.poses = {pose};
  EXPECT_EQ(refused(bad).where, "/poses/0/supports/0");
}

TEST(Discretize, LargeNetworksTakeLittleTime) {
  Model model;
  constexpr int kSide = 14;  // 14 x 14 cells of 10 edges: about 4,000 nodes, 15,000 degrees of freedom
  for (int i = 0; i <= kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      model.rods.push_back(straight("x", Vec3(j, i, 0), Vec3(j + 1, i, 0), 10));
      model.rods.push_back(straight("y", Vec3(i, j, 0), Vec3(i, j + 1, 0), 10));
    }
  }
  const auto start = std::chrono::steady_clock::now();
  const Structure s = built(model);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  EXPECT_EQ(s.joints.size(), size_t{(kSide + 1) * (kSide + 1)});
  EXPECT_LT(seconds, 0.5);
  RecordProperty("milliseconds", static_cast<int>(seconds * 1000));
}

}  // namespace
}  // namespace lissom
