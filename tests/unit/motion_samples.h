#pragma once
/// Models and small helpers of the tests of motion in time.

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "lissom/motion/motion.h"
#include "lissom/motion/natural_modes.h"

namespace lissom {

constexpr double kPi = std::numbers::pi;
constexpr double kLength = 0.15;

inline Selector at_rod(const std::string& name, double fraction = -1) {
  Selector s;
  s.kind = Selector::Kind::kRod;
  s.name = name;
  s.fraction = fraction;
  return s;
}

inline Support support_at(SupportKind kind, const Selector& at) {
  Support s;
  s.kind = kind;
  s.at = at;
  return s;
}

/// A rod along x, its normal along z, with a pose "held" (its support) and a motion in it.
inline Model rod_model(const std::string& material, double r_n, double r_b, int edges, std::vector<Support> supports) {
  Model model;
  Rod rod;
  rod.name = "rod";
  rod.curve = Polyline{{Vec3::Zero(), Vec3(kLength, 0, 0)}, false};
  rod.material = material;
  rod.section = {SectionShape::kEllipse, {r_n}, {r_b}, 0};
  rod.edges = edges;
  model.rods = {rod};
  model.torsion = TorsionModel::kPolar;
  Pose pose;
  pose.name = "held";
  pose.supports = std::move(supports);
  model.poses = {pose};
  MotionCase motion;
  motion.name = "motion";
  motion.pose = "held";
  model.motions = {motion};
  return model;
}

inline Model cantilever(const std::string& material, double r_n, double r_b, int edges) {
  return rod_model(material, r_n, r_b, edges, {support_at(SupportKind::kClamp, at_rod("rod", 0))});
}

inline MotionResult run(const Model& model, const MotionOptions& options = {}, const Context& context = {}) {
  const System system = make_system(model).value();
  const auto result = simulate(model, system, model.motions[0], "/motions/0", options, context);
  EXPECT_TRUE(result.ok()) << (result.ok() ? "" : result.error().text());
  return result.ok() ? result.value() : MotionResult{};
}

/// An integrator on a rod, started at rest in the drawn shape with the velocity of one of its modes.
struct Vibration {
  Model model;
  System system;
  StaticProblem problem;
  LoadHistory history;
  NaturalMode mode;

  Vibration(Model m, const ModeFilter& filter, int count, RollInertia inertia = RollInertia::kLumped)
      : model(std::move(m)),
        system(make_system(model).value()),
        problem(make_static_problem(model, system, model.poses[0], "",
                                    inertia == RollInertia::kLumped ? NullMotions::kKeep : NullMotions::kKeepRigid)
                    .value()) {
    const State drawn = drawn_state(system);
    const auto modes = separated(system, drawn, natural_modes(problem, drawn, count, inertia).value(), inertia, filter);
    mode = modes[find_mode(modes, filter, 0)];
  }

  double omega() const { return 2 * kPi * mode.frequency; }

  /// Amplitude of the mode in the present displacement, and its energy.
  double amplitude(const Integrator& integrator) const {
    const VecX dq = integrator.state().q - drawn_state(system).q;
    return dq.dot(integrator.mass().cwiseProduct(mode.shape));
  }
  double energy(const Integrator& integrator) const {
    const double x = amplitude(integrator) * omega(),
                 v = integrator.velocity().dot(integrator.mass().cwiseProduct(mode.shape));
    return (x * x + v * v) / 2;
  }
};

/// Error of the phase after `periods`, relative to a radian, for amplitudes in the linear range.
inline double phase_error(const Vibration& vibration, double rho, int steps_per_period, int periods) {
  Integrator integrator(vibration.problem, vibration.history, {.rho_infinity = rho}, {});
  const double small = 1e-6;
  integrator.begin(drawn_state(vibration.system), small * vibration.omega() * vibration.mode.shape);
  const double dt = 1 / (vibration.mode.frequency * steps_per_period);
  for (int i = 0; i < steps_per_period * periods; ++i) {
    const StepAttempt attempt = integrator.attempt(dt);
    EXPECT_TRUE(attempt.converged);
    integrator.accept();
  }
  return std::abs(vibration.amplitude(integrator)) / small;  // sin(omega t) = 0 at the end
}

}  // namespace lissom
