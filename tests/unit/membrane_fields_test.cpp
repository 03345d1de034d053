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
  if (with_fabric) {
    Membrane sail;
    sail.name = "sail";
    sail.shape = MembraneGrid{.corner = Vec2::Zero(), .size = Vec2(0.1, 0.1)};
    sail.material = "soft knit";
    sail.pre_stretch = Vec2(1.3, 1.3);
    f.model.membranes = {sail};
  }
  f.system = make_system(f.model).value();
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
  EXPECT_EQ(sail.triangles.size(), 2u);
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
