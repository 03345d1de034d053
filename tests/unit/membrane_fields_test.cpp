#include <cmath>
#include <gtest/gtest.h>

#include "lissom/mechanics/system.h"
#include "lissom/session/fields.h"

namespace lissom {
namespace {

/// A square frame of PLA of side 0.1 m, two triangles of pre-stretched knit in it.
struct Frame4 {
  Model model;
  System system;
};

Frame4 square_frame(bool with_fabric) {
  Frame4 f;
  Rod rod;
  rod.name = "frame";
  rod.curve = Polyline{{Vec3(0, 0, 0), Vec3(0.1, 0, 0), Vec3(0.1, 0.1, 0), Vec3(0, 0.1, 0)}, true};
  rod.material = "PLA";
  rod.section = {SectionShape::kEllipse, {1e-3}, {1e-3}, 0};
  rod.edges = 4;
  f.model.rods = {rod};
  f.system = make_system(f.model).value();
  if (!with_fabric) return f;
  Structure& s = f.system.structure;
  s.membranes = {{.name = "sail",
                  .material = "soft knit",
                  .pre_stretch = Vec2(1.3, 1.3),
                  .nodes = {0, 1, 2, 3},
                  .first_triangle = 0,
                  .triangles = 2}};
  for (const std::array<int, 3>& node : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
    StructureTriangle t;
    t.node = node;
    t.membrane = 0;
    for (int k = 0; k < 3; ++k) t.corner[k] = s.nodes[node[k]].head<2>();
    s.triangles.push_back(t);
  }
  return f;
}

TEST(MembraneFields, FlatFabricHasItsPreStretch) {
  const Frame4 f = square_frame(true);
  const State state = drawn_state(f.system);
  const Result<Drawing> drawing = draw_state({f.model, f.system, state}, nullptr);
  ASSERT_TRUE(drawing.ok()) << drawing.error().text();
  ASSERT_TRUE(check_drawing(drawing.value()).ok());
  const auto values = [&](const char* name) { return drawing.value().field(name)->values; };
  const double t = 0.3 / 0.7 * (1.3 * 1.3 - 1) / 2;
  for (int i = 0; i < 2; ++i) {
    EXPECT_NEAR(values("smallest stretch")[i], 1.3, 1e-7);
    EXPECT_NEAR(values("largest stretch")[i], 1.3, 1e-7);
    EXPECT_NEAR(values("largest tension")[i], t, 1e-9);
    EXPECT_NEAR(values("smallest tension")[i], t, 1e-9);
    EXPECT_EQ(values("slack")[i], 0);
    EXPECT_NEAR(values("fabric energy")[i], t * (1.3 * 1.3 - 1) / 2, 1e-9);
  }
  const MembraneSheet& sail = drawing.value().membranes.at(0);
  EXPECT_EQ(sail.points.size(), 4u);
  EXPECT_EQ(sail.triangles[1], (std::array{0, 2, 3}));
  EXPECT_NEAR(sail.tension[0].norm(), t, 1e-9);
  EXPECT_NEAR(sail.smallest_stretch[0], 1.3, 1e-7);
  EXPECT_EQ(values("displacement").size(), 8u);
}

TEST(MembraneFields, AreAbsentWithoutMembranes) {
  const Frame4 f = square_frame(false);
  const State state = drawn_state(f.system);
  const Drawing drawing = draw_state({f.model, f.system, state}, nullptr).value();
  EXPECT_TRUE(drawing.membranes.empty());
  for (const FieldInfo& info : field_list()) {
    EXPECT_EQ(drawing.field(info.name) != nullptr, info.needs == FieldNeeds::kNothing) << info.name;
  }
}

}  // namespace
}  // namespace lissom
