#include "lissom/session/design_run.h"

#include <chrono>
#include <fmt/format.h>
#include <utility>

#include "lissom/design/adaptive_pins.h"
#include "lissom/design/parameters_of.h"

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
  run->model_ = model;
  run->brief_ = *model.design;
  run->constraints_.tolerance = run->brief_.settings.constraint_tolerance;
  if (const Status s = run->constraints_.validate(); !s) return s.error();
  // What is wrong with a later stage is told now, not after hours.
  for (int stage = run->stages() - 1; stage >= 0; --stage) {
    if (const Status s = run->make_stage(stage); !s) return s.error();
  }
  context.report({.task = "design", .detail = "finding the shapes of the start"});
  if (const Status s = run->problem_->release(); !s) return s.error();
  run->first_ = run->problem_->design();
  run->first_point_ = run->problem_->point();
  run->first_measures_ = run->problem_->measures();
  run->first_largest_ = largest_misses(*run->problem_);
  run->first_value_ = run->problem_->value();
  if (const Status s = run->begin(); !s) return s.error();
  return run;
}

Status DesignRun::make_stage(int stage) {
  Brief brief = brief_;
  const bool last = stage + 1 == stages();
  if (!last) {
    const StageBrief& own = brief_.stages[static_cast<std::size_t>(stage)];
    brief.parameters = own.parameters;
    if (own.iterations) brief.settings.iterations = *own.iterations;
  }
  const auto in_stage = [&](Error error) {
    if (!last && error.where.starts_with("/design/parameters")) {
      error.where = fmt::format("/design/stages/{}{}", stage, error.where.substr(std::string_view("/design").size()));
    }
    return error;
  };
  options_ = options_of(brief.settings);
  if (Status s = options_.validate(); !s) return s;
  Result<BriefSpace> space = make_brief_space(brief, model_);
  if (!space) return in_stage(space.error());
  Result<BriefGoals> goals = make_brief_goals(brief, space.value());
  if (!goals) return in_stage(goals.error());
  goals_ = std::move(goals).value();
  if (Status s = check_method(options_, goals_.goals); !s) return s;
  StructureProblemOptions options;
  options.solve.tolerance = brief.settings.solve_tolerance;
  Result<std::unique_ptr<StructureProblem>> problem =
      StructureProblem::make(space.value().space, goals_.goals, goals_.wishes, options, quiet_);
  if (!problem) return in_stage(problem.error());
  if (brief.settings.pins == DesignSettings::Pins::kAdaptive && problem.value()->constraints() > 0) {
    return Error{ErrorCode::kUnsupported, "/design/settings/pins", "soft pins cannot adapt where goals are hard",
                 "make the goals soft, or the pins \"fixed\""};
  }
  stage_end_.reset();
  plain_.reset();
  constrained_.reset();
  problem_ = std::move(problem).value();
  stage_ = stage;
  return {};
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

Status DesignRun::advance() {
  const DesignPoint point = problem_->point();
  Design design = problem_->design();
  effort_before_ = effort();
  if (Status s = make_stage(stage_ + 1); !s) return s;
  // How stiff pins have become is no parameter: it goes on beside them.
  for (std::size_t k = 0; k < problem_->poses().size(); ++k) {
    Pose& pose = design.model.poses[static_cast<std::size_t>(problem_->poses()[k]->pose())];
    for (SoftPin& pin : pose.soft_pins) pin.stiffness /= point.pin_factors[static_cast<Eigen::Index>(k)];
  }
  const Result<VecX> p = parameters_of(problem_->space(), design);
  if (!p) return p.error();
  if (Status s = problem_->release(&p.value(), &point); !s) return s;
  return begin();
}

Status DesignRun::resume(DesignCheckpoint checkpoint) {
  if (checkpoint.stage < 0 || checkpoint.stage >= stages()) {
    return Error{ErrorCode::kType, "/stage", "the document has no such stage", "start the run anew"};
  }
  if (Status s = make_stage(checkpoint.stage); !s) return s;
  if (Status s = problem_->restore(checkpoint.point); !s) return s;
  const std::optional<DesignVerdict> verdict =
      problem_->constraints() == 0 ? checkpoint.descent.inner.verdict : checkpoint.descent.verdict;
  if (verdict && *verdict != DesignVerdict::kCancelled && stage_ + 1 < stages()) stage_end_ = verdict;
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
  steps_ = std::move(checkpoint.steps);
  for (const DesignStep& done : steps_) {
    if (done.stage < stage_) effort_before_ = done.record.effort;
  }
  return {};
}

bool DesignRun::step() {
  if (!status_) return false;
  const auto begin = std::chrono::steady_clock::now();
  if (ended_to_go_on()) {
    status_ = advance();
    return status_.ok();
  }
  const std::size_t before = state().records.size();
  const bool goes_on = plain_ ? plain_->step(quiet_) : constrained_->step(quiet_);
  if (state().records.size() > before) {
    DesignStep done;
    done.stage = stage_;
    done.record = state().records.back();
    done.record.effort = effort();
    if (done.record.accepted && !stage_verdict()) status_ = adapt_pins();
    const double past = steps_.empty() ? 0 : steps_.back().seconds;
    done.seconds = past + std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const std::vector<GoalMeasure> measures = problem_->measures();
    for (const GoalMeasure& measure : measures) done.rms.push_back(measure.rms);
    steps_.push_back(std::move(done));
    const std::string detail = progress(measures);
    context_.report({.task = "design", .iteration = static_cast<int>(steps_.size()), .detail = detail});
    if (context_.log) context_.log(detail);
  }
  return status_.ok() && (goes_on || ended_to_go_on());
}

Status DesignRun::adapt_pins() {
  if (brief_.settings.pins == DesignSettings::Pins::kFixed) return {};
  const Result<VecX> changes = pin_changes(*problem_, goals_);
  if (!changes) return changes.error();
  const Result<bool> changed = problem_->stiffen_pins(changes.value());
  if (!changed) return changed.error();
  if (changed.value()) plain_->value_has_changed();
  return {};
}

bool DesignRun::ended_to_go_on() const {
  const std::optional<DesignVerdict> verdict = stage_verdict();
  return verdict && stage_ + 1 < stages() && *verdict != DesignVerdict::kCancelled &&
         *verdict != DesignVerdict::kBadStart;
}

DesignCheckpoint DesignRun::checkpoint() const {
  DesignCheckpoint saved{stage_, problem_->point(), {}, steps_};
  if (plain_) saved.descent.inner = plain_->state();
  if (constrained_) saved.descent = constrained_->state();
  return saved;
}

const OptimizerState& DesignRun::state() const { return plain_ ? plain_->state() : constrained_->descent().state(); }

DesignEffort DesignRun::effort() const {
  const DesignEffort& now = state().effort;
  return {effort_before_.attempts + now.attempts, effort_before_.solves + now.solves,
          effort_before_.factorizations + now.factorizations, effort_before_.back_solves + now.back_solves};
}

std::optional<DesignVerdict> DesignRun::stage_verdict() const {
  if (stage_end_) return stage_end_;
  return plain_ ? plain_->state().verdict : constrained_->state().verdict;
}

std::optional<DesignVerdict> DesignRun::verdict() const {
  return ended_to_go_on() ? std::optional<DesignVerdict>() : stage_verdict();
}

std::string DesignRun::message() const { return plain_ ? plain_->state().message : constrained_->state().message; }

double DesignRun::seconds_left() const {
  return plain_ ? plain_->seconds_left() : constrained_->descent().seconds_left();
}

std::string DesignRun::progress(const std::vector<GoalMeasure>& measures) const {
  std::string text = stages() > 1 ? fmt::format("stage {} of {}: ", stage_ + 1, stages()) : std::string();
  const std::size_t head = text.size();
  for (const GoalMeasure& measure : measures) {
    text += fmt::format("{}{} {}", text.size() == head ? "" : ", ", measure.name,
                        in_unit_of_goal(measure.rms, measure.unit));
  }
  const DesignRecord& record = state().records.back();
  text += fmt::format(", gradient {:.2e}", record.gradient);
  if (record.active_bounds > 0) text += fmt::format(", {} at bounds", record.active_bounds);
  if (const double left = seconds_left(); left >= 0) text += fmt::format(", about {:.0f} s left", left);
  return text;
}

}  // namespace lissom
