/// What discretisation warns about or refuses although the document is well formed: rod ends that lie on rods without a
/// joint, and supports that take back each other's movements.

#include <gtest/gtest.h>

#include "lissom/model/structure.h"
#include "scenes/parts.h"

namespace lissom {
namespace {

Rod straight(const std::string& name, const Vec3& a, const Vec3& b, int edges) {
  return scene_models::round_rod(name, Polyline{{a, b}, false}, 1e-3, "PLA", edges);
}

/// A beam of three edges along x and a branch that ends at `place`.
Model branch_at(const Vec3& place) {
  Model model;
  model.rods = {straight("beam", Vec3::Zero(), Vec3(0.3, 0, 0), 3),
                straight("branch", place + Vec3(0, 0.1, 0), place, 2)};
  return model;
}

std::vector<std::string> notes(const Model& model) {
  const Result<Structure> s = discretize(model);
  EXPECT_TRUE(s) << (s ? "" : s.error().text());
  return s ? s.value().notes : std::vector<std::string>();
}

TEST(DiscretizeNotes, ARodEndOnARodBetweenItsNodesIsSaid) {
  const std::vector<std::string> said = notes(branch_at({0.15, 0, 0}));
  ASSERT_EQ(said.size(), 1u);
  EXPECT_EQ(
      said[0],
      "rod \"branch\" ends on rod \"beam\" at (150, 0, 0) mm, but is not joined to it; make that place a point or a "
      "node of both");
}

TEST(DiscretizeNotes, AnEndNextToANodeIsSaid) {
  EXPECT_EQ(notes(branch_at({0.1, 0, 0})).size(), 0u);     // joined
  EXPECT_EQ(notes(branch_at({0.1, 2e-5, 0})).size(), 1u);  // just missed
  EXPECT_EQ(notes(branch_at({0.1, 2e-3, 0})).size(), 0u);  // two rods that lie apart
}

TEST(DiscretizeNotes, NothingIsSaidWhereRodsAreKeptApart) {
  Model model = branch_at({0.15, 0, 0});
  model.merge_distance = -1;
  EXPECT_EQ(notes(model).size(), 0u);
}

TEST(DiscretizeNotes, ManyLooseEndsAreCounted) {
  Model model = branch_at({0.15, 0, 0});
  for (int i = 0; i < 20; ++i) {
    const Vec3 place(0.11 + 0.001 * i, 0, 0);
    model.rods.push_back(straight("more" + std::to_string(i), place + Vec3(0, 0, 0.1), place, 2));
    model.rods.back().axes.normal = Vec3::UnitX();
  }
  const std::vector<std::string> said = notes(model);
  ASSERT_EQ(said.size(), 9u);
  EXPECT_EQ(said[8], "13 more rod ends lie on rods without a joint");
}

Support pin(const std::string& rod, double fraction, const Vec3& move) {
  Support support;
  support.at.kind = Selector::Kind::kRod;
  support.at.name = rod;
  support.at.fraction = fraction;
  support.kind = SupportKind::kPin;
  support.move = move;
  return support;
}

Status held(const std::vector<Support>& supports) {
  Model model;
  model.rods = {straight("beam", Vec3::Zero(), Vec3(0.3, 0, 0), 3)};
  Pose pose;
  pose.name = "held";
  pose.supports = supports;
  model.poses = {pose};
  const Result<Structure> s = discretize(model);
  return s ? Status() : Status(s.error());
}

TEST(DiscretizeSupports, ALaterSupportMayNotTakeBackAMovement) {
  Support all = pin("beam", 1, Vec3::Zero());
  all.at = Selector();
  all.at.kind = Selector::Kind::kAll;
  const Status status = held({pin("beam", 1, Vec3(0, 0, 0.01)), all});
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().where, "/poses/0/supports/1");
  EXPECT_EQ(status.error().message,
            "this support and support 0 hold the node at (300, 0, 0) mm and move it differently");
  EXPECT_EQ(status.error().hint, "hold and move it in one support");
  EXPECT_FALSE(held({all, pin("beam", 1, Vec3(0, 0, 0.01))}));
}

TEST(DiscretizeSupports, AlsoAlongOtherDirections) {
  Support along_x = pin("beam", 1, Vec3(0.01, 0, 0)), along_z = pin("beam", 1, Vec3::Zero());
  along_x.kind = along_z.kind = SupportKind::kFree;
  along_x.directions = {Vec3::UnitX()};
  along_z.directions = {Vec3::UnitZ()};
  EXPECT_FALSE(held({along_x, along_z}));
  EXPECT_TRUE(held({along_z, along_x}));  // what the first one holds stays where it is
}

TEST(DiscretizeSupports, SupportsThatAgreeAreTaken) {
  const Vec3 move(0, 0, 0.01);
  EXPECT_TRUE(held({pin("beam", 0, Vec3::Zero()), pin("beam", 1, move)}));
  EXPECT_TRUE(held({pin("beam", 1, move), pin("beam", 1, move)}));
  Support turned = pin("beam", 1, Vec3::Zero()), clamped = turned;
  turned.kind = clamped.kind = SupportKind::kClamp;
  turned.turn_axis = Vec3::UnitY();
  turned.turn_angle = 0.1;
  EXPECT_FALSE(held({turned, clamped}));
  EXPECT_TRUE(held({turned, turned}));
}

}  // namespace
}  // namespace lissom
