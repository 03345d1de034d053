#pragma once
/// A plan under edit: its equilibrium follows every change. Small changes keep mesh, patterns and factor; larger ones get a
/// new mesh, on which the shape goes on from where it was.

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "lissom/core/context.h"
#include "lissom/design/plan_mesh.h"
#include "lissom/equilibrium/live_solver.h"

namespace lissom {

/// How a design took a change.
struct DesignChange {
  bool remeshed = false;
  std::string reason;   ///< why, in words, when it was
  Following following;  ///< predicted and actual move; after remeshing the move from the shape carried over
};

class LiveDesign {
 public:
  /// Looks at a design while it settles: everything but equilibrium() is that of the state shown already.
  using Watch = std::function<void(const LiveDesign& design, const State& state, double residual)>;

  struct Options {
    SolveOptions solve;
    MeshLimits mesh;
    double refine = 1;
    Watch watch;  ///< must be quick; empty: nobody looks
  };

  /// Releases pose number `pose` of a model with a plan, from its seed.
  static Result<std::unique_ptr<LiveDesign>> make(const Model& model, int pose, const Options& options,
                                                  const Context& context = {});
  /// Stands at an equilibrium of pose number `pose` that was found before, on its mesh, and settles it where it is none.
  static Result<std::unique_ptr<LiveDesign>> at(const Model& model, int pose, std::shared_ptr<const PlanMesh> mesh,
                                                const State& equilibrium, const Options& options,
                                                const Context& context = {});
  LiveDesign(const LiveDesign&) = delete;
  LiveDesign& operator=(const LiveDesign&) = delete;

  const Model& model() const { return model_; }
  int pose() const { return pose_; }
  const std::shared_ptr<const PlanMesh>& mesh() const { return mesh_; }
  /// The plan as it is now, on the mesh.
  const ExpandedPlan& expanded() const { return expanded_; }
  const System& system() const { return system_; }
  const StaticProblem& problem() const { return *problem_; }
  const Equilibrium& equilibrium() const { return equilibrium_; }

  /// Takes over another model, with any points, rods and numbers, and follows it. After an error all is as before. A shape
  /// that is not stable in the end is kept and is where the next change starts.
  Result<DesignChange> change(const Model& changed) { return change(changed, options_.mesh); }
  /// The same where the mesh at hand has to serve within other limits.
  Result<DesignChange> change(const Model& changed, const MeshLimits& limits);

  /// Whether the mesh is one that change() would keep for the present plan.
  bool mesh_fits() const { return mesh_->fit(*model_.plan, options_.mesh).good; }

  /// Takes over another model with a state of it on a mesh of its own, as it was kept. After an error all is as before.
  Status take(const Model& model, std::shared_ptr<const PlanMesh> mesh, const State& equilibrium);

 private:
  LiveDesign(int pose, const Options& options, const Context& context)
      : pose_(pose), options_(options), context_(context) {}

  std::string place() const { return "/poses/" + std::to_string(pose_); }
  const Pose& pose_of(const Model& model) const { return model.poses[static_cast<std::size_t>(pose_)]; }
  Result<DesignChange> follow(const Model& changed);
  Result<DesignChange> remesh(const Model& changed, std::string reason);
  /// Moves in: everything but the equilibrium.
  Status furnish(const Model& model, std::shared_ptr<const PlanMesh> mesh, ExpandedPlan expanded, System system);

  Model model_;
  int pose_;
  Options options_;
  Context context_;
  std::shared_ptr<const PlanMesh> mesh_;
  ExpandedPlan expanded_;
  System system_;
  std::optional<StaticProblem> problem_;
  std::unique_ptr<LiveSolver> solver_;
  Equilibrium equilibrium_;
};

}  // namespace lissom
