#pragma once
/// The design whose equilibrium comes nearest to a target shape, with hard constraints as heavy penalties: result optimisation
/// [mathematics (6.6)]. Shapes are pinned down before they are compared. Ties of parameters are kept exactly: steps are projected.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lissom/design/hard_constraints.h"
#include "lissom/design/pose_follower.h"
#include "lissom/design/reduced_problem.h"
#include "lissom/design/shape_response.h"

namespace lissom {

/// Where the nodes of a shape are wanted.
struct ShapeTarget {
  VecX places;                  ///< m, (3 per node)
  std::vector<int> nodes;       ///< that count
  std::vector<double> weights;  ///< of each of them, > 0
  VecX p = {};                  ///< SI, parameters that bring it about to first order; empty where none are known
};

class ShapeFit final : public ReducedProblem {
 public:
  /// How much more than a place that misses its target a constraint that is violated as much counts.
  static constexpr double kConstraintWeight = 1e3;

  /// Begins at the start of `response`. `context` has to outlive the fit.
  static Result<std::unique_ptr<ShapeFit>> make(std::shared_ptr<const ShapeResponse> response,
                                                HardConstraints constraints, ShapeTarget target,
                                                const Context& context);

  /// Goes to the parameters that the target knows of, or part of the way, if the shape comes nearer to it there.
  bool approach();

  /// m, weighted root mean square over the nodes that count, at the point.
  double distance() const;
  /// m, the largest entry of C at the point.
  double violation() const;
  VecX p() const { return x_.cwiseProduct(response_->scale()); }  ///< SI
  const Design& design() const { return design_; }
  const State& state() const { return state_; }  ///< equilibrium at the point, pinned down

  int size() const override { return response_->size(); }
  std::string parameter_name(int i) const override { return response_->parameters()[static_cast<std::size_t>(i)].name; }
  const VecX& lower() const override { return lower_; }
  const VecX& upper() const override { return upper_; }
  const VecX& x() const override { return x_; }
  double value() const override { return value_; }
  const VecX& residual() const override { return residual_; }
  const VecX& gradient() override;
  const MatX& gram() override;
  VecX jacobian_times(const VecX& v) override;
  VecX jacobian_transposed_times(const VecX& w) override;
  /// Without the second derivatives of the residual: of Gauss and Newton.
  VecX hessian_times(const VecX& v) override;
  Attempt attempt(const VecX& x) override;
  const VecX& attempted_residual() const override { return attempted_residual_; }
  void accept() override;
  DesignEffort effort() const override;

 private:
  ShapeFit(std::shared_ptr<const ShapeResponse> response, HardConstraints constraints, ShapeTarget target)
      : response_(std::move(response)),
        constraints_(std::move(constraints)),
        target_(std::move(target)),
        ties_(constraints_.ties) {}

  /// The point nearest to x that keeps the ties, within the bounds.
  VecX tied(const VecX& x) const;
  VecX residual_of(const State& state) const;
  /// Rows of the Jacobian from a response matrix.
  MatX rows_of(const MatX& response, const State& state) const;
  const MatX& jacobian();

  std::shared_ptr<const ShapeResponse> response_;
  HardConstraints constraints_;
  ShapeTarget target_;
  ConstraintProjection ties_;
  std::unique_ptr<PoseFollower> follower_;
  VecX lower_, upper_, start_, x_, residual_, attempted_x_, attempted_residual_;
  double value_ = 0, length_ = 1;  // m, size of the structure: residuals are shares of it
  Design design_, attempted_design_;
  State state_, attempted_state_;
  std::optional<MatX> jacobian_;
  std::optional<VecX> gradient_;
  std::optional<MatX> gram_;
  DesignEffort effort_;
};

}  // namespace lissom
