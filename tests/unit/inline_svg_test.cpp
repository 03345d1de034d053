// Pictures for the inside of pages: view/svg_writer.h, view/page_colors.h, and the styles of layers made for reports.

#include <gtest/gtest.h>
#include <set>

#include "lissom/view/chart.h"
#include "lissom/view/page_colors.h"
#include "lissom/view/picture.h"
#include "tests/unit/picture_samples.h"

namespace lissom {
namespace {

using samples::count;
using samples::straight;

Drawing beam(double height) {
  Drawing drawing;
  drawing.rods = {straight(0.1, 4, 0.002, 0.002)};
  for (Vec3& p : drawing.rods[0].points) p.z() += height;
  return drawing;
}

TEST(InlineSvg, TextStaysTextAndColoursArePageVariables) {
  Canvas canvas(ImageFormat::kInlineSvg, 200, 100);
  canvas.fill({1, 1, 1});
  canvas.text({10, 20}, "1 < 2 & \"3\"", {.size = 12, .color = theme_colors(Theme::kLight).ink});
  canvas.polygon(std::array{Vec2(0, 0), Vec2(10, 0), Vec2(0, 10)}, {0.2, 0.4, 0.6});
  const std::string svg = canvas.finish("A \"title\"").value();
  EXPECT_EQ(svg,
            "<svg role=\"img\" aria-label=\"A &quot;title&quot;\" viewBox=\"0 0 2000 1000\" fill=\"none\" "
            "stroke-linecap=\"round\" stroke-linejoin=\"round\"><text fill=\"var(--ink)\" font-size=\"120\" x=\"100\" "
            "y=\"200\">1 &lt; 2 &amp; &quot;3&quot;</text><path fill=\"#336699\" d=\"m0 0 100 0-100 100z\"/></svg>");
}

TEST(InlineSvg, NeighboursOfEqualPaintShareAPathAndTurnAlike) {
  Canvas canvas(ImageFormat::kInlineSvg, 100, 100);
  const Color red{1, 0, 0};
  canvas.polygon(std::array{Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)}, red);
  canvas.polygon(std::array{Vec2(5, 6), Vec2(5, 5), Vec2(6, 5)}, red);  // the same way around
  canvas.polygon(std::array{Vec2(5, 5), Vec2(5, 6), Vec2(6, 5)}, red);  // turns the other way
  const std::string svg = canvas.finish("").value();
  EXPECT_EQ(count(svg, "<path"), 1u);
  EXPECT_NE(svg.find("d=\"m0 0 10 0-10 10zm50 60 0-10 10 0zm10-10-10 10 0-10z\""), std::string::npos) << svg;
}

TEST(InlineSvg, TranslucentPiecesStayApart) {
  Canvas canvas(ImageFormat::kInlineSvg, 100, 100);
  for (int i = 0; i < 2; ++i) canvas.polygon(std::array{Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)}, {1, 0, 0}, 0.5);
  EXPECT_EQ(count(canvas.finish("").value(), "<path fill=\"#ff0000\" opacity=\"0.50\""), 2u);
}

TEST(InlineSvg, HasNoIdsThatCouldMeetThoseOfAnotherPicture) {
  Chart chart;
  chart.x.label = "x", chart.y.label = "y";
  chart.series = {{.name = "a", .x = {0, 1}, .y = {1, 2}}, {.name = "b", .x = {0, 1}, .y = {2, 3}}};
  const std::string svg = draw_chart(chart, ImageFormat::kInlineSvg).value();
  EXPECT_EQ(count(svg, " id="), 0u);
  EXPECT_EQ(count(svg, "href"), 0u);
  EXPECT_EQ(count(svg, "http"), 0u);
  EXPECT_EQ(count(svg, "<svg "), count(svg, "</svg>"));
}

TEST(InlineSvg, PageColoursHaveNamesAndPaintsOfTheirOwn) {
  std::set<std::string> names, paints;
  for (const PageColor& c : page_colors()) {
    names.insert(c.name);
    paints.insert(page_paint(c.drawn));
    EXPECT_EQ(page_paint(c.drawn), "var(--" + c.name + ")");
  }
  EXPECT_EQ(names.size(), page_colors().size());
  EXPECT_EQ(paints.size(), page_colors().size());
  EXPECT_EQ(page_paint({0.2, 0.4, 0.6}), "#336699");
}

/// Contrast of two colours as WCAG 2.1 has it.
double contrast(const Color& a, const Color& b) {
  const auto luminance = [](const Color& c) {
    const auto linear = [](double v) { return v <= 0.03928 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
    return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b) + 0.05;
  };
  return std::max(luminance(a), luminance(b)) / std::min(luminance(a), luminance(b));
}

TEST(InlineSvg, TextHasContrastAndStepsGrowInBothThemes) {
  const auto color = [](const std::string& name) {
    for (const PageColor& c : page_colors()) {
      if (c.name == name) return c;
    }
    ADD_FAILURE() << name;
    return PageColor{};
  };
  const PageColor page = color("page");
  for (const char* name : {"ink", "faint"}) {
    EXPECT_GT(contrast(color(name).light, page.light), 4.5) << name;
    EXPECT_GT(contrast(color(name).dark, page.dark), 4.5) << name;
  }
  for (const char* name : {"series-0", "series-1"}) {
    EXPECT_GT(contrast(color(name).light, page.light), 3) << name;
    EXPECT_GT(contrast(color(name).dark, page.dark), 3) << name;
  }
  for (int k = 1; k < kPageSteps; ++k) {
    const PageColor here = color("step-" + std::to_string(k)), before = color("step-" + std::to_string(k - 1));
    EXPECT_GT(contrast(here.light, page.light), 1.1 * contrast(before.light, page.light)) << k;
    EXPECT_GT(contrast(here.dark, page.dark), 1.1 * contrast(before.dark, page.dark)) << k;
  }
}

TEST(ReportLayers, TrackIsBehindLinesAndDotsAreOnTop) {
  Layer track{.drawing = beam(0), .style = Layer::Style::kTrack, .ink = {1, 0, 0}};
  Layer line{.drawing = beam(0.01), .style = Layer::Style::kLines, .ink = {0, 1, 0}};
  track.dots = {Vec3(0.05, 0, 0)};
  const std::string svg = draw_picture({{{line, track}, ""}}, {}, ImageFormat::kInlineSvg).value();
  const size_t red = svg.find("stroke=\"#ff0000\""), green = svg.find("stroke=\"#00ff00\"");
  ASSERT_NE(red, std::string::npos);
  ASSERT_NE(green, std::string::npos);
  EXPECT_LT(red, green);
  EXPECT_GT(svg.find("<circle fill=\"#ff0000\""), green);
  EXPECT_EQ(count(svg, "<circle"), 1u);
}

TEST(ReportLayers, LaterLinesCoverEarlierOnesHoweverNear) {
  // Seen from the front right above, the first one is nearer.
  const Layer near{.drawing = beam(0.01), .style = Layer::Style::kLines, .ink = {1, 0, 0}};
  const Layer far{.drawing = beam(0), .style = Layer::Style::kLines, .ink = {0, 1, 0}};
  const std::string svg = draw_picture({{{near, far}, ""}}, {}, ImageFormat::kInlineSvg).value();
  EXPECT_LT(svg.rfind("stroke=\"#ff0000\""), svg.find("stroke=\"#00ff00\""));
}

TEST(ReportLayers, LinesHaveTheWidthOfTheirWeight) {
  const auto width = [](double weight) {
    Layer line{.drawing = beam(0), .style = Layer::Style::kLines, .ink = {0, 1, 0}, .weight = weight};
    const std::string svg = draw_picture({{{line}, ""}}, {}, ImageFormat::kInlineSvg).value();
    const size_t at = svg.find("stroke=\"#00ff00\" stroke-width=\"");
    return std::stod(svg.substr(at + 31));
  };
  EXPECT_NEAR(width(2), 2 * width(1), 1);  // whole tenths of px
}

TEST(ReportLayers, FlatStepsUseOnlyTheColoursOfTheSteps) {
  Drawing drawing = beam(0);
  drawing.fields = {samples::edge_field("deviation", {0, 1, 2, 3, 4})};
  drawing.fields[0].place = Field::Place::kNode;
  drawing.fields[0].colors = Field::Colors::kSequential;
  PictureOptions options{.field = "deviation", .sections = Sections::kFlat, .steps = kPageSteps};
  const std::string svg = draw_picture({{{{.drawing = drawing}}, ""}}, options, ImageFormat::kInlineSvg).value();
  for (int k = 0; k < kPageSteps; ++k) {
    const std::string paint = "var(--step-" + std::to_string(k) + ")";
    EXPECT_GE(count(svg, "fill=\"" + paint), 1u) << k;  // in the legend
  }
  EXPECT_GE(count(svg, "stroke=\"var(--step-0)"), 1u);
  EXPECT_GE(count(svg, "stroke=\"var(--step-7)"), 1u);
  EXPECT_EQ(count(svg, "=\"#"), 0u);  // nothing but the page's own colours
}

TEST(ReportLayers, StepsOfARangeIncludeItsEnds) {
  const ColorRange range{0, 8};
  constexpr auto kMap = Field::Colors::kSequential;
  EXPECT_EQ(range.color(kMap, 0, 8), page_step(0));
  EXPECT_EQ(range.color(kMap, 0.99, 8), page_step(0));
  EXPECT_EQ(range.color(kMap, 1.01, 8), page_step(1));
  EXPECT_EQ(range.color(kMap, 8, 8), page_step(7));
  EXPECT_EQ(range.color(kMap, 1e9, 8), page_step(7));
  EXPECT_EQ(range.color(kMap, -1, 8), page_step(0));
  EXPECT_EQ(range.color(kMap, NAN, 8), kNoValueColor);
}

TEST(ReportLayers, DotsHaveToBeFinite) {
  Layer layer{.drawing = beam(0)};
  layer.dots = {Vec3(0, NAN, 0)};
  EXPECT_EQ(draw_picture({{{layer}, ""}}, {}, ImageFormat::kSvg).error().where, "dots");
}

}  // namespace
}  // namespace lissom
