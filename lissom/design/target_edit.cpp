#include "lissom/design/target_edit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "lissom/design/shape_modes.h"

namespace lissom {

namespace {

constexpr int kPowerSteps = 30;
constexpr int kMostStaying = 300;
constexpr double kNearBound = 0.01;  // of the range

BoundMap map_of(std::span<const Parameter> parameters) {
  VecX lower(static_cast<Eigen::Index>(parameters.size())), upper(lower.size());
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    lower[static_cast<Eigen::Index>(i)] = parameters[i].lower;
    upper[static_cast<Eigen::Index>(i)] = parameters[i].upper;
  }
  return {std::move(lower), std::move(upper)};
}

double largest_eigenvalue(const MatX& matrix) {
  VecX v = VecX::Ones(matrix.rows());
  double value = 0;
  for (int step = 0; step < kPowerSteps; ++step) {
    const VecX next = matrix * v;
    value = next.norm();
    if (!(value > 0)) return 0;
    v = next / value;
  }
  return value;
}

}  // namespace

TargetEdit::TargetEdit(std::shared_ptr<const ShapeResponse> response, HardConstraints constraints,
                       std::vector<PulledNode> pulled, double stay)
    : response_(std::move(response)),
      constraints_(std::move(constraints)),
      pulled_(std::move(pulled)),
      map_(map_of(response_->parameters())) {
  const ShapeResponse& s = *response_;
  u_ = map_.unbounded(map_.inside(s.p()));
  slope_ = map_.slope(u_);
  MatX k = constraint_response(constraints_, s.start().state.q, s.matrix());
  k.array().rowwise() *= slope_.transpose().array();
  projection_ = ConstraintProjection(k);
  rows_.resize(3 * static_cast<Eigen::Index>(pulled_.size()), s.size());
  for (std::size_t i = 0; i < pulled_.size(); ++i) {
    rows_.middleRows<3>(3 * static_cast<Eigen::Index>(i)) =
        pulled_[i].weight * s.matrix().middleRows<3>(3 * pulled_[i].node);
  }
  rows_.array().rowwise() *= slope_.transpose().array();
  rows_.transposeInPlace();
  projection_.apply(rows_);
  MatX normal = MatX::Zero(s.size(), s.size());
  normal.selfadjointView<Eigen::Lower>().rankUpdate(rows_);
  normal = MatX(normal.selfadjointView<Eigen::Lower>());
  rows_.transposeInPlace();
  if (stay > 0) add_stay(stay, normal);
  const double least = kLeastChange * largest_eigenvalue(normal);
  normal.diagonal().array() += least > 0 ? least : 1;
  normal_.compute(normal);
}

void TargetEdit::add_stay(double stay, MatX& normal) const {
  const ShapeResponse& s = *response_;
  std::vector<bool> is_pulled(static_cast<std::size_t>(s.system().layout.nodes()), false);
  double total = 0;
  for (const PulledNode& node : pulled_) {
    is_pulled[static_cast<std::size_t>(node.node)] = true;
    total += node.weight * node.weight;
  }
  std::vector<int> rest;
  for (const int node : spread_nodes(s.system(), kMostStaying)) {
    if (!is_pulled[static_cast<std::size_t>(node)]) rest.push_back(node);
  }
  if (rest.empty()) return;
  const double weight = stay * std::sqrt(total / static_cast<double>(rest.size()));
  MatX rows(3 * static_cast<Eigen::Index>(rest.size()), s.size());
  for (std::size_t i = 0; i < rest.size(); ++i) {
    rows.middleRows<3>(3 * static_cast<Eigen::Index>(i)) = weight * s.matrix().middleRows<3>(3 * rest[i]);
  }
  rows.array().rowwise() *= slope_.transpose().array();
  rows.transposeInPlace();
  projection_.apply(rows);
  normal.selfadjointView<Eigen::Lower>().rankUpdate(rows);
  normal = MatX(normal.selfadjointView<Eigen::Lower>());
}

TargetEdit::Answer TargetEdit::answer(const VecX& wanted) const {
  VecX weighted = wanted;
  double total = 0;
  for (std::size_t i = 0; i < pulled_.size(); ++i) {
    weighted.segment<3>(3 * static_cast<Eigen::Index>(i)) *= pulled_[i].weight;
    total += pulled_[i].weight * pulled_[i].weight;
  }
  const VecX change = projection_.of(normal_.solve(rows_.transpose() * weighted));
  const ShapeResponse& s = *response_;
  Answer answer;
  answer.p = map_.parameters(u_ + s.scale().cwiseProduct(change));
  answer.dq = s.matrix() * slope_.cwiseProduct(change);
  answer.rms = std::sqrt((rows_ * change - weighted).squaredNorm() / std::max(total, 1e-300));
  return answer;
}

std::vector<ParameterChange> largest_changes(std::span<const Parameter> parameters, const VecX& from, const VecX& to,
                                             int most) {
  std::vector<ParameterChange> changes;
  for (int i = 0; i < static_cast<int>(parameters.size()); ++i) {
    const Parameter& parameter = parameters[static_cast<std::size_t>(i)];
    const double near = kNearBound * (parameter.upper - parameter.lower);
    changes.push_back({i, from[i], to[i], to[i] < parameter.lower + near || to[i] > parameter.upper - near});
  }
  const auto size = [&](const ParameterChange& change) {
    return std::abs(change.to - change.from) / parameters[static_cast<std::size_t>(change.parameter)].scale;
  };
  std::stable_sort(changes.begin(), changes.end(),
                   [&](const ParameterChange& a, const ParameterChange& b) { return size(a) > size(b); });
  if (static_cast<int>(changes.size()) > most) changes.resize(static_cast<std::size_t>(most));
  return changes;
}

}  // namespace lissom
