#include "lissom/session/design_run.h"

#include <chrono>
#include <fmt/format.h>
#include <utility>

namespace lissom {

namespace {

OptimizeOptions options_of(const DesignSettings& settings) {
  OptimizeOptions options;
  for (const DesignMethodInfo& info : design_methods()) {
    if (info.name == settings.method) options.method = info.method;
  }
  options.control =
      settings.control == DesignSettings::Control::kTrustRegion ? StepControl::kTrustRegion : StepControl::kLineSearch;
  options.max_iterations = settings.iterations;
  options.gradient_tolerance = settings.gradient_tolerance;
  options.decrease_tolerance = settings.decrease_tolerance;
  return options;
}

/// Exact Newton needs what some objectives do not have.
Status check_method(const OptimizeOptions& options, const std::vector<Goal>& goals) {
  if (options.method != DesignMethod::kNewton) return {};
  for (const Goal& goal : goals) {
    if (Status s = check_curvature(goal); !s) return s;
  }
  return {};
}

}  // namespace

std::string in_unit_of_goal(double value, std::string_view unit) {
  if (unit == "m") return fmt::format("{:.4g} mm", 1e3 * value);
  return fmt::format("{:.4g}{}{}", value, unit.empty() ? "" : " ", unit);
}

std::vector<double> largest_misses(const StructureProblem& problem) {
  std::vector<double> largest;
  const Design& design = problem.design();
  for (const auto& pose : problem.poses()) {
    pose->stand_at_point(design);
    const Pose& described = design.model.poses[static_cast<std::size_t>(pose->pose())];
    for (const Goal& goal : problem.goals()) {
      if (goal.pose != pose->pose()) continue;
      VecX c;
      goal.objective->values({design, described, pose->problem(), pose->state()}, c);
      largest.push_back(goal_residual(goal.kind, c - goal.target).cwiseAbs().maxCoeff());
    }
  }
  return largest;
}

Result<std::unique_ptr<DesignRun>> DesignRun::start(const Model& model, const Context& context) {
  if (!model.design) {
    return Error{ErrorCode::kConflict, "/design", "the document does not say what may change and what is to be reached",
                 "describe it under \"design\""};
  }
  std::unique_ptr<DesignRun> run(new DesignRun);
  run->context_ = context;
  run->quiet_ = context;
  run->quiet_.progress = {};
  run->quiet_.log = {};
  run->brief_ = *model.design;
  run->options_ = options_of(run->brief_.settings);
  run->constraints_.tolerance = run->brief_.settings.constraint_tolerance;
  if (const Status s = run->options_.validate(); !s) return s.error();
  if (const Status s = run->constraints_.validate(); !s) return s.error();
  Result<BriefSpace> space = make_brief_space(run->brief_, model);
  if (!space) return space.error();
  Result<BriefGoals> goals = make_brief_goals(run->brief_, space.value());
  if (!goals) return goals.error();
  run->goals_ = std::move(goals).value();
  if (const Status s = check_method(run->options_, run->goals_.goals); !s) return s.error();
  StructureProblemOptions options;
  options.solve.tolerance = run->brief_.settings.solve_tolerance;
  Result<std::unique_ptr<StructureProblem>> problem =
      StructureProblem::make(space.value().space, run->goals_.goals, run->goals_.wishes, options, run->quiet_);
  if (!problem) return problem.error();
  run->problem_ = std::move(problem).value();
  context.report({.task = "design", .detail = "finding the shapes of the start"});
  if (const Status s = run->problem_->release(); !s) return s.error();
  run->first_ = run->problem_->design();
  run->first_point_ = run->problem_->point();
  run->first_measures_ = run->problem_->measures();
  run->first_largest_ = largest_misses(*run->problem_);
  if (const Status s = run->begin(); !s) return s.error();
  return run;
}

Status DesignRun::begin() {
  if (problem_->constraints() == 0) {
    plain_.emplace(*problem_, options_);
    return {};
  }
  Result<AugmentedLagrangian> made = AugmentedLagrangian::begin(*problem_, options_, constraints_);
  if (!made) return made.error();
  constrained_.emplace(std::move(made).value());
  return {};
}

Status DesignRun::resume(DesignCheckpoint checkpoint) {
  if (const Status s = problem_->restore(checkpoint.point); !s) return s;
  if (checkpoint.rms.size() != checkpoint.seconds.size()) {
    return Error{ErrorCode::kType, "/seconds", "the history of the run is not complete", "start the run anew"};
  }
  if (problem_->constraints() == 0) {
    Result<Optimizer> made = Optimizer::resumed(*problem_, options_, std::move(checkpoint.descent.inner));
    if (!made) return made.error();
    plain_.emplace(std::move(made).value());
  } else {
    Result<AugmentedLagrangian> made =
        AugmentedLagrangian::resumed(*problem_, options_, constraints_, std::move(checkpoint.descent));
    if (!made) return made.error();
    constrained_.emplace(std::move(made).value());
  }
  history_.seconds = std::move(checkpoint.seconds);
  history_.rms = std::move(checkpoint.rms);
  return {};
}

bool DesignRun::step() {
  const auto begin = std::chrono::steady_clock::now();
  const std::size_t before = state().records.size();
  const bool goes_on = plain_ ? plain_->step(quiet_) : constrained_->step(quiet_);
  if (state().records.size() > before) {
    const double past = history_.seconds.empty() ? 0 : history_.seconds.back();
    history_.seconds.push_back(past + std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    std::vector<double>& rms = history_.rms.emplace_back();
    for (const GoalMeasure& measure : problem_->measures()) rms.push_back(measure.rms);
    context_.report({.task = "design", .iteration = state().iteration, .detail = progress()});
    if (context_.log) context_.log(progress());
  }
  return goes_on;
}

DesignCheckpoint DesignRun::checkpoint() const {
  DesignCheckpoint saved = history_;
  saved.point = problem_->point();
  if (plain_) saved.descent.inner = plain_->state();
  if (constrained_) saved.descent = constrained_->state();
  return saved;
}

const OptimizerState& DesignRun::state() const { return plain_ ? plain_->state() : constrained_->descent().state(); }

std::optional<DesignVerdict> DesignRun::verdict() const {
  return plain_ ? plain_->state().verdict : constrained_->state().verdict;
}

std::string DesignRun::message() const { return plain_ ? plain_->state().message : constrained_->state().message; }

double DesignRun::seconds_left() const {
  return plain_ ? plain_->seconds_left() : constrained_->descent().seconds_left();
}

std::string DesignRun::progress() const {
  std::string text;
  for (const GoalMeasure& measure : problem_->measures()) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", measure.name, in_unit_of_goal(measure.rms, measure.unit));
  }
  if (state().records.empty()) return text;
  const DesignRecord& record = state().records.back();
  text += fmt::format(", gradient {:.2e}", record.gradient);
  if (record.active_bounds > 0) text += fmt::format(", {} at bounds", record.active_bounds);
  if (const double left = seconds_left(); left >= 0) text += fmt::format(", about {:.0f} s left", left);
  return text;
}

}  // namespace lissom
