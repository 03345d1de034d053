#include "lissom/model/document.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "lissom/core/file_io.h"
#include "tests/unit/model_bits.h"

// Designated initialisers leave members at their defaults on purpose.
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"

namespace lissom {
namespace {
namespace fs = std::filesystem;

constexpr const char* kGood = "tests/documents/good";

Model read(std::string_view text) {
  Result<Model> model = read_document(text, kGood);
  EXPECT_TRUE(model) << (model ? "" : model.error().text()) << "\n" << text;
  return model ? std::move(model).value() : Model();
}

std::string good(const char* name) {
  Result<std::string> text = read_file(fs::path(kGood) / name);
  EXPECT_TRUE(text);
  return text ? std::move(text).value() : std::string();
}

TEST(Document, GoodDocumentsReadBackToTheSameBits) {
  int count = 0;
  for (const auto& entry : fs::directory_iterator(kGood)) {
    if (entry.path().extension() != ".lissom") continue;
    SCOPED_TRACE(entry.path().string());
    const Model model = read(read_file(entry.path()).value());
    const std::string written = write_document(model);
    const Model again = read(written);
    EXPECT_EQ(ModelBits::of(again), ModelBits::of(model));
    EXPECT_EQ(write_document(again), written);
    EXPECT_TRUE(written.ends_with("}\n"));
    ++count;
  }
  EXPECT_GE(count, 5);
}

TEST(Document, EveryKeyIsRead) {
  const Model m = read(good("everything.lissom"));
  EXPECT_EQ(m.torsion, TorsionModel::kPolar);
  ASSERT_EQ(m.materials.size(), 2u);
  EXPECT_EQ(m.materials[0].name, "soft/hard ~ print");
  EXPECT_EQ(m.materials[0].youngs_modulus, 32e6);
  EXPECT_EQ(m.materials[0].strain_limit, 0.2);
  EXPECT_EQ(m.materials[1].density, 0);
  ASSERT_EQ(m.rods.size(), 9u);
  const Polyline& polyline = std::get<Polyline>(m.rods[0].curve);
  EXPECT_TRUE(polyline.closed);
  EXPECT_EQ(polyline.points[2], Vec3(0.1, 0.1, 0));
  EXPECT_EQ(m.rods[0].edge_length, 0.002);
  EXPECT_EQ(m.rods[0].section.r_n, (std::vector<double>{0.0005, 0.001, 0.0005}));
  EXPECT_EQ(m.rods[0].section.r_b, (std::vector<double>(3, 0.002)));
  EXPECT_EQ(m.rods[0].axes.kind, MaterialAxes::Kind::kTransport);
  EXPECT_EQ(m.rods[0].natural.kind, Natural::Kind::kStraight);
  EXPECT_EQ(m.rods[1].section.r_n, (std::vector<double>(2, 0.00015)));
  EXPECT_EQ(m.rods[1].natural.curvature_n, -0.5);
  EXPECT_EQ(m.rods[1].natural.twist, std::numbers::pi / 2);
  EXPECT_EQ(std::get<Arc>(m.rods[2].curve).angle, 2 * std::numbers::pi);
  EXPECT_EQ(m.rods[2].section.wall, 0.0005);
  EXPECT_EQ(std::get<Helix>(m.rods[3].curve).turns, -3);
  EXPECT_EQ(m.rods[3].natural.axes->normal, Vec3(0, 1, 0));
  EXPECT_EQ(m.rods[4].axes.kind, MaterialAxes::Kind::kJoints);
  EXPECT_EQ(m.rods[6].name, "grid-1");
  EXPECT_EQ(std::get<Polyline>(m.rods[7].curve).points.size(), 3u);
  EXPECT_FALSE(std::get<Polyline>(m.rods[7].curve).closed);
  EXPECT_TRUE(std::get<Polyline>(m.rods[8].curve).closed);
  EXPECT_EQ(m.joint_kind, JointKind::kCorotational);
  EXPECT_EQ(m.joint_weights, JointWeights::kThesis);
  EXPECT_EQ(m.joints.at(0).kind, JointKind::kBall);
  EXPECT_EQ(m.merge_distance, 1e-6);
  ASSERT_EQ(m.membrane_materials.size(), 2u);
  EXPECT_EQ(m.membrane_materials[0].stiffness_2, 15);
  EXPECT_EQ(m.membrane_materials[0].area_density, 0.12);
  EXPECT_DOUBLE_EQ(m.membrane_materials[1].stiffness_1, 47.2e3 * 0.5e-3);
  EXPECT_DOUBLE_EQ(m.membrane_materials[1].area_density, 122 * 0.5e-3);
  ASSERT_EQ(m.membranes.size(), 4u);
  EXPECT_EQ(std::get<MembraneGrid>(m.membranes[0].shape).cells_y, 4);
  EXPECT_EQ(m.membranes[0].pre_stretch, Vec2(1.3, 1.1));
  EXPECT_EQ(m.membranes[0].warp_angle, 0.5);
  EXPECT_EQ(m.membranes[0].bending, 2);
  EXPECT_EQ(std::get<MembraneDisc>(m.membranes[1].shape).inner_radius, 0.1);
  EXPECT_EQ(std::get<MembraneTriangles>(m.membranes[2].shape).columns, 3);
  EXPECT_EQ(std::get<MembraneMesh>(m.membranes[3].shape).triangles.at(1), (std::array<int, 3>{0, 2, 3}));
  EXPECT_EQ(std::get<MembraneMesh>(m.membranes[3].shape).stiffness, (std::vector<double>{1, 3}));
  EXPECT_EQ(std::get<MembraneMesh>(m.membranes[3].shape).density, (std::vector<double>{0, 2.5}));
  EXPECT_EQ(m.membranes[3].rest_folds, RestFolds::kFlat);
  ASSERT_EQ(m.solids.size(), 1u);
  EXPECT_EQ(m.solids[0].points.at(3), Vec3(0, 0, 0.5));
  EXPECT_EQ(m.solids[0].tetrahedra.at(1), (std::array<int, 4>{0, 2, 4, 3}));
  EXPECT_EQ(m.solids[0].material, "TPU 92A");
  EXPECT_EQ(m.solids[0].stiffness, (std::vector<double>{0.1, 1}));
  EXPECT_EQ(m.solids[0].density, (std::vector<double>{1, 0}));
  EXPECT_EQ(m.fabric_tests.at(0).pulls.at(1).across, 0);
  EXPECT_EQ(m.sets.at(1).nodes.parts.at(1).fraction, 0.5);
  const Pose& loaded = m.poses.at(0);
  EXPECT_EQ(loaded.rigid_motion, RigidMotion::kRemove);
  EXPECT_EQ(loaded.supports.at(0).move, Vec3(0, 0, 0.001));
  EXPECT_EQ(loaded.supports[0].move_inwards, 0.002);
  EXPECT_EQ(loaded.supports[0].shrink, 0.02);
  EXPECT_EQ(loaded.supports[1].turn_angle, 2 * std::numbers::pi);
  EXPECT_EQ(loaded.supports[3].kind, SupportKind::kSymmetry);
  EXPECT_EQ(loaded.supports[4].kind, SupportKind::kFree);
  EXPECT_TRUE(loaded.supports[4].roll);
  EXPECT_EQ(loaded.supports[4].rotations.at(0), Vec3(1, 0, 0));
  EXPECT_EQ(loaded.supports[5].directions.at(0), Vec3(0.6, 0.8, 0));
  EXPECT_EQ(loaded.soft_pins.at(1).stiffness, 2);
  EXPECT_EQ(loaded.forces.at(0).force[2], -1);
  EXPECT_TRUE(loaded.forces[0].shared);
  EXPECT_EQ(loaded.moments.at(0).moment, Vec3(0.002, 0, -0.001));
  EXPECT_EQ(loaded.supports[6].at.rim, Selector::Rim::kOuter);
  EXPECT_EQ(loaded.supports[6].deform(0, 1), 0.5);
  EXPECT_EQ(loaded.edge_loads.at(0).force_per_length[0], 3);
  EXPECT_EQ(loaded.stretch_scaling, Scaling::kProportional);
  EXPECT_EQ(m.poses.at(2).form_finding->rounds, 20);
  EXPECT_EQ(loaded.gravity->scaling, Scaling::kConstant);
  EXPECT_EQ(loaded.path->follow, LoadPath::Follow::kArcLength);
  EXPECT_EQ(m.poses.at(1).gravity->acceleration, Vec3(0, 0, -9.81));
  EXPECT_EQ(m.poses.at(2).gravity->acceleration, Vec3(0, 0, -1.62));
  EXPECT_TRUE(m.poses.at(3).frozen);
  EXPECT_EQ(m.motions.at(0).step, 0.001);
  EXPECT_EQ(m.motions[0].load_factor.at(2), Vec2(2, 0.5));
  const Expectation& claim = m.expectations.at(0);
  EXPECT_EQ(claim.combine, "limit");
  EXPECT_EQ(claim.value, (std::vector<double>{0.001, 0.0025, 0.003}));
  EXPECT_EQ(claim.tolerance_absolute, 0.0001);
  EXPECT_EQ(claim.tolerance_relative, 0);
  EXPECT_EQ(claim.scale, 2);
  EXPECT_EQ(claim.offset, 0.001);
  EXPECT_EQ(claim.fraction, 0.25);
  EXPECT_EQ(claim.membrane, "disc");
  EXPECT_EQ(claim.fabric_test, "strips");
  EXPECT_EQ(m.expectations.at(1).tolerance_relative, 0.01);
}

TEST(Document, TheUnitOfAClaimIsTakenFromItsText) {
  const Model m = read(good("cantilever.lissom"));
  EXPECT_EQ(m.expectations.at(1).unit, "deg");
  EXPECT_EQ(m.expectations[1].value.at(0), 14.01 * (std::numbers::pi / 180));
  EXPECT_EQ(m.expectations[0].axis, Vec3(0, 0, -1));
  EXPECT_EQ(m.expectations[0].scale, 0.2);
}

TEST(Document, DirectionsAreNormalised) {
  std::string text = good("everything.lissom");
  text.replace(text.find("[0, 0.6, 0.8], \"z\""), 13, "[0, 3e200, 4e200]");
  const Vec3 normal = read(text).rods.at(1).axes.normals.at(1);
  EXPECT_NEAR((normal - Vec3(0, 0.6, 0.8)).norm(), 0, 1e-15);
}

/// A valid model whose numbers are drawn at random over many magnitudes.
class RandomModel {
 public:
  explicit RandomModel(unsigned seed) : random_(seed) {}

  Model make() {
    Model m;
    m.title = "t\u00e4\"\n\t\\";
    m.materials = {{"m/1", positive(), number(0, 0.5), positive(), positive(), "s"}};
    for (int i = 0; i < 4; ++i) m.rods.push_back(rod(i));
    m.membrane_materials = {{"f/1", positive(), positive(), number(-0.9, 0.9), positive(), positive(), "s"}};
    for (int i = 0; i < 4; ++i) m.membranes.push_back(membrane(i));
    m.solids = {solid()};
    m.plan = plan();
    m.fabric_tests = {{"t", {{any(), 1 + positive(), positive(), pick(2) ? positive() : 0}}}};
    m.joint_kind = static_cast<JointKind>(pick(3));
    m.joint_weights = static_cast<JointWeights>(pick(2));
    m.joints = {{selector(2), static_cast<JointKind>(pick(3))}};
    m.merge_distance = pick(2) ? -1 : positive();
    m.torsion = static_cast<TorsionModel>(pick(2));
    m.sets = {{"s", {.kind = Selector::Kind::kPoint, .point = vector(), .tolerance = positive()}}};
    m.poses = {pose("p"), pose("q")};
    m.motions = {motion()};
    m.expectations = {expectation(), expectation()};
    return m;
  }

 private:
  int pick(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  double number(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  double positive() { return std::pow(10, number(-12, 12)); }
  double thin() { return std::pow(10, number(-12, -3)); }  // splines bend around more than that
  double any() { return pick(8) == 0 ? 0.0 : (pick(2) ? 1 : -1) * positive(); }
  Vec3 vector() { return {any(), any(), any()}; }
  Vec3 direction() { return Vec3(number(0.1, 1), number(-1, 1), number(-1, 1)).normalized(); }

  Plan plan() {
    Plan p;
    for (const char* name : {"a", "b", "c"}) {  // never at one place nor in line
      const size_t k = p.points.size();
      const Vec2 at(double(k) + number(0, 0.9), k == 1 ? number(0.5, 1) : number(-1, 0));
      p.points.push_back({name, at, thin(), thin(), pick(2) == 1});
    }
    const bool closed = pick(2) == 1;
    p.rods = {
        {"plan 1", {0, 1, 2}, static_cast<PlanCurve>(pick(3)), pick(2) ? PlanRole::kGhost : PlanRole::kRod, closed},
        {"plan 2", {2, 0}, PlanCurve::kStraight, PlanRole::kRod, false}};
    p.material = "m/1";
    p.edge_length = positive();
    p.max_turn = number(0.01, 0.5);
    p.fabric.material = "f/1";
    p.fabric.pre_stretch = pick(2) ? Vec2::Constant(number(1, 4)) : Vec2(number(1, 4), number(0.1, 4));
    p.fabric.warp_angle = number(-3, 3);
    p.fabric.edge_length = positive();
    p.fabric.min_angle = number(0.01, 0.5);
    p.fabric.bending = positive();
    p.fabric.outline = {"plan 1"};
    p.fabric.holes = {Vec2(any(), any())};
    return p;
  }
  Selector selector(int depth) {
    Selector s;
    s.kind = static_cast<Selector::Kind>(pick(depth > 0 ? 11 : 10));
    if (s.kind == Selector::Kind::kSet) s.name = "s";
    if (s.kind == Selector::Kind::kPlanPoint) s.name = "a";
    if (s.kind == Selector::Kind::kRod) {
      s.name = "rod1";
      if (pick(2)) s.fraction = number(0, 1);
    }
    if (s.kind == Selector::Kind::kPoint) {
      s.point = vector();
      s.tolerance = pick(2) ? positive() : 0;
    }
    if (s.kind == Selector::Kind::kBox) {
      s.low = vector();
      s.high = s.low.cwiseMax(vector());
    }
    if (s.kind == Selector::Kind::kMembrane || s.kind == Selector::Kind::kRim) s.name = "membrane1";
    if (s.kind == Selector::Kind::kRim) s.rim = static_cast<Selector::Rim>(pick(3));
    if (s.kind == Selector::Kind::kUnion) s.parts = {selector(depth - 1), selector(depth - 1)};
    return s;
  }

  Membrane membrane(int index) {
    Membrane m;
    m.name = "membrane" + std::to_string(index);
    m.material = pick(2) ? "f/1" : "soft knit";
    const Vec2 place(any(), any());
    if (index == 0) m.shape = MembraneGrid{place, Vec2(positive(), positive()), 1 + pick(9), 1 + pick(9)};
    if (index == 1) m.shape = MembraneDisc{place, 1 + positive(), pick(2) ? number(0, 1) : 0, 1 + pick(9), 3 + pick(9)};
    if (index == 2) m.shape = MembraneTriangles{place, positive(), 1 + pick(9), 1 + pick(9)};
    const double size = positive();
    if (index == 3) {
      m.shape = MembraneMesh{{Vec3::Zero(), size * Vec3::UnitX(), size * direction()}, {{0, 1, 2}}, {positive()}, {0}};
    }
    m.pre_stretch = pick(2) ? Vec2(positive(), positive()) : Vec2(1.5, 1.5);
    m.warp_angle = any();
    m.bending = pick(2) ? positive() : 0;
    m.rest_folds = static_cast<RestFolds>(pick(2));
    return m;
  }

  Solid solid() {
    const double size = positive();
    const Vec3 top = number(0.1, 1) * Vec3::UnitZ() + number(-1, 1) * Vec3::UnitX();
    return {"solid",        {Vec3::Zero(), size * Vec3::UnitX(), size * Vec3::UnitY(), size * top},
            {{0, 1, 2, 3}}, "PLA",
            {positive()},   {positive()}};
  }

  Rod rod(int index) {
    Rod r;
    r.name = "rod" + std::to_string(index);
    const Vec3 centre = vector(), start = centre + Vec3(0, 0, 1 + centre.norm());
    if (index == 0) r.curve = Polyline{{vector(), vector(), vector()}, pick(2) == 1};
    if (index == 1) r.curve = Spline{{vector(), vector(), vector(), vector()}, pick(2) == 1};
    if (index == 2) r.curve = Arc{centre, start, Vec3::UnitX(), number(-6, 6), false};
    if (index == 3) r.curve = Helix{centre, start, Vec3::UnitX(), any(), number(0.1, 1e5)};
    r.material = pick(2) ? "m/1" : "PETG";
    r.section.shape = static_cast<SectionShape>(pick(3));
    for (int i = 0; i < 1 + pick(3); ++i) r.section.r_n.push_back(positive());
    r.section.r_b = r.section.r_n;
    if (r.section.shape != SectionShape::kTube && pick(2)) r.section.r_b[0] = positive();
    if (r.section.shape == SectionShape::kTube) {
      r.section.wall = 0.5 * *std::min_element(r.section.r_n.begin(), r.section.r_n.end());
    }
    r.axes.kind = static_cast<MaterialAxes::Kind>(pick(4));
    if (r.axes.kind <= MaterialAxes::Kind::kTransport) r.axes.normal = direction();
    if (r.axes.kind == MaterialAxes::Kind::kPerPoint) r.axes.normals = {direction(), direction()};
    r.natural.kind = static_cast<Natural::Kind>(pick(3));
    if (r.natural.kind == Natural::Kind::kCurved) {
      r.natural.curvature_b = any();
      r.natural.curvature_n = any();
      r.natural.twist = any();
    }
    if (pick(2)) r.natural.length_factor = positive();
    pick(2) ? r.edges = 3 + pick(1000) : r.edge_length = positive();
    return r;
  }

  Pose pose(const char* name) {
    Pose p;
    p.name = name;
    Support support{.at = selector(1), .kind = SupportKind::kClamp, .move = vector(), .turn_axis = direction()};
    support.turn_angle = any();
    if (pick(2)) support.move_inwards = any();
    if (pick(2)) support.shrink = -positive();
    const Vec3 n = direction(), b = n.unitOrthogonal();
    p.supports = {support,
                  {.at = selector(0), .kind = SupportKind::kFree, .directions = {n, b}, .rotations = {b}, .roll = true},
                  {.at = selector(0), .kind = SupportKind::kSymmetry, .normal = n}};
    p.soft_pins = {{selector(0), positive(), pick(2) ? std::optional<Vec3>(vector()) : std::nullopt}};
    p.forces = {{selector(0), vector(), pick(2) == 1, static_cast<Scaling>(pick(2))}};
    p.moments = {{selector(0), vector(), static_cast<Scaling>(pick(2))}};
    p.line_loads = {{{"rod0"}, vector(), static_cast<Scaling>(pick(2))}};
    p.edge_loads = {{selector(0), vector(), static_cast<Scaling>(pick(2))}};
    p.stretch_scaling = static_cast<Scaling>(pick(2));
    if (pick(2)) p.supports[0].deform << direction(), vector(), direction();
    p.gravity = Gravity{vector(), static_cast<Scaling>(pick(2))};
    p.path = LoadPath{any(), positive() * 1e6, 1 + pick(50), LoadPath::Follow::kArcLength, false, pick(2) == 1};
    p.seed = Seed{static_cast<Seed::Shape>(pick(2)), direction(), any()};
    return p;
  }

  MotionCase motion() {
    MotionCase m{.name = "m", .start_pose = "p", .pose = "q", .duration = 1 + positive()};
    m.step = m.duration * number(0.001, 0.1);
    m.record_every = positive();
    m.rho_infinity = number(0, 1);
    m.mass_damping = positive();
    m.stiffness_damping = positive();
    m.load_factor = {{0, any()}, {positive(), any()}};
    m.kicks = {{selector(0), vector()}};
    return m;
  }

  Expectation expectation() {
    Expectation e;
    e.quantity = "q";
    e.poses = {"p"};
    e.at = selector(0);
    e.axis = direction();
    e.fraction = number(0, 1);
    e.mode = pick(9);
    e.scale = any() + 1e-20;
    e.offset = any();
    e.unit = std::vector<std::string>{"", "-", "mm", "deg", "kg/m^3", "in"}[static_cast<std::size_t>(pick(6))];
    e.value = {any()};
    (pick(2) ? e.tolerance_relative : e.tolerance_absolute) = positive();
    return e;
  }

  std::mt19937 random_;
};

TEST(Document, RandomModelsReadBackToTheSameBits) {
  int checked = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    const Model model = RandomModel(seed).make();
    const Status status = model.validate();
    ASSERT_TRUE(status) << status.error().text();
    const std::string text = write_document(model);
    const Result<Model> again = read_document(text);
    ASSERT_TRUE(again) << again.error().text() << "\n" << text;
    ASSERT_EQ(ModelBits::of(again.value()), ModelBits::of(model)) << text;
    ++checked;
  }
  EXPECT_EQ(checked, 300);
}

/// The examples of the guide are documents that work.
TEST(Document, ExamplesOfTheGuideAreGoodDocuments) {
  const std::string guide = read_file("docs/guide/document.md").value();
  const std::string open = "```json\n", close = "```";
  int examples = 0;
  for (std::size_t at = guide.find(open); at != std::string::npos; at = guide.find(open, at)) {
    at += open.size();
    read(guide.substr(at, guide.find(close, at) - at));
    ++examples;
  }
  EXPECT_GE(examples, 3);
}

TEST(Document, DeepNestingNeitherOverflowsNorHangs) {
  for (const char* bracket : {"[", "{\"a\":", "[{\"a\":"}) {
    std::string text = "{\"lissom\": 1, \"sets\": {\"a\": ";
    for (int i = 0; i < 100'000; ++i) text += bracket;
    const Result<Model> model = read_document(text);
    ASSERT_FALSE(model);
    EXPECT_EQ(model.error().message, "the brackets are nested deeper than 64");
  }
}

TEST(Document, AByteOrderMarkIsSkipped) { EXPECT_TRUE(read_document("\xEF\xBB\xBF" + good("smallest.lissom"))); }

}  // namespace
}  // namespace lissom
