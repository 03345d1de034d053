// What tools keep, and the plan as the page draws it.

#include "lissom/editing/tool_constraints.h"

#include <gtest/gtest.h>

#include "lissom/editing/edits_json.h"
#include "lissom/editing/plan_json.h"
#include "lissom/editing/templates.h"
#include "lissom/model/document.h"
#include "tests/unit/edit_samples.h"

namespace lissom {
namespace {

using edit_samples::done;
using edit_samples::Json;
using edit_samples::model;
using edit_samples::Names;
using edit_samples::point;
using edit_samples::refused;

TEST(ToolConstraints, LiveInNamedSets) {
  const EditOutcome out = done({{"name", "set_constraints"},
                                {"pinned", {"a", "b"}},
                                {"attached", Json::array({Json::array({"c", "d"})})},
                                {"in_plane", {{"a", "b", "m"}}},
                                {"symmetric", {{"axis", "x"}, {"at_mm", 30}}}});
  EXPECT_EQ(out.title, "Change what is kept");
  const Result<Model> again = read_document(write_document(out.model));
  ASSERT_TRUE(again);
  const ToolConstraints all = constraints_of(again.value());
  EXPECT_EQ(all.pinned, (Names{"a", "b"}));
  ASSERT_EQ(all.attached.size(), 1U);
  ASSERT_EQ(all.in_plane.size(), 1U);
  ASSERT_TRUE(all.symmetric);
  EXPECT_EQ(all.symmetric->axis, 0);
  EXPECT_EQ(all.symmetric->at, 0.03);
  EXPECT_EQ(out.model.sets.size(), 6U);

  const EditOutcome fewer = done(out.model, {{"name", "set_constraints"}, {"pinned", {"a"}}, {"symmetric", nullptr}});
  EXPECT_FALSE(constraints_of(fewer.model).symmetric);
  EXPECT_EQ(constraints_of(fewer.model).attached.size(), 1U) << "what is not given stays";
  const EditOutcome unpinned = done(out.model, {{"name", "set_constraints"}, {"pinned", {"a"}}});
  EXPECT_EQ(unpinned.title, "Unpin point b");

  const EditOutcome gone = done(out.model, {{"name", "remove"}, {"points", {"m"}}});
  EXPECT_TRUE(constraints_of(gone.model).in_plane.empty()) << "two points are in a plane anyhow";
  const EditOutcome renamed = done(out.model, {{"name", "rename"}, {"point", "a"}, {"to", "z"}});
  EXPECT_EQ(constraints_of(renamed.model).pinned, (Names{"z", "b"}));
  EXPECT_EQ(refused({{"name", "set_constraints"}, {"attached", Json::array({Json::array({"c"})})}}).where,
            "/edit/attached/0");
  EXPECT_EQ(refused({{"name", "set_constraints"}, {"symmetric", {{"axis", "z"}}}}).where, "/edit/symmetric/axis");
}

TEST(ToolConstraints, LeaveTheUsersSetsAlone) {
  Model own = model();
  own.sets[0].name = "pinned";
  own.sets[0].nodes.kind = Selector::Kind::kAll;
  own.poses[0].supports[0].at.name = "pinned";
  EXPECT_TRUE(constraints_of(own).none());
  EXPECT_EQ(refused(own, {{"name", "set_constraints"}, {"pinned", {"a"}}}).where, "/sets/pinned");
  EXPECT_TRUE(apply_edit(own, {{"name", "set_constraints"}, {"attached", Json::array({Json::array({"a", "b"})})}}));
}

class Symmetry : public ::testing::Test {
 protected:
  Model symmetric_ = done({{"name", "set_constraints"}, {"symmetric", {{"axis", "x"}, {"at_mm", 30}}}}).model;
};

TEST_F(Symmetry, PartnersFollow) {
  const EditOutcome out =
      done(symmetric_, {{"name", "move_points"}, {"moves", {{{"point", "a"}, {"to_mm", {-3, 1}}}}}});
  EXPECT_EQ(point(out.model, "b").at, Vec2(0.063, 0.001));
  const EditOutcome thick = done(symmetric_, {{"name", "set_radii"}, {"points", {"c"}}, {"r_b_mm", 0.9}});
  EXPECT_EQ(point(thick.model, "d").r_b, 9e-4);
}

TEST_F(Symmetry, PointsOnTheLineStayOnIt) {
  const EditOutcome out =
      done(symmetric_, {{"name", "move_points"}, {"moves", {{{"point", "k"}, {"to_mm", {33, 50}}}}}});
  EXPECT_EQ(point(out.model, "k").at, Vec2(0.03, 0.05));
}

TEST_F(Symmetry, BothSidesMovedTakeTheMean) {
  const EditOutcome out =
      done(symmetric_, {{"name", "transform_points"}, {"points", {"a", "b"}}, {"move_mm", {5, -2}}});
  EXPECT_EQ(point(out.model, "a").at, Vec2(0, -0.002)) << "along x they would leave each other";
  EXPECT_EQ(point(out.model, "b").at, Vec2(0.06, -0.002));
  const Json apart = {{{"point", "a"}, {"to_mm", {-4, 0}}}, {{"point", "b"}, {"to_mm", {64, 0}}}};
  EXPECT_EQ(point(done(symmetric_, {{"name", "move_points"}, {"moves", apart}}).model, "a").at, Vec2(-0.004, 0));
}

TEST(PlanJson, SaysWhatThePageDraws) {
  const Json plan = plan_to_json(done({{"name", "set_constraints"}, {"pinned", {"a"}}}).model);
  EXPECT_EQ(plan["points"][1],
            (Json{{"name", "b"}, {"at_mm", {60.0, 0.0}}, {"r_n_mm", 0.2}, {"r_b_mm", 0.4}, {"split", false}}));
  const Json& frame = plan["rods"][0];
  EXPECT_EQ(frame["points"], (Json{0, 1, 2, 3}));
  EXPECT_NEAR(frame["length_mm"].get<double>(), 240, 1e-9);
  EXPECT_EQ(frame["line_mm"].size(), 5U) << "a closed line returns to its start";
  EXPECT_EQ(frame["line_mm"][4], frame["line_mm"][0]);
  const double sagitta = 8, radius = (30 * 30 + sagitta * sagitta) / (2 * sagitta);
  EXPECT_NEAR(plan["rods"][2]["length_mm"].get<double>(), 2 * radius * std::asin(30 / radius), 1e-2);
  EXPECT_EQ(plan["fabric"]["pre_stretch"], (Json{1.4, 1.4}));
  EXPECT_EQ(plan["constraints"]["pinned"], (Json{"a"}));
  EXPECT_TRUE(plan["constraints"]["symmetric"].is_null());
  EXPECT_EQ(plan["edge_length_mm"], 4.0);
  EXPECT_NEAR(plan["max_turn_deg"].get<double>(), 10.03, 0.01);
}

}  // namespace
}  // namespace lissom
