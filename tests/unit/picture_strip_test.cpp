#include "lissom/session/picture_strip.h"

#include <gtest/gtest.h>

#include "lissom/session/ghost_lines.h"
#include "tests/unit/view_samples.h"

namespace lissom {
namespace {

/// Width and height in the head of an SVG, px.
std::pair<int, int> size_of(const std::string& svg) {
  const auto number = [&](const std::string& name) {
    const size_t at = svg.find(" " + name + "=\"");
    return at == std::string::npos ? 0 : std::stoi(svg.substr(at + name.size() + 3));
  };
  return {number("width"), number("height")};
}

TEST(PictureStrip, HeightFollowsFromWhatIsSeen) {
  const PictureStrip strip{.title = "Family", .view = Viewpoint::top(), .width = 1200};
  std::vector<Panel> panels;
  for (double bend : {0.0, 2.0, 4.0}) {
    panels.push_back({{{samples::saddle(2, bend)}}, "bend " + std::to_string(static_cast<int>(bend))});
  }
  const Result<std::string> square = draw_panels(strip, panels, ImageFormat::kSvg);
  ASSERT_TRUE(square.ok()) << square.error().text();
  const auto [width, height] = size_of(square.value());
  EXPECT_EQ(width, 1200);
  EXPECT_GT(height, 400);  // three squares in a row
  EXPECT_LT(height, 1200);
  for (Panel& panel : panels) panel.layers[0].guides = {{{0, -0.4, 0}, {0, 0.4, 0}}};  // eight times as tall
  EXPECT_GT(size_of(draw_panels(strip, panels, ImageFormat::kSvg).value()).second, height);
  EXPECT_FALSE(draw_panels(strip, {}, ImageFormat::kSvg).ok());
}

TEST(GhostLines, AreWhereThePlanDrawsThem) {
  Model model;
  model.plan = Plan{};
  Plan& plan = *model.plan;
  for (const Vec2& at : {Vec2(0, 0), Vec2(0.1, 0), Vec2(0.1, 0.1), Vec2(0, 0.1)}) {
    plan.points.push_back({.name = "p" + std::to_string(plan.points.size()), .at = at, .r_n = 1e-3, .r_b = 1e-3});
  }
  for (int k = 0; k < 4; ++k) {
    plan.rods.push_back({.name = "side " + std::to_string(k),
                         .points = {k, (k + 1) % 4},
                         .curve = PlanCurve::kStraight,
                         .role = k == 2 ? PlanRole::kGhost : PlanRole::kRod});
  }
  plan.material = "PLA";
  plan.edge_length = 0.02;
  plan.fabric.material = "soft knit";
  const Result<System> system = make_system(model);
  ASSERT_TRUE(system.ok()) << system.error().text();
  const State state = drawn_state(system.value());
  const auto lines = ghost_lines(model, system.value(), state);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_GE(lines[0].size(), 6u);
  EXPECT_LT((lines[0].front() - Vec3(0.1, 0.1, 0)).norm(), 1e-12);
  EXPECT_LT((lines[0].back() - Vec3(0, 0.1, 0)).norm(), 1e-12);
  for (const Vec3& p : lines[0]) EXPECT_NEAR(p.y(), 0.1, 1e-12);
  model.plan.reset();
  EXPECT_TRUE(ghost_lines(model, system.value(), state).empty());
}

}  // namespace
}  // namespace lissom
