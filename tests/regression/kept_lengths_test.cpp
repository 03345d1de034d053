/// Edges that keep a part of their length, as a wish about rest shapes.

#include "lissom/design/kept_lengths.h"

#include <gtest/gtest.h>
#include <memory>
#include <utility>

#include "lissom/design/network_radii.h"
#include "lissom/design/rest_shape.h"
#include "scenes/parts.h"

namespace lissom {
namespace {

constexpr int kEdges = 4;

/// A rod from the origin, 20 mm along x.
std::shared_ptr<const Design> one_rod() {
  ObjLines drawing;
  drawing.points = {Vec3::Zero(), Vec3(0.02, 0, 0)};
  drawing.segments = {{0, 1}};
  Model model = scene_models::sheet("line", drawing, 1e-3, "TPU 92A", kEdges);
  Result<System> system = make_system(model);
  EXPECT_TRUE(system) << system.error().text();
  return std::make_shared<const Design>(Design{std::move(model), std::move(system).value()});
}

/// The far end moves by (x, y) mm.
VecX moved(const DesignSpace& space, double x, double y) {
  VecX p = space.start();
  for (Eigen::Index i = 0; i < p.size(); ++i) {
    const Parameter& parameter = space.parameters()[static_cast<std::size_t>(i)];
    if (parameter.at->x() > 0.01 && parameter.axis < 2) p[i] = 1e-3 * (parameter.axis == 0 ? x : y);
  }
  return p;
}

TEST(KeptLengths, ShortEdgesCountAndNothingElse) {
  const std::shared_ptr<const Design> base = one_rod();
  const Result<LinearSpace> space = rest_shape_space(base, {ControlStage::kEnds, 0.019, RestShapeGauge::kFree});
  ASSERT_TRUE(space);
  const ParameterGoal wish = make_kept_lengths(*base, space.value());
  ASSERT_EQ(wish.rows.rows(), kEdges);
  EXPECT_TRUE(wish_residual(wish, space.value().start()).isZero(0));
  EXPECT_TRUE(wish_residual(wish, moved(space.value(), -3.9, 10)).isZero(0));  // 0.8 of 20 mm are kept
  EXPECT_TRUE(wish_residual(wish, moved(space.value(), 15, 0)).isZero(0));
  const VecX half = wish_residual(wish, moved(space.value(), -10, 0)),
             gone = wish_residual(wish, moved(space.value(), -18, 0));
  for (int e = 0; e < kEdges; ++e) {
    EXPECT_GT(std::abs(half[e]), 0);
    EXPECT_NEAR(gone[e] / half[e], 7.0 / 3, 1e-9);  // 0.7 and 0.3 of the length are missing
  }
}

TEST(KeptLengths, AreNoneOfRadii) {
  const std::shared_ptr<const Design> base = one_rod();
  const Result<LinearSpace> space = radii_space(base, ControlStage::kEnds, {1e-3, 3e-3});
  ASSERT_TRUE(space);
  EXPECT_EQ(make_kept_lengths(*base, space.value()).rows.rows(), 0);
}

}  // namespace
}  // namespace lissom
