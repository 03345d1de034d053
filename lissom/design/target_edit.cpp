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
constexpr double kMostSoftness = 10;  // motions count up to so many times as much
constexpr double kNearBound = 0.01;   // of the range
constexpr double kMoves = 0.01;  // mean square share of a motion in places: below it rods only turn about themselves
constexpr int kMostSteps = 3, kMostHalvings = 4;
constexpr double kArrived = 0.01;  // of the value: a step that gains less is the last

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
  for (const PulledNode& node : pulled_) total_ += node.weight * node.weight;
  p_ = map_.inside(s.p());
  u_ = map_.unbounded(p_);
  k_ = constraint_response(constraints_, s.start().state.q, s.matrix());
  rows_.resize(3 * static_cast<Eigen::Index>(pulled_.size()), s.size());
  for (std::size_t i = 0; i < pulled_.size(); ++i) {
    rows_.middleRows<3>(3 * static_cast<Eigen::Index>(i)) =
        pulled_[i].weight * s.matrix().middleRows<3>(3 * pulled_[i].node);
  }
  gram_ = MatX::Zero(s.size(), s.size());
  gram_.selfadjointView<Eigen::Lower>().rankUpdate(rows_.transpose());
  if (stay > 0) {
    gram_.selfadjointView<Eigen::Lower>().rankUpdate(stay_rows(stay).transpose());
    gram_.selfadjointView<Eigen::Lower>().rankUpdate(soft_rows(stay).transpose());
  }
  gram_ = MatX(gram_.selfadjointView<Eigen::Lower>());
  const VecX slope = map_.slope(u_);
  largest_ = largest_eigenvalue(normal_at(slope, ConstraintProjection(k_ * slope.asDiagonal())));
  for (int caution = 0; caution < static_cast<int>(kCautions.size()); ++caution) {
    slopes_.push_back(slope_at(VecX::Zero(s.size()), least_change(caution)));
  }
}

/// Amplitudes of the softest motions.
MatX TargetEdit::soft_rows(double stay) const {
  const ShapeResponse& s = *response_;
  const std::vector<Mode>& softest = s.softest();
  const int places = 3 * s.system().layout.nodes();
  MatX rows = MatX::Zero(static_cast<Eigen::Index>(softest.size()), s.size());
  for (std::size_t i = 0; i < softest.size(); ++i) {
    const VecX shape = softest[i].shape.head(places);
    const double moves = shape.squaredNorm();
    if (moves < kMoves * s.system().layout.nodes()) continue;
    const double softness = std::sqrt(std::max(softest.back().stiffness, 0.0) / std::max(softest[i].stiffness, 1e-300));
    const double weight = std::min(softness, kMostSoftness) * stay * std::sqrt(total_);
    rows.row(static_cast<Eigen::Index>(i)) = weight / moves * shape.transpose() * s.matrix().topRows(places);
  }
  return rows;
}

double TargetEdit::least_change(int caution) const {
  return largest_ > 0 ? kCautions[static_cast<std::size_t>(caution)] * kLeastChange * largest_ : 1;
}

MatX TargetEdit::stay_rows(double stay) const {
  const ShapeResponse& s = *response_;
  std::vector<bool> is_pulled(static_cast<std::size_t>(s.system().layout.nodes()), false);
  for (const PulledNode& node : pulled_) is_pulled[static_cast<std::size_t>(node.node)] = true;
  std::vector<int> rest;
  for (const int node : spread_nodes(s.system(), kMostStaying)) {
    if (!is_pulled[static_cast<std::size_t>(node)]) rest.push_back(node);
  }
  const double weight = stay * std::sqrt(total_ / std::max(static_cast<double>(rest.size()), 1.0));
  MatX rows(3 * static_cast<Eigen::Index>(rest.size()), s.size());
  for (std::size_t i = 0; i < rest.size(); ++i) {
    rows.middleRows<3>(3 * static_cast<Eigen::Index>(i)) = weight * s.matrix().middleRows<3>(3 * rest[i]);
  }
  return rows;
}

TargetEdit::Trial TargetEdit::trial(const VecX& change, const VecX& pull, double least) const {
  const VecX& scale = response_->scale();
  Trial trial;
  trial.change = change;
  trial.x = (map_.parameters(u_ + scale.cwiseProduct(change)) - p_).cwiseQuotient(scale);
  trial.value = trial.x.dot(0.5 * (gram_ * trial.x) - pull) + 0.5 * least * change.squaredNorm();
  return trial;
}

MatX TargetEdit::normal_at(const VecX& slope, const ConstraintProjection& projection) const {
  MatX normal = slope.asDiagonal() * gram_ * slope.asDiagonal();
  projection.apply(normal);
  normal.transposeInPlace();
  projection.apply(normal);
  return normal;
}

TargetEdit::Slope TargetEdit::slope_at(const VecX& change, double least) const {
  Slope at;
  at.slope = map_.slope(u_ + response_->scale().cwiseProduct(change));
  at.projection = ConstraintProjection(k_ * at.slope.asDiagonal());
  MatX normal = normal_at(at.slope, at.projection);
  normal.diagonal().array() += least;
  at.normal.compute(normal);
  return at;
}

VecX TargetEdit::step(const Trial& from, const Slope& at, const VecX& pull, double least) const {
  const VecX downhill = at.slope.cwiseProduct(pull - gram_ * from.x) - least * from.change;
  return at.projection.of(at.normal.solve(at.projection.of(downhill)));
}

VecX TargetEdit::weighted(const VecX& wanted) const {
  VecX weighted = wanted;
  for (std::size_t i = 0; i < pulled_.size(); ++i) {
    weighted.segment<3>(3 * static_cast<Eigen::Index>(i)) *= pulled_[i].weight;
  }
  return weighted;
}

double TargetEdit::miss(const VecX& x, const VecX& weighted) const {
  return std::sqrt((rows_ * x - weighted).squaredNorm() / std::max(total_, 1e-300));
}

TargetEdit::Answer TargetEdit::answer(const VecX& wanted, int caution) const {
  const VecX aims = weighted(wanted), pull = rows_.transpose() * aims;
  const double least = least_change(caution);
  Trial best = trial(VecX::Zero(u_.size()), pull, least);
  const Slope* at = &slopes_[static_cast<std::size_t>(caution)];
  Slope later;
  for (int i = 0;; ++i) {
    const VecX d = step(best, *at, pull, least);
    Trial next = trial(best.change + d, pull, least);
    for (int halving = 0; halving < kMostHalvings && !(next.value < best.value); ++halving) {
      next = trial(0.5 * (best.change + next.change), pull, least);
    }
    if (!(next.value < best.value)) break;
    const double gained = best.value - next.value;
    best = std::move(next);
    if (i + 1 == kMostSteps || gained < kArrived * std::abs(best.value)) break;
    later = slope_at(best.change, least);
    at = &later;
  }
  // Bounds bend the way that leaves the constraints alone.
  for (int i = 0; i < kMostSteps && k_.rows() > 0; ++i) {
    const VecX slope = map_.slope(u_ + response_->scale().cwiseProduct(best.change));
    const ConstraintProjection projection(k_ * slope.asDiagonal());
    best = trial(best.change + projection.least_change(-k_ * best.x), pull, least);
  }
  const ShapeResponse& s = *response_;
  return {map_.clamped(s.p() + s.scale().cwiseProduct(best.x)), s.matrix() * best.x, miss(best.x, aims)};
}

TargetEdit::Answer TargetEdit::shortened(const Answer& answer, const VecX& wanted, double share) const {
  const ShapeResponse& s = *response_;
  const VecX p = s.p() + share * (answer.p - s.p());
  return {p, share * answer.dq, miss((p - s.p()).cwiseQuotient(s.scale()), weighted(wanted))};
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
