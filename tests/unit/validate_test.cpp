#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <string>

#include "lissom/model/model.h"

// Designated initialisers leave members at their defaults on purpose.
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"

namespace lissom {
namespace {

const double kNan = std::nan("");
const double kInfinity = std::numeric_limits<double>::infinity();

/// A model that says a little of everything and is valid.
Model valid() {
  Model m;
  m.materials = {{.name = "own/1", .youngs_modulus = 1e9, .poisson_ratio = 0.3, .density = 1000}};
  Rod rod{.name = "beam", .curve = Polyline{{Vec3(0, 0, 0), Vec3(1, 0, 0)}}, .material = "own/1", .edges = 4};
  rod.section.r_n = rod.section.r_b = {0.001};
  Rod ring = rod;
  ring.name = "ring";
  ring.curve = Arc{.centre = Vec3(0, 0, 1), .start = Vec3(1, 0, 1), .angle = 3};
  m.rods = {rod, ring};
  const Selector tip{.kind = Selector::Kind::kRod, .name = "beam", .fraction = 1};
  m.sets = {{"tip", tip}};
  Pose pose{.name = "p"};
  pose.supports = {{.at = {.kind = Selector::Kind::kSet, .name = "tip"}, .kind = SupportKind::kClamp}};
  pose.soft_pins = {{.at = tip, .stiffness = 1}};
  pose.forces = {{.at = tip}};
  pose.moments = {{.at = tip}};
  pose.line_loads = {{.rods = {"ring"}}};
  pose.gravity = Gravity();
  pose.path = LoadPath();
  pose.seed = Seed();
  m.poses = {pose};
  m.motions = {{.name = "m", .pose = "p", .duration = 1, .step = 0.1, .kicks = {{.at = tip}}}};
  m.expectations = {{.quantity = "displacement", .at = tip, .value = {1}, .unit = "mm", .tolerance_relative = 0.01}};
  return m;
}

struct Mistake {
  const char* where;
  std::function<void(Model&)> make;
};

TEST(Validate, AValidModelIsAccepted) {
  const Status status = valid().validate();
  EXPECT_TRUE(status) << status.error().text();
}

/// What a program can put into a model besides what a document can say, and the place where it is reported.
TEST(Validate, MistakesAreReportedWhereTheDocumentWouldSayThem) {
  const std::vector<Mistake> mistakes = {
      {"/materials/own~11", [](Model& m) { m.materials[0].youngs_modulus = kNan; }},
      {"/materials/own~11", [](Model& m) { m.materials.push_back(m.materials[0]); }},
      {"/rods/1/name", [](Model& m) { m.rods[1].name = "beam"; }},
      {"/rods/0/name", [](Model& m) { m.rods[0].name.clear(); }},
      {"/rods/0/line/1",
       [](Model& m) {
         m.rods[0].curve = Polyline{{Vec3(0, 0, 0), Vec3(kNan, 0, 0)}};
       }},
      {"/rods/0/spline", [](Model& m) { m.rods[0].curve = Spline{{Vec3(0, 0, 0)}}; }},
      {"/rods/1/arc/angle", [](Model& m) { std::get<Arc>(m.rods[1].curve).angle = kInfinity; }},
      {"/rods/1/arc/axis", [](Model& m) { std::get<Arc>(m.rods[1].curve).axis.setZero(); }},
      {"/rods/0/material", [](Model& m) { m.rods[0].material = "wood"; }},
      {"/rods/0/section/radius", [](Model& m) { m.rods[0].section.r_n = m.rods[0].section.r_b = {kInfinity}; }},
      {"/rods/0/section/r_b", [](Model& m) { m.rods[0].section.r_b = {0.0}; }},
      {"/rods/0/section",
       [](Model& m) {
         m.rods[0].section.r_b = {1, 1};
       }},
      {"/rods/0/section", [](Model& m) { m.rods[0].section = {}; }},
      {"/rods/0/axes/normal", [](Model& m) { m.rods[0].axes.normal.setZero(); }},
      {"/rods/0/axes/per_point", [](Model& m) { m.rods[0].axes.kind = MaterialAxes::Kind::kPerPoint; }},
      {"/rods/0/natural/curve", [](Model& m) { m.rods[0].natural.kind = Natural::Kind::kCurve; }},
      {"/rods/0/natural/twist",
       [](Model& m) { m.rods[0].natural = {.kind = Natural::Kind::kCurved, .twist = kInfinity}; }},
      {"/rods/0", [](Model& m) { m.rods[0].edges = 0; }},
      {"/rods/0/edges", [](Model& m) { m.rods[0].edges = -3; }},
      {"/rods", [](Model& m) { m.rods.clear(); }},
      {"/joints/merge_distance", [](Model& m) { m.merge_distance = kNan; }},
      {"/joints/exceptions/0/at", [](Model& m) { m.joints = {{.at = {.kind = Selector::Kind::kSet, .name = "tpi"}}}; }},
      {"/sets/tip/rod", [](Model& m) { m.sets[0].nodes.name = "bream"; }},
      {"/sets/tip/at", [](Model& m) { m.sets[0].nodes.fraction = 1.5; }},
      {"/sets/tip", [](Model& m) { m.sets[0].nodes = {.kind = Selector::Kind::kUnion}; }},
      {"/sets/tip/point",
       [](Model& m) { m.sets[0].nodes = {.kind = Selector::Kind::kPoint, .point = Vec3(0, kNan, 0)}; }},
      {"/sets/joints", [](Model& m) { m.sets[0].name = "joints"; }},
      {"/poses/1/name", [](Model& m) { m.poses.push_back({.name = "p"}); }},
      {"/poses/0/supports/0/move", [](Model& m) { m.poses[0].supports[0].move[1] = kNan; }},
      {"/poses/0/supports/0/turn/angle", [](Model& m) { m.poses[0].supports[0].turn_angle = kInfinity; }},
      {"/poses/0/supports/0/hold",
       [](Model& m) {
         m.poses[0].supports[0].kind = SupportKind::kFree;
         m.poses[0].supports[0].directions = {Vec3(2, 0, 0)};
       }},
      {"/poses/0/supports/0/hold", [](Model& m) { m.poses[0].supports[0].kind = SupportKind::kFree; }},
      {"/poses/0/supports/1", [](Model& m) { m.poses[0].supports.push_back(m.poses[0].supports[0]); }},
      {"/poses/0/soft_pins/0/stiffness", [](Model& m) { m.poses[0].soft_pins[0].stiffness = -1; }},
      {"/poses/0/forces/0/force", [](Model& m) { m.poses[0].forces[0].force[0] = kNan; }},
      {"/poses/0/moments/0/moment", [](Model& m) { m.poses[0].moments[0].moment[0] = kNan; }},
      {"/poses/0/line_loads/0/rods/0", [](Model& m) { m.poses[0].line_loads[0].rods[0] = "wring"; }},
      {"/poses/0/gravity", [](Model& m) { m.materials[0].density = 0; }},
      {"/poses/0/path/to", [](Model& m) { m.poses[0].path->to = kNan; }},
      {"/poses/0/path/steps", [](Model& m) { m.poses[0].path->steps = 0; }},
      {"/poses/0/seed/amplitude", [](Model& m) { m.poses[0].seed->amplitude = kNan; }},
      {"/motions/0/pose", [](Model& m) { m.motions[0].pose = "q"; }},
      {"/motions/0/step", [](Model& m) { m.motions[0].step = 2; }},
      {"/motions/0/duration", [](Model& m) { m.motions[0].duration = kNan; }},
      {"/motions/0/load_factor/1",
       [](Model& m) {
         m.motions[0].load_factor = {Vec2(0, 1), Vec2(0, 2)};
       }},
      {"/motions/0/kicks/0/velocity", [](Model& m) { m.motions[0].kicks[0].velocity[2] = kInfinity; }},
      {"/expect/0/pose", [](Model& m) { m.expectations[0].poses = {"q"}; }},
      {"/expect/0/axis", [](Model& m) { m.expectations[0].axis = Vec3(1, 1, 0); }},
      {"/expect/0/value", [](Model& m) { m.expectations[0].value = {kNan}; }},
      {"/expect/0/value", [](Model& m) { m.expectations[0].value.clear(); }},
      {"/expect/0/unit", [](Model& m) { m.expectations[0].unit = "millimetre"; }},
      {"/expect/0/tolerance", [](Model& m) { m.expectations[0].tolerance_absolute = 1; }},
      {"/expect/0/tolerance", [](Model& m) { m.expectations[0].tolerance_relative = 0; }},
  };
  for (std::size_t i = 0; i < mistakes.size(); ++i) {
    SCOPED_TRACE("mistake " + std::to_string(i) + " at " + mistakes[i].where);
    Model model = valid();
    mistakes[i].make(model);
    const Status status = model.validate();
    ASSERT_FALSE(status);
    EXPECT_EQ(status.error().where, mistakes[i].where) << status.error().text();
    EXPECT_FALSE(status.error().message.empty());
  }
}

}  // namespace
}  // namespace lissom
