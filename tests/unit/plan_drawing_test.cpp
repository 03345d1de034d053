#include "lissom/model/plan_drawing.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "lissom/model/check_plan.h"
#include "lissom/model/expand_plan.h"
#include "lissom/model/plan_dxf.h"
#include "lissom/model/plan_svg.h"
#include "lissom/model/svg_path_data.h"

namespace lissom {
namespace {

constexpr double kPi = std::numbers::pi;

/// A circle as a ghost, a spline across it with an own width, and straight rods between.
Model sample() {
  Model model;
  Plan& plan = model.plan.emplace();
  plan.material = "PLA";
  plan.edge_length = 3e-3;
  plan.fabric.material = "soft knit";
  const auto add = [&](const char* name, double x, double y) {
    plan.points.push_back({name, Vec2(x, y), 3e-4, 5e-4, false});
    return static_cast<int>(plan.points.size()) - 1;
  };
  const int a = add("a", 0.05, 0), b = add("b", 0, 0.05), c = add("c", -0.05, 0), d = add("d", 0, -0.05);
  const int m = add("m", 0.004, 0.01), n = add("n", -0.02, 0.004);
  plan.rods.push_back({"edge", {a, b, c, d}, PlanCurve::kArc, PlanRole::kGhost, true});
  plan.rods.push_back({"spine & <co>", {a, m, n, c}, PlanCurve::kSpline, PlanRole::kRod, false});
  plan.rods.push_back({"ribs", {b, m, d}, PlanCurve::kStraight, PlanRole::kRod, false});
  return model;
}

Plan traced(const PlanDrawing& drawing) {
  std::vector<std::string> notes;
  Result<Plan> plan = plan_from_drawing(drawing, {}, "here", notes);
  EXPECT_TRUE(plan) << plan.error().text();
  return plan ? std::move(plan).value() : Plan();
}

PlanDrawing svg(const std::string& body,
                const std::string& size = "width=\"100mm\" height=\"100mm\" viewBox=\"0 0 100 100\"") {
  Result<PlanDrawing> drawing =
      read_svg_drawing("<svg xmlns=\"http://www.w3.org/2000/svg\" " + size + ">" + body + "</svg>", "test.svg");
  EXPECT_TRUE(drawing) << drawing.error().text();
  return drawing ? std::move(drawing).value() : PlanDrawing();
}

/// Same rods through the same points, whatever these are called.
void expect_same(const Plan& plan, const Plan& other, double tolerance) {
  ASSERT_EQ(plan.rods.size(), other.rods.size());
  ASSERT_EQ(plan.points.size(), other.points.size());
  for (const PlanRod& rod : plan.rods) {
    SCOPED_TRACE(rod.name);
    const auto same =
        std::find_if(other.rods.begin(), other.rods.end(), [&](const PlanRod& r) { return r.name == rod.name; });
    ASSERT_NE(same, other.rods.end());
    EXPECT_EQ(rod.curve, same->curve);
    EXPECT_EQ(rod.role, same->role);
    EXPECT_EQ(rod.closed, same->closed);
    ASSERT_EQ(rod.points.size(), same->points.size());
    for (size_t i = 0; i < rod.points.size(); ++i) {
      const PlanPoint &p = plan.points[static_cast<size_t>(rod.points[i])],
                      &q = other.points[static_cast<size_t>(same->points[i])];
      EXPECT_NEAR((p.at - q.at).norm(), 0, tolerance);
      EXPECT_NEAR(p.r_n, q.r_n, 1e-12);
      EXPECT_NEAR(p.r_b, q.r_b, 1e-12);
    }
  }
}

TEST(PlanDrawing, SvgBringsThePlanBack) {
  const Model model = sample();
  const std::string text = write_svg_drawing(drawing_of_plan(*model.plan), "a \"disc\" & more");
  EXPECT_NE(text.find("id=\"RODS\""), std::string::npos);
  EXPECT_NE(text.find("id=\"GHOST\""), std::string::npos);
  EXPECT_NE(text.find("100 mm</text>"), std::string::npos);
  EXPECT_NE(text.find("width=\"130mm\" height=\"145mm\" viewBox=\"-65 -65 130 145\""), std::string::npos)
      << text.substr(0, 400);
  const Result<PlanDrawing> drawing = read_svg_drawing(text, "test.svg");
  ASSERT_TRUE(drawing) << drawing.error().text();
  EXPECT_EQ(drawing.value().left_out, 13);
  expect_same(*model.plan, traced(drawing.value()), 2e-9);
}

TEST(PlanDrawing, DxfBringsThePlanBack) {
  const Model model = sample();
  const std::string text = write_dxf_drawing(drawing_of_plan(*model.plan));
  EXPECT_NE(text.find("$INSUNITS\n70\n4\n"), std::string::npos);
  EXPECT_NE(text.find("$ACADVER\n1\nAC1015\n"), std::string::npos);
  const Result<PlanDrawing> drawing = read_dxf_drawing(text, "test.dxf");
  ASSERT_TRUE(drawing) << drawing.error().text();
  EXPECT_EQ(drawing.value().left_out, 13);
  expect_same(*model.plan, traced(drawing.value()), 2e-9);
}

TEST(PlanDrawing, WhatWasReadCanBeBuilt) {
  Model model = sample();
  model.plan = traced(drawing_of_plan(*model.plan));
  const Result<ExpandedPlan> plan = expand_plan(model);
  ASSERT_TRUE(plan) << plan.error().text();
  EXPECT_EQ(plan.value().rods.size(), 2u);
  EXPECT_GT(plan.value().mesh().triangles.size(), 500u);
}

TEST(PlanDrawing, CrossingsAndEndsOnLinesBecomePoints) {
  const Plan plan =
      traced(svg("<rect id='frame' x='10' y='10' width='80' height='80'/>"
                 "<line id='one' x1='10' y1='30' x2='90' y2='70'/>"
                 "<path id='two' d='M 50 10 C 50 40 70 60 50.01 90.02'/>"));
  EXPECT_EQ(plan.rods.size(), 3u);
  ASSERT_EQ(plan.rods[0].points.size(), 8u);
  ASSERT_EQ(plan.rods[1].points.size(), 3u);
  const std::vector<int>& two = plan.rods[2].points;
  EXPECT_EQ(std::count(two.begin(), two.end(), plan.rods[1].points[1]), 1);
  for (const int end : {two.front(), two.back()}) {
    EXPECT_EQ(std::count(plan.rods[0].points.begin(), plan.rods[0].points.end(), end), 1);
  }
  EXPECT_EQ(plan.rods[2].curve, PlanCurve::kSpline);
  Model model;
  model.plan = plan;
  const Result<ExpandedPlan> expansion = expand_plan(model);
  EXPECT_TRUE(expansion) << expansion.error().text();
}

TEST(PlanDrawing, SplinesStayWithinTheTolerance) {
  const PlanDrawing drawing = svg("<path d='M 0 50 C 20 0 30 0 50 50 S 70 100 100 40'/>");
  std::vector<std::string> notes;
  const Plan plan = plan_from_drawing(drawing, {}, "here", notes).value();
  EXPECT_TRUE(notes.empty());
  ASSERT_EQ(plan.rods.size(), 1u);
  EXPECT_GT(plan.rods[0].points.size(), 4u);
  EXPECT_LT(plan.rods[0].points.size(), 40u);
  const Plan again = traced(drawing_of_plan(plan));
  EXPECT_EQ(again.rods[0].points.size(), plan.rods[0].points.size());
}

TEST(PlanDrawing, ALineThatCrossesItselfIsCut) {
  const Plan plan = traced(svg("<polyline points='10,10 90,90 90,10 10,90'/>"));
  ASSERT_EQ(plan.rods.size(), 2u);
  EXPECT_EQ(plan.points.size(), 5u);
}

TEST(PlanDrawing, CornersEndSplinesAndCirclesStayRound) {
  const Plan corner = traced(svg("<path id='v' d='M 10 10 Q 30 20 50 50 Q 60 20 90 10'/>"));
  ASSERT_EQ(corner.rods.size(), 2u);
  EXPECT_EQ(corner.rods[0].name, "v");
  EXPECT_EQ(corner.rods[1].name, "v 2");
  EXPECT_EQ(corner.rods[0].points.back(), corner.rods[1].points.front());
  const Plan circle = traced(svg("<circle cx='50' cy='40' r='20'/>"));
  ASSERT_EQ(circle.rods.size(), 1u);
  EXPECT_EQ(circle.rods[0].curve, PlanCurve::kArc);
  EXPECT_TRUE(circle.rods[0].closed);
  for (const PlanPoint& p : circle.points) EXPECT_NEAR((p.at - Vec2(0.05, -0.04)).norm(), 0.02, 2e-9);
}

TEST(SvgDrawing, UnitsTransformsAndWidthsAreFollowed) {
  const PlanDrawing inches = svg("<line x1='0' y1='0' x2='1' y2='0'/>", "width='2in' height='2in' viewBox='0 0 2 2'");
  EXPECT_NEAR(inches.lines[0].path[0].to.x(), 0.0254, 1e-15);
  const PlanDrawing pixels = svg("<line x1='0' y1='0' x2='96' y2='0'/>", "");
  EXPECT_NEAR(pixels.lines[0].path[0].to.x(), 0.0254, 1e-15);
  const PlanDrawing moved =
      svg("<g transform='translate(10,20) scale(2)' style='stroke-width: 0.5'><g id='ghost' transform='rotate(90)'>"
          "<line x1='0' y1='0' x2='5' y2='0'/></g><path style='stroke-width:1' d='m1 1h2v3z'/></g>"
          "<g id='Marks'><line x2='3'/></g>");
  ASSERT_EQ(moved.lines.size(), 2u);
  EXPECT_EQ(moved.left_out, 1);
  EXPECT_EQ(moved.lines[0].role, PlanRole::kGhost);
  EXPECT_NEAR((moved.lines[0].path[0].to - Vec2(0.01, -0.03)).norm(), 0, 1e-15);
  EXPECT_NEAR(*moved.lines[0].r_b, 0.5e-3, 1e-15);
  EXPECT_NEAR(*moved.lines[1].r_b, 1e-3, 1e-15);
  EXPECT_TRUE(moved.lines[1].closed);
  EXPECT_EQ(moved.lines[1].path.size(), 3u);
}

TEST(SvgDrawing, EveryPathCommandIsRead) {
  const Result<std::vector<SubPath>> read = read_path_data(
      "M10,10L20 10H30V20h-5v5c0,5,5,5,5,0s5-5 5,0q5 5 10 0t10 0a5 5 0 0 1 10 0A10 5 30 1050 40Zm5 5l1 1");
  ASSERT_TRUE(read) << read.error().text();
  ASSERT_EQ(read.value().size(), 2u);
  const PlanarPath& path = read.value()[0].path;
  EXPECT_TRUE(read.value()[0].closed);
  EXPECT_EQ(path[4].to, Vec2(25, 25));
  EXPECT_EQ(path[5].b, Vec2(30, 30));
  EXPECT_EQ(path[6].a, Vec2(30, 20));
  EXPECT_EQ(path[6].to, Vec2(35, 25));
  EXPECT_EQ(path[8].to, Vec2(55, 25));
  EXPECT_EQ(path[9].kind, PathPiece::Kind::kArc);
  EXPECT_NEAR(sweep_of(path[9]) + sweep_of(path[10]), kPi, 1e-12);
  EXPECT_EQ(read.value()[1].path[0].from, Vec2(15, 15));
  EXPECT_FALSE(read_path_data("L 1 1"));
  EXPECT_FALSE(read_path_data("M 1 1 C 2 2"));
  EXPECT_FALSE(read_path_data("M 1 1 X 3"));
  EXPECT_FALSE(read_svg_drawing("<svg><path d='M 1'/></svg>", "bad.svg"));
  EXPECT_FALSE(read_svg_drawing("<html/>", "bad.svg"));
  EXPECT_FALSE(read_svg_drawing("<svg><g>", "bad.svg"));
}

TEST(DxfDrawing, EntitiesOfOtherProgramsAreRead) {
  const std::string head = "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n1\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n";
  const std::string text =
      head +
      "  0\r\nLINE\r\n  8\r\n0\r\n 10\r\n1.0\r\n 20\r\n0.0\r\n 11\r\n2.0\r\n 21\r\n1.0\r\n"
      "0\nARC\n8\nghost\n10\n0\n20\n0\n40\n2\n50\n270\n51\n90\n"
      "0\nCIRCLE\n8\nMARKS\n10\n0\n20\n0\n40\n2\n"
      "0\nPOLYLINE\n8\nRODS\n70\n1\n0\nVERTEX\n10\n0\n20\n0\n42\n1\n0\nVERTEX\n10\n2\n20\n0\n0\nSEQEND\n"
      "0\nELLIPSE\n8\n0\n10\n0\n20\n0\n11\n4\n21\n0\n40\n0.5\n41\n0\n42\n3.14159265358979\n"
      "0\nTEXT\n8\n0\n1\nhello\n0\nENDSEC\n0\nEOF\n";
  const Result<PlanDrawing> drawing = read_dxf_drawing(text, "other.dxf");
  ASSERT_TRUE(drawing) << drawing.error().text();
  const std::vector<DrawnLine>& lines = drawing.value().lines;
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(drawing.value().left_out, 1);
  EXPECT_NEAR((lines[0].path[0].to - 0.0254 * Vec2(2, 1)).norm(), 0, 1e-15);
  EXPECT_EQ(lines[1].role, PlanRole::kGhost);
  EXPECT_NEAR(sweep_of(lines[1].path[0]), kPi / 2, 1e-9);
  EXPECT_EQ(lines[1].path.size(), 2u);
  EXPECT_TRUE(lines[2].closed);
  EXPECT_EQ(lines[2].path[0].kind, PathPiece::Kind::kArc);
  EXPECT_NEAR(lines[2].path[0].a.y(), -0.0254, 1e-15);  // bulge 1: half a circle, anticlockwise
  EXPECT_EQ(lines[3].path[0].kind, PathPiece::Kind::kCubic);
  EXPECT_FALSE(read_dxf_drawing("0\nSECTION\n", "cut.dxf"));
  EXPECT_FALSE(read_dxf_drawing("AutoCAD Binary DXF", "binary.dxf"));
}

}  // namespace
}  // namespace lissom
