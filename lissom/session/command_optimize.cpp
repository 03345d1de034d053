#include "lissom/session/command_optimize.h"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "lissom/core/file_io.h"
#include "lissom/core/nearest_name.h"
#include "lissom/model/brief_methods.h"
#include "lissom/model/document.h"
#include "lissom/session/design_checkpoint.h"
#include "lissom/session/layout_json.h"
#include "lissom/session/optimized_report.h"
#include "lissom/session/optimizer_json.h"
#include "lissom/session/output.h"

namespace lissom {

namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

constexpr std::uintmax_t kLargestCheckpoint = std::uintmax_t{1} << 30;
constexpr double kSavingShare = 0.1;  // of the time, at most

/// The document with what the command line says instead.
Result<Model> commanded(const Document& document, const OptimizeCommand& command) {
  Model model = document.model;
  if (!model.design) return model;
  if (command.method) {
    const std::vector<std::string> known(kBriefMethods.begin(), kBriefMethods.end());
    if (std::find(known.begin(), known.end(), *command.method) == known.end()) {
      return Error{ErrorCode::kUnknown, "--method", fmt::format("there is no method \"{}\"", *command.method),
                   suggestion(*command.method, known)};
    }
    model.design->settings.method = *command.method;
  }
  if (command.iterations) model.design->settings.iterations = *command.iterations;
  return model;
}

/// Saves the run from time to time, so that saving never takes more than a small part of it.
class Saver {
 public:
  Saver(Output& output, std::string name, std::string fingerprint)
      : output_(output), name_(std::move(name)), fingerprint_(std::move(fingerprint)) {}

  Status after_iteration(const DesignRun& run) {
    const double since = std::chrono::duration<double>(Clock::now() - saved_).count();
    if (since * kSavingShare < cost_) return {};
    return save(run);
  }
  Status save(const DesignRun& run) {
    const Clock::time_point begin = Clock::now();
    const Status status = output_.write(name_, checkpoint_text(run.checkpoint(), fingerprint_));
    output_.take_written();
    saved_ = Clock::now();
    cost_ = std::chrono::duration<double>(saved_ - begin).count();
    return status;
  }

 private:
  Output& output_;
  std::string name_, fingerprint_;
  Clock::time_point saved_ = Clock::now();
  double cost_ = 0;
};

Json goals_json(const OptimizedDesign& design, const std::vector<Goal>& goals, const Model& model) {
  Json list = Json::array();
  for (std::size_t g = 0; g < design.after.size(); ++g) {
    const GoalMeasure& after = design.after[g];
    list.push_back({{"goal", after.name},
                    {"pose", model.poses[static_cast<std::size_t>(after.pose)].name},
                    {"hard", goals[g].force == GoalForce::kHard},
                    {"unit", after.unit},
                    {"rms_before", design.before[g].rms},
                    {"rms_after", after.rms}});
  }
  return list;
}

Json parameters_json(const DesignRun& run) {
  Json list = Json::array();
  const StructureProblem& problem = run.problem();
  const VecX start = problem.space().start();
  for (int i = 0; i < problem.size(); ++i) {
    const Parameter& p = problem.space().parameters()[static_cast<std::size_t>(i)];
    list.push_back({{"name", p.name},
                    {"unit", si_unit(p.kind)},
                    {"start", start[i]},
                    {"value", problem.p()[i]},
                    {"lower", p.lower},
                    {"upper", p.upper}});
  }
  return list;
}

/// Goals in the order of the measures: pose by pose.
std::vector<Goal> goals_by_pose(const DesignRun& run) {
  std::vector<Goal> sorted;
  for (const auto& pose : run.problem().poses()) {
    for (const Goal& goal : run.goals().goals) {
      if (goal.pose == pose->pose()) sorted.push_back(goal);
    }
  }
  return sorted;
}

Json result_json(const DesignRun& run, const OptimizedDesign& design, const Document& document) {
  const Model& model = run.problem().design().model;
  Json json;
  json["document"] = document.name;
  json["verdict"] = design_verdict_info(design.verdict).name;
  json["message"] = design.message;
  json["iterations"] = design.iterations;
  json["objective"] = run.problem().value();
  json["method"] = design_method_name(run.options().method);
  json["goals"] = goals_json(design, goals_by_pose(run), model);
  json["effort"] = effort_to_json(run.effort());
  json["notes"] = design.notes;
  return json;
}

Status write_results(const DesignRun& run, const Document& document, const OptimizeCommand& command,
                     OptimizedDesign& design, Output& output) {
  Json result = result_json(run, design, document);
  Json whole = result;
  whole.erase("effort");  // work that was done again after a stop counts there
  whole["parameters"] = parameters_json(run);
  const std::string& name = document.name;
  Model found = run.problem().design().model;
  found.design->settings = document.model.design->settings;
  // It stands for itself, as it lies in another folder than the files that its base may name.
  if (const Status s = output.write(name + "-designed.lissom", write_document(found, NetworkText::kRods)); !s) return s;
  if (const Status s = output.write(name + "-design.json", json_lines(whole)); !s) return s;
  DesignReport report = report_of(run);
  report.title = document.model.title.empty() ? name : document.model.title;
  report.document = name;
  report.files = {name + "-designed.lissom", name + "-design.json", name + "-design.checkpoint.json"};
  report.command = command.line;
  report.version = command.version;
  if (const Status s = output.write(name + "-design.html", design_report_html(report)); !s) return s;
  design.report = std::move(report);
  design.files = output.take_written();
  result["files"] = file_list(design.files);
  design.summary = json_line(result);
  return {};
}

}  // namespace

int exit_code(DesignVerdict verdict) {
  switch (verdict) {
    case DesignVerdict::kConverged:
    case DesignVerdict::kGoodEnough:
      return 0;
    case DesignVerdict::kIterationLimit:
    case DesignVerdict::kConstraintLimit:
      return 12;
    case DesignVerdict::kLimit:
      return 13;
    case DesignVerdict::kCancelled:
      return 15;
    case DesignVerdict::kBadStart:
      return 16;
    case DesignVerdict::kJumped:
      return 17;
    case DesignVerdict::kNoEquilibrium:
      return 18;
    case DesignVerdict::kInfeasible:
      break;
  }
  return 19;
}

Result<OptimizedDesign> optimize_command(const Document& document, const OptimizeCommand& command,
                                         const Context& context) {
  const Result<Model> model = commanded(document, command);
  if (!model) return model.error();
  const std::string fingerprint = design_fingerprint(model.value());
  const std::string checkpoint_name = document.name + "-design.checkpoint.json";
  std::optional<DesignCheckpoint> checkpoint;
  if (command.begin == OptimizeCommand::Begin::kResume) {
    const std::filesystem::path path = command.folder / checkpoint_name;
    const Result<std::string> text = read_file(path, kLargestCheckpoint);
    if (!text) return text.error();
    Result<DesignCheckpoint> read = read_checkpoint(text.value(), fingerprint, path.string());
    if (!read) return read.error();
    checkpoint = std::move(read).value();
  }
  Result<std::unique_ptr<DesignRun>> made = DesignRun::start(model.value(), context);
  if (!made) return made.error();
  DesignRun& run = *made.value();
  if (checkpoint) {
    if (const Status s = run.resume(std::move(*checkpoint)); !s) return s.error();
  }
  Output output(command.folder);
  if (const Status s = output.prepare(); !s) return s.error();
  Saver saver(output, checkpoint_name, fingerprint);
  while (run.step()) {
    if (const Status s = saver.after_iteration(run); !s) return s.error();
  }
  if (!run.status()) return run.status().error();
  if (const Status s = saver.save(run); !s) return s.error();
  OptimizedDesign design;
  design.verdict = *run.verdict();
  design.message = run.message();
  design.iterations = static_cast<int>(run.steps().size());
  design.before = run.first_measures();
  design.after = run.problem().measures();
  for (const DesignStep& step : run.steps()) {
    design.stages.resize(std::max(design.stages.size(), static_cast<std::size_t>(step.stage) + 1));
    StageOutcome& stage = design.stages[static_cast<std::size_t>(step.stage)];
    stage = {stage.iterations + 1, step.seconds, step.rms};
  }
  design.notes = run.goals().notes;
  design.model = run.problem().design().model;
  if (const Status s = write_results(run, document, command, design, output); !s) return s.error();
  return design;
}

}  // namespace lissom
