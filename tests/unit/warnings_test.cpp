#include "lissom/session/warnings.h"

#include <cmath>
#include <gtest/gtest.h>

#include "lissom/session/slack_remedy.h"
#include "lissom/session/totals.h"

namespace lissom {
namespace {

Rod rod_between(const std::string& name, const Vec3& from, const Vec3& to, double r = 1e-3) {
  Rod rod;
  rod.name = name;
  rod.curve = Polyline{{from, to}, false};
  rod.material = "PLA";
  rod.section = {SectionShape::kEllipse, {r}, {r}, 0};
  rod.edges = 2;
  return rod;
}

/// A square of side 0.1 m of pre-stretched knit in four rods, with a fifth rod across it.
System square(double pre_stretch = 1.3, double r = 1e-3) {
  const Vec3 a(0, 0, 0), b(0.1, 0, 0), c(0.1, 0.1, 0), d(0, 0.1, 0);
  Model model;
  model.rods = {rod_between("south", a, b, r), rod_between("east", b, c, r), rod_between("north", c, d, r),
                rod_between("west", d, a, r), rod_between("spar", (d + a) / 2, (b + c) / 2, r)};
  Membrane sail;
  sail.name = "sail";
  sail.shape = MembraneGrid{.corner = Vec2::Zero(), .size = Vec2(0.1, 0.1), .cells_x = 2, .cells_y = 2};
  sail.material = "soft knit";
  sail.pre_stretch = Vec2(pre_stretch, pre_stretch);
  model.membranes = {sail};
  return make_system(model).value();
}

/// The drawn state with every node moved.
template <class Move>
State moved(const System& system, const Move& move) {
  State state = drawn_state(system);
  for (int i = 0; i < system.layout.nodes(); ++i) {
    const Vec3 p = move(state.position(i));
    for (int k = 0; k < 3; ++k) state.q[3 * i + k] = p[k];
  }
  for (int e = 0; e < system.edge_count(); ++e) {
    const StructureEdge& edge = system.structure.edges[e];
    const Vec3 d = state.position(edge.node1) - state.position(edge.node0);
    state.edges[e].length = d.norm();
    state.edges[e].t = d.normalized();
  }
  return state;
}

const Warning* find(const std::vector<Warning>& list, const std::string& what) {
  for (const Warning& w : list) {
    if (w.what == what) return &w;
  }
  return nullptr;
}

TEST(Warnings, NoneForATautFlatSheet) {
  const System system = square();
  EXPECT_TRUE(warnings(system, drawn_state(system), 1).empty());
}

TEST(Warnings, SlackFabricComesWithAPreStretchAndAFactorOfRadii) {
  const System system = square();
  const State state = moved(system, [](const Vec3& p) { return Vec3(p.x() * 0.75, p.y(), p.z()); });
  const std::vector<Warning> list = warnings(system, state, 1, {.compression = 1});
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0].what, "slack fabric");
  EXPECT_NEAR(list[0].value, 1.3 * 0.75, 1e-12);
  EXPECT_NE(list[0].where.find("membrane \"sail\", near ("), std::string::npos) << list[0].where;
  // 1.3 * 1.05 / 0.975 = 1.4; ((1.4^2 - 1) / (1.3^2 - 1))^(1/4) = 1.0863
  EXPECT_NE(list[0].remedy.find("pre-stretch to 1.4 and multiply all radii by 1.09"), std::string::npos)
      << list[0].remedy;
}

TEST(Warnings, FabricWithoutPreStretchIsToldToHaveOne) {
  const System system = square(1);
  const Warning* w = nullptr;
  const std::vector<Warning> list = warnings(system, drawn_state(system), 1);
  ASSERT_NE(w = find(list, "slack fabric"), nullptr);
  EXPECT_NE(w->remedy.find("give it a pre-stretch"), std::string::npos) << w->remedy;
}

TEST(Warnings, CompressedRodsNameTheBoundaryRodToGhost) {
  const System system = square();
  // Squeezed along x, most on the right: only rods along x get shorter.
  const State state =
      moved(system, [](const Vec3& p) { return Vec3(p.x() - (p.x() > 0.06 ? 0.002 : 0.0), p.y(), p.z()); });
  const std::vector<Warning> list = warnings(system, state, 1, {.compression = 0.01});
  int spar = 0, own = 0;
  for (const Warning& w : list) {
    ASSERT_EQ(w.what, "compressed rod");
    EXPECT_NEAR(w.value, 0.04, 1e-12);
    if (w.where.starts_with("rod \"spar\", near (")) {
      ++spar;
      EXPECT_NE(w.remedy.find("make the boundary rod \"east\" a ghost"), std::string::npos) << w.remedy;
    } else {
      ++own;
      EXPECT_NE(w.remedy.find("make it a ghost"), std::string::npos) << w.remedy;
    }
  }
  EXPECT_EQ(spar, 1);
  EXPECT_EQ(own, 2);
  EXPECT_TRUE(warnings(system, state, 1, {.compression = 0.05}).empty());
}

TEST(Warnings, SharpTurnsAndThinRods) {
  const System system = square(1.3, 0.2e-3);
  const double lift = 0.05 * std::tan(11.5 * std::numbers::pi / 180);  // turns by 23 degrees
  const State state = moved(system, [&](const Vec3& p) {
    return Vec3(p.x(), p.y(), p.y() < 0.01 ? lift * (1 - std::abs(p.x() - 0.05) / 0.05) : 0.0);
  });
  const std::vector<Warning> list = warnings(system, state, 1, {.stretch = 0, .compression = 1});
  const Warning *turn = find(list, "turning angle"), *thin = find(list, "thin rod");
  ASSERT_NE(turn, nullptr);
  EXPECT_NEAR(turn->value, 23 * std::numbers::pi / 180, 1e-9);
  EXPECT_TRUE(turn->where.starts_with("rod \"south\", near (50, 0,")) << turn->where;
  EXPECT_NE(turn->remedy.find("some percent off"), std::string::npos);
  ASSERT_NE(thin, nullptr);
  EXPECT_EQ(thin->value, 0.2e-3);
  EXPECT_NE(thin->remedy.find("multiply all radii by 1.25 and the stiffness of the fabric by 2.44"), std::string::npos)
      << thin->remedy;
  EXPECT_EQ(thin->where, "rod \"south\" and 4 more");
  EXPECT_EQ(list.size(), 2u);
}

TEST(SlackRemedy, FollowsTheTensionOfTheFlatSheet) {
  const TriangleRest alike{.corner = {}, .stiffness_1 = 47.2, .stiffness_2 = 47.2, .poisson_ratio = 0.3};
  EXPECT_NEAR(flat_tension(alike, Vec2(1.3, 1.3)), 47.2 / 0.7 * 0.345, 1e-12);
  const TriangleRest other{.corner = {}, .stiffness_1 = 60, .stiffness_2 = 20, .poisson_ratio = 0};
  EXPECT_NEAR(flat_tension(other, Vec2(1.2, 1)), 60 * 0.22 * 1.2 / 2, 1e-12);
  const std::optional<SlackRemedy> remedy = slack_remedy(alike, Vec2(1.3, 1.2), 0.9, 1.05);
  ASSERT_TRUE(remedy.has_value());
  EXPECT_NEAR(remedy->pre_stretch.x(), 1.3 * 1.05 / 0.9, 1e-12);
  EXPECT_NEAR(remedy->pre_stretch.y(), 1.2 * 1.05 / 0.9, 1e-12);
  EXPECT_NEAR(std::pow(remedy->radius_factor, 4) * flat_tension(alike, Vec2(1.3, 1.2)),
              flat_tension(alike, remedy->pre_stretch), 1e-9);
  EXPECT_FALSE(slack_remedy(alike, Vec2(1.3, 1.3), 1.06, 1.05).has_value());
  EXPECT_FALSE(slack_remedy(alike, Vec2(1, 1), 0.9, 1.05).has_value());
  EXPECT_FALSE(slack_remedy(alike, Vec2(1.3, 1.3), 0, 1.05).has_value());
}

TEST(Totals, BoxAreaAndSlack) {
  const System system = square();
  // The half with y > 0.05 shrinks to 70 % along y; everything stands up along z.
  const State state = moved(system, [](const Vec3& p) {
    const double y = p.y() < 0.06 ? p.y() : 0.05 + 0.7 * (p.y() - 0.05);
    return Vec3(p.x(), 0.2, y);
  });
  const Totals t = totals(system, state, 1);
  EXPECT_NEAR(t.height, 0.085, 1e-12);
  EXPECT_NEAR(t.low.y(), 0.2, 1e-12);
  EXPECT_NEAR(t.high.x() - t.low.x(), 0.1, 1e-12);
  EXPECT_NEAR(t.area, 0.0085, 1e-12);
  EXPECT_NEAR(t.rest_area, 0.01 / 1.69, 1e-12);
  EXPECT_NEAR(t.slack_area, 0.0035, 1e-12);
  EXPECT_NEAR(t.smallest_stretch, 0.91, 1e-12);
}

}  // namespace
}  // namespace lissom
