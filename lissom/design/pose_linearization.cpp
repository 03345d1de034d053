#include "lissom/design/pose_linearization.h"

#include <utility>

#include "lissom/mechanics/load_numbers.h"
#include "lissom/mechanics/rest_jacobian.h"
#include "lissom/mechanics/rest_numbers.h"
#include "lissom/mechanics/third_derivative.h"

namespace lissom {

namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

void append(const SparseRows& rows, int first, Triplets& entries) {
  for (int r = 0; r < rows.outerSize(); ++r) {
    for (SparseRows::InnerIterator it(rows, r); it; ++it) {
      entries.emplace_back(first + static_cast<int>(it.row()), static_cast<int>(it.col()), it.value());
    }
  }
}

}  // namespace

Result<PoseLinearization> PoseLinearization::make(const DesignPose& point, const LinearSolver& factor,
                                                  std::vector<const Goal*> goals) {
  Result<Sensitivity> sensitivity =
      Sensitivity::make(point.design.model, point.pose, point.problem, point.state, factor, point.jacobian);
  if (!sensitivity) return sensitivity.error();
  PoseLinearization out(point, std::move(goals), std::move(sensitivity).value());
  out.evaluate_goals();
  return out;
}

void PoseLinearization::evaluate_goals() {
  const PoseShape shape = point_.shape();
  const int unknowns = point_.design.system.layout.size(), numbers = static_cast<int>(sensitivity_.numbers().rows());
  Triplets by_q, by_numbers;
  std::vector<VecX> parts;
  SparseRows rows, number_rows;
  int first = 0;
  for (const Goal* goal : goals_) {
    goal_jacobian(*goal, shape, rows, number_rows);
    append(rows, first, by_q);
    append(number_rows, first, by_numbers);
    parts.push_back(goal_residual(*goal, shape));
    first += static_cast<int>(parts.back().size());
  }
  residual_.resize(first);
  by_q_.resize(first, unknowns);
  by_numbers_.resize(first, numbers);
  by_q_.setFromTriplets(by_q.begin(), by_q.end());
  by_numbers_.setFromTriplets(by_numbers.begin(), by_numbers.end());
  first = 0;
  for (const VecX& r : parts) {
    residual_.segment(first, r.size()) = r;
    first += static_cast<int>(r.size());
  }
}

VecX PoseLinearization::times(const VecX& v) const {
  return by_q_ * sensitivity_.forward(v) + by_numbers_ * (sensitivity_.numbers() * v);
}

VecX PoseLinearization::transposed_times(const VecX& w) const {
  return sensitivity_.adjoint(by_q_.transpose() * w) +
         sensitivity_.numbers().transpose() * (by_numbers_.transpose() * w);
}

MatX PoseLinearization::dense() const {
  const int rows = static_cast<int>(residual_.size()), m = sensitivity_.parameters();
  MatX jacobian(rows, m);
  if (rows < m) {
    for (int i = 0; i < rows; ++i) jacobian.row(i) = transposed_times(VecX::Unit(rows, i)).transpose();
    return jacobian;
  }
  jacobian = by_q_ * sensitivity_.dense();
  if (by_numbers_.nonZeros() > 0) jacobian += MatX(SparseRows(by_numbers_ * sensitivity_.numbers()));
  return jacobian;
}

PoseLinearization::Lagrangian PoseLinearization::lagrangian_times(const VecX& multiplier, const VecX& dq, const VecX& v,
                                                                  ThreadPool* threads) const {
  const Design& design = point_.design;
  const Potential& potential = point_.problem.potential;
  VecX global_multiplier = multiplier;
  potential.to_global(global_multiplier);
  const VecX dn = sensitivity_.numbers() * v;
  const int rests = RestNumbers(design.system.structure).size();
  const VecX d_rest = dn.head(rests);
  VecX l_q = VecX::Zero(dq.size()), l_rest = VecX::Zero(rests);
  for (const Goal* goal : goals_) {
    add_goal_second_order(*goal, point_.shape(), SecondOrder::kExact, dq, d_rest, l_q, l_rest);
  }
  VecX third_q, third_n;
  third_derivative(potential, point_.state, global_multiplier, dq, dn, third_q, third_n, threads);
  l_q += third_q;
  VecX l_n = third_n;
  l_n.head(rests) += l_rest;
  potential.to_local(l_q);
  VecX by_p = sensitivity_.numbers().transpose() * l_n;
  const bool holds = sensitivity_.held().cols() > 0;
  if (holds) by_p += sensitivity_.held().transpose() * l_q;
  if (point_.jacobian.inputs.cols() == 0) return {std::move(l_q), std::move(by_p)};

  // How numbers and held places follow the parameters to second order.
  const VecX h_n = by_numbers_.transpose() * residual_;
  const VecX by_numbers = h_n + sensitivity_.gradient_by_numbers().transpose() * multiplier;
  const VecX by_rest = by_numbers.head(rests);
  by_p += point_.jacobian.inputs.transpose() *
          rest_curvature(design.model, design.system, by_rest, point_.jacobian.inputs * v);
  VecX by_inputs = rest_jacobian(design.model, design.system).transpose() * by_rest;
  const int places = 3 * design.system.layout.nodes();
  const LoadNumbers loads(point_.shape().pose, design.system.structure);
  if (loads.has_drawn_targets()) by_inputs.head(places) += by_numbers.tail(places);
  if (holds) {
    VecX by_held = by_q_.transpose() * residual_;
    potential.to_local(by_held);
    by_held += sensitivity_.hessian_times(multiplier);
    by_inputs.head(places) += point_.problem.supports.held_by_places(design.system).transpose() * by_held;
  }
  by_p += point_.space.curvature(design, point_.p, by_inputs, v);
  return {std::move(l_q), std::move(by_p)};
}

VecX PoseLinearization::hessian_times(const VecX& v, ThreadPool* threads) const {
  VecX local_h_q = by_q_.transpose() * residual_;
  point_.problem.potential.to_local(local_h_q);
  const VecX multiplier = -sensitivity_.back_solve(local_h_q, Sensitivity::Side::kTransposed);
  // L = h + multiplier' gradient along (s, v) [mathematics 5.2].
  Lagrangian l = lagrangian_times(multiplier, sensitivity_.forward(v), v, threads);
  const VecX change = -sensitivity_.back_solve(l.by_q, Sensitivity::Side::kTransposed);  // of the multiplier
  l.by_p += sensitivity_.forces().transpose() * change;
  return l.by_p;
}

}  // namespace lissom
