/// Loads, pins, movements of supports and fabrics as design parameters.

#include <cmath>
#include <gtest/gtest.h>
#include <memory>

#include "lissom/design/design_spaces.h"
#include "lissom/design/load_space.h"
#include "lissom/design/rest_shape.h"
#include "lissom/design/stiffness_spaces.h"
#include "lissom/mechanics/load_numbers.h"
#include "scenes/parts.h"
#include "tests/regression/design_samples.h"
#include "tests/regression/loaded_frame.h"

namespace lissom {
namespace {

using samples::base_of;
using samples::design_at;
using samples::expect_consistent;
using samples::expect_input_jacobian;
using samples::expect_sensitivities;
using samples::loaded_frame;
using samples::made;
using samples::uneven;

constexpr JointKind kJoints[] = {JointKind::kExplicit, JointKind::kCorotational};

TEST(LoadSpaces, NumbersAreThoseOfThePose) {
  const auto base = base_of(loaded_frame(JointKind::kExplicit));
  const Pose& pose = base->model.poses[1];
  const LoadNumbers numbers(pose, base->system.structure);
  const VecX values = load_number_values(pose, base->system.structure);
  EXPECT_EQ(Vec3(values.segment<3>(numbers.gravity())), Vec3(0, 0, -9.81));
  EXPECT_EQ(Vec3(values.segment<3>(numbers.force(1))), pose.forces[1].force);
  EXPECT_EQ(values[numbers.pin_stiffness(1)], 25);
  EXPECT_EQ(Vec3(values.segment<3>(numbers.pin_target(0))), *pose.soft_pins[0].target);
  EXPECT_EQ(Vec3(values.segment<3>(numbers.drawn_target(3))), base->system.structure.nodes[3]);
  EXPECT_EQ(numbers.size(), values.size());
  EXPECT_EQ(LoadNumbers(base->model.poses[0], base->system.structure).size(), 0);
}

TEST(LoadSpaces, SensitivitiesToLoadsPinsAndMoves) {
  for (const JointKind joints : kJoints) {
    const auto base = base_of(loaded_frame(joints));
    const auto choice = [](LoadKind kind, int index, LoadPart part, double low, double high) {
      return LoadChoice{kind, 1, index, part, {low, high}};
    };
    const LinearSpace space = made(load_space(
        base,
        {choice(LoadKind::kForce, 0, LoadPart::kY, -2, 2), choice(LoadKind::kForce, 1, LoadPart::kSize, 0, 2),
         choice(LoadKind::kMoment, 0, LoadPart::kX, -0.1, 0.1), choice(LoadKind::kLineLoad, 0, LoadPart::kSize, 0, 5),
         choice(LoadKind::kGravity, 0, LoadPart::kZ, -20, 0),
         choice(LoadKind::kPinStiffness, 0, LoadPart::kSize, 1, 100),
         choice(LoadKind::kPinTarget, 0, LoadPart::kZ, 0, 0.1), choice(LoadKind::kMove, 0, LoadPart::kX, -0.02, 0.02),
         choice(LoadKind::kMove, 1, LoadPart::kX, -0.02, 0.02)}));
    ASSERT_EQ(space.size(), 9);
    EXPECT_EQ(space.start()[0], 0.4);
    EXPECT_NEAR(space.start()[1], std::hypot(0.3, 0.1), 1e-15);
    const VecX p = uneven(space, 0.05);
    const Design design = design_at(space, p);
    const Pose& pose = design.model.poses[1];
    EXPECT_EQ(pose.forces[0].force, Vec3(0.2, p[0], -0.6));
    EXPECT_NEAR(pose.forces[1].force.norm(), p[1], 1e-15);
    EXPECT_EQ(pose.soft_pins[0].target->z(), p[6]);
    EXPECT_EQ(pose.supports[1].move.x(), p[8]);
    EXPECT_EQ(pose.supports[1].move.z(), -2e-3);
    EXPECT_EQ(design.model.poses[0].supports[0].move, base->model.poses[0].supports[0].move);
    expect_sensitivities(space, p, 1, {0, 1, 2, 3, 4, 5, 6, 7, 8}, 0.05);
  }
}

/// Pins without a target and all that is held follow the rest shape; loads and moves are beside it.
TEST(LoadSpaces, TogetherWithTheRestShape) {
  for (const JointKind joints : kJoints) {
    const auto base = base_of(loaded_frame(joints));
    const auto shape = std::make_shared<const LinearSpace>(
        made(rest_shape_space(base, {ControlStage::kMiddle, 0.02, RestShapeGauge::kFree})));
    const auto loads = std::make_shared<const LinearSpace>(
        made(load_space(base, {{LoadKind::kMove, 1, 1, LoadPart::kSize, {0, 0.02}},
                               {LoadKind::kLineLoad, 1, 0, LoadPart::kX, {-5, 5}}})));
    const SumSpace space = made(SumSpace::make({shape, loads}));
    const VecX p = uneven(space, 0.05);
    expect_consistent(space, p);
    // The foot, the knee with its pin, the tip on its rail, the middle of the leg.
    expect_sensitivities(space, p, 1, {0, 2, 3, 5, 6, 8, 10, space.size() - 2, space.size() - 1}, 0.02);
  }
}

TEST(LoadSpaces, WhatCannotBeIsNamed) {
  const auto base = base_of(loaded_frame(JointKind::kExplicit));
  const auto refused = [&](const std::vector<LoadChoice>& choices) {
    const Result<LinearSpace> space = load_space(base, choices);
    EXPECT_FALSE(space);
    return space ? std::string() : space.error().text();
  };
  EXPECT_EQ(refused({{LoadKind::kForce, 1, 2, LoadPart::kX, {0, 1}}}),
            "/poses/1/forces: pose \"loaded\" has no force number 2 (there are 2 in this list)");
  EXPECT_EQ(refused({{LoadKind::kPinTarget, 1, 1, LoadPart::kX, {0, 1}}}),
            "/poses/1/soft_pins: this soft pin pulls towards where its nodes are drawn (give it a target)");
  EXPECT_EQ(refused({{LoadKind::kGravity, 0, 0, LoadPart::kSize, {0, 1}}}),
            "/poses/0/gravity: pose \"other\" has no gravity number 0 (there are 0 in this list)");
  EXPECT_EQ(
      refused({{LoadKind::kForce, 1, 0, LoadPart::kX, {0, 1}}, {LoadKind::kForce, 1, 0, LoadPart::kSize, {0, 1}}}),
      "/poses/1/forces: force 0 is chosen in more than one way (choose it once)");
  EXPECT_FALSE(load_space(base, {{LoadKind::kForce, 7, 0, LoadPart::kX, {0, 1}}}));
  EXPECT_FALSE(load_space(base, {{LoadKind::kForce, 1, 0, LoadPart::kX, {1, 2}}}));  // 0.2 N now
  EXPECT_FALSE(load_space(base, {}));
}

/// A cloth clamped along two edges, sagging and bending.
Model cloth() {
  Model model;
  model.membrane_materials.push_back({"cloth", 400, 700, 0.3, 3e-3, 0.5, "test"});
  Membrane sheet;
  sheet.name = "sheet";
  sheet.material = "cloth";
  sheet.warp_angle = 0.3;
  sheet.pre_stretch = {1.03, 1.02};
  sheet.shape = MembraneGrid{{0, 0}, {0.12, 0.1}, 5, 4};
  model.membranes.push_back(sheet);
  Pose pose;
  pose.name = "hung";
  for (const double x : {0.0, 0.12}) {
    Support pin;
    pin.kind = SupportKind::kPin;
    pin.at = scene_models::box(Vec3(x - 1e-6, -1, -1), Vec3(x + 1e-6, 1, 1));
    pose.supports.push_back(pin);
  }
  Support row;  // the row of nodes next to an edge too: a clamp
  row.kind = SupportKind::kPin;
  row.at = scene_models::box(Vec3(0.02, -1, -1), Vec3(0.03, 1, 1));
  pose.supports.push_back(row);
  pose.gravity = Gravity{};
  PointForce pull;
  pull.at = scene_models::box(Vec3(0.06, 0.09, -1), Vec3(0.08, 0.11, 1));
  pull.force = {0, 0.1, -0.5};
  pose.forces = {pull};
  model.poses.push_back(pose);
  return model;
}

TEST(LoadSpaces, SensitivitiesToFabrics) {
  const auto base = base_of(cloth());
  const LinearSpace space = made(fabric_space(base, {{SheetProperty::kStiffness1, {100, 900}},
                                                     {SheetProperty::kStiffness2, {100, 900}},
                                                     {SheetProperty::kPoissonRatio, {0.05, 0.5}},
                                                     {SheetProperty::kThickness, {1e-3, 5e-3}},
                                                     {SheetProperty::kPreStretch, {1.01, 1.2}}}));
  ASSERT_EQ(space.size(), 5);
  const VecX p = uneven(space, 0.05);
  expect_consistent(space, p);
  expect_input_jacobian(space, p);
  expect_sensitivities(space, p, 0, {0, 1, 2, 3, 4}, 0.02);
  const LinearSpace both = made(fabric_space(base, {{SheetProperty::kStiffness, {100, 900}}}));
  const Design design = design_at(both, VecX::Constant(1, 800));
  EXPECT_EQ(design.model.membrane_materials[0].stiffness_1, 800);
  EXPECT_EQ(design.model.membrane_materials[0].stiffness_2, 1400);
  EXPECT_FALSE(fabric_space(base, {{SheetProperty::kStiffness, {100, 900}}, {SheetProperty::kStiffness2, {100, 900}}}));
}

/// Two cloths of one fabric keep it in common.
TEST(LoadSpaces, FabricsAreSharedOut) {
  Model model = cloth();
  Membrane other = model.membranes[0];
  other.name = "other";
  other.shape = MembraneGrid{{0.2, 0}, {0.12, 0.1}, 5, 4};
  model.membranes.push_back(other);
  model.poses.clear();
  const auto base = base_of(model);
  const LinearSpace fabric = made(fabric_space(base, {{SheetProperty::kThickness, {1e-3, 5e-3}}}));
  EXPECT_EQ(fabric.size(), 1);
  const LinearSpace stretch = made(fabric_space(base, {{SheetProperty::kPreStretch1, {1.01, 1.2}}}));
  EXPECT_EQ(stretch.size(), 2);
  expect_consistent(stretch, uneven(stretch));
  // Each with a thickness of its own, as a sum of spaces might ask for.
  DesignValues values = values_of(*base);
  values.inputs[RestInputs(base->system.structure).thickness(1)] = 1e-3;
  const Result<Design> design = with_values(*base, values);
  ASSERT_TRUE(design) << design.error().text();
  EXPECT_EQ(design.value().model.membranes[0].material, "cloth");
  EXPECT_EQ(design.value().model.membranes[1].material, "cloth of other");
  EXPECT_EQ(design.value().model.membrane_material("cloth of other")->thickness, 1e-3);
  EXPECT_EQ(design.value().model.membrane_material("cloth")->thickness, 3e-3);
}

}  // namespace
}  // namespace lissom
