#include "lissom/design/shape_fit.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lissom/core/assert.h"

namespace lissom {

namespace {

// Of the forces, against that of shapes to look at: along soft motions a residual that is small enough to the eye is a long
// way from rest, and steps are judged by less than that.
constexpr double kFineness = 1e-2;
constexpr double kWays[] = {1, 0.5, 0.25};  // to parameters that are expected to be good

}  // namespace

Result<std::unique_ptr<ShapeFit>> ShapeFit::make(std::shared_ptr<const ShapeResponse> response,
                                                 HardConstraints constraints, ShapeTarget target,
                                                 const Context& context) {
  LISSOM_ASSERT(target.nodes.size() == target.weights.size() && !target.nodes.empty());
  std::unique_ptr<ShapeFit> fit(new ShapeFit(std::move(response), std::move(constraints), std::move(target)));
  const ShapeResponse& s = *fit->response_;
  fit->design_ = *s.space().base();
  SolveOptions solve;
  solve.modes = 0;
  solve.tolerance *= kFineness;
  Result<std::unique_ptr<PoseFollower>> follower = PoseFollower::make(fit->design_, s.start().pose, solve, context);
  if (!follower) return follower.error();
  fit->follower_ = std::move(follower).value();
  const PoseEnd end = fit->follower_->restore(fit->design_, s.start().state);
  if (end.outcome != Outcome::kSettled) {
    return Error{ErrorCode::kConflict, {}, "the shape is not stable: " + end.reason, "let it settle first"};
  }
  fit->state_ = s.start().state;
  fit->length_ = s.system().structure.size;
  fit->start_ = fit->x_ = s.p().cwiseQuotient(s.scale());
  fit->lower_.resize(s.size());
  fit->upper_.resize(s.size());
  for (int i = 0; i < s.size(); ++i) {
    const Parameter& parameter = s.parameters()[static_cast<std::size_t>(i)];
    fit->lower_[i] = parameter.lower / parameter.scale;
    fit->upper_[i] = parameter.upper / parameter.scale;
  }
  fit->residual_ = fit->residual_of(fit->state_);
  fit->value_ = 0.5 * fit->residual_.squaredNorm();
  // The response at the start is known.
  fit->jacobian_ = fit->rows_of(s.matrix(), fit->state_);
  return fit;
}

VecX ShapeFit::tied(const VecX& x) const { return (start_ + ties_.of(x - start_)).cwiseMax(lower_).cwiseMin(upper_); }

VecX ShapeFit::residual_of(const State& state) const {
  const auto count = static_cast<Eigen::Index>(target_.nodes.size());
  const VecX violation = violations(constraints_, response_->start().state.q, state.q);
  VecX residual(3 * count + violation.size());
  double total = 0;
  for (const double weight : target_.weights) total += weight;
  for (Eigen::Index i = 0; i < count; ++i) {
    const int node = target_.nodes[static_cast<std::size_t>(i)];
    const double weight = std::sqrt(target_.weights[static_cast<std::size_t>(i)] / total);
    residual.segment<3>(3 * i) = weight / length_ * (state.position(node) - target_.places.segment<3>(3 * node));
  }
  residual.tail(violation.size()) = std::sqrt(kConstraintWeight) / length_ * violation;
  return residual;
}

MatX ShapeFit::rows_of(const MatX& response, const State& state) const {
  const auto count = static_cast<Eigen::Index>(target_.nodes.size());
  const SparseRows constraint = constraint_jacobian(constraints_, state.q, static_cast<int>(response.rows()));
  MatX rows(3 * count + constraint.rows(), response.cols());
  double total = 0;
  for (const double weight : target_.weights) total += weight;
  for (Eigen::Index i = 0; i < count; ++i) {
    const int node = target_.nodes[static_cast<std::size_t>(i)];
    const double weight = std::sqrt(target_.weights[static_cast<std::size_t>(i)] / total);
    rows.middleRows<3>(3 * i) = weight / length_ * response.middleRows<3>(3 * node);
  }
  rows.bottomRows(constraint.rows()) = std::sqrt(kConstraintWeight) / length_ * (constraint * response);
  if (ties_.rank() == 0) return rows;
  rows.transposeInPlace();
  ties_.apply(rows);
  rows.transposeInPlace();
  return rows;
}

double ShapeFit::distance() const {
  const auto places = static_cast<Eigen::Index>(3 * target_.nodes.size());
  return length_ * residual_.head(places).norm();
}

double ShapeFit::violation() const {
  const VecX values = violations(constraints_, response_->start().state.q, state_.q);
  return values.size() > 0 ? values.cwiseAbs().maxCoeff() : 0;
}

bool ShapeFit::approach() {
  if (target_.p.size() == 0) return false;
  const VecX way = target_.p.cwiseQuotient(response_->scale()) - x_;
  for (const double share : kWays) {
    const Attempt attempted = attempt(x_ + share * way);
    if (attempted.outcome == Outcome::kCancelled) return false;
    if (attempted.outcome != Outcome::kSettled || !(attempted.value < value_)) continue;
    accept();
    return true;
  }
  return false;
}

const MatX& ShapeFit::jacobian() {
  if (!jacobian_) {
    follower_->stand_at_point(design_);
    const Result<MatX> response =
        response_matrix(design_, response_->space(), p(), *follower_, state_, response_->pins());
    LISSOM_ASSERT(response);  // it could be made at the start, and poses have not changed
    jacobian_ = rows_of(response.value(), state_);
    effort_.back_solves += size();
  }
  return *jacobian_;
}

const VecX& ShapeFit::gradient() {
  if (!gradient_) gradient_ = jacobian().transpose() * residual_;
  return *gradient_;
}

const MatX& ShapeFit::gram() {
  if (!gram_) {
    MatX gram = MatX::Zero(size(), size());
    gram.selfadjointView<Eigen::Lower>().rankUpdate(jacobian().transpose());
    gram_ = MatX(gram.selfadjointView<Eigen::Lower>());
  }
  return *gram_;
}

VecX ShapeFit::jacobian_times(const VecX& v) { return jacobian() * v; }
VecX ShapeFit::jacobian_transposed_times(const VecX& w) { return jacobian().transpose() * w; }
VecX ShapeFit::hessian_times(const VecX& v) { return jacobian().transpose() * (jacobian() * v); }

Attempt ShapeFit::attempt(const VecX& x) {
  ++effort_.attempts;
  attempted_x_ = tied(x);
  Result<Design> design =
      response_->space().applied(*response_->space().base(), attempted_x_.cwiseProduct(response_->scale()));
  if (!design) return {Outcome::kNoDesign, 0, design.error().text()};
  attempted_design_ = std::move(design).value();
  follower_->stand_at_point(design_);
  const PoseEnd end = follower_->attempt(attempted_design_);
  if (end.outcome != Outcome::kSettled) return {end.outcome, 0, end.reason};
  attempted_state_ = pinned_down(follower_->problem(), follower_->attempted().state, response_->pins());
  attempted_residual_ = residual_of(attempted_state_);
  return {Outcome::kSettled, 0.5 * attempted_residual_.squaredNorm(), {}};
}

void ShapeFit::accept() {
  // Where it was pinned down, so that derivatives are those of the shape that is compared.
  const PoseEnd end = follower_->restore(attempted_design_, attempted_state_);
  LISSOM_ASSERT(end.outcome == Outcome::kSettled);
  x_ = attempted_x_;
  design_ = attempted_design_;
  state_ = attempted_state_;
  residual_ = attempted_residual_;
  value_ = 0.5 * residual_.squaredNorm();
  jacobian_.reset();
  gradient_.reset();
  gram_.reset();
}

DesignEffort ShapeFit::effort() const {
  DesignEffort effort = effort_;
  effort.solves = follower_->solves();
  effort.factorizations = follower_->factorizations();
  return effort;
}

}  // namespace lissom
