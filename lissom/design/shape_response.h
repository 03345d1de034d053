#pragma once
/// How the shape of a plan answers to all of its parameters, to first order: S as a matrix, for tools that explore it while
/// the pointer moves [mathematics 6.2, 7]. Parameters count in scales, so that they compare with each other.

#include <memory>
#include <vector>

#include "lissom/core/context.h"
#include "lissom/design/hard_constraints.h"
#include "lissom/design/plan_design_space.h"
#include "lissom/design/pose_follower.h"
#include "lissom/design/rigid_gauge.h"

namespace lissom {

/// From when on the mesh of the start no longer serves tools: later than while dragging, for they cannot make a new one.
MeshLimits tool_limits();

/// A shape that tools begin at.
struct ShapeStart {
  std::shared_ptr<const PlanMesh> mesh;
  Model model;  ///< its plan lies on the mesh
  int pose = 0;
  State state;  ///< the equilibrium, pinned down
};

class ShapeResponse {
 public:
  /// `pins`: places that `start.state` was pinned down to. kConflict where the shape is not stable.
  static Result<std::shared_ptr<const ShapeResponse>> make(ShapeStart start, const PlanSpaceOptions& options,
                                                           std::vector<PinnedNode> pins, const Context& context);
  ShapeResponse(const ShapeResponse&) = delete;
  ShapeResponse& operator=(const ShapeResponse&) = delete;

  const ShapeStart& start() const { return start_; }
  const PlanDesignSpace& space() const { return *space_; }
  std::span<const Parameter> parameters() const { return space_->parameters(); }
  const System& system() const { return space_->base()->system; }
  const std::vector<PinnedNode>& pins() const { return pins_; }
  int size() const { return static_cast<int>(scale_.size()); }

  const VecX& p() const { return p_; }          ///< SI
  const VecX& scale() const { return scale_; }  ///< SI, of each parameter
  /// d unknowns / d (p / scale), (unknowns x m), global axes, rigid motions pinned down.
  const MatX& matrix() const { return matrix_; }

  /// Its softest motions, softest first.
  const std::vector<Mode>& softest() const { return softest_; }

  /// The start moved by an increment of all unknowns; false where an edge would turn around.
  [[nodiscard]] bool moved(const VecX& dq, State& state) const { return advance(system(), start_.state, dq, state); }

 private:
  ShapeResponse() = default;

  ShapeStart start_;
  std::shared_ptr<const PlanDesignSpace> space_;
  std::vector<PinnedNode> pins_;
  VecX p_, scale_;
  MatX matrix_;
  std::vector<Mode> softest_;
};

/// d unknowns / d (p / scale) where a follower stands, pinned down at `state`.
Result<MatX> response_matrix(const Design& design, const PlanDesignSpace& space, const VecX& p, PoseFollower& follower,
                             const State& state, const std::vector<PinnedNode>& pins);

}  // namespace lissom
