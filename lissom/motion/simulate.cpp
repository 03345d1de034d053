#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <optional>
#include <utility>

#include "lissom/equilibrium/solve.h"
#include "lissom/motion/monitors.h"
#include "lissom/motion/motion.h"

namespace lissom {

namespace {

constexpr MotionVerdictInfo kVerdicts[] = {
    {MotionVerdict::kFinished, "finished", "the motion reached its end", 0},
    {MotionVerdict::kNoStart, "no_start", "there is no stable equilibrium to start from", 16},
    {MotionVerdict::kStepLimit, "step_limit", "the allowed number of steps did not reach the end", 12},
    {MotionVerdict::kStalled, "stalled", "even the smallest step did not converge", 13},
    {MotionVerdict::kCancelled, "cancelled", "stopped by you; what was played is kept", 15},
};

constexpr double kSafety = 0.8, kGrow = 1.25, kShrink = 0.2;
constexpr double kKeep = 0.9;  ///< a step is kept unless it should shrink by more than this, or grow for a while
constexpr int kPatience = 5;   ///< good steps before it grows
constexpr double kSmallestStep = 1e-7;  ///< of MotionCase::step
constexpr int kManyIterations = 8;      ///< a step that needs more does not let the next one grow

Error range_error(const std::string& where, std::string message, std::string hint) {
  return {ErrorCode::kRange, where, std::move(message), std::move(hint)};
}

Status check(const MotionCase& motion, const std::string& where) {
  if (!(motion.duration > 0) || !std::isfinite(motion.duration)) {
    return range_error(where + "/duration", "the duration has to be a positive time", "give it in seconds");
  }
  if (!(motion.step > 0) || motion.step > motion.duration) {
    return range_error(where + "/step", "the time step has to be positive and not longer than the duration",
                       "a fortieth of the shortest period of interest is a good start");
  }
  if (!(motion.record_every >= 0) || !std::isfinite(motion.record_every)) {
    return range_error(where + "/record_every", "the time between records cannot be negative", "0 records every step");
  }
  if (!(motion.rho_infinity >= 0) || motion.rho_infinity > 1) {
    return range_error(where + "/rho_infinity", "the spectral radius has to lie between 0 and 1",
                       "1: no numerical damping, 0.8: high frequencies die out");
  }
  if (!(motion.mass_damping >= 0) || !(motion.stiffness_damping >= 0) || !std::isfinite(motion.mass_damping) ||
      !std::isfinite(motion.stiffness_damping)) {
    return range_error(where + "/mass_damping", "damping cannot be negative", "0 switches it off");
  }
  if (motion.adaptive && (!(motion.error_tolerance > 0) || motion.error_tolerance > 0.1)) {
    return range_error(where + "/error_tolerance", "the error tolerance has to lie between 0 and 0.1", "1e-3 is usual");
  }
  return {};
}

struct PoseOf {
  const Pose* pose;
  std::string where;
};

Result<PoseOf> find_pose(const Model& model, const std::string& name, const std::string& where) {
  for (size_t i = 0; i < model.poses.size(); ++i) {
    if (model.poses[i].name == name) return PoseOf{&model.poses[i], "/poses/" + std::to_string(i)};
  }
  return Error{ErrorCode::kUnknown, where, "there is no pose \"" + name + "\"", "name one of the poses"};
}

/// Velocities at the start, per unknown.
Result<VecX> kicks(const Model& model, const System& system, const MotionCase& motion, const std::string& where) {
  VecX velocity = VecX::Zero(system.layout.size());
  for (size_t k = 0; k < motion.kicks.size(); ++k) {
    const std::string place = where + "/kicks/" + std::to_string(k);
    if (!motion.kicks[k].velocity.allFinite()) {
      return range_error(place + "/velocity", "the velocity is not a finite vector", "give three numbers");
    }
    const Result<std::vector<int>> nodes = select(model, system.structure, motion.kicks[k].at, place + "/at");
    if (!nodes) return nodes.error();
    for (const int node : nodes.value()) velocity.segment<3>(3 * node) = motion.kicks[k].velocity;
  }
  return velocity;
}

class Run {
 public:
  Run(const StaticProblem& problem, const MotionCase& motion, const LoadHistory& history, Monitors& monitors,
      const MotionOptions& options, const Context& context)
      : motion_(motion),
        history_(history),
        monitors_(monitors),
        options_(options),
        context_(context),
        integrator_(problem, history,
                    {motion.rho_infinity, motion.mass_damping, motion.stiffness_damping,
                     motion.roll_inertia ? RollInertia::kLumped : RollInertia::kNone},
                    context) {}

  MotionResult run(const State& start, const VecX& velocity) {
    integrator_.begin(start, velocity);
    record();
    double dt = motion_.step;
    int next_record = 1;
    while (integrator_.time() < motion_.duration) {
      if (context_.cancelled()) return finish(MotionVerdict::kCancelled);
      if (result_.steps >= options_.max_steps) return finish(MotionVerdict::kStepLimit);
      // Ahead to the next time that has to be hit, in equal steps.
      double target = std::min(motion_.duration, history_.next_kink(integrator_.time()));
      bool at_record = motion_.record_every == 0;
      if (motion_.record_every > 0) {
        const double record_time = next_record * motion_.record_every;
        at_record = record_time <= target * (1 + 1e-12);
        if (at_record) target = std::min(target, record_time);
      }
      const double ahead = target - integrator_.time();
      const double pieces = std::max(1.0, std::ceil(ahead / dt * (1 - 1e-9)));
      const StepAttempt attempt = integrator_.attempt(ahead / pieces);
      result_.iterations += attempt.iterations;
      if (!accepted(attempt)) {
        ++result_.rejected_steps;
        dt = ahead / pieces * (attempt.converged ? step_factor(attempt.error) : 0.5);
        if (dt < kSmallestStep * motion_.step) return finish(MotionVerdict::kStalled);
        continue;
      }
      integrator_.accept();
      ++result_.steps;
      last_step_ = ahead / pieces;
      if (pieces == 1) integrator_.set_time(target);
      if (motion_.record_every == 0 || (at_record && pieces == 1)) {
        record();
        ++next_record;
      }
      dt = next_step(dt, attempt);
      context_.report({"motion", integrator_.time() / motion_.duration, result_.steps, attempt.residual, "moving"});
    }
    if (result_.records.back().time < integrator_.time()) record();
    return finish(MotionVerdict::kFinished);
  }

 private:
  bool accepted(const StepAttempt& attempt) const {
    return attempt.converged && (!motion_.adaptive || attempt.error <= motion_.error_tolerance);
  }

  double step_factor(double error) const {
    if (!(error > 0)) return kGrow;
    return std::clamp(kSafety * std::cbrt(motion_.error_tolerance / error), kShrink, kGrow);
  }

  /// Changing the step often excites vibrations that it does not resolve: it is kept as long as it does.
  double next_step(double dt, const StepAttempt& attempt) {
    const double factor = motion_.adaptive ? step_factor(attempt.error) : kGrow;
    const bool good = factor >= kGrow && attempt.iterations <= kManyIterations;
    patience_ = good ? patience_ + 1 : 0;
    // Steps that were shortened only to hit a time say little about how much longer they could be.
    if (factor < kKeep) return factor * last_step_;
    if (patience_ < kPatience) return dt;
    patience_ = 0;
    return std::min(motion_.step, kGrow * dt);
  }

  void record() {
    State settled;
    integrator_.settle(settled);
    MotionRecord record = monitors_.record(integrator_, settled, context_);
    record.steps = result_.steps;
    record.iterations = result_.iterations;
    record.step = last_step_;
    result_.records.push_back(std::move(record));
    result_.states.push_back(std::move(settled));
  }

  MotionResult finish(MotionVerdict verdict) {
    result_.verdict = verdict;
    integrator_.settle(result_.last);
    result_.last_time = integrator_.time();
    result_.message = std::string(motion_verdict_info(verdict).sentence);
    if (verdict != MotionVerdict::kFinished) {
      result_.message += fmt::format("; {:.6g} s of {:.6g} s were computed", result_.last_time, motion_.duration);
    }
    return std::move(result_);
  }

  const MotionCase& motion_;
  const LoadHistory& history_;
  Monitors& monitors_;
  const MotionOptions& options_;
  const Context& context_;
  Integrator integrator_;
  MotionResult result_;
  double last_step_ = 0;
  int patience_ = 0;
};

}  // namespace

const MotionVerdictInfo& motion_verdict_info(MotionVerdict verdict) {
  for (const MotionVerdictInfo& info : kVerdicts) {
    if (info.verdict == verdict) return info;
  }
  return kVerdicts[0];
}

double MotionResult::balance_error() const {
  double drift = 0, scale = 0;
  for (const MotionRecord& record : records) {
    drift = std::max(drift, std::abs(record.drift));
    scale = std::max({scale, record.translation_energy + record.roll_energy,
                      std::abs(record.elastic_energy - records.front().elastic_energy)});
  }
  return scale > 0 ? drift / scale : 0;
}

Result<MotionResult> simulate(const Model& model, const System& system, const MotionCase& motion,
                              const std::string& where, const MotionOptions& options, const Context& context) {
  const Status status = check(motion, where);
  if (!status) return status.error();
  const Result<LoadHistory> history = LoadHistory::make(motion.load_factor, where + "/load_factor");
  if (!history) return history.error();
  const Result<PoseOf> pose = find_pose(model, motion.pose, where + "/pose");
  if (!pose) return pose.error();
  const NullMotions null_motions = motion.roll_inertia ? NullMotions::kKeep : NullMotions::kKeepRigid;
  const Result<StaticProblem> problem =
      make_static_problem(model, system, *pose.value().pose, pose.value().where, null_motions);
  if (!problem) return problem.error();
  const Result<VecX> velocity = kicks(model, system, motion, where);
  if (!velocity) return velocity.error();
  Result<Monitors> monitors = Monitors::make(model, problem.value(), options, where);
  if (!monitors) return monitors.error();
  for (int i = 0; i < system.layout.nodes(); ++i) {
    if (!(system.rest.node_mass[i] > 0)) {
      return Error{ErrorCode::kConflict, where, "node " + std::to_string(i) + " has no mass, so it cannot move in time",
                   "give every material of the structure a density"};
    }
  }

  State start = drawn_state(system);
  if (!motion.start_pose.empty()) {
    const Result<PoseOf> from = find_pose(model, motion.start_pose, where + "/start_pose");
    if (!from) return from.error();
    const Result<StaticProblem> rest = make_static_problem(model, system, *from.value().pose, from.value().where);
    if (!rest) return rest.error();
    Equilibrium equilibrium = solve(rest.value(), start_state(rest.value(), *from.value().pose), 1, {}, context);
    start = std::move(equilibrium.state);
    if (equilibrium.verdict != Verdict::kStable && equilibrium.verdict != Verdict::kCritical) {
      MotionResult result;
      result.verdict = equilibrium.verdict == Verdict::kCancelled ? MotionVerdict::kCancelled : MotionVerdict::kNoStart;
      result.message = std::string(motion_verdict_info(result.verdict).sentence) + ": " + equilibrium.message;
      result.last = std::move(start);
      return result;
    }
  }
  // What stays held has to be where the motion's pose holds it.
  start.load_factor = history.value().at(0);
  const VecX jump = problem.value().supports.prescribed_increment(system, start, start.load_factor);
  Eigen::Index farthest = 0;
  if (jump.cwiseAbs().maxCoeff(&farthest) > 1e-6 * system.structure.size) {
    return Error{
        ErrorCode::kConflict, where + "/pose",
        fmt::format("the motion begins with a jump: its pose holds unknown {} elsewhere ({:.3g}) than it starts",
                    farthest, jump[farthest]),
        "hold it at the same place in both poses, or start the load factor where the start pose is"};
  }
  return Run(problem.value(), motion, history.value(), monitors.value(), options, context).run(start, velocity.value());
}

}  // namespace lissom
