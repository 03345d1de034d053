/// Derivatives in total space: blocks of all poses in one numbering, without units.

#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "lissom/core/assert.h"
#include "lissom/core/sparse_pattern.h"
#include "lissom/design/total_space.h"

namespace lissom {

namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

constexpr double kSolved = 1e-2;    // error of a solve beyond which a factor is none
constexpr double kBalanced = 1e-6;  // the same of its residual

template <class Matrix>
void append(const Matrix& part, int row, int column, Triplets& entries) {
  for (int k = 0; k < part.outerSize(); ++k) {
    for (typename Matrix::InnerIterator it(part, k); it; ++it) {
      entries.emplace_back(row + static_cast<int>(it.row()), column + static_cast<int>(it.col()), it.value());
    }
  }
}

SparseMatrix made(Eigen::Index rows, Eigen::Index columns, const Triplets& entries) {
  SparseMatrix matrix(rows, columns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

/// Free part of a Hessian in the order of a pattern, times the scales of its rows and columns.
void append_hessian(const StaticProblem& problem, const std::vector<double>& values, const VecX& scale, int first,
                    Triplets& entries) {
  const SparsePattern& pattern = problem.potential.pattern();
  const std::span<const int> kept = problem.supports.kept();
  for (int column = 0; column < pattern.size(); ++column) {
    const int j = kept[static_cast<std::size_t>(column)];
    if (j < 0) continue;
    const auto at = static_cast<std::size_t>(column);
    for (int slot = pattern.column_start()[at]; slot < pattern.column_start()[at + 1]; ++slot) {
      const int row = pattern.row()[static_cast<std::size_t>(slot)], i = kept[static_cast<std::size_t>(row)];
      if (i < 0) continue;
      const double value = values[static_cast<std::size_t>(slot)] * scale[i] * scale[j];
      entries.emplace_back(first + i, first + j, value);
      if (i != j) entries.emplace_back(first + j, first + i, value);
    }
  }
}

}  // namespace

Status TotalSpace::linearize() {
  renew_point();  // failed attempts leave their numbers
  if (linear_) return {};
  jacobian_ = problem_->space().jacobian(design_, p_);
  singular_.clear();
  negative_ = 0;
  for (const auto& part : parts_) {
    part->workspace->assemble(part->state);
    const FactorReport report = part->workspace->factorize(0);
    ++effort_.factorizations;
    if (!report.complete) {
      const Pose& pose = design_.model.poses[static_cast<std::size_t>(part->pose)];
      singular_ = fmt::format("pose \"{}\": the stiffness matrix is singular", pose.name);
    }
    negative_ += std::max(report.negative_pivots, 0);
    Result<PoseLinearization> linear =
        PoseLinearization::make({design_, problem_->space(), p_, jacobian_, part->pose, *part->problem, part->state},
                                part->workspace->factor(), part->goals);
    if (!linear) return linear.error();
    part->linear.emplace(std::move(linear).value());
  }
  assemble_blocks();
  linear_ = true;
  if (singular_.empty()) check_factors();
  return {};
}

void TotalSpace::assemble_blocks() {
  Triplets hessian, mixed, by_u, by_x;
  int row = 0;
  const int m = parameters();
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    Part& part = *parts_[k];
    const PoseLinearization& linear = *part.linear;
    const Sensitivity& sensitivity = linear.sensitivity();
    append_hessian(*part.problem, part.workspace->hessian(), part.scale / std::sqrt(part.energy), first_[k], hessian);
    const std::span<const int> kept = part.problem->supports.kept();
    const SparseMatrix& forces = sensitivity.forces();
    for (int j = 0; j < forces.outerSize(); ++j) {
      for (SparseMatrix::InnerIterator it(forces, j); it; ++it) {
        const int i = kept[static_cast<std::size_t>(it.row())];
        if (i >= 0) mixed.emplace_back(first_[k] + i, j, it.value() * part.scale[i] * scale_[j] / part.energy);
      }
    }
    append(SparseRows(linear.by_q() * part.free), row, first_[k], by_u);
    append(SparseRows(linear.by_numbers() * SparseMatrix(sensitivity.numbers() * scale_.asDiagonal())), row, 0, by_x);
    part.held.resize(0, 0);
    if (sensitivity.held().cols() > 0) {
      part.held = part.to_global * SparseMatrix(sensitivity.held() * scale_.asDiagonal());
      append(SparseRows(linear.by_q() * part.held), row, 0, by_x);
      holds_ = true;
    }
    row += static_cast<int>(linear.residual().size());
  }
  for (const ParameterGoal& wish : problem_->wishes()) {
    append(SparseMatrix(std::sqrt(wish.weight) * wish.rows * scale_.asDiagonal()), row, 0, by_x);
    row += static_cast<int>(wish.rows.rows());
  }
  LISSOM_ASSERT(row == residual_.size());
  hessian_ = made(states(), states(), hessian);
  mixed_ = made(states(), m, mixed);
  residual_by_u_ = made(row, states(), by_u);
  residual_by_x_ = made(row, m, by_x);
}

/// A factor whose pivots are rounding, or that grew without pivoting, solves nothing although it is complete.
void TotalSpace::check_factors() {
  VecX b(states());
  for (int i = 0; i < b.size(); ++i) b[i] = std::cos(1.0 + 1.7 * i);
  const VecX image = hessian_ * b, again = solve(image), left = hessian_ * again - image;
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    const auto own = [&](const VecX& v) { return v.segment(first_[k], first_[k + 1] - first_[k]).norm(); };
    if (own(again - b) <= kSolved * own(b) && own(left) <= kBalanced * own(image)) continue;
    const Pose& pose = design_.model.poses[static_cast<std::size_t>(parts_[k]->pose)];
    singular_ = fmt::format("pose \"{}\": the stiffness matrix is singular up to rounding", pose.name);
  }
}

VecX TotalSpace::gradient() const {
  VecX g(size());
  g << residual_by_u_.transpose() * residual_, residual_by_x_.transpose() * residual_;
  return g;
}

VecX TotalSpace::constraint_times(const VecX& v) const {
  return hessian_ * v.head(states()) + mixed_ * v.tail(parameters());
}

VecX TotalSpace::constraint_transposed_times(const VecX& w) const {
  VecX out(size());
  out << hessian_ * w, mixed_.transpose() * w;
  return out;
}

VecX TotalSpace::gauss_newton_times(const VecX& v) const {
  const VecX r = residual_by_u_ * v.head(states()) + residual_by_x_ * v.tail(parameters());
  VecX out(size());
  out << residual_by_u_.transpose() * r, residual_by_x_.transpose() * r;
  return out;
}

VecX TotalSpace::lagrangian_times(const VecX& lambda, const VecX& v) const {
  LISSOM_ASSERT(linear_ && numbers_ == Numbers::kPoint);
  VecX out = VecX::Zero(size());
  const VecX by_p = scale_.cwiseProduct(v.tail(parameters()));
  VecX multiplier, free;
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    const Part& part = *parts_[k];
    const Supports& supports = part.problem->supports;
    const Eigen::Index count = part.scale.size();
    supports.expand(part.scale.cwiseProduct(lambda.segment(first_[k], count)) / part.energy, multiplier);
    const PoseLinearization::Lagrangian l =
        part.linear->lagrangian_times(multiplier, increment(static_cast<int>(k), v), by_p, context_.threads);
    supports.restrict(l.by_q, free);
    out.segment(first_[k], count) = part.scale.cwiseProduct(free);
    out.tail(parameters()) += scale_.cwiseProduct(l.by_p);
  }
  for (const ParameterGoal& wish : problem_->wishes()) {
    out.tail(parameters()) += wish.weight * scale_.cwiseProduct(VecX(wish.rows.transpose() * (wish.rows * by_p)));
  }
  return out;
}

VecX TotalSpace::solve(const VecX& b) const {
  LISSOM_ASSERT(linear_ && singular_.empty());
  VecX out(states()), x;
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    const Part& part = *parts_[k];
    const Eigen::Index count = part.scale.size();
    part.workspace->factor().solve(b.segment(first_[k], count).cwiseQuotient(part.scale), x);
    out.segment(first_[k], count) = part.energy * x.cwiseQuotient(part.scale);
    ++effort_.back_solves;
  }
  return out;
}

MatX TotalSpace::sensitivity() const {
  LISSOM_ASSERT(linear_ && singular_.empty());
  MatX out(states(), parameters()), x;
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    const Part& part = *parts_[k];
    const Eigen::Index count = part.scale.size();
    const MatX right = part.scale.cwiseInverse().asDiagonal() * MatX(mixed_.middleRows(first_[k], count));
    part.workspace->factor().solve_many(right, x);
    out.middleRows(first_[k], count) = -part.energy * (part.scale.cwiseInverse().asDiagonal() * x);
    effort_.back_solves += parameters();
  }
  return out;
}

}  // namespace lissom
