#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "lissom/model/structure.h"
#include "scenes/parts.h"

namespace lissom {
namespace {

Rod straight(const std::string& name, const Vec3& a, const Vec3& b, int edges) {
  return scene_models::round_rod(name, Polyline{{a, b}, false}, 1e-3, "PLA", edges);
}

/// n x n cells of unit size, a rod of two edges on every side; nodes lifted to a dome.
Model grid(int n, double lift) {
  Model model;
  const auto at = [&](int i, int j) {
    const double x = i - n / 2.0, y = j - n / 2.0;
    return Vec3(i, j, -lift * (x * x + y * y));
  };
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j < n; ++j) {
      model.rods.push_back(straight("x" + std::to_string(i) + std::to_string(j), at(j, i), at(j + 1, i), 2));
      model.rods.push_back(straight("y" + std::to_string(i) + std::to_string(j), at(i, j), at(i, j + 1), 2));
    }
  }
  return model;
}

Selector of(Selector::Kind kind, const std::string& name = "", double fraction = -1) {
  Selector s;
  s.kind = kind;
  s.name = name;
  s.fraction = fraction;
  return s;
}

struct Built {
  Model model;
  Structure structure;
  explicit Built(Model m) : model(std::move(m)), structure(discretize(model).value()) {}
  std::vector<int> nodes(const Selector& s) const {
    const Result<std::vector<int>> r = select(model, structure, s, "w");
    EXPECT_TRUE(r.ok()) << (r.ok() ? "" : r.error().text());
    return r.ok() ? r.value() : std::vector<int>{};
  }
  Error error(const Selector& s) const {
    const Result<std::vector<int>> r = select(model, structure, s, "w");
    EXPECT_FALSE(r.ok());
    return r.ok() ? Error{} : r.error();
  }
};

TEST(Select, BoundaryOfADomeIsItsOuterSquare) {
  for (const double lift : {0.0, 0.05}) {
    const Built b(grid(5, lift));
    const std::vector<int> nodes = b.nodes(of(Selector::Kind::kBoundary));
    EXPECT_EQ(nodes.size(), 20u);  // where rods meet, not the nodes between
    for (int node : nodes) {
      const Vec3& p = b.structure.nodes[static_cast<size_t>(node)];
      EXPECT_TRUE(p.x() == 0 || p.x() == 5 || p.y() == 0 || p.y() == 5);
    }
    EXPECT_TRUE(std::is_sorted(nodes.begin(), nodes.end()));
  }
}

TEST(Select, BoundaryIgnoresLooseBranchesAndConcaveCornersStay) {
  Model model = grid(3, 0);
  model.rods.push_back(straight("tail", Vec3(0, 0, 0), Vec3(-2, -1, 0), 3));
  model.rods.push_back(straight("inner", Vec3(1, 1, 0), Vec3(1.4, 1.4, 0), 2));
  const Built b(model);
  EXPECT_EQ(b.nodes(of(Selector::Kind::kBoundary)).size(), 12u);
  // An L of three cells.
  Model bent;
  const double c[3][2] = {{0, 0}, {1, 0}, {0, 1}};
  for (const auto& [x, y] : c) {
    const Vec3 p(x, y, 0), q = p + Vec3::UnitX(), r = p + Vec3(1, 1, 0), s = p + Vec3::UnitY();
    for (const auto& [from, to] : {std::pair{p, q}, {q, r}, {r, s}, {s, p}}) {
      bent.rods.push_back(straight("r" + std::to_string(bent.rods.size()), from, to, 2));
    }
  }
  EXPECT_EQ(Built(bent).nodes(of(Selector::Kind::kBoundary)).size(), 8u);
}

TEST(Select, BoundaryOfARingIsAllOfItAndOfAChainItsEnds) {
  Model ring;
  Rod rod = straight("ring", Vec3::Zero(), Vec3::UnitX(), 12);
  rod.curve = Arc{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitZ(), 2 * std::numbers::pi, true};
  ring.rods = {rod};
  EXPECT_EQ(Built(ring).nodes(of(Selector::Kind::kBoundary)).size(), 12u);
  Model chain;
  chain.rods = {straight("a", Vec3::Zero(), Vec3(1, 0, 0), 3), straight("b", Vec3(1, 0, 0), Vec3(1, 1, 0), 3)};
  EXPECT_EQ(Built(chain).nodes(of(Selector::Kind::kBoundary)), (std::vector<int>{0, 6}));
}

TEST(Select, PlacesAlongRods) {
  Model model;
  model.rods = {straight("rod", Vec3::Zero(), Vec3(1, 0, 0), 10)};
  const Built b(model);
  EXPECT_EQ(b.nodes(of(Selector::Kind::kRod, "rod")).size(), 11u);
  EXPECT_EQ(b.nodes(of(Selector::Kind::kRod, "rod", 0)), std::vector<int>{0});
  EXPECT_EQ(b.nodes(of(Selector::Kind::kRod, "rod", 1)), std::vector<int>{10});
  EXPECT_EQ(b.nodes(of(Selector::Kind::kRod, "rod", 0.32)), std::vector<int>{3});
  EXPECT_EQ(b.nodes(of(Selector::Kind::kRod, "rod", 0.25)), std::vector<int>{2});
  EXPECT_EQ(b.error(of(Selector::Kind::kRod, "rod", 1.5)).code, ErrorCode::kRange);
  const Error unknown = b.error(of(Selector::Kind::kRod, "rods"));
  EXPECT_EQ(unknown.code, ErrorCode::kUnknown);
  EXPECT_NE(unknown.hint.find("\"rod\""), std::string::npos);
}

TEST(Select, PointsBoxesJointsUnionsAndSets) {
  Model model = grid(2, 0);
  NamedSet corner, both, loop, first;
  corner.name = "corner";
  corner.nodes.kind = Selector::Kind::kPoint;
  corner.nodes.point = Vec3(0, 0.1, 0);
  both.name = "both";
  both.nodes.kind = Selector::Kind::kUnion;
  both.nodes.parts = {of(Selector::Kind::kSet, "corner"), of(Selector::Kind::kSet, "corner"),
                      of(Selector::Kind::kRod, "x00", 1)};
  loop.name = "loop";
  loop.nodes = of(Selector::Kind::kSet, "loop");
  model.sets = {corner, both, loop};
  const Built b(model);
  EXPECT_EQ(b.nodes(of(Selector::Kind::kSet, "corner")), std::vector<int>{0});
  EXPECT_EQ(b.nodes(of(Selector::Kind::kSet, "both")), (std::vector<int>{0, 2}));
  EXPECT_EQ(b.error(of(Selector::Kind::kSet, "loop")).code, ErrorCode::kConflict);
  EXPECT_NE(b.error(of(Selector::Kind::kSet, "corners")).hint.find("\"corner\""), std::string::npos);
  EXPECT_EQ(b.nodes(of(Selector::Kind::kJoints)).size(), 9u);
  EXPECT_EQ(b.nodes(of(Selector::Kind::kAll)).size(), b.structure.nodes.size());

  Selector far = corner.nodes;
  far.point = Vec3(0, -2, 0);
  const Error error = b.error(far);
  EXPECT_EQ(error.where, "w");
  EXPECT_NE(error.message.find("2 m away"), std::string::npos) << error.message;
  far.tolerance = 3;
  EXPECT_EQ(b.nodes(far), std::vector<int>{0});

  Selector box = of(Selector::Kind::kBox);
  box.low = Vec3(-1, -1, -1);
  box.high = Vec3(0, 9, 1);
  EXPECT_EQ(b.nodes(box).size(), 5u);
  box.high = Vec3(-0.5, 9, 1);
  EXPECT_EQ(b.error(box).code, ErrorCode::kGeometry);
  EXPECT_EQ(b.error(of(Selector::Kind::kUnion)).code, ErrorCode::kGeometry);
}

TEST(Select, SetsThatNameEachOtherOftenAreResolvedOnce) {
  Model model;
  model.rods = {straight("rod", Vec3::Zero(), Vec3(1, 0, 0), 2)};
  for (int i = 0; i < 60; ++i) {
    NamedSet set;
    set.name = "s" + std::to_string(i);
    set.nodes = of(Selector::Kind::kUnion);
    const Selector next = i < 59 ? of(Selector::Kind::kSet, "s" + std::to_string(i + 1)) : of(Selector::Kind::kAll);
    set.nodes.parts = {next, next};
    model.sets.push_back(set);
  }
  EXPECT_EQ(Built(model).nodes(of(Selector::Kind::kSet, "s0")).size(), 3u);
}

}  // namespace
}  // namespace lissom
