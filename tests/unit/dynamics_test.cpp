/// Motion in time: order, energy, momenta, damping, supports that move, and what happens when it goes wrong.
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <gtest/gtest.h>
#include <numbers>

#include "lissom/motion/motion.h"
#include "lissom/motion/natural_modes.h"
#include "tests/count_allocations.h"
#include "tests/unit/motion_samples.h"

namespace lissom {
namespace {

TEST(Dynamics, SecondOrderForEveryNumericalDamping) {
  const Vibration vibration(cantilever("PLA", 0.5e-3, 1e-3, 12), {ModeKind::kBending, Vec3::UnitZ()}, 3);
  EXPECT_NEAR(vibration.mode.frequency, 10.1585, 0.1);
  for (const double rho : {1.0, 0.8, 0.0}) {
    const double coarse = phase_error(vibration, rho, 80, 2), fine = phase_error(vibration, rho, 160, 2);
    EXPECT_GT(std::log2(coarse / fine), 1.9) << rho;
    EXPECT_LT(std::log2(coarse / fine), 2.2) << rho;
  }
  // The midpoint rule's known error: the period is longer by (omega dt)^2 / 12.
  EXPECT_NEAR(phase_error(vibration, 1, 40, 2), 4 * kPi * std::pow(2 * kPi / 40, 2) / 12, 2e-3);
}

TEST(Dynamics, EnergyBalanceOfALargeSwing) {
  // A soft pendulum let go from the horizontal: large rotations, bending on the way.
  Model model = rod_model("TPU 92A", 1e-3, 2e-3, 12, {support_at(SupportKind::kPin, at_rod("rod", 0))});
  model.poses[0].gravity = Gravity{};
  MotionCase& motion = model.motions[0];
  motion.duration = 2;
  motion.step = 4e-3;
  motion.record_every = 0.02;
  motion.error_tolerance = 2e-4;
  const MotionResult result = run(model);
  EXPECT_EQ(result.verdict, MotionVerdict::kFinished) << result.message;
  double kinetic = 0, lowest = 0;
  for (size_t i = 0; i < result.records.size(); ++i) {
    kinetic = std::max(kinetic, result.records[i].translation_energy);
    lowest = std::min(lowest, result.states[i].position(12).z());
    EXPECT_EQ(result.records[i].time, static_cast<double>(i) * 0.02);
    EXPECT_EQ(result.records[i].ledger.numerical_loss, 0);
    EXPECT_EQ(result.records[i].ledger.rayleigh_loss, 0);
  }
  EXPECT_EQ(result.records.size(), 101u);
  EXPECT_LT(lowest, -0.13);
  EXPECT_LT(result.balance_error(), 0.01);
  // What the weight gives up is kinetic, but for the bending.
  EXPECT_GT(kinetic, 0.5 * 1200 * kPi * 2e-6 * kLength * 9.81 * kLength / 2);
}

TEST(Dynamics, NumericalDampingRemovesWhatTheStepDoesNotResolve) {
  const Vibration axial(cantilever("PLA", 0.5e-3, 1e-3, 12), {ModeKind::kAxial, Vec3::Zero()}, 24);
  const Vibration bending(cantilever("PLA", 0.5e-3, 1e-3, 12), {ModeKind::kBending, Vec3::UnitZ()}, 3);
  for (const double rho : {1.0, 0.5}) {
    for (const Vibration* vibration : {&axial, &bending}) {
      Integrator integrator(vibration->problem, vibration->history, {.rho_infinity = rho}, {});
      const double small = 1e-8;
      integrator.begin(drawn_state(vibration->system), small * vibration->omega() * vibration->mode.shape);
      const double before = vibration->energy(integrator);
      for (int i = 0; i < 40; ++i) {
        ASSERT_TRUE(integrator.attempt(1e-3).converged);  // about a hundredth of the bending period, three axial ones
        integrator.accept();
      }
      const double left = vibration->energy(integrator) / before;
      if (rho == 1 || vibration == &bending) {
        EXPECT_NEAR(left, 1, 0.02) << rho;
      } else {
        EXPECT_LT(left, 1e-6);
        // The books know where it went.
        EXPECT_NEAR(integrator.ledger().numerical_loss, before, 0.02 * before);
      }
    }
  }
}

TEST(Dynamics, RayleighDampingFollowsTheory) {
  const Vibration vibration(cantilever("PLA", 0.5e-3, 1e-3, 12), {ModeKind::kBending, Vec3::UnitZ()}, 3);
  const double w = vibration.omega();
  for (const IntegratorOptions options : {IntegratorOptions{.mass_damping = 4}, {.stiffness_damping = 8 / (w * w)}}) {
    Integrator integrator(vibration.problem, vibration.history, options, {});
    integrator.begin(drawn_state(vibration.system), 1e-6 * w * vibration.mode.shape);
    const double before = vibration.energy(integrator);
    const int steps = 400;
    const double dt = 2 * kPi / w / 100;
    for (int i = 0; i < steps; ++i) {
      ASSERT_TRUE(integrator.attempt(dt).converged);
      integrator.accept();
    }
    // Amplitudes fall like exp(-(alpha + beta w^2) t / 2).
    const double rate = options.mass_damping + options.stiffness_damping * w * w;
    const double left = vibration.energy(integrator) / before;
    EXPECT_NEAR(std::log(left), -rate * steps * dt, 0.01 * rate * steps * dt);
    EXPECT_NEAR(integrator.ledger().rayleigh_loss, before * (1 - left), 0.01 * before);
  }
}

TEST(Dynamics, TorsionalVibrationHasItsWaveSpeed) {
  const Vibration vibration(cantilever("PLA", 1e-3, 1e-3, 30), {ModeKind::kTorsional, Vec3::Zero()}, 30);
  EXPECT_NEAR(vibration.mode.frequency, 1651.08, 0.01 * 1651.08);
  EXPECT_LT(phase_error(vibration, 1, 100, 2), 2 * 4 * kPi * std::pow(2 * kPi / 100, 2) / 12);
}

TEST(Dynamics, RollsWithoutInertiaFollowTheShape) {
  Model model = cantilever("TPU 92A", 1e-3, 2e-3, 10);
  model.poses[0].gravity = Gravity{};
  // Off the axis of the sections, so that bending and twist couple.
  model.rods[0].axes.normal = Vec3(0, 0.5, 1);
  model.motions[0].duration = 0.2;
  model.motions[0].step = 2e-3;
  model.motions[0].record_every = 0.02;
  model.motions[0].error_tolerance = 1e-4;
  model.motions[0].roll_inertia = false;
  const MotionResult massless = run(model);
  EXPECT_EQ(massless.verdict, MotionVerdict::kFinished) << massless.message;
  EXPECT_LT(massless.balance_error(), 0.01);
  model.motions[0].roll_inertia = true;
  const MotionResult massive = run(model);
  double motion = 0, difference = 0, twist = 0;
  for (size_t i = 0; i < massive.states.size(); ++i) {
    EXPECT_EQ(massless.records[i].roll_energy, 0);
    motion = std::max(motion, (massive.states[i].q - massive.states[0].q).head(33).norm());
    difference = std::max(difference, (massive.states[i].q - massless.states[i].q).head(33).norm());
    twist = std::max(twist, massless.states[i].q.tail(13).head(10).cwiseAbs().maxCoeff());
  }
  EXPECT_GT(twist, 1e-3);
  EXPECT_LT(difference, 0.02 * motion);
}

Model flying_frame() {
  // Two rods joined at a right angle, in free flight with translation and spin.
  Model model = rod_model("TPU 92A", 1e-3, 2e-3, 8, {});
  Rod second = model.rods[0];
  second.name = "second";
  second.curve = Polyline{{Vec3::Zero(), Vec3(0, 0.08, 0.03)}, false};
  second.edges = 5;
  model.rods.push_back(second);
  model.motions[0].duration = 0.1;
  model.motions[0].step = 1e-3;
  model.motions[0].error_tolerance = 1e-4;
  MotionCase::Kick all;
  all.velocity = Vec3(0.5, 0.2, 1);
  MotionCase::Kick tip;
  tip.at = at_rod("second", 1);
  tip.velocity = Vec3(8, -5, 20);
  MotionCase::Kick other = tip;
  other.at = at_rod("rod", 1);
  other.velocity = Vec3(0, -15, 4);
  model.motions[0].kicks = {all, tip, other};
  return model;
}

TEST(Dynamics, FreeFlightConservesMomenta) {
  const MotionResult result = run(flying_frame());
  EXPECT_EQ(result.verdict, MotionVerdict::kFinished) << result.message;
  const MotionRecord& first = result.records.front();
  double turned = 0, bent = 0;
  for (size_t i = 0; i < result.records.size(); ++i) {
    const MotionRecord& record = result.records[i];
    EXPECT_LT((record.momentum - first.momentum).norm(), 1e-6 * first.momentum.norm());
    EXPECT_LT((record.angular_momentum - first.angular_momentum).norm(), 1e-4 * first.angular_momentum.norm());
    turned = std::max(turned, std::acos(result.states[i].edges[3].t.dot(result.states[0].edges[3].t)));
    bent = std::max(bent, record.elastic_energy);
  }
  EXPECT_GT(turned, 0.3);
  EXPECT_GT(bent, 1e-3 * first.translation_energy);
  EXPECT_LT(result.balance_error(), 0.01);
}

TEST(Dynamics, SpinOfATurningRodKeepsItsAngularMomentum) {
  // Without the gyroscopic couple the spin would turn with the rod for nothing.
  Model model = rod_model("PLA", 4e-3, 4e-3, 6, {});
  const System system = make_system(model).value();
  const StaticProblem problem = make_static_problem(model, system, model.poses[0], "", NullMotions::kKeep).value();
  const LoadHistory history;
  Integrator integrator(problem, history, {}, {});
  VecX velocity = VecX::Zero(system.layout.size());
  for (int i = 0; i <= 6; ++i) velocity[3 * i + 1] = 10 * (system.structure.nodes[i].x() - kLength / 2);
  velocity.tail(6).setConstant(2000);
  integrator.begin(drawn_state(system), velocity);
  const auto angular_momentum = [&] {
    const VecX v = integrator.velocity();
    Vec3 sum = Vec3::Zero();
    for (int i = 0; i <= 6; ++i) {
      const Vec3 x = integrator.state().position(i);
      sum += integrator.mass()[3 * i] * x.cross(v.segment<3>(3 * i));
    }
    for (int e = 0; e < 6; ++e) sum += integrator.mass()[21 + e] * v[21 + e] * integrator.state().edges[e].t;
    return sum;
  };
  const Vec3 before = angular_momentum();
  for (int i = 0; i < 500; ++i) {
    ASSERT_TRUE(integrator.attempt(1e-4).converged);
    integrator.accept();
  }
  const double spin = 2000 * 6 * integrator.mass()[21];
  const double turned = std::acos(std::clamp(integrator.state().edges[0].t.x(), -1.0, 1.0));
  EXPECT_GT(turned, 0.05);
  EXPECT_LT((angular_momentum() - before).norm(), 0.01 * spin);
}

TEST(Dynamics, SameBytesForAnyNumberOfThreads) {
  const Model model = flying_frame();
  ThreadPool two(2);
  Context context;
  const MotionResult one = run(model);
  context.threads = &two;
  const MotionResult other = run(model, {}, context);
  ASSERT_EQ(one.last.q.size(), other.last.q.size());
  EXPECT_EQ(std::memcmp(one.last.q.data(), other.last.q.data(), sizeof(double) * one.last.q.size()), 0);
  EXPECT_EQ(one.steps, other.steps);
}

TEST(Dynamics, AdaptiveAgreesWithSmallFixedSteps) {
  Model model = cantilever("TPU 92A", 1e-3, 2e-3, 10);
  model.poses[0].gravity = Gravity{};
  model.motions[0].duration = 0.3;
  model.motions[0].step = 0.02;
  model.motions[0].record_every = 0.03;
  model.motions[0].error_tolerance = 1e-5;
  const MotionResult adaptive = run(model);
  model.motions[0].adaptive = false;
  model.motions[0].step = 2e-4;
  const MotionResult fixed = run(model);
  EXPECT_EQ(fixed.steps, 1500);
  EXPECT_LT(adaptive.steps, 700);
  ASSERT_EQ(adaptive.states.size(), fixed.states.size());
  for (size_t i = 0; i < fixed.states.size(); ++i) {
    EXPECT_LT((adaptive.states[i].position(10) - fixed.states[i].position(10)).norm(), 0.01 * kLength);
  }
}

/// A rod whose centreline is held, twisted at its end in the start pose and released there.
Model twisted_axis(double twist) {
  Support line = support_at(SupportKind::kPin, at_rod("rod"));
  Support clamp = support_at(SupportKind::kClamp, at_rod("rod", 0));
  Model model = rod_model("PLA", 1e-3, 1e-3, 30, {line, clamp});
  Pose twisted = model.poses[0];
  twisted.name = "twisted";
  Support turned = support_at(SupportKind::kClamp, at_rod("rod", 1));
  turned.turn_axis = Vec3::UnitX();
  turned.turn_angle = twist;
  twisted.supports.push_back(turned);
  model.poses.push_back(twisted);
  MotionCase& motion = model.motions[0];
  motion.start_pose = "twisted";
  motion.duration = 1 / 1651.08;
  motion.step = motion.duration / 200;
  motion.adaptive = false;
  return model;
}

TEST(Dynamics, ReleaseKeepsTheTwistOfTheStartPose) {
  const double twist = 2 * kPi + 0.5;  // more than one turn
  const Model model = twisted_axis(twist);
  const MotionResult result = run(model);
  ASSERT_EQ(result.verdict, MotionVerdict::kFinished) << result.message;
  const System system = make_system(model).value();
  const int roll = system.layout.roll(29);
  const double shear = 3.31e9 / (2 * 1.36), stiffness = shear * kPi * 0.5e-12;
  // The joint at the released end has no mass: it follows its edge at once, and the spring between them, half an edge
  // long, gives up its share.
  const double energy = stiffness * twist * twist / kLength / 2 * 59 / 60;
  EXPECT_NEAR(result.records[0].elastic_energy, energy, 1e-6 * energy);
  EXPECT_NEAR(result.states[0].q[roll], twist, 0.05 * twist);
  // Half a period later (one length there, one back) it is twisted the other way; then back.
  EXPECT_NEAR(result.states[100].q[roll], -twist, 0.1 * twist);
  EXPECT_NEAR(result.states[200].q[roll], twist, 0.1 * twist);
  EXPECT_NEAR(result.records[50].roll_energy, result.records[0].elastic_energy,
              0.05 * result.records[0].elastic_energy);
  EXPECT_LT(result.balance_error(), 1e-3);
}

TEST(Dynamics, WorkOfMovingSupportsIsInTheBalance) {
  Model model = cantilever("TPU 92A", 1e-3, 2e-3, 10);
  model.poses[0].supports[0].move = Vec3(0, 0, 0.05);
  model.poses[0].supports[0].turn_axis = Vec3::UnitY();
  model.poses[0].supports[0].turn_angle = 1;
  model.motions[0].duration = 0.4;
  model.motions[0].step = 5e-3;
  model.motions[0].record_every = 0.1;
  model.motions[0].error_tolerance = 1e-4;
  model.motions[0].load_factor = {Vec2(0, 0), Vec2(0.1, 1), Vec2(0.25, 0.5)};
  const MotionResult result = run(model);
  ASSERT_EQ(result.verdict, MotionVerdict::kFinished) << result.message;
  EXPECT_NEAR(result.states[1].position(0).z(), 0.05, 1e-12);
  EXPECT_NEAR(result.states[4].position(0).z(), 0.025, 1e-12);
  EXPECT_GT(result.records[1].ledger.support_work, 1e-4);
  EXPECT_LT(result.balance_error(), 0.01);
}

TEST(Dynamics, WatchesSeeTheTurn) {
  Model model = rod_model("PLA", 2e-3, 2e-3, 4, {support_at(SupportKind::kPin, at_rod("rod", 0))});
  for (int i = 1; i <= 4; ++i) {
    MotionCase::Kick kick;
    kick.at = at_rod("rod", i / 4.0);
    kick.velocity = Vec3(0, 10 * kLength * i / 4.0, 0);
    model.motions[0].kicks.push_back(kick);
  }
  model.motions[0].duration = 1;
  model.motions[0].step = 0.01;
  model.motions[0].error_tolerance = 1e-4;
  MotionOptions options;
  options.watches = {{"rod", at_rod("rod"), Vec3::Zero(), Vec3::UnitZ()}};
  const MotionResult result = run(model, options);
  const WatchRecord& last = result.records.back().watches[0];
  EXPECT_NEAR(last.turn, 10, 0.05);  // 10 rad/s for a second: more than a full turn
  EXPECT_NEAR(last.turn_rate, 10, 0.1);
  const double first = result.records.front().watches[0].angular_momentum;
  EXPECT_NEAR(last.angular_momentum, first, 0.01 * first);
}

TEST(Dynamics, AWatchWithoutAPointTurnsAboutItsMiddle) {
  Model model = rod_model("PLA", 2e-3, 2e-3, 4, {});
  for (int i = 0; i <= 4; ++i) {
    MotionCase::Kick kick;
    kick.at = at_rod("rod", i / 4.0);
    kick.velocity = Vec3(0, 10 * kLength * (i / 4.0 - 0.5), 0);
    model.motions[0].kicks.push_back(kick);
  }
  model.motions[0].duration = 1;
  model.motions[0].step = 0.01;
  model.motions[0].error_tolerance = 1e-4;
  MotionOptions options;
  options.watches = {{"middle", at_rod("rod"), {}, Vec3::UnitZ()}, {"end", at_rod("rod"), Vec3::Zero(), Vec3::UnitZ()}};
  const MotionResult result = run(model, options);
  EXPECT_NEAR(result.records.back().watches[0].turn, 10, 0.05);
  EXPECT_GT(std::abs(result.records.back().watches[1].turn - 10), 1);
}

#ifdef LISSOM_COUNTS_ALLOCATIONS
TEST(Dynamics, StepsDoNotAllocate) {
  Model model = twisted_axis(1);
  model.poses[0].supports[1].move = Vec3::Zero();
  model.poses[0].supports[1].turn_axis = Vec3::UnitX();
  model.poses[0].supports[1].turn_angle = 1;
  const System system = make_system(model).value();
  const StaticProblem problem = make_static_problem(model, system, model.poses[0], "", NullMotions::kKeep).value();
  const std::vector<Vec2> points{Vec2(0, 0), Vec2(1, 1)};
  const LoadHistory history = LoadHistory::make(points, "").value();
  Integrator integrator(problem, history, {.rho_infinity = 0.9, .stiffness_damping = 1e-6}, {});
  integrator.begin(drawn_state(system), VecX::Zero(system.layout.size()));
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(integrator.attempt(1e-4).converged);
    integrator.accept();
  }
  const long before = allocations.load();
  for (int i = 0; i < 20; ++i) {
    ASSERT_TRUE(integrator.attempt(1e-4).converged);
    integrator.accept();
  }
  EXPECT_EQ(allocations.load() - before, 0);
}
#endif

TEST(Dynamics, EndsInAVerdict) {
  Model model = cantilever("TPU 92A", 1e-3, 2e-3, 5);
  model.poses[0].gravity = Gravity{};
  model.motions[0].duration = 1;
  model.motions[0].step = 0.01;
  MotionOptions few;
  few.max_steps = 3;
  const MotionResult limited = run(model, few);
  EXPECT_EQ(limited.verdict, MotionVerdict::kStepLimit);
  EXPECT_EQ(limited.steps, 3);
  EXPECT_GT(limited.last_time, 0);
  EXPECT_NE(limited.message.find("of 1 s"), std::string::npos);
  const std::atomic<bool> cancel{true};
  Context context;
  context.cancel = &cancel;
  const MotionResult cancelled = run(model, {}, context);
  EXPECT_EQ(cancelled.verdict, MotionVerdict::kCancelled);
  EXPECT_EQ(cancelled.records.size(), 1u);
}

TEST(Dynamics, BadInputIsNamed) {
  const Model good = cantilever("TPU 92A", 1e-3, 2e-3, 5);
  struct Case {
    const char* place;
    void (*spoil)(Model&);
  };
  const Case cases[] = {
      {"/motions/0/duration", [](Model& m) { m.motions[0].duration = -1; }},
      {"/motions/0/step", [](Model& m) { m.motions[0].step = 0; }},
      {"/motions/0/rho_infinity", [](Model& m) { m.motions[0].rho_infinity = 1.5; }},
      {"/motions/0/pose", [](Model& m) { m.motions[0].pose = "nowhere"; }},
      {"/motions/0/start_pose", [](Model& m) { m.motions[0].start_pose = "nowhere"; }},
      {"/motions/0/load_factor/1",
       [](Model& m) {
         m.motions[0].load_factor = {Vec2(1, 0), Vec2(1, 1)};
       }},
      {"/motions/0/kicks/0/at",
       [](Model& m) {
         m.motions[0].kicks = {{at_rod("rood", 1), Vec3::UnitX()}};
       }},
      {"/motions/0/pose", [](Model& m) { m.poses[0].supports[0].move = Vec3::UnitZ(); }},
  };
  for (const Case& c : cases) {
    Model model = good;
    model.motions[0].duration = 1;
    model.motions[0].step = 0.01;
    c.spoil(model);
    const System system = make_system(model).value();
    const auto result = simulate(model, system, model.motions[0], "/motions/0");
    ASSERT_FALSE(result.ok()) << c.place;
    EXPECT_EQ(result.error().where.rfind(c.place, 0), 0u) << result.error().text();
    EXPECT_FALSE(result.error().hint.empty());
  }
}

}  // namespace
}  // namespace lissom
