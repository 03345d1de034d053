/// Derivatives of a structure's inverse problem, pose by pose.

#include <algorithm>
#include <cmath>

#include "lissom/core/assert.h"
#include "lissom/design/structure_problem.h"

namespace lissom {

Status StructureProblem::ensure_linear() {
  for_poses([&](int k) { poses_[static_cast<std::size_t>(k)]->stand_at_point(design_); });
  if (!linear_.empty()) return {};
  jacobian_ = space_->jacobian(design_, p_);
  std::vector<std::optional<PoseLinearization>> made(poses_.size());
  std::vector<Status> errors(poses_.size());
  for_poses([&](int k) {
    const auto i = static_cast<std::size_t>(k);
    std::vector<const Goal*> goals;
    for (const int g : by_pose_[i]) goals.push_back(&effective_[static_cast<std::size_t>(g)]);
    PoseFollower& pose = *poses_[i];
    Result<PoseLinearization> linear = PoseLinearization::make(
        {design_, *space_, p_, jacobian_, pose.pose(), pose.problem(), pose.state()}, pose.factor(), std::move(goals));
    if (linear) {
      made[i].emplace(std::move(linear).value());
    } else {
      errors[i] = linear.error();
    }
  });
  for (const Status& error : errors) {
    if (!error) return error;
  }
  for (auto& linear : made) linear_.push_back(std::move(*linear));
  return {};
}

void StructureProblem::ensure_dense() {
  if (!dense_.empty()) return;
  const Status linear = ensure_linear();
  LISSOM_ASSERT(linear);
  dense_.resize(poses_.size());
  for_poses([&](int k) {
    const auto i = static_cast<std::size_t>(k);
    dense_[i] = linear_[i].dense() * scale_.asDiagonal();
  });
  for (const PoseLinearization& linear_at : linear_) {
    effort_.back_solves += static_cast<int>(std::min<Eigen::Index>(linear_at.residual().size(), size()));
  }
}

const VecX& StructureProblem::gradient() {
  if (!gradient_) gradient_ = jacobian_transposed_times(residual_);
  return *gradient_;
}

const MatX& StructureProblem::gram() {
  if (gram_) return *gram_;
  ensure_dense();
  std::vector<MatX> parts(poses_.size());
  for_poses([&](int k) {
    const auto i = static_cast<std::size_t>(k);
    parts[i] = MatX::Zero(size(), size());
    parts[i].selfadjointView<Eigen::Lower>().rankUpdate(dense_[i].transpose());
  });
  MatX sum = MatX::Zero(size(), size());
  for (const MatX& part : parts) sum += part;
  sum.triangularView<Eigen::StrictlyUpper>() = sum.transpose();
  for (const SparseMatrix& rows : wish_rows_) sum += MatX(SparseMatrix(rows.transpose() * rows));
  gram_ = std::move(sum);
  return *gram_;
}

VecX StructureProblem::jacobian_times(const VecX& v) {
  const VecX by_p = scale_.cwiseProduct(v);
  if (dense_.empty()) {
    const Status linear = ensure_linear();
    LISSOM_ASSERT(linear);
    effort_.back_solves += static_cast<int>(poses_.size());
  }
  std::vector<VecX> parts(poses_.size());
  for_poses([&](int k) {
    const auto i = static_cast<std::size_t>(k);
    parts[i] = dense_.empty() ? linear_[i].times(by_p) : VecX(dense_[i] * v);
  });
  VecX all(residual_.size());
  Eigen::Index at = 0;
  for (const VecX& part : parts) {
    all.segment(at, part.size()) = part;
    at += part.size();
  }
  for (const SparseMatrix& rows : wish_rows_) {
    all.segment(at, rows.rows()) = rows * v;
    at += rows.rows();
  }
  return all;
}

VecX StructureProblem::jacobian_transposed_times(const VecX& w) {
  LISSOM_ASSERT(w.size() == residual_.size());
  if (dense_.empty()) {
    const Status linear = ensure_linear();
    LISSOM_ASSERT(linear);
    effort_.back_solves += static_cast<int>(poses_.size());
  }
  std::vector<Eigen::Index> first(poses_.size() + 1, 0);
  for (std::size_t k = 0; k < poses_.size(); ++k) {
    first[k + 1] = first[k] + (dense_.empty() ? linear_[k].residual().size() : dense_[k].rows());
  }
  std::vector<VecX> parts(poses_.size());
  for_poses([&](int k) {
    const auto i = static_cast<std::size_t>(k);
    const VecX own = w.segment(first[i], first[i + 1] - first[i]);
    parts[i] = dense_.empty() ? VecX(scale_.cwiseProduct(linear_[i].transposed_times(own)))
                              : VecX(dense_[i].transpose() * own);
  });
  VecX sum = VecX::Zero(size());
  for (const VecX& part : parts) sum += part;
  Eigen::Index at = first.back();
  for (const SparseMatrix& rows : wish_rows_) {
    sum += rows.transpose() * w.segment(at, rows.rows());
    at += rows.rows();
  }
  return sum;
}

VecX StructureProblem::hessian_times(const VecX& v) {
  const Status linear = ensure_linear();
  LISSOM_ASSERT(linear);
  effort_.back_solves += 3 * static_cast<int>(poses_.size());
  const VecX by_p = scale_.cwiseProduct(v);
  std::vector<VecX> parts(poses_.size());
  for_poses([&](int k) {
    const auto i = static_cast<std::size_t>(k);
    parts[i] = linear_[i].hessian_times(by_p, inner_.threads);
  });
  VecX sum = VecX::Zero(size());
  for (const VecX& part : parts) sum += part;
  sum = scale_.cwiseProduct(sum);
  for (const SparseMatrix& rows : wish_rows_) sum += rows.transpose() * (rows * v);
  return sum;
}

DesignEffort StructureProblem::effort() const {
  DesignEffort effort = effort_;
  for (const auto& pose : poses_) {
    effort.solves += pose->solves();
    effort.factorizations += pose->factorizations();
  }
  return effort;
}

}  // namespace lissom
