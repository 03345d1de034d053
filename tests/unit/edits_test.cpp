/// Every edit of a plan: a right use of each, refused ones, and what refers to what was edited.

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include "lissom/editing/edits_json.h"
#include "lissom/editing/plan_json.h"
#include "lissom/editing/rod_curve.h"
#include "lissom/editing/templates.h"
#include "lissom/editing/tool_constraints.h"
#include "tests/unit/edit_samples.h"

namespace lissom {
namespace {

using edit_samples::done;
using edit_samples::Json;
using edit_samples::model;
using edit_samples::Names;
using edit_samples::names;
using edit_samples::point;
using edit_samples::refused;
using edit_samples::rod;

TEST(Edits, MovesPoints) {
  const EditOutcome out = done({{"name", "move_points"}, {"moves", {{{"point", "m"}, {"to_mm", {28.1, 31}}}}}});
  EXPECT_EQ(point(out.model, "m").at, Vec2(0.0281, 0.031));
  EXPECT_EQ(out.title, "Move point m");
  const Json twice = {{"point", "m"}, {"to_mm", {1, 2}}};
  EXPECT_EQ(refused({{"name", "move_points"}, {"moves", {twice, twice}}}).where, "/edit/moves/1/point");
  EXPECT_EQ(refused({{"name", "move_points"}, {"moves", Json::array()}}).where, "/edit/moves");
  const Error onto = refused({{"name", "move_points"}, {"moves", {{{"point", "m"}, {"to_mm", {60, 60}}}}}});
  EXPECT_NE(onto.message.find("same place"), std::string::npos) << onto.text();
}

TEST(Edits, TransformsPoints) {
  const EditOutcome out = done({{"name", "transform_points"},
                                {"points", {"m", "k"}},
                                {"about_mm", {30, 30}},
                                {"turn_deg", 90},
                                {"scale", {1, 0.5}}});
  EXPECT_EQ(point(out.model, "m").at, Vec2(0.03, 0.03));
  EXPECT_EQ(point(out.model, "k").at, Vec2(0.019, 0.03));
  EXPECT_EQ(done({{"name", "transform_points"}, {"points", {"m"}}, {"move_mm", {1, 0}}}).title, "Move point m");
  EXPECT_EQ(done({{"name", "transform_points"}, {"points", {"m", "k"}}, {"turn_deg", 15}}).title,
            "Turn 2 points by 15 degrees");
  EXPECT_EQ(refused({{"name", "transform_points"}, {"points", {"m"}}, {"scale", {0, 1}}}).where, "/edit/scale");
}

TEST(Edits, DrawsRodsThroughOldAndNewPointsAndPlacesOnRods) {
  const EditOutcome out =
      done({{"name", "add_rod"},
            {"through", {{{"point", "b"}}, {{"at_mm", {50, 10}}}, {{"rod", "across"}, {"at_mm", {46, 44}}}}},
            {"curve", "straight"}});
  const PlanRod& added = rod(out.model, "rod1");
  EXPECT_EQ(names(out.model, added), (Names{"b", "p1", "p2"}));
  EXPECT_EQ(names(out.model, rod(out.model, "across")), (Names{"a", "m", "p2", "c"}));
  EXPECT_LT((point(out.model, "p2").at - Vec2(0.045, 0.045)).norm(), 1e-9);
  EXPECT_EQ(point(out.model, "p1").r_b, 4e-4);
  EXPECT_EQ(out.title, "Draw rod rod1");
  EXPECT_EQ(refused({{"name", "add_rod"}, {"through", {{{"point", "b"}}}}}).where, "/edit/through");
  EXPECT_EQ(refused({{"name", "add_rod"}, {"through", {{{"point", "b"}}, {{"point", "b"}}}}}).where, "/edit/through");
  EXPECT_EQ(refused({{"name", "add_rod"}, {"rod", "bow"}, {"through", {{{"point", "b"}}, {{"point", "m"}}}}}).where,
            "/edit/rod");
  EXPECT_EQ(refused({{"name", "add_rod"}, {"through", {{{"point", "b"}}, {{"rod", "bow"}}}}}).where, "/edit/through/1");
}

TEST(Edits, RodsThatCrossOthersAreJoinedToThem) {
  const EditOutcome out = done({{"name", "add_rod"}, {"through", {{{"point", "b"}}, {{"point", "d"}}}}});
  EXPECT_EQ(names(out.model, rod(out.model, "rod1")), (Names{"b", "m", "d"}));
  const EditOutcome new_point =
      done({{"name", "add_rod"}, {"through", {{{"point", "b"}}, {{"at_mm", {10, 30}}}}}, {"role", "ghost"}});
  const PlanRod& ghost = rod(new_point.model, "rod1");
  EXPECT_EQ(ghost.role, PlanRole::kGhost);
  EXPECT_EQ(names(new_point.model, ghost), (Names{"b", "p2", "p1"}));
  EXPECT_EQ(names(new_point.model, rod(new_point.model, "across")), (Names{"a", "p2", "m", "c"}));
  EXPECT_EQ(new_point.notes.size(), 1U);
  const EditOutcome apart =
      done({{"name", "add_rod"}, {"through", {{{"point", "b"}}, {{"point", "d"}}}}, {"join", false}});
  EXPECT_EQ(names(apart.model, rod(apart.model, "rod1")), (Names{"b", "d"}));
}

TEST(Edits, PointsOnArcsLeaveTheirCircleAlone) {
  const EditOutcome out = done({{"name", "insert_point"}, {"rod", "bow"}, {"at_mm", {10, 60}}});
  const PlanRod& bow = rod(out.model, "bow");
  EXPECT_EQ(bow.curve, PlanCurve::kArc);
  EXPECT_EQ(names(out.model, bow), (Names{"d", "p2", "p1", "k", "c"}));
  // The circle through d, k and c.
  const double sagitta = 8e-3, radius = (0.03 * 0.03 + sagitta * sagitta) / (2 * sagitta);
  for (const char* name : {"p1", "p2"})
    EXPECT_NEAR((point(out.model, name).at - Vec2(0.03, 0.052 + radius)).norm(), radius, 1e-8);
}

TEST(Edits, InsertsPointsWhereTheRodIsNearest) {
  const EditOutcome out = done({{"name", "insert_point"}, {"rod", "frame"}, {"at_mm", {62, 20}}, {"r_b_mm", 0.7}});
  EXPECT_EQ(names(out.model, rod(out.model, "frame")), (Names{"a", "b", "p1", "c", "d"}));
  EXPECT_LT((point(out.model, "p1").at - Vec2(0.06, 0.02)).norm(), 1e-9);
  EXPECT_EQ(point(out.model, "p1").r_b, 7e-4);
  EXPECT_EQ(point(out.model, "p1").r_n, 2e-4);
  EXPECT_EQ(refused({{"name", "insert_point"}, {"rod", "frame"}, {"at_mm", {60.1, 0}}}).where, "/edit/at_mm");
}

/// Largest distance of a place on one rod from another, m.
double distance_between(const PlanRod& rod, const Model& in, const PlanRod& other, const Model& there) {
  const RodCurve from(*in.plan, rod), to(*there.plan, other);
  double largest = 0;
  for (int piece = 0; piece < from.pieces(); ++piece) {
    for (int k = 0; k < 8; ++k) largest = std::max(largest, to.nearest(from.point(piece, k / 8.0)).distance);
  }
  return largest;
}

TEST(Edits, SplinesStayNearTheirLineWhereverAPointIsPut) {
  const Model before = templates()[0].make();
  ASSERT_EQ(before.plan->rods[0].name, "rim");
  const RodCurve rim(*before.plan, before.plan->rods[0]);
  for (int k = 1; k < 40; ++k) {
    const Vec2 at = 1e3 * rim.point(2, k / 40.0);
    const Result<EditOutcome> out =
        apply_edit(before, {{"name", "insert_point"}, {"rod", "rim"}, {"at_mm", {at.x(), at.y()}}});
    if (!out) {
      EXPECT_TRUE(k <= 2 || k >= 38) << "too near to a point that is there: " << out.error().text();
      continue;
    }
    const Model& after = out.value().model;
    EXPECT_LE(after.plan->points.size(), 13U) << "one point, and some that lead up to it";
    EXPECT_LT(distance_between(after.plan->rods[0], after, before.plan->rods[0], before), 2e-3) << k;
  }
}

TEST(Edits, OpenSplinesTakePointsNearTheirEnds) {
  const Model two =
      done({{"name", "add_rod"}, {"through", {{{"point", "b"}}, {{"point", "m"}}}}, {"curve", "spline"}}).model;
  for (const double share : {0.06, 0.1, 0.3, 0.5, 0.8, 0.94}) {
    const Json at = {60 - 30 * share, 30 * share};
    const Model after = done(two, {{"name", "insert_point"}, {"rod", "rod1"}, {"at_mm", at}}).model;
    EXPECT_LT(distance_between(rod(after, "rod1"), after, rod(two, "rod1"), two), 1e-6) << share;
  }
}

TEST(Edits, ANewcomerDrawsAcrossADisc) {
  Model disc = templates()[0].make();
  const auto on_rim = [](double x, double y) { return Json{{"rod", "rim"}, {"at_mm", {x, y}}}; };
  disc = done(disc, {{"name", "add_rod"}, {"through", {on_rim(-60, 4), on_rim(60, -9)}}}).model;
  const EditOutcome out = done(disc, {{"name", "add_rod"}, {"through", {on_rim(5, -60), on_rim(-30, 52)}}});
  EXPECT_EQ(out.notes.size(), 1U);
  EXPECT_EQ(rod(out.model, "rod1").points.size(), 3U);
  EXPECT_EQ(rod(out.model, "rod2").points.size(), 3U);
}

TEST(Edits, RemovesPointsAndRodsAndWhatNamedThem) {
  const EditOutcome out = done({{"name", "remove"}, {"points", {"m", "k"}}});
  EXPECT_EQ(names(out.model, rod(out.model, "across")), (Names{"a", "c"}));
  EXPECT_EQ(rod(out.model, "bow").curve, PlanCurve::kStraight);
  EXPECT_EQ(out.model.plan->points.size(), 4U);
  EXPECT_EQ(out.title, "Remove 2 points");
  EXPECT_TRUE(out.model.poses[0].supports.empty()) << "it held the point m";
  EXPECT_EQ(out.model.sets.size(), 1U);
  ASSERT_EQ(out.notes.size(), 2U);
  EXPECT_NE(out.notes[1].find("support of pose released"), std::string::npos) << out.notes[1];
  EXPECT_EQ(done({{"name", "remove"}, {"rods", {"bow"}}}).model.plan->points.size(), 5U);
  EXPECT_EQ(refused({{"name", "remove"}}).where, "/edit");
  EXPECT_EQ(refused({{"name", "remove"}, {"rods", {"frame", "across", "bow"}}}).where, "/plan/rods");
}

TEST(Edits, SetsRadii) {
  const EditOutcome out = done({{"name", "set_radii"}, {"points", {"a", "m"}}, {"r_n_mm", 0.5}});
  EXPECT_EQ(point(out.model, "m").r_n, 5e-4);
  EXPECT_EQ(point(out.model, "m").r_b, 4e-4);
  EXPECT_EQ(out.title, "Make rods 1 mm high at 2 points");
  EXPECT_EQ(point(done({{"name", "set_radii"}, {"points", {"a"}}, {"factor", 1.5}}).model, "a").r_b, 6e-4);
  EXPECT_EQ(refused({{"name", "set_radii"}, {"points", {"a"}}}).where, "/edit");
  EXPECT_EQ(refused({{"name", "set_radii"}, {"points", {"a"}}, {"factor", -1}}).where, "/edit/factor");
  EXPECT_EQ(refused({{"name", "set_radii"}, {"points", {"a"}}, {"r_n_mm", 0}}).where, "/edit/r_n_mm");
}

TEST(Edits, MakesGhostsAndKinksAndCurves) {
  const EditOutcome ghosts = done({{"name", "set_role"}, {"rods", {"bow", "frame"}}, {"role", "ghost"}});
  EXPECT_EQ(rod(ghosts.model, "bow").role, PlanRole::kGhost);
  EXPECT_EQ(ghosts.title, "Make 2 rods ghosts");
  EXPECT_EQ(refused({{"name", "set_role"}, {"rods", {"bow"}}, {"role", "phantom"}}).where, "/edit/role");

  const EditOutcome kink = done({{"name", "set_split"}, {"points", {"m"}}, {"split", true}});
  EXPECT_TRUE(point(kink.model, "m").split);
  const Selector& line = kink.model.sets[1].nodes;
  ASSERT_EQ(line.kind, Selector::Kind::kUnion) << "the rod is called across-0 and across-1 now";
  EXPECT_EQ(line.parts[0].name, "across-0");
  EXPECT_EQ(line.parts[1].name, "across-1");
  const Selector& quarter = kink.model.poses[0].forces[1].at;
  EXPECT_EQ(quarter.name, "across-0");
  EXPECT_NEAR(quarter.fraction, 0.5, 1e-9);
  const EditOutcome smooth = done(kink.model, {{"name", "set_split"}, {"points", {"m"}}, {"split", false}});
  EXPECT_EQ(smooth.model.poses[0].forces[1].at.name, "across");
  EXPECT_NEAR(smooth.model.poses[0].forces[1].at.fraction, 0.25, 1e-9);

  EXPECT_EQ(rod(done({{"name", "set_curve"}, {"rods", {"across"}}, {"curve", "spline"}}).model, "across").curve,
            PlanCurve::kSpline);

  EXPECT_TRUE(rod(done({{"name", "set_closed"}, {"rod", "across"}, {"closed", false}}).model, "frame").closed);
  EXPECT_FALSE(rod(done({{"name", "set_closed"}, {"rod", "frame"}, {"closed", false}}).model, "frame").closed);
  const Model two = done({{"name", "remove"}, {"points", {"m"}}}).model;
  EXPECT_EQ(refused(two, {{"name", "set_curve"}, {"rods", {"across"}}, {"curve", "arc"}}).code, ErrorCode::kGeometry);
  EXPECT_EQ(refused(two, {{"name", "set_closed"}, {"rod", "across"}, {"closed", true}}).where, "/edit/rod");
}

TEST(Edits, SplitsAndJoinsRods) {
  const EditOutcome split = done({{"name", "split_rod"}, {"rod", "across"}, {"point", "m"}});
  EXPECT_EQ(names(split.model, rod(split.model, "across")), (Names{"a", "m"}));
  EXPECT_EQ(names(split.model, rod(split.model, "rod1")), (Names{"m", "c"}));
  EXPECT_EQ(split.model.sets[1].nodes.parts.size(), 2U);
  const EditOutcome joined = done(split.model, {{"name", "join_rods"}, {"rods", {"across", "rod1"}}});
  EXPECT_EQ(names(joined.model, rod(joined.model, "across")), (Names{"a", "m", "c"}));
  EXPECT_EQ(joined.model.plan->rods.size(), 3U);
  EXPECT_NEAR(joined.model.poses[0].forces[1].at.fraction, 0.25, 1e-9);

  const Json beside = {{"name", "split_rod"}, {"rod", "across"}, {"at_mm", {15, 15}}};
  const EditOutcome anywhere = done(beside);
  EXPECT_EQ(names(anywhere.model, rod(anywhere.model, "across")), (Names{"a", "p1"}));
  EXPECT_EQ(names(anywhere.model, rod(anywhere.model, "rod1")), (Names{"p1", "m", "c"}));

  const EditOutcome ring = done({{"name", "split_rod"}, {"rod", "frame"}, {"point", "b"}});
  EXPECT_EQ(names(ring.model, rod(ring.model, "frame")), (Names{"b", "c", "d"}));
  EXPECT_EQ(names(ring.model, rod(ring.model, "rod1")), (Names{"d", "a", "b"}));
  EXPECT_EQ(ring.notes.size(), 1U);
  const EditOutcome closed = done(ring.model, {{"name", "join_rods"}, {"rods", {"frame", "rod1"}}});
  EXPECT_TRUE(rod(closed.model, "frame").closed);

  const EditOutcome arc = done({{"name", "split_rod"}, {"rod", "bow"}, {"point", "k"}});
  EXPECT_EQ(names(arc.model, rod(arc.model, "bow")), (Names{"d", "p1", "k"}));
  EXPECT_EQ(names(arc.model, rod(arc.model, "rod1")), (Names{"k", "p2", "c"}));
  EXPECT_EQ(refused({{"name", "split_rod"}, {"rod", "across"}, {"point", "a"}}).where, "/edit/point");
  EXPECT_EQ(refused({{"name", "split_rod"}, {"rod", "across"}, {"point", "b"}}).where, "/edit/point");
  EXPECT_EQ(refused({{"name", "split_rod"}, {"rod", "across"}}).where, "/edit");
  EXPECT_EQ(refused({{"name", "split_rod"}, {"rod", "across"}, {"at_mm", {0, 0.1}}}).where, "/edit/at_mm");
  EXPECT_EQ(refused({{"name", "join_rods"}, {"rods", {"across", "bow"}}}).where, "/edit/rods");
  EXPECT_EQ(refused({{"name", "join_rods"}, {"rods", {"across", "frame"}}}).where, "/edit/rods");
}

TEST(Edits, MergesPoints) {
  const EditOutcome out = done({{"name", "merge_points"}, {"points", {"c", "m", "k"}}});
  EXPECT_EQ(names(out.model, rod(out.model, "across")), (Names{"a", "c"}));
  EXPECT_EQ(out.title, "Merge 2 points into c");
  EXPECT_EQ(out.model.sets[0].nodes.name, "c") << "what was named m is c now";
  EXPECT_EQ(refused({{"name", "merge_points"}, {"points", {"c"}}}).where, "/edit/points");
  EXPECT_EQ(refused({{"name", "merge_points"}, {"points", {"a", "c"}}}).code, ErrorCode::kGeometry)
      << "frame would run through it twice";
}

TEST(Edits, RenamesAlsoInSelections) {
  const EditOutcome out = done({{"name", "rename"}, {"point", "m"}, {"to", "centre"}});
  EXPECT_EQ(out.model.sets[0].nodes.name, "centre");
  EXPECT_EQ(out.title, "Rename point m to centre");
  const EditOutcome rods = done({{"name", "rename"}, {"rod", "across"}, {"to", "diagonal"}});
  EXPECT_EQ(rods.model.sets[1].nodes.name, "diagonal");
  EXPECT_EQ(rods.model.poses[0].forces[1].at.name, "diagonal");
  EXPECT_EQ(rods.model.poses[0].forces[1].at.fraction, 0.25);
  EXPECT_EQ(refused({{"name", "rename"}, {"point", "m"}, {"to", "a"}}).where, "/edit/to");
  EXPECT_EQ(refused({{"name", "rename"}, {"point", "m"}, {"to", ""}}).where, "/edit/to");
  EXPECT_EQ(refused({{"name", "rename"}, {"point", "m"}, {"rod", "bow"}, {"to", "x"}}).where, "/edit");
}

TEST(Edits, MirrorsRodsAndSharesWhatIsThere) {
  const EditOutcome out = done({{"name", "mirror"}, {"rods", {"bow"}}, {"axis", "y"}, {"at_mm", 30}});
  const PlanRod& image = rod(out.model, "rod1");
  EXPECT_EQ(names(out.model, image), (Names{"a", "p1", "b"}));
  EXPECT_EQ(point(out.model, "p1").at, Vec2(0.03, 0.008));
  EXPECT_EQ(out.title, "Mirror rod bow");
  EXPECT_EQ(refused(out.model, {{"name", "mirror"}, {"rods", {"bow"}}, {"axis", "y"}, {"at_mm", 30}}).where,
            "/edit/rods");
  EXPECT_EQ(refused({{"name", "mirror"}, {"rods", {"bow"}}, {"axis", "x"}, {"at_mm", 30}}).where, "/edit/rods")
      << "it is its own image";
}

TEST(Edits, ChangesFabricAndRods) {
  const EditOutcome stretch = done({{"name", "set_pre_stretch"}, {"along", {1.46, 1.46}}});
  EXPECT_EQ(stretch.title, "Raise the stretch to 1.46");
  EXPECT_EQ(stretch.model.plan->fabric.pre_stretch, Vec2(1.46, 1.46));
  EXPECT_EQ(done({{"name", "set_pre_stretch"}, {"along", {1.5, 1.3}}}).title, "Set the stretch to 1.5 and 1.3");
  EXPECT_EQ(refused({{"name", "set_pre_stretch"}, {"along", {0.9, 0.9}}}).code, ErrorCode::kRange);
  EXPECT_EQ(refused({{"name", "set_pre_stretch"}, {"along", 1.4}}).where, "/edit/along");

  const EditOutcome fabric = done({{"name", "set_fabric"}, {"warp_angle_deg", 30}, {"edge_length_mm", 5}});
  EXPECT_NE(write_document(fabric.model).find("\"warp_angle\": \"30 deg\","), std::string::npos)
      << write_document(fabric.model);
  EXPECT_EQ(fabric.title, "Change the fabric");
  const Error silk = refused({{"name", "set_fabric"}, {"material", "soft knot"}});
  EXPECT_EQ(silk.where, "/plan/fabric/material");
  EXPECT_NE(silk.hint.find("soft knit"), std::string::npos);

  EXPECT_EQ(done({{"name", "set_rods"}, {"material", "PETG"}}).title, "Print the rods in PETG");
  EXPECT_EQ(refused({{"name", "set_rods"}, {"max_turn_deg", 0}}).where, "/plan/max_turn");
  EXPECT_EQ(refused({{"name", "set_rods"}}).where, "/edit");

  const EditOutcome hole = done({{"name", "add_hole"}, {"at_mm", {45, 20}}});
  ASSERT_EQ(hole.model.plan->fabric.holes.size(), 1U);
  EXPECT_EQ(hole.model.plan->fabric.holes[0], Vec2(0.045, 0.02));
  EXPECT_TRUE(done(hole.model, {{"name", "remove_hole"}, {"hole", 0}}).model.plan->fabric.holes.empty());
  EXPECT_EQ(refused(hole.model, {{"name", "remove_hole"}, {"hole", 1}}).where, "/edit/hole");

  const EditOutcome strong = done({{"name", "strengthen"}, {"pre_stretch_factor", 1.05}, {"radius_factor", 1.04}});
  EXPECT_EQ(strong.title, "Raise the stretch to 1.47 and the radii by 4 %");
  EXPECT_NEAR(point(strong.model, "m").r_b, 4.16e-4, 1e-12);
  EXPECT_EQ(refused({{"name", "strengthen"}, {"pre_stretch_factor", 0}, {"radius_factor", 1}}).where,
            "/edit/pre_stretch_factor");

  EXPECT_EQ(done({{"name", "set_title"}, {"title", "Kite"}}).model.title, "Kite");
  EXPECT_EQ(refused({{"name", "set_title"}}).where, "/edit");
}

TEST(Edits, TakesOverDesigns) {
  const EditOutcome out =
      done({{"name", "set_design"},
            {"points", {{{"point", "m"}, {"at_mm", {31, 29.5}}, {"r_n_mm", 0.31}}, {{"point", "k"}, {"r_b_mm", 0.5}}}},
            {"pre_stretch", {1.5, 1.45}},
            {"title", "Adopt mode 1"}});
  EXPECT_EQ(point(out.model, "m").at, Vec2(0.031, 0.0295));
  EXPECT_EQ(point(out.model, "k").r_b, 5e-4);
  EXPECT_EQ(out.model.plan->fabric.pre_stretch, Vec2(1.5, 1.45));
  EXPECT_EQ(out.title, "Adopt mode 1");
  EXPECT_EQ(refused({{"name", "set_design"}, {"points", {{{"point", "m"}, {"r_n_mm", -1}}}}}).code, ErrorCode::kRange);
}

TEST(Edits, StrictAboutWhatTheyAreGiven) {
  EXPECT_EQ(refused(Json::array()).where, "/edit");
  EXPECT_EQ(refused(Json::object()).where, "/edit/name");
  const Error near = refused({{"name", "move_point"}});
  EXPECT_EQ(near.code, ErrorCode::kUnknown);
  EXPECT_EQ(near.hint, "did you mean \"move_points\"?");
  const Error field = refused({{"name", "set_title"}, {"title", "x"}, {"tittle", "y"}});
  EXPECT_EQ(field.where, "/edit/tittle");
  EXPECT_EQ(field.hint, "did you mean \"title\"?");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refused({{"name", "move_points"}, {"moves", {{{"point", "m"}, {"to_mm", {nan, 0}}}}}}).where,
            "/edit/moves/0/to_mm/0");
  EXPECT_EQ(refused({{"name", "move_points"}, {"moves", {{{"point", "m"}, {"to_mm", {1e300, 0}}}}}}).code,
            ErrorCode::kRange);
  EXPECT_EQ(refused({{"name", "move_points"}, {"moves", {{{"point", "m"}, {"to_mm", "here"}}}}}).where,
            "/edit/moves/0/to_mm");
  EXPECT_EQ(refused({{"name", "move_points"}, {"moves", {7}}}).where, "/edit/moves/0");
  EXPECT_EQ(refused({{"name", "move_points"}, {"moves", {{{"point", 7}, {"to_mm", {0, 0}}}}}}).where,
            "/edit/moves/0/point");
  const Error name = refused({{"name", "set_split"}, {"points", {"a", "mm"}}, {"split", true}});
  EXPECT_EQ(name.where, "/edit/points/1");
  EXPECT_EQ(name.code, ErrorCode::kUnknown);
  EXPECT_EQ(refused({{"name", "set_split"}, {"points", {"a", "a"}}, {"split", true}}).where, "/edit/points/1");
  EXPECT_EQ(refused({{"name", "set_split"}, {"points", {"a"}}, {"split", 1}}).where, "/edit/split");
  Model without = model();
  without.plan.reset();
  EXPECT_EQ(refused(without, {{"name", "set_title"}, {"title", "x"}}).where, "/edit");
}

TEST(Edits, EveryFieldHasItsSentence) {
  ASSERT_EQ(edits().size(), 24U);
  EXPECT_EQ(edits_to_json().size(), edits().size());
  for (const EditInfo* info : edits()) {
    EXPECT_TRUE(info->sentence.ends_with('.')) << info->name;
    for (const EditField& field : info->fields) EXPECT_FALSE(field.sentence.empty()) << info->name << " " << field.name;
  }
}

TEST(Edits, JsonOfStrangersIsReadStrictly) {
  EXPECT_TRUE(read_json(R"({"a": [1, {"b": null}]})"));
  EXPECT_FALSE(read_json(R"({"a": 1, "a": 2})"));
  EXPECT_FALSE(read_json(R"({"a": 1)"));
  EXPECT_FALSE(read_json(R"({"a": 1e999})"));
  EXPECT_FALSE(read_json(R"({"a": NaN})"));
  EXPECT_FALSE(read_json("\"\xff\""));
  EXPECT_FALSE(read_json(std::string(100, '[') + std::string(100, ']')));
}

}  // namespace
}  // namespace lissom
