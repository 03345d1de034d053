#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "lissom/view/picture.h"
#include "tests/unit/picture_samples.h"

namespace lissom {
namespace {

using samples::count;
using samples::hex;
using samples::panel;
using std::numbers::pi;

PictureOptions small_page() {
  PictureOptions options{.width = 400, .height = 300, .view = Viewpoint::top()};
  options.axes = options.ruler = Visibility::kHidden;
  return options;
}

TEST(MembranePicture, ClothHidesWhatIsBelowAndLetsItShowThrough) {
  Drawing drawing = samples::saddle(4, 0);
  // Straight rods under and over the cloth, in colours of their own.
  drawing.rods.push_back(samples::strip("below", {{-0.04, -0.02, -0.01}, {0.04, -0.02, -0.01}}, 1e-5, 1e-5));
  drawing.rods.push_back(samples::strip("above", {{-0.04, 0.02, 0.01}, {0.04, 0.02, 0.01}}, 1e-5, 1e-5));
  std::vector<double> values(static_cast<size_t>(drawing.edge_count()), 0);
  values[16] = -1;
  values[17] = 1;
  drawing.fields = {samples::edge_field("force", values)};
  PictureOptions options = small_page();
  options.field = "force";
  const auto positions = [&] {
    const std::string svg = draw_picture({panel(drawing)}, options, ImageFormat::kSvg).value();
    const size_t through = svg.find("stroke-opacity:0.2");  // the rods again, faintly, after everything else
    const std::string solid = svg.substr(0, through);
    // Faces that look up at the light have one colour on flat cloth.
    const size_t cloth = solid.rfind("fill:#f");
    EXPECT_NE(through, std::string::npos);
    EXPECT_NE(cloth, std::string::npos);
    const auto at = [&](double value) {
      return solid.find("stroke:" + hex(map_color(Field::Colors::kDiverging, value)));
    };
    EXPECT_NE(at(0), std::string::npos);
    EXPECT_NE(at(1), std::string::npos);
    return std::pair(at(0) < cloth, at(1) < cloth);
  };
  EXPECT_EQ(positions(), std::pair(true, false));
  options.view.elevation = -pi / 2;
  EXPECT_EQ(positions(), std::pair(false, true));
}

TEST(MembranePicture, ClothShowsItsFieldAndTwoLegends) {
  Drawing drawing = samples::saddle(2, 3);
  drawing.fields = {samples::triangle_field("tension", {1, 2, 3, 4, 5, 6, 7, 8}),
                    samples::edge_field("force", std::vector<double>(8, 1))};
  PictureOptions options = small_page();
  const std::string plain = draw_picture({panel(drawing)}, options, ImageFormat::kSvg).value();
  options.membrane_field = "tension";
  options.field = "force";
  const std::string both = draw_picture({panel(drawing)}, options, ImageFormat::kSvg).value();
  EXPECT_EQ(count(plain, "linear"), 0u);
  EXPECT_GE(count(both, "<linearGradient"), 2u);
  options.membrane_field = "force";
  EXPECT_EQ(draw_picture({panel(drawing)}, options, ImageFormat::kSvg).error().code, ErrorCode::kConflict);
  options.membrane_field = "pull";
  EXPECT_NE(draw_picture({panel(drawing)}, options, ImageFormat::kSvg).error().text().find("\"pull\""),
            std::string::npos);
}

TEST(MembranePicture, SlackClothIsHatchedAndTensionHasStrokes) {
  Drawing drawing = samples::saddle(4, 0);
  PictureOptions options = small_page();
  const auto strokes = [&] {
    return count(draw_picture({panel(drawing)}, options, ImageFormat::kSvg).value(), "fill:none");
  };
  const size_t plain = strokes();
  drawing.membranes[0].smallest_stretch.assign(32, 1);
  EXPECT_EQ(strokes(), plain);
  drawing.membranes[0].smallest_stretch.assign(32, 0.99);
  const size_t hatched = strokes();
  EXPECT_GT(hatched, plain + 30);
  options.slack = Visibility::kHidden;
  EXPECT_EQ(strokes(), plain);
  drawing.membranes[0].tension.assign(32, Vec3(1, 0, 0));
  EXPECT_EQ(strokes(), plain);
  options.tension = Visibility::kShown;
  EXPECT_GT(strokes(), plain + 10);
}

TEST(MembranePicture, GuidesAreDashedOverEverything) {
  Layer layer{.drawing = samples::saddle(2, 0), .guides = {{{-0.2, 0, 0}, {0.2, 0, 0}}}};
  const std::string svg = draw_picture({{{layer}, ""}}, small_page(), ImageFormat::kSvg).value();
  EXPECT_EQ(count(svg, "stroke-dasharray"), 1u);
  EXPECT_GT(svg.find("stroke-dasharray"), svg.rfind("fill:#f"));
  layer.guides[0][1].x() = std::nan("");
  EXPECT_FALSE(draw_picture({{{layer}, ""}}, small_page(), ImageFormat::kSvg).ok());
}

TEST(MembranePicture, MembranesAreChecked) {
  Drawing drawing = samples::saddle(2, 0);
  EXPECT_TRUE(check_drawing(drawing).ok());
  drawing.rods.clear();
  EXPECT_TRUE(check_drawing(drawing).ok());
  drawing.fields = {samples::triangle_field("tension", std::vector<double>(7))};
  EXPECT_NE(check_drawing(drawing).error().text().find("7 values where the drawing has 8"), std::string::npos);
  drawing.fields.clear();
  drawing.membranes[0].triangles[3][1] = 9;
  EXPECT_NE(check_drawing(drawing).error().text().find("membrane \"sail\": a triangle names point 9"),
            std::string::npos);
  drawing.membranes[0].triangles[3][1] = 8;
  drawing.membranes[0].points[4].x() = std::nan("");
  EXPECT_NE(check_drawing(drawing).error().text().find("point 4"), std::string::npos);
}

}  // namespace
}  // namespace lissom
