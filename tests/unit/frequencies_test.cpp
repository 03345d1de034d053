/// Natural frequencies against beam theory and the wave equations.
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "lissom/equilibrium/solve.h"
#include "lissom/motion/natural_modes.h"

namespace lissom {
namespace {

constexpr double kLength = 0.15;
constexpr double kPi = std::numbers::pi;

Rod rod_of(const std::string& name, double r_n, double r_b, int edges) {
  Rod rod;
  rod.name = name;
  rod.curve = Polyline{{Vec3::Zero(), Vec3(kLength, 0, 0)}, false};
  rod.material = "PLA";
  rod.section = {SectionShape::kEllipse, {r_n}, {r_b}, 0};
  rod.edges = edges;
  return rod;
}

Selector end_of(const std::string& rod, double fraction) {
  Selector s;
  s.kind = Selector::Kind::kRod;
  s.name = rod;
  s.fraction = fraction;
  return s;
}

/// A rod along x with its normal along z, clamped at x = 0 unless free.
struct Beam {
  Model model;
  System system;
  Pose pose;

  Beam(double r_n, double r_b, int edges, bool clamped, bool ball = false) {
    model.rods = {rod_of("rod", r_n, r_b, edges)};
    if (clamped) {
      Support clamp;
      clamp.at = end_of("rod", 0);
      clamp.kind = ball ? SupportKind::kPin : SupportKind::kClamp;
      pose.supports = {clamp};
    }
    model.poses = {pose};
    system = make_system(model).value();
  }

  std::vector<NaturalMode> modes(int count, NullMotions null_motions = NullMotions::kKeep,
                                 RollInertia inertia = RollInertia::kLumped) const {
    const StaticProblem problem = make_static_problem(model, system, pose, "", null_motions).value();
    const auto result = natural_modes(problem, drawn_state(system), count, inertia);
    EXPECT_TRUE(result.ok()) << (result.ok() ? "" : result.error().text());
    return result.ok() ? result.value() : std::vector<NaturalMode>{};
  }

  double frequency(const std::vector<NaturalMode>& all, const ModeFilter& filter, int k) const {
    const auto modes = separated(system, drawn_state(system), all, RollInertia::kLumped, filter);
    const int i = find_mode(modes, filter, k);
    EXPECT_GE(i, 0);
    return i < 0 ? 0 : modes[i].frequency;
  }
};

TEST(Frequencies, CantileverInBothDirections) {
  const Beam beam(0.5e-3, 1e-3, 100, true);
  const auto modes = beam.modes(10);
  ASSERT_EQ(modes.size(), 10u);
  const double along_n[] = {10.1585, 63.6625, 178.257}, along_b[] = {20.3171, 127.325, 356.514};
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(beam.frequency(modes, {ModeKind::kBending, Vec3::UnitZ()}, k), along_n[k], 0.01 * along_n[k]);
    EXPECT_NEAR(beam.frequency(modes, {ModeKind::kBending, Vec3::UnitY()}, k), along_b[k], 0.01 * along_b[k]);
  }
  for (size_t i = 0; i < modes.size(); ++i) {
    EXPECT_NEAR(modes[i].axial + modes[i].torsional + modes[i].bending, 1, 1e-12);
    EXPECT_NEAR(modes[i].translation.trace() + modes[i].torsional, 1, 1e-12);
    EXPECT_FALSE(modes[i].unstable());
    if (i > 0) EXPECT_GE(modes[i].frequency, modes[i - 1].frequency);
  }
}

TEST(Frequencies, AxialAndTorsional) {
  for (const double r_n : {1e-3, 0.5e-3}) {
    const Beam beam(r_n, 1e-3, 100, true);
    Model polar = beam.model;
    // The wave speed of torsion is that of shear for the polar torsion constant only.
    polar.torsion = TorsionModel::kPolar;
    Beam with_polar = beam;
    with_polar.model = polar;
    with_polar.system = make_system(polar).value();
    const auto modes = with_polar.modes(40);
    EXPECT_NEAR(with_polar.frequency(modes, {ModeKind::kAxial, Vec3::Zero()}, 0), 2723.03, 0.01 * 2723.03);
    EXPECT_NEAR(with_polar.frequency(modes, {ModeKind::kAxial, Vec3::UnitX()}, 0), 2723.03, 0.01 * 2723.03);
    EXPECT_NEAR(with_polar.frequency(modes, {ModeKind::kTorsional, Vec3::Zero()}, 0), 1651.08, 0.01 * 1651.08);
  }
}

TEST(Frequencies, DoubleModesOfRoundRodsAreSeparated) {
  const Beam beam(1e-3, 1e-3, 60, true);
  const auto modes = beam.modes(12);
  // Bending of a round rod in any plane: ask for two oblique directions at right angles.
  const Vec3 u = Vec3(0, 1, 2).normalized(), v = Vec3(0, -2, 1).normalized();
  for (int k = 0; k < 3; ++k) {
    const double first = 20.3171 * std::vector<double>{1, 6.26690, 17.5475}[k];
    EXPECT_NEAR(beam.frequency(modes, {ModeKind::kBending, u}, k), first, 0.01 * first);
    EXPECT_NEAR(beam.frequency(modes, {ModeKind::kBending, v}, k), first, 0.01 * first);
  }
  const auto turned =
      separated(beam.system, drawn_state(beam.system), modes, RollInertia::kLumped, {ModeKind::kAny, u});
  const NaturalMode& mode = turned[find_mode(turned, {ModeKind::kAny, u}, 0)];
  EXPECT_NEAR(mode.share_along(u), 1, 1e-9);
  // Turning keeps modes normalised and orthogonal.
  const VecX mass = lumped_mass(beam.system, RollInertia::kLumped);
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) {
      EXPECT_NEAR(turned[i].shape.dot(mass.cwiseProduct(turned[j].shape)), i == j ? 1 : 0, 1e-9);
    }
  }
}

TEST(Frequencies, FreeRodHasRigidMotionsAndVibratesFreely) {
  const Beam beam(0.5e-3, 1e-3, 80, false);
  const auto modes = beam.modes(9);
  int rigid = 0;
  for (const NaturalMode& mode : modes) rigid += mode.frequency == 0 && !mode.unstable();
  EXPECT_EQ(rigid, 6);
  // cos x cosh x = 1: x = 4.73004 against 1.87510 of the cantilever.
  const double expected = 10.1585 * std::pow(4.730041 / 1.875104, 2);
  EXPECT_NEAR(modes[6].frequency, expected, 0.01 * expected);
}

TEST(Frequencies, WithoutRollInertiaThereAreNoTorsionalModes) {
  const Beam beam(0.5e-3, 1e-3, 40, true);
  const auto modes = beam.modes(30, NullMotions::kKeepRigid, RollInertia::kNone);
  for (const NaturalMode& mode : modes) EXPECT_EQ(mode.torsional, 0);
  EXPECT_NEAR(modes[0].frequency, 10.1585, 0.1);
  EXPECT_EQ(find_mode(modes, {ModeKind::kTorsional, Vec3::Zero()}, 0), -1);
}

TEST(Frequencies, UnstableEquilibriumGrows) {
  // A column upright under an end force above Euler's: straight, but unstable along n.
  Beam beam(0.5e-3, 1e-3, 40, true);
  const double bending = 3.31e9 * kPi * 0.5e-3 * 1e-3 * 0.25e-6 / 4;
  const double critical = bending * std::pow(kPi / (2 * kLength), 2);
  PointForce push;
  push.at = end_of("rod", 1);
  for (const double factor : {0.5, 1.5}) {
    push.force = Vec3(-factor * critical, 0, 0);
    beam.pose.forces = {push};
    const StaticProblem problem =
        make_static_problem(beam.model, beam.system, beam.pose, "", NullMotions::kKeep).value();
    SolveOptions options;
    options.at_saddle = AtSaddle::kStay;
    const Equilibrium e = solve(problem, drawn_state(beam.system), 1, options);
    const auto modes = natural_modes(problem, e.state, 2, RollInertia::kLumped);
    ASSERT_TRUE(modes.ok());
    EXPECT_EQ(modes.value()[0].unstable(), factor > 1);
    if (factor < 1) {
      // f^2 falls nearly linearly to zero at the critical load.
      EXPECT_NEAR(modes.value()[0].frequency, 10.1585 * std::sqrt(0.5), 0.03 * 10.1585);
    }
  }
}

TEST(Frequencies, NothingToMoveIsAnError) {
  Beam beam(0.5e-3, 1e-3, 5, true);
  Material weightless = *find_material("PLA");
  weightless.name = "weightless";
  weightless.density = 0;
  beam.model.materials = {weightless};
  beam.model.rods[0].material = "weightless";
  const System system = make_system(beam.model).value();
  const StaticProblem problem = make_static_problem(beam.model, system, beam.pose, "").value();
  const auto modes = natural_modes(problem, drawn_state(system), 3, RollInertia::kLumped);
  ASSERT_FALSE(modes.ok());
  EXPECT_NE(modes.error().message.find("mass"), std::string::npos);
}

}  // namespace
}  // namespace lissom
