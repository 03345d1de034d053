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

/// All that a run needs to go on as if it had not been stopped.
struct DesignCheckpoint {
  DesignPoint point;
  ConstrainedState descent;              ///< `inner` alone where no goal is hard
  std::vector<double> seconds;           ///< since the start, after each iteration
  std::vector<std::vector<double>> rms;  ///< of each goal, after each iteration, SI
};

class DesignRun {
 public:
  /// Reads the brief of `model`, makes space and goals, and finds the equilibria of the start. kConflict where the document
  /// has no brief. `context` is copied; what it points to has to outlive the run.
  static Result<std::unique_ptr<DesignRun>> start(const Model& model, const Context& context);
  DesignRun(const DesignRun&) = delete;
  DesignRun& operator=(const DesignRun&) = delete;

  /// Goes on from a checkpoint of the same model instead.
  Status resume(DesignCheckpoint checkpoint);

  /// One iteration. False: there is a verdict.
  bool step();
  DesignCheckpoint checkpoint() const;

  /// Of the last iteration, for people: root mean squares per goal, gradient, bounds, time left.
  std::string progress() const;
  const OptimizerState& state() const;
  std::optional<DesignVerdict> verdict() const;
  std::string message() const;
  double seconds_left() const;

  const StructureProblem& problem() const { return *problem_; }
  const BriefGoals& goals() const { return goals_; }
  /// What the run began with.
  const Design& first() const { return first_; }
  const DesignPoint& first_point() const { return first_point_; }
  const std::vector<GoalMeasure>& first_measures() const { return first_measures_; }
  const std::vector<double>& first_largest() const { return first_largest_; }
  const DesignCheckpoint& history() const { return history_; }
  const OptimizeOptions& options() const { return options_; }

 private:
  DesignRun() = default;
  Status begin();

  Context context_, quiet_;
  Brief brief_;
  OptimizeOptions options_;
  ConstraintOptions constraints_;
  BriefGoals goals_;
  Design first_;
  DesignPoint first_point_;
  std::vector<GoalMeasure> first_measures_;
  std::vector<double> first_largest_;
  std::unique_ptr<StructureProblem> problem_;
  std::optional<Optimizer> plain_;                  // without hard goals
  std::optional<AugmentedLagrangian> constrained_;  // with them
  DesignCheckpoint history_;                        // `seconds` and `rms` only
};

/// Largest component of what misses each goal, SI, in the order of StructureProblem::measures.
std::vector<double> largest_misses(const StructureProblem& problem);

/// Number in a unit that suits it: "0.123 mm".
std::string in_unit_of_goal(double value, std::string_view unit);

}  // namespace lissom
