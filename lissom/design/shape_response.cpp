#include "lissom/design/shape_response.h"

#include <utility>

#include "lissom/design/sensitivity.h"

namespace lissom {

namespace {

constexpr int kSoftest = 4;

VecX scales_of(std::span<const Parameter> parameters) {
  VecX scales(static_cast<Eigen::Index>(parameters.size()));
  for (std::size_t i = 0; i < parameters.size(); ++i) scales[static_cast<Eigen::Index>(i)] = parameters[i].scale;
  return scales;
}

}  // namespace

MeshLimits tool_limits() { return {.angle_ratio = 0.1, .length_ratio = 2.5, .turn_ratio = 4}; }

Result<MatX> response_matrix(const Design& design, const PlanDesignSpace& space, const VecX& p, PoseFollower& follower,
                             const State& state, const std::vector<PinnedNode>& pins) {
  const DesignJacobian jacobian = space.jacobian(design, p);
  const Result<Sensitivity> sensitivity =
      Sensitivity::make(design.model, follower.pose(), follower.problem(), state, follower.factor(), jacobian);
  if (!sensitivity) return sensitivity.error();
  MatX matrix = sensitivity.value().dense();
  const VecX scales = scales_of(space.parameters());
  matrix.array().rowwise() *= scales.transpose().array();
  const SparseMatrix drawn = jacobian.inputs.topRows(3 * follower.system().layout.nodes()) * scales.asDiagonal();
  pin_down_response(follower.problem(), state, pins, drawn, matrix);
  return matrix;
}

Result<std::shared_ptr<const ShapeResponse>> ShapeResponse::make(ShapeStart start, const PlanSpaceOptions& options,
                                                                 std::vector<PinnedNode> pins, const Context& context) {
  Result<PlanDesignSpace> space = PlanDesignSpace::on_mesh(start.model, start.mesh, options, tool_limits());
  if (!space) return space.error();
  const std::shared_ptr<ShapeResponse> made(new ShapeResponse);
  made->space_ = std::make_shared<const PlanDesignSpace>(std::move(space).value());
  made->start_ = std::move(start);
  made->pins_ = std::move(pins);
  made->p_ = made->space_->start();
  made->scale_ = scales_of(made->space_->parameters());
  const Design& base = *made->space_->base();
  SolveOptions solve;
  solve.modes = kSoftest;
  Result<std::unique_ptr<PoseFollower>> follower = PoseFollower::make(base, made->start_.pose, solve, context);
  if (!follower) return follower.error();
  if (follower.value()->release(base, &made->start_.state).outcome == Outcome::kSettled) {
    made->softest_ = follower.value()->attempted().modes;
  }
  const PoseEnd end = follower.value()->restore(base, made->start_.state);
  if (end.outcome != Outcome::kSettled) {
    return Error{ErrorCode::kConflict, {}, "the shape is not stable: " + end.reason, "let it settle first"};
  }
  Result<MatX> matrix =
      response_matrix(base, *made->space_, made->p_, *follower.value(), made->start_.state, made->pins_);
  if (!matrix) return matrix.error();
  made->matrix_ = std::move(matrix).value();
  return std::shared_ptr<const ShapeResponse>(made);
}

}  // namespace lissom
