#include <chrono>
#include <gtest/gtest.h>
#include <numbers>

#include "lissom/model/structure.h"
#include "lissom/view/picture.h"
#include "lissom/view/pose_markers.h"
#include "lissom/view/rod_drawing.h"
#include "lissom/view/svg_compact.h"
#include "lissom/view/text.h"
#include "lissom/view/tube.h"
#include "tests/unit/picture_samples.h"

namespace lissom {
namespace {

using samples::count;
using samples::hex;
using samples::panel;
using std::numbers::pi;

TEST(Drawing, FollowsTheStructure) {
  Structure structure;
  structure.nodes = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0)};
  const Section tube{.shape = SectionShape::kTube, .r_n = 0.02, .r_b = 0.02, .wall = 0.004};
  structure.edges = {{.node0 = 2, .node1 = 0, .rod = 1, .section = tube, .drawn = {}, .rest = {}},
                     {.node0 = 0, .node1 = 1, .rod = 0, .section = {.r_n = 0.1, .r_b = 0.3}, .drawn = {}, .rest = {}}};
  structure.rods = {{.name = "a", .material = "", .nodes = {0, 1}, .edges = {1}, .natural_rates = {}},
                    {.name = "b", .material = "", .nodes = {2, 0}, .edges = {0}, .natural_rates = {}}};
  const std::vector<Vec3> moved = {Vec3(0, 0, 5), Vec3(1, 0, 5), Vec3(2, 0, 6)};
  const std::vector<Frame> frames(2);
  const Drawing drawing = make_drawing(structure, moved, frames);
  ASSERT_EQ(drawing.rods.size(), 2u);
  EXPECT_EQ(drawing.rods[1].points[0], moved[2]);
  EXPECT_EQ(drawing.rods[0].r_b[0], 0.3);
  EXPECT_EQ(drawing.rods[1].wall[0], 0.004);
  EXPECT_TRUE(drawing.rods[0].wall.empty());
  EXPECT_EQ(field_values(structure, Field::Place::kNode, std::vector<double>{1, 2, 3}),
            (std::vector<double>{1, 2, 3, 1}));
  EXPECT_EQ(field_values(structure, Field::Place::kEdge, std::vector<double>{1, 2}), (std::vector<double>{2, 1}));
  EXPECT_TRUE(check_drawing(drawing).ok());
}

TEST(Drawing, PosesBecomeMarkers) {
  Rod rod;
  rod.name = "beam";
  rod.curve = Polyline{{Vec3(0, 0, 0), Vec3(1, 0, 0)}, false};
  rod.material = "PLA";
  rod.section = {SectionShape::kEllipse, {1e-3}, {2e-3}, 0};
  rod.edges = 4;
  Model model;
  model.rods = {rod};
  const auto end = [](double fraction) {
    Selector selector;
    selector.kind = Selector::Kind::kRod;
    selector.name = "beam";
    selector.fraction = fraction;
    return selector;
  };
  Pose pose;
  pose.name = "loaded";
  pose.supports.resize(2);
  pose.supports[0].at = end(0);
  pose.supports[0].kind = SupportKind::kClamp;
  pose.supports[1].at = end(1);
  pose.supports[1].kind = SupportKind::kSymmetry;
  pose.forces.resize(1);
  pose.forces[0].force = Vec3(0, 0, -10);
  pose.forces[0].shared = true;  // over the five nodes
  model.poses = {pose};
  const Result<Structure> structure = discretize(model);
  ASSERT_TRUE(structure.ok()) << structure.error().text();
  std::vector<Vec3> moved = structure.value().nodes;
  for (Vec3& p : moved) p.y() += 7;
  const Result<std::vector<Marker>> markers = pose_markers(model, structure.value(), pose, moved);
  ASSERT_TRUE(markers.ok()) << markers.error().text();
  ASSERT_EQ(markers.value().size(), 6u);
  EXPECT_EQ(markers.value()[0].kind, Marker::Kind::kClamp);
  EXPECT_EQ(markers.value()[0].at, Vec3(0, 7, 0));
  EXPECT_EQ(markers.value()[3].kind, Marker::Kind::kForce);
  EXPECT_EQ(markers.value()[3].vector, Vec3(0, 0, -2));
  pose.supports[0].at.name = "bean";
  EXPECT_FALSE(pose_markers(model, structure.value(), pose, moved).ok());
}

TEST(Tube, RingsLieOnTheSectionAndCurvesPassThroughPoints) {
  const RodStrip rod = samples::circle(1, 12, 0.05);
  const std::vector<Ring> rings = tube_rings(rod, std::vector<int>(12, 8));
  ASSERT_EQ(rings.size(), 12u * 8 + 1);
  for (size_t i = 0; i < rings.size(); ++i) {
    EXPECT_NEAR(rings[i].centre.norm(), 1, 2e-3);  // chord of the polygon would be 0.034 off
    if (i % 8 == 0) {
      EXPECT_EQ(rings[i].centre, rod.points[i / 8 % 12]);
    }
    EXPECT_NEAR(rings[i].b.dot(rings[i].n), 0, 1e-12);
    for (const Vec2& p : section_outline(SectionShape::kEllipse, 8)) {
      EXPECT_NEAR((ring_point(rings[i], p) - rings[i].centre).norm(), 0.05, 0.04 * 0.05);
    }
  }
}

TEST(Camera, FitsAndPointsUp) {
  const std::vector<Vec3> points = {Vec3(0, 0, 0), Vec3(3, 1, 0), Vec3(1, 2, 5)};
  const std::vector<double> radii = {0.1, 0.2, 0.05};
  for (Projection projection : {Projection::kOrthographic, Projection::kPerspective}) {
    for (Viewpoint view : {Viewpoint::iso(), Viewpoint::top(), Viewpoint::front(), Viewpoint::right()}) {
      view.projection = projection;
      const Camera camera(view, points, radii, {10, 20}, {300, 200});
      for (size_t i = 0; i < points.size(); ++i) {
        const Vec2 p = camera.project(points[i]);
        const double r = radii[i] * camera.scale(points[i]);
        EXPECT_GE(p.x() - r, 10 - 1e-9);
        EXPECT_LE(p.x() + r, 310 + 1e-9);
        EXPECT_GE(p.y() - r, 20 - 1e-9);
        EXPECT_LE(p.y() + r, 220 + 1e-9);
      }
    }
  }
  const Camera front(Viewpoint::front(), points, radii, {0, 0}, {100, 100});
  EXPECT_LT(front.project({0, 0, 1}).y(), front.project({0, 0, 0}).y());
  EXPECT_GT(front.project({1, 0, 0}).x(), front.project({0, 0, 0}).x());
  EXPECT_GT(front.depth({0, -1, 0}), front.depth({0, 1, 0}));
  const Camera top(Viewpoint::top(), points, radii, {0, 0}, {100, 100});
  EXPECT_LT(top.project({0, 1, 0}).y(), top.project({0, 0, 0}).y());
  Viewpoint near = Viewpoint::front();
  near.projection = Projection::kPerspective;
  const Camera perspective(near, points, radii, {0, 0}, {100, 100});
  EXPECT_GT(perspective.scale({0, -1, 0}), perspective.scale({0, 1, 0}));
}

TEST(Picture, SameBytesEveryTime) {
  const std::vector<Panel> panels = {panel(samples::beam_and_ring()),
                                     panel(samples::beam_and_ring(), Layer::Style::kGhost)};
  PictureOptions options{.width = 400, .height = 300, .title = "Beam & ring", .field = "axial force"};
  for (ImageFormat format : {ImageFormat::kPng, ImageFormat::kSvg}) {
    const Result<std::string> first = draw_picture(panels, options, format);
    ASSERT_TRUE(first.ok()) << first.error().text();
    EXPECT_EQ(first.value(), draw_picture(panels, options, format).value());
  }
  const std::string svg = draw_picture(panels, options, ImageFormat::kSvg).value();
  EXPECT_NE(svg.find("<title>Beam &amp; ring</title>"), std::string::npos);
  EXPECT_EQ(svg.find("rgb("), std::string::npos);
}

TEST(Picture, ThinRodsAreLinesInTheExactColourOfTheField) {
  Drawing drawing;
  drawing.rods = {samples::straight(1, 4, 1e-4, 1e-4)};
  drawing.fields = {samples::edge_field("force", {-2, -1, std::nan(""), 2})};
  PictureOptions options{.width = 400, .height = 300, .view = Viewpoint::front(), .field = "force"};
  options.axes = options.ruler = Visibility::kHidden;
  const std::string svg = draw_picture({panel(drawing)}, options, ImageFormat::kSvg).value();
  const ColorRange range{-2, 2};
  for (double value : {-2.0, -1.0, std::nan(""), 2.0}) {
    EXPECT_GE(count(svg, "stroke:" + hex(range.color(Field::Colors::kDiverging, value))), 1u) << value;
  }
  EXPECT_EQ(count(svg, "stroke:" + hex(range.color(Field::Colors::kDiverging, 1))), 0u);
  options.range = ColorRange{-4, 4};
  const std::string wider = draw_picture({panel(drawing)}, options, ImageFormat::kSvg).value();
  EXPECT_GE(count(wider, "stroke:" + hex(ColorRange{-2, 2}.color(Field::Colors::kDiverging, 1))), 1u);
}

TEST(Picture, DrawsNearRodsOverFarOnes) {
  Drawing drawing;  // seen from -y: the second rod is nearer
  drawing.rods = {samples::strip("far", {{-1, 1, 0}, {1, 1, 0}}, 1e-4, 1e-4),
                  samples::strip("near", {{0, -1, -1}, {0, -1, 1}}, 1e-4, 1e-4)};
  drawing.fields = {samples::edge_field("force", {-1, 1})};
  PictureOptions options{.width = 400, .height = 300, .view = Viewpoint::front(), .field = "force"};
  const auto order = [&] {
    const std::string svg = draw_picture({panel(drawing)}, options, ImageFormat::kSvg).value();
    return svg.rfind("stroke:" + hex(map_color(Field::Colors::kDiverging, 1))) >
           svg.rfind("stroke:" + hex(map_color(Field::Colors::kDiverging, 0)));
  };
  EXPECT_TRUE(order());
  options.view.azimuth = pi / 2;
  EXPECT_FALSE(order());
}

TEST(Picture, SupportsForcesAndThemesShow) {
  Drawing drawing = samples::beam_and_ring();
  PictureOptions options{.width = 400, .height = 300};
  const std::string bare = draw_picture({panel(drawing)}, options, ImageFormat::kSvg).value();
  drawing.markers = {{.kind = Marker::Kind::kPin, .at = drawing.rods[0].points[0]},
                     {.kind = Marker::Kind::kForce, .at = drawing.rods[0].points[3], .vector = Vec3(0, 0, -2)}};
  const std::string marked = draw_picture({panel(drawing)}, options, ImageFormat::kSvg).value();
  EXPECT_GT(count(marked, "<path"), count(bare, "<path") + 10);
  options.supports = options.forces = Visibility::kHidden;
  EXPECT_EQ(draw_picture({panel(drawing)}, options, ImageFormat::kSvg).value(), bare);
  options.theme = Theme::kDark;
  const std::string dark = draw_picture({panel(drawing)}, options, ImageFormat::kSvg).value();
  EXPECT_NE(dark.find("fill:" + hex(theme_colors(Theme::kDark).page)), std::string::npos);
}

TEST(Picture, LargeNetworksAreFastAndModerateInSize) {
  Drawing drawing;
  std::vector<double> values;
  for (int i = 0; i < 125; ++i) {
    for (int across = 0; across < 2; ++across) {
      std::vector<Vec3> points;
      for (int k = 0; k <= 60; ++k) {
        const double u = i / 6.2 - 10, v = k / 3.0 - 10;
        points.push_back({across ? u : v, across ? v : u, 0.02 * (100 - u * u) * (1 - v * v / 100)});
        if (k > 0) values.push_back(std::sin(u) * std::cos(v));
      }
      drawing.rods.push_back(samples::strip("r", points, 0.02, 0.02));
    }
  }
  drawing.fields = {samples::edge_field("force", values)};
  ASSERT_EQ(drawing.edge_count(), 15000);
  const PictureOptions options{.field = "force"};
  const auto start = std::chrono::steady_clock::now();
  const Result<std::string> png = draw_picture({panel(drawing)}, options, ImageFormat::kPng);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  ASSERT_TRUE(png.ok());
  RecordProperty("milliseconds", static_cast<int>(1000 * seconds));
  EXPECT_LT(draw_picture({panel(drawing)}, options, ImageFormat::kSvg).value().size(), 4u << 20);
}

TEST(Picture, OddShapesAreDrawn) {
  Drawing drawing;
  drawing.rods = {samples::straight(1, 2, 0.3, 0.001, SectionShape::kRectangle)};
  drawing.rods[0].points[2] = drawing.rods[0].points[1];  // an edge without length
  drawing.rods.push_back(samples::strip("back and forth", {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}, 0.01, 0.01));
  drawing.rods.push_back(samples::strip("\xff<&>\n", {{0, 0, 0}, {0, 0, 1}}, 0.01, 0.01));
  drawing.fields = {samples::edge_field("\xc3(", std::vector<double>(5, std::nan("")))};
  const PictureOptions options{.width = 300, .height = 200, .title = "\xff", .field = "\xc3("};
  for (ImageFormat format : {ImageFormat::kPng, ImageFormat::kSvg}) {
    const Result<std::string> picture = draw_picture({panel(drawing)}, options, format);
    ASSERT_TRUE(picture.ok()) << picture.error().text();
    EXPECT_EQ(picture.value().find("nan"), std::string::npos);
  }
}

TEST(Picture, ErrorsSayWhatIsWrong) {
  const auto error = [](const std::vector<Panel>& panels, const PictureOptions& options) {
    const Result<std::string> result = draw_picture(panels, options, ImageFormat::kSvg);
    return result.ok() ? std::string("drawn") : result.error().text();
  };
  PictureOptions options{.width = 300, .height = 200};
  EXPECT_NE(error({}, options).find("nothing to draw"), std::string::npos);
  EXPECT_NE(error({panel({})}, options).find("no rods"), std::string::npos);
  Drawing drawing = samples::beam_and_ring();
  drawing.rods[1].points[0].z() = std::nan("");
  EXPECT_NE(error({panel(drawing)}, options).find("rod \"ring\": point 0"), std::string::npos);
  drawing = samples::beam_and_ring();
  drawing.rods[0].r_n[1] = 0;
  EXPECT_NE(error({panel(drawing)}, options).find("rod \"beam\": the section of edge 1"), std::string::npos);
  options.field = "strain";
  EXPECT_NE(error({panel(samples::beam_and_ring())}, options).find("known fields: axial force, bending"),
            std::string::npos);
  options.field.clear();
  options.width = 0;
  EXPECT_NE(error({panel(samples::beam_and_ring())}, options).find("0 x 200"), std::string::npos);
  options.width = 300;
  options.view.elevation = 3;
  EXPECT_NE(error({panel(samples::beam_and_ring())}, options).find("view"), std::string::npos);
}

TEST(Text, BrokenNamesBecomePrintable) {
  EXPECT_EQ(printable("a\xff\xc3(b\n\xe2\x82\xac"),
            "a?"
            "?(b?\xe2\x82\xac");
  EXPECT_EQ(printable("\xed\xa0\x80\xf0\x9f\x98\x80\xc0\xaf"),
            "?"
            "?"
            "?\xf0\x9f\x98\x80?"
            "?");
  EXPECT_EQ(xml_escaped("<a & \"b\">"), "&lt;a &amp; &quot;b&quot;&gt;");
  EXPECT_EQ(compact_svg("fill:rgb(100%,0%,50.2%);fill-opacity:1;x=\"surface12\""), "fill:#ff0080;x=\"surface\"");
}

}  // namespace
}  // namespace lissom
