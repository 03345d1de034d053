#pragma once
/// One pose of a design whose parameters change: a point, in stable equilibrium, from which attempts at changed parameters
/// follow the same branch. What an attempt finds depends on the point alone, not on attempts before it, so that a run that was
/// stopped goes on as if it had not been.

#include <memory>
#include <string>

#include "lissom/core/context.h"
#include "lissom/design/design.h"
#include "lissom/design/reduced_problem.h"
#include "lissom/equilibrium/live_solver.h"

namespace lissom {

/// How an attempt ended in one pose.
struct PoseEnd {
  Outcome outcome = Outcome::kUnsettled;
  std::string reason;  ///< in words, unless settled
};

class PoseFollower {
 public:
  /// Of pose number `pose` of the design's model. Nothing is solved yet. `context` has to outlive the follower; its threads
  /// must not be used by others at the same time.
  static Result<std::unique_ptr<PoseFollower>> make(const Design& design, int pose, const SolveOptions& options,
                                                    const Context& context);
  PoseFollower(const PoseFollower&) = delete;
  PoseFollower& operator=(const PoseFollower&) = delete;

  /// Finds the first point, from the drawn shape with the pose's seed or from `start`.
  PoseEnd release(const Design& design, const State* start = nullptr);
  /// Takes a point over that was found before: bit for bit what goes on from it.
  PoseEnd restore(const Design& design, const State& equilibrium);

  /// Follows the point to a changed design with the same nodes, joints and triangles.
  PoseEnd attempt(const Design& changed);
  /// The last attempt, which settled, becomes the point.
  void accept();

  /// Makes numbers and factor those of the point, given the design there; to be called before derivatives are taken.
  void stand_at_point(const Design& design);

  const System& system() const { return system_; }
  const StaticProblem& problem() const { return *problem_; }
  LinearSolver& factor() { return solver_->factor(); }
  /// Of the point.
  const State& state() const { return point_; }
  /// Of the last attempt; numbers are those of the attempt until `stand_at_point`.
  const Equilibrium& attempted() const { return attempted_; }
  int pose() const { return pose_; }
  int solves() const { return solves_; }
  int factorizations() const { return solver_->factorizations(); }

 private:
  PoseFollower(const Design& design, int pose, const SolveOptions& options)
      : pose_(pose), options_(options), system_(design.system) {}

  const Pose& pose_of(const Design& design) const { return design.model.poses[static_cast<std::size_t>(pose_)]; }
  Status renew(const Design& design);
  PoseEnd end_of(const Equilibrium& equilibrium, const std::string& pose) const;

  int pose_;
  SolveOptions options_;
  System system_;
  std::unique_ptr<StaticProblem> problem_;
  std::unique_ptr<LiveSolver> solver_;
  State point_;
  Equilibrium attempted_;
  bool at_point_ = false;  // numbers and factor are those of the point
  int solves_ = 0;
};

}  // namespace lissom
