/// Hexagons of rods are softer than squares, and these than triangles [thesis 5.2.2, figure 5.2; mathematics 9].

#include "scenes/cells.h"

#include <gtest/gtest.h>

#include "lissom/equilibrium/settled.h"

namespace lissom {
namespace {

double energy(const scene_models::CellShape& shape, const Vec2& by) {
  const Model model = scene_models::moved_cell(shape, by);
  const System system = make_system(model).value();
  const Equilibrium found = settled(model, system, model.poses[0], "/poses/0", {}).value();
  EXPECT_EQ(found.verdict, Verdict::kStable) << shape.name << ": " << found.message;
  return found.energy;
}

TEST(Cells, AreTheSofterTheMoreCornersTheyHave) {
  for (const Vec2& by : {Vec2(0, 0.005), Vec2(0.005, 0), Vec2(0.003, 0.004), Vec2(-0.004, 0.003), Vec2(0, -0.002)}) {
    const auto shapes = scene_models::cell_shapes();
    const double triangle = energy(shapes[0], by), square = energy(shapes[1], by), hexagon = energy(shapes[2], by);
    EXPECT_GT(triangle, 1.3 * square) << by.transpose();
    EXPECT_GT(square, 3 * hexagon) << by.transpose();
    EXPECT_GT(hexagon, 0);
  }
}

}  // namespace
}  // namespace lissom
