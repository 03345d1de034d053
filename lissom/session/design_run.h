#pragma once
/// The inverse design of a document, from its "design" section to the best design that was found: stoppable and resumable
/// between iterations.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lissom/core/context.h"
#include "lissom/core/result.h"
#include "lissom/design/augmented_lagrangian.h"
#include "lissom/design/brief_goals.h"
#include "lissom/design/structure_problem.h"

namespace lissom {

/// One iteration of a run.
struct DesignStep {
  int stage = 0;            ///< counted from 0
  double seconds = 0;       ///< since the start
  std::vector<double> rms;  ///< of each goal afterwards, SI
  DesignRecord record;      ///< with the effort of all stages so far
};

/// All that a run needs to go on as if it had not been stopped.
struct DesignCheckpoint {
  int stage = 0;
  DesignPoint point;
  ConstrainedState descent;  ///< of this stage; `inner` alone where no goal is hard
  std::vector<DesignStep> steps;
};

class DesignRun {
 public:
  /// Reads the brief of `model`, makes space and goals of all stages, and finds the equilibria of the start. kConflict where
  /// the document has no brief. `context` is copied; what it points to has to outlive the run.
  static Result<std::unique_ptr<DesignRun>> start(const Model& model, const Context& context);
  DesignRun(const DesignRun&) = delete;
  DesignRun& operator=(const DesignRun&) = delete;

  /// Goes on from a checkpoint of the same model instead.
  Status resume(DesignCheckpoint checkpoint);

  /// One iteration, or the way to the next stage. False: there is a verdict, or `status` has an error.
  bool step();
  const Status& status() const { return status_; }
  DesignCheckpoint checkpoint() const;

  /// Of the present stage.
  const OptimizerState& state() const;
  int stage() const { return stage_; }
  int stages() const { return static_cast<int>(brief_.stages.size()) + 1; }
  /// Of the last stage, or the reason why there was no next one.
  std::optional<DesignVerdict> verdict() const;
  std::string message() const;
  double seconds_left() const;
  /// Of all stages.
  const std::vector<DesignStep>& steps() const { return steps_; }
  DesignEffort effort() const;

  /// Of the present stage. Every stage has the document as its base.
  const StructureProblem& problem() const { return *problem_; }
  const BriefGoals& goals() const { return goals_; }
  /// What the run began with.
  const Design& first() const { return first_; }
  const DesignPoint& first_point() const { return first_point_; }
  const std::vector<GoalMeasure>& first_measures() const { return first_measures_; }
  const std::vector<double>& first_largest() const { return first_largest_; }
  double first_value() const { return first_value_; }  ///< h
  const OptimizeOptions& options() const { return options_; }

 private:
  DesignRun() = default;
  /// Space, goals and problem of a stage, nothing solved.
  Status make_stage(int stage);
  Status begin();
  /// The next stage begins at the point of this one.
  Status advance();
  Status adapt_pins();
  /// Of the last iteration, for people: root mean squares per goal, gradient, bounds, time left.
  std::string progress(const std::vector<GoalMeasure>& measures) const;
  bool ended_to_go_on() const;
  std::optional<DesignVerdict> stage_verdict() const;

  Context context_, quiet_;
  Model model_;
  Brief brief_;
  OptimizeOptions options_;
  ConstraintOptions constraints_;
  BriefGoals goals_;
  Design first_;
  DesignPoint first_point_;
  std::vector<GoalMeasure> first_measures_;
  std::vector<double> first_largest_;
  double first_value_ = 0;
  int stage_ = 0;
  std::unique_ptr<StructureProblem> problem_;
  std::optional<Optimizer> plain_;                  // without hard goals
  std::optional<AugmentedLagrangian> constrained_;  // with them
  std::optional<DesignVerdict> stage_end_;          // of a stage that had ended when the run was saved
  DesignEffort effort_before_;                      // of the stages before this one
  std::vector<DesignStep> steps_;
  Status status_;
};

/// Largest component of what misses each goal, SI, in the order of StructureProblem::measures.
std::vector<double> largest_misses(const StructureProblem& problem);

/// Number in a unit that suits it: "0.123 mm".
std::string in_unit_of_goal(double value, std::string_view unit);

}  // namespace lissom
