#include "lissom/session/optimized_report.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>

#include "lissom/session/report_pose.h"

namespace lissom {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

DesignReport::Measure measure_of(std::string_view unit) {
  if (unit == "m") return {"mm", 1000};
  return {std::string(unit), 1};
}

struct VerdictWords {
  DesignReport::Tone tone;
  const char* remedy;
};
VerdictWords words_of(DesignVerdict verdict) {
  using Tone = DesignReport::Tone;
  switch (verdict) {
    case DesignVerdict::kConverged:
    case DesignVerdict::kGoodEnough:
      return {Tone::kReached, ""};
    case DesignVerdict::kCancelled:
      return {Tone::kStopped, "go on with --resume"};
    case DesignVerdict::kIterationLimit:
      return {Tone::kStopped, "go on with --resume and more --iterations"};
    case DesignVerdict::kLimit:
      return {Tone::kStopped, "try another method, or solve the poses more exactly with a smaller solve_tolerance"};
    case DesignVerdict::kJumped:
      return {Tone::kTrouble, "start from another design, or add a goal for the stability margin"};
    case DesignVerdict::kNoEquilibrium:
      return {Tone::kTrouble, "narrow the bounds of the parameters, or hold the structure better"};
    case DesignVerdict::kInfeasible:
    case DesignVerdict::kConstraintLimit:
      return {Tone::kTrouble, "let a hard goal be soft, or widen the bounds of the parameters"};
    case DesignVerdict::kBadStart:
      break;
  }
  return {Tone::kTrouble, "start from another design"};
}

/// Wanted places of the nodes of a pose; not numbers where there is none.
std::vector<Vec3> wanted_places(const DesignRun& run, int pose) {
  std::vector<Vec3> wanted(run.first().system.structure.nodes.size(), Vec3::Constant(kNone));
  for (std::size_t g = 0; g < run.goals().goals.size(); ++g) {
    if (run.goals().goals[g].pose != pose) continue;
    const std::vector<int>& nodes = run.goals().nodes[g];
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      wanted[static_cast<std::size_t>(nodes[i])] =
          run.goals().goals[g].target.segment<3>(3 * static_cast<Eigen::Index>(i));
    }
  }
  return wanted;
}

void add_history(const DesignRun& run, DesignReport& report) {
  const auto stage_name = [&run](int stage) {
    return run.stages() > 1 ? fmt::format("stage {}", stage + 1) : std::string();
  };
  DesignReport::Step start;
  start.objective = run.first_value();
  start.gradient = run.steps().empty() ? kNone : run.steps().front().record.gradient;
  start.stage = stage_name(0);
  for (const GoalMeasure& m : run.first_measures()) start.rms.push_back(m.rms);
  start.radius = kNone;
  report.history.push_back(start);
  for (std::size_t i = 0; i < run.steps().size(); ++i) {
    const DesignStep& step = run.steps()[i];
    const DesignRecord& r = step.record;
    if (!r.accepted) continue;
    report.history.push_back({.iteration = static_cast<int>(i) + 1,
                              .seconds = step.seconds,
                              .objective = r.value,
                              .gradient = r.gradient,
                              .active_bounds = r.active_bounds,
                              .radius = r.cap,
                              .stage = stage_name(step.stage),
                              .rms = step.rms});
  }
}

void add_parameters(const DesignRun& run, DesignReport& report) {
  const StructureProblem& problem = run.problem();
  const std::span<const Parameter> parameters = problem.space().parameters();
  const VecX start = problem.space().start();
  for (int i = 0; i < problem.size(); ++i) {
    const Parameter& p = parameters[static_cast<std::size_t>(i)];
    const double value = problem.p()[i];
    const double gradient = run.state().promise.size() == problem.size() ? run.state().promise[i] : 0;
    using Bound = DesignReport::Parameter::Bound;
    const Bound bound = value <= p.lower ? Bound::kLower : value >= p.upper ? Bound::kUpper : Bound::kFree;
    report.parameters.push_back({p.name,
                                 p.name.substr(p.name.rfind(": ") == std::string::npos ? 0 : p.name.rfind(": ") + 2),
                                 measure_of(si_unit(p.kind)), start[i], value, p.lower, p.upper, gradient, bound});
  }
}

}  // namespace

DesignReport report_of(const DesignRun& run) {
  const StructureProblem& problem = run.problem();
  DesignReport report;
  const DesignVerdict verdict = run.verdict().value_or(DesignVerdict::kCancelled);
  const VerdictWords words = words_of(verdict);
  report.tone = words.tone;
  report.verdict = design_verdict_info(verdict).name;
  std::replace(report.verdict.begin(), report.verdict.end(), '_', ' ');
  report.sentence = run.message();
  report.remedy = words.remedy;
  for (const DesignMethodInfo& info : design_methods()) {
    if (info.method == run.options().method) report.method = fmt::format("{}: {}", info.name, info.meaning);
  }
  const Structure& structure = problem.design().system.structure;
  report.size = {static_cast<int>(structure.rods.size()),
                 static_cast<int>(structure.nodes.size()),
                 0,
                 static_cast<int>(problem.poses().size()),
                 problem.size(),
                 static_cast<int>(run.goals().goals.size())};
  report.seconds = run.steps().empty() ? 0 : run.steps().back().seconds;
  report.warnings = run.goals().notes;
  add_history(run, report);
  add_parameters(run, report);
  const std::vector<GoalMeasure> after = problem.measures();
  const std::vector<double> largest = largest_misses(problem);
  for (std::size_t k = 0; k < problem.poses().size(); ++k) {
    const PoseFollower& pose = *problem.poses()[k];
    report.size.unknowns += pose.problem().supports.unknowns();
    const std::string& name = problem.design().model.poses[static_cast<std::size_t>(pose.pose())].name;
    report.poses.push_back(report_pose(name, run.first().system, run.first_point().states[k], problem.design().system,
                                       pose.state(), wanted_places(run, pose.pose())));
    for (const Goal& goal : run.goals().goals) {
      if (goal.pose != pose.pose()) continue;
      const std::size_t g = report.goals.size();
      report.goals.push_back({goal.name, name, measure_of(goal.objective->unit()), run.first_measures()[g].rms,
                              after[g].rms, run.first_largest()[g], largest[g]});
    }
  }
  return report;
}

}  // namespace lissom
