/// Design spaces of rod networks: radii, rest shapes, moduli and natural shapes, alone and together.

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <string>

#include "lissom/design/design_spaces.h"
#include "lissom/design/network_radii.h"
#include "lissom/design/rest_shape.h"
#include "lissom/design/stiffness_spaces.h"
#include "scenes/parts.h"
#include "tests/regression/design_samples.h"

namespace lissom {
namespace {

using samples::base_of;
using samples::design_at;
using samples::expect_consistent;
using samples::expect_input_jacobian;
using samples::expect_sensitivities;
using samples::made;
using samples::uneven;

/// Hexagons that are not quite flat and held at both ends, so that frames, twists and clamps all matter. `axes`: of the rods.
Model sheet(JointKind joints, MaterialAxes::Kind axes = MaterialAxes::Kind::kDirection) {
  const ObjLines lines = hexagon_pattern(0.02, 2, 2);
  Model model = scene_models::sheet("sheet", lines, 1.5e-3, "TPU 92A", 4);
  for (Rod& rod : model.rods) {
    auto& line = std::get<Polyline>(rod.curve);
    const auto lifted = [](Vec3 x) {
      x.z() = 6 * x.x() * x.y() + 2 * x.x() * x.x();
      return x;
    };
    const Vec3 a = line.points.front(), b = line.points.back();
    line.points = {lifted(a), lifted(0.5 * (a + b)) + Vec3(0, 0, 5e-4), lifted(b)};
    rod.axes.kind = axes;
    rod.axes.normal = Vec3(0.1, -0.2, 1).normalized();
  }
  model.joint_kind = joints;
  Pose pose = scene_models::hanging_pose(lines, 1e-6);
  for (Support& support : pose.supports) {
    for (Selector& part : support.at.parts) {
      part.low.z() = -1;
      part.high.z() = 1;
    }
    support.at.low.z() = -1;
    support.at.high.z() = 1;
  }
  model.poses.push_back(pose);
  return model;
}

constexpr JointKind kJoints[] = {JointKind::kExplicit, JointKind::kCorotational};

TEST(NetworkSpaces, RadiiMakeConsistentDesigns) {
  for (const JointKind joints : kJoints) {
    const auto base = base_of(sheet(joints, MaterialAxes::Kind::kJoints));
    const LinearSpace space = made(radii_space(base, ControlStage::kThirds, {1e-3, 4e-3}));
    EXPECT_NEAR(space.start().minCoeff(), 1.5e-3, 1e-15);
    EXPECT_NEAR(space.start().maxCoeff(), 1.5e-3, 1e-15);
    expect_consistent(space, uneven(space));
    expect_input_jacobian(space, uneven(space));
  }
}

TEST(NetworkSpaces, RadiiStartFromTheNearestOfTheSpace) {
  Model model = sheet(JointKind::kExplicit);
  for (Rod& rod : model.rods) {
    rod.section.r_n = {1.2e-3, 2.4e-3, 1.8e-3};
    rod.section.r_b = {5e-3, 5e-3, 5e-3};
  }
  const LinearSpace space = made(radii_space(base_of(model), ControlStage::kThirds, {1e-3, 4e-3}));
  const int controls = space.size() / 2;
  EXPECT_EQ(space.start().tail(controls).minCoeff(), 4e-3);  // clipped
  const VecX start = space.start();
  const Design design = design_at(space, start);
  // No other radii of the space are nearer: the residual is orthogonal to it.
  const DesignJacobian jacobian = space.jacobian(design, start);
  const VecX miss = rest_input_values(design.model, design.system) - rest_input_values(model, base_of(model)->system);
  EXPECT_LT((jacobian.inputs.transpose() * miss).head(controls).cwiseAbs().maxCoeff(),
            1e-9 * miss.cwiseAbs().maxCoeff());
  // A design of the space is found again.
  const VecX p = uneven(space, 0.02);
  const Design other = design_at(space, p);
  const LinearSpace again = made(radii_space(base_of(other.model), ControlStage::kThirds, {1e-3, 4.5e-3}));
  EXPECT_LT((again.start() - p).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(NetworkSpaces, RestShapesMakeConsistentDesigns) {
  for (const MaterialAxes::Kind axes :
       {MaterialAxes::Kind::kDirection, MaterialAxes::Kind::kTransport, MaterialAxes::Kind::kJoints}) {
    for (const JointKind joints : kJoints) {
      const auto base = base_of(sheet(joints, axes));
      const LinearSpace space = made(rest_shape_space(base, {ControlStage::kThirds, 5e-3}));
      EXPECT_EQ(space.start(), VecX::Zero(space.size()));
      const Design start = design_at(space, space.start());
      samples::expect_same_numbers(base->system.structure, rest_number_values(start.system),
                                   rest_number_values(base->system), 1e-12);
      expect_consistent(space, uneven(space, 0.05));
      // Not moved by more than nothing: the rods of the base.
      VecX hardly = space.start();
      hardly[7] = 1e-16;
      const Design converted = design_at(space, hardly);
      samples::expect_same_numbers(base->system.structure, rest_number_values(converted.system),
                                   rest_number_values(base->system), 1e-12);
      expect_consistent(space, hardly);
    }
  }
}

TEST(NetworkSpaces, TheGaugeOfRestShapesLeavesNoRigidMotion) {
  const auto base = base_of(sheet(JointKind::kExplicit));
  const LinearSpace space = made(rest_shape_space(base, {ControlStage::kMiddle, 5e-3}));
  const LinearSpace open = made(rest_shape_space(base, {ControlStage::kMiddle, 5e-3, RestShapeGauge::kFree}));
  EXPECT_EQ(open.size(), space.size() + 6);
  // Rigid velocity fields of the nodes against those that the space can make.
  const int nodes = static_cast<int>(base->system.structure.nodes.size());
  MatX rigid = MatX::Zero(3 * nodes, 6);
  for (int i = 0; i < nodes; ++i) {
    for (int k = 0; k < 3; ++k) {
      rigid(3 * i + k, k) = 1;
      rigid.block<3, 1>(3 * i, 3 + k) = 10 * Vec3::Unit(k).cross(base->system.structure.nodes[i]);
    }
  }
  MatX both(3 * nodes, 6 + space.size());
  both << rigid, MatX(space.rows().inputs.topRows(3 * nodes));
  EXPECT_EQ(Eigen::ColPivHouseholderQR<MatX>(both).rank(), 6 + space.size());
}

TEST(NetworkSpaces, SensitivitiesToRadii) {
  for (const JointKind joints : kJoints) {
    const auto base = base_of(sheet(joints));
    const LinearSpace space = made(radii_space(base, ControlStage::kThirds, {1e-3, 4e-3}));
    expect_sensitivities(space, uneven(space), 0, {0, space.size() - 1}, 0.1);
  }
}

TEST(NetworkSpaces, SensitivitiesToRestShapes) {
  for (const JointKind joints : kJoints) {
    const auto base = base_of(sheet(joints, MaterialAxes::Kind::kJoints));
    const LinearSpace space = made(rest_shape_space(base, {ControlStage::kThirds, 5e-3, RestShapeGauge::kFree}));
    // Ends that are held, ends that are not, and controls between.
    expect_sensitivities(space, uneven(space, 0.03), 0, {0, 1, 2, 20, space.size() - 1}, 0.05);
  }
}

/// Where nothing has moved yet, too: normals from joints or from transport follow the nodes, those of the space do not.
TEST(NetworkSpaces, SensitivitiesToRestShapesAtTheStart) {
  for (const MaterialAxes::Kind axes : {MaterialAxes::Kind::kTransport, MaterialAxes::Kind::kJoints}) {
    const auto base = base_of(sheet(JointKind::kExplicit, axes));
    const LinearSpace space = made(rest_shape_space(base, {ControlStage::kMiddle, 5e-3, RestShapeGauge::kFree}));
    expect_sensitivities(space, space.start(), 0, {1, 2, 20}, 0.05);
    // Also where another space has made the design.
    const SumSpace both =
        SumSpace::make({std::make_shared<LinearSpace>(made(radii_space(base, ControlStage::kEnds, {1e-3, 4e-3}))),
                        std::make_shared<LinearSpace>(space)})
            .value();
    expect_sensitivities(both, both.start(), 0, {both.size() - space.size() + 2}, 0.05);
  }
}

TEST(NetworkSpaces, SensitivitiesToModuli) {
  const auto base = base_of(sheet(JointKind::kCorotational));
  const LinearSpace one = made(youngs_modulus_space(base, ModulusChoice::kPerMaterial, {5e6, 80e6}));
  EXPECT_EQ(one.size(), 1);
  expect_consistent(one, uneven(one));
  expect_sensitivities(one, one.start(), 0, {0}, 0.1);
  const LinearSpace each = made(youngs_modulus_space(base, ModulusChoice::kPerRod, {5e6, 80e6}));
  expect_consistent(each, uneven(each));
  expect_input_jacobian(each, uneven(each));
  expect_sensitivities(each, uneven(each), 0, {0, each.size() - 1}, 0.1);
}

TEST(NetworkSpaces, NaturalShapes) {
  for (const JointKind joints : kJoints) {
    Model model = sheet(joints, MaterialAxes::Kind::kJoints);
    for (Rod& rod : model.rods) rod.natural.kind = Natural::Kind::kStraight;
    model.rods[1].natural.kind = Natural::Kind::kCurved;
    model.rods[1].natural.curvature_b = 8;
    model.rods[1].natural.length_factor = 1.02;
    const auto base = base_of(model);
    const LinearSpace space = made(natural_shape_space(base, {},
                                                       {{NaturalProperty::kCurvatureB, {-20, 20}},
                                                        {NaturalProperty::kCurvatureN, {-20, 20}},
                                                        {NaturalProperty::kTwist, {-20, 20}},
                                                        {NaturalProperty::kLengthFactor, {0.9, 1.1}}}));
    const int rods = static_cast<int>(model.rods.size());
    ASSERT_EQ(space.size(), 4 * rods);
    EXPECT_EQ(space.start()[1], 8);
    expect_consistent(space, space.start());
    const VecX p = uneven(space, 0.1);
    expect_consistent(space, p);
    expect_input_jacobian(space, p);
    expect_sensitivities(space, p, 0, {2, rods + 3, 2 * rods + 1, 3 * rods + 4}, 0.05);
  }
}

TEST(NetworkSpaces, TheLengthOfACantilever) {
  Model model;
  model.rods.push_back(
      scene_models::round_rod("beam", Polyline{{Vec3(0.1, 0, 0), Vec3(0.3, 0, 0.05)}}, 2e-3, "PLA", 8));
  Pose pose;
  pose.name = "loaded";
  pose.supports.push_back(scene_models::hold(scene_models::rod_place("beam", 0), SupportKind::kClamp));
  PointForce tip;
  tip.at = scene_models::rod_place("beam", 1);
  tip.force = {0, 0.3, -1.5};
  pose.forces.push_back(tip);
  pose.gravity = Gravity{};
  model.poses.push_back(pose);
  const auto base = base_of(model);
  const LinearSpace space = made(straight_length_space(base, {"beam"}, {0.5, 2}));
  const double length = std::hypot(0.2, 0.05);
  EXPECT_NEAR(space.start()[0], length, 1e-15);
  EXPECT_EQ(space.parameters()[0].kind, ParameterKind::kLength);
  const VecX longer = VecX::Constant(1, 1.3 * length);
  expect_consistent(space, longer);
  expect_sensitivities(space, longer, 0, {0}, 0.05);
  EXPECT_NEAR(design_at(space, longer).system.structure.edges[5].rest_length, 1.3 * length / 8, 1e-15);
}

TEST(NetworkSpaces, TogetherAndTied) {
  for (const JointKind joints : kJoints) {
    const auto base = base_of(sheet(joints, MaterialAxes::Kind::kTransport));
    const auto radii =
        std::make_shared<const LinearSpace>(made(radii_space(base, ControlStage::kMiddle, {1e-3, 4e-3})));
    const auto shape = std::make_shared<const LinearSpace>(made(rest_shape_space(base, {ControlStage::kEnds, 5e-3})));
    const auto moduli =
        std::make_shared<const LinearSpace>(made(youngs_modulus_space(base, ModulusChoice::kPerMaterial, {5e6, 80e6})));
    const SumSpace all = made(SumSpace::make({radii, shape, moduli}));
    ASSERT_EQ(all.size(), radii->size() + shape->size() + 1);
    const VecX p = uneven(all, 0.04);
    expect_consistent(all, p);
    expect_input_jacobian(all, p);
    expect_sensitivities(all, p, 0, {1, radii->size() + 4, all.size() - 1}, 0.05);
    const Result<SumSpace> twice = SumSpace::make({radii, moduli, radii});
    ASSERT_FALSE(twice);
    EXPECT_EQ(twice.error().code, ErrorCode::kConflict);

    const auto sum = std::make_shared<const SumSpace>(all);
    const MappedSpace factor = made(common_factor(radii, "all radii"));
    EXPECT_NEAR(factor.start()[0], 1, 1e-12);
    EXPECT_NEAR(factor.parameters()[0].lower, 1e-3 / 1.5e-3, 1e-12);
    EXPECT_NEAR(factor.parameters()[0].upper, 4e-3 / 1.5e-3, 1e-12);
    expect_consistent(factor, VecX::Constant(1, factor.parameters()[0].upper));
    const MappedSpace tied = made(tied_parameters(sum, {{0, 3, 2}, {radii->size() + 1, radii->size() + 5}}));
    EXPECT_EQ(tied.size(), all.size() - 3);
    expect_input_jacobian(tied, uneven(tied, 0.04));
    expect_sensitivities(tied, uneven(tied, 0.04), 0, {0}, 0.05);
    const MappedSpace some = made(chosen_parameters(sum, {2, all.size() - 1}));
    EXPECT_EQ(some.inner_parameters(some.start()), all.start());
    expect_input_jacobian(some, uneven(some));
  }
}

TEST(NetworkSpaces, SpectralSpacesAskForReach) {
  const auto base = base_of(sheet(JointKind::kExplicit));
  const auto radii = std::make_shared<const LinearSpace>(made(radii_space(base, ControlStage::kEnds, {1e-3, 4e-3})));
  MatX z(radii->size(), 2);
  for (int i = 0; i < z.rows(); ++i) z.row(i) << std::sin(0.4 * i), std::cos(0.7 * i);
  const MappedSpace space = made(spectral_space(radii, z, Vec2(1e-4, 1e-4), Vec2(3e-4, 1e-3), "slow direction"));
  EXPECT_EQ(space.start(), VecX::Zero(2));
  expect_consistent(space, Vec2(2e-4, -1e-4));
  expect_input_jacobian(space, Vec2(2e-4, -1e-4));
  const Result<Design> outside = space.at(Vec2(0, 9e-4));  // within its own bounds, not within those of the radii
  ASSERT_FALSE(outside);
  EXPECT_EQ(outside.error().code, ErrorCode::kRange);
  std::vector<Parameter> open(2);
  open[0].name = "a";
  open[0].scale = 0;
  open[1] = open[0];
  const Result<MappedSpace> none = MappedSpace::make(radii, radii->start(), z.sparseView(), open);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, ErrorCode::kUnsupported);
}

TEST(NetworkSpaces, MirrorImagesAreTied) {
  Model model = scene_models::sheet("sheet", square_pattern(0.02, 2, 3), 1.5e-3, "TPU 92A", 4);
  const auto base = base_of(model);
  Vec3 middle = Vec3::Zero();
  Eigen::AlignedBox3d box;
  for (const Vec3& node : base->system.structure.nodes) box.extend(node);
  middle = box.center();
  const auto shape = std::make_shared<const LinearSpace>(
      made(rest_shape_space(base, {ControlStage::kThirds, 5e-3, RestShapeGauge::kFree})));
  const MappedSpace half = made(mirrored(shape, Vec3::UnitY(), middle.y(), 1e-9));
  EXPECT_LT(half.size(), shape->size());
  const Design design = design_at(half, uneven(half, 0.1));
  // The moved drawing is its own mirror image.
  for (const Vec3& node : design.system.structure.nodes) {
    const Vec3 image(node.x(), 2 * middle.y() - node.y(), node.z());
    double nearest = 1;
    for (const Vec3& other : design.system.structure.nodes) nearest = std::min(nearest, (other - image).norm());
    EXPECT_LT(nearest, 1e-14);
  }
  const Result<MappedSpace> off = mirrored(shape, Vec3::UnitY(), middle.y() + 1e-3, 1e-9);
  ASSERT_FALSE(off);
  EXPECT_EQ(off.error().code, ErrorCode::kGeometry);
  const auto radii = std::make_shared<const LinearSpace>(made(radii_space(base, ControlStage::kThirds, {1e-3, 4e-3})));
  const MappedSpace round = made(mirrored(radii, Vec3::UnitY(), middle.y(), 1e-9));
  EXPECT_LT(round.size(), radii->size());
  expect_input_jacobian(round, uneven(round, 0.05));
  const Structure thick = design_at(round, uneven(round, 0.05)).system.structure;
  const auto centre = [&](const StructureEdge& e) -> Vec3 {
    return 0.5 * (thick.nodes[e.node0] + thick.nodes[e.node1]);
  };
  int compared = 0;
  for (const StructureEdge& edge : thick.edges) {
    const Vec3 at = centre(edge), image(at.x(), 2 * middle.y() - at.y(), at.z());
    for (const StructureEdge& other : thick.edges) {
      if ((centre(other) - image).norm() > 1e-9) continue;
      EXPECT_NEAR(edge.section.r_n, other.section.r_n, 1e-15);
      EXPECT_NEAR(edge.section.r_b, other.section.r_b, 1e-15);
      ++compared;
    }
  }
  EXPECT_EQ(compared, static_cast<int>(thick.edges.size()));
}

TEST(NetworkSpaces, WhatCannotBeIsNamed) {
  const auto base = base_of(sheet(JointKind::kExplicit));
  const LinearSpace space = made(rest_shape_space(base, {ControlStage::kEnds, 5e-3}));
  VecX p = space.start();
  p[3] = 6e-3;
  const Result<Design> outside = space.at(p);
  ASSERT_FALSE(outside);
  EXPECT_EQ(outside.error().code, ErrorCode::kRange);
  EXPECT_EQ(outside.error().message, space.parameters()[3].name + " is 6 mm, outside of -5 to 5 mm");
  p[3] = NAN;
  EXPECT_FALSE(space.at(p));
  Model straight = base->model;
  straight.rods[0].natural.kind = Natural::Kind::kStraight;
  EXPECT_FALSE(rest_shape_space(base_of(straight), {ControlStage::kEnds, 5e-3}));
  EXPECT_FALSE(rest_shape_space(base, {ControlStage::kEnds, 0}));
  EXPECT_FALSE(natural_shape_space(base, {}, {{NaturalProperty::kTwist, {-1, 1}}}));
  EXPECT_FALSE(natural_shape_space(base, {"no such rod"}, {{NaturalProperty::kLengthFactor, {0.5, 2}}}));
  const std::string curved = base->system.structure.rods[0].name;
  EXPECT_FALSE(straight_length_space(base, {curved}, {0.5, 2}));
  // A rod whose end is moved onto its start.
  Model single;
  single.rods.push_back(scene_models::round_rod("beam", Polyline{{Vec3::Zero(), Vec3(0.1, 0, 0)}}, 1e-3, "PLA", 4));
  const LinearSpace wide = made(rest_shape_space(base_of(single), {ControlStage::kEnds, 0.2, RestShapeGauge::kFree}));
  VecX far = wide.start();
  far[3] = -0.1;
  const Result<Design> broken = wide.at(far);
  ASSERT_FALSE(broken);
  EXPECT_EQ(broken.error().message, "an edge of rod \"beam\" would lose its length");
}

}  // namespace
}  // namespace lissom
