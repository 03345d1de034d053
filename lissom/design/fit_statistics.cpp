#include "lissom/design/fit_statistics.h"

#include <Eigen/SVD>
#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>

#include "lissom/core/assert.h"

namespace lissom {

namespace {

using Certainty = ParameterCertainty::State;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
/// Of the largest: what equilibria and their derivatives resolve.
constexpr double kInsensitive = 1e-8, kSingular = 1e-6;
/// Share of a parameter in a direction without effect (unit length) from which on it takes part in it.
constexpr double kTakesPart = 1e-3;

/// Columns of unit length of those parameters that have an effect.
struct Columns {
  std::vector<int> numbers;
  VecX length;
  MatX unit;
};

Columns effective(const MatX& jacobian, const std::vector<FittedParameter>& parameters, FitStatistics& out) {
  const Eigen::Index m = jacobian.cols();
  VecX effect(m);
  for (Eigen::Index i = 0; i < m; ++i)
    effect[i] = jacobian.col(i).norm() * parameters[static_cast<std::size_t>(i)].reach;
  const double least = kInsensitive * effect.maxCoeff();
  Columns columns;
  for (int i = 0; i < m; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (parameters[k].bound == FittedParameter::Bound::kLower) {
      out.parameters[k].state = Certainty::kAtLowerBound;
    } else if (parameters[k].bound == FittedParameter::Bound::kUpper) {
      out.parameters[k].state = Certainty::kAtUpperBound;
    } else if (!(effect[i] > least)) {
      out.parameters[k].state = Certainty::kUndetermined;
    } else {
      columns.numbers.push_back(i);
    }
  }
  const Eigen::Index count = static_cast<Eigen::Index>(columns.numbers.size());
  columns.length.resize(count);
  columns.unit.resize(jacobian.rows(), count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const auto column = jacobian.col(columns.numbers[static_cast<std::size_t>(k)]);
    columns.length[k] = column.norm();
    columns.unit.col(k) = column / columns.length[k];
  }
  return columns;
}

/// (J'J)^-1 on the directions that have an effect; parameters of the others are marked, in groups that belong together.
MatX inverse_gram(const Columns& columns, FitStatistics& out) {
  const Eigen::Index count = columns.length.size();
  if (count == 0) return MatX::Zero(0, 0);
  const Eigen::JacobiSVD<MatX> svd(columns.unit, Eigen::ComputeThinU | Eigen::ComputeFullV);
  const VecX& sigma = svd.singularValues();
  const MatX& v = svd.matrixV();
  MatX inverse = MatX::Zero(count, count), null_space = MatX::Zero(count, count);
  for (Eigen::Index k = 0; k < count; ++k) {
    if (k < sigma.size() && sigma[k] > kSingular * sigma[0]) {
      inverse += v.col(k) * v.col(k).transpose() / (sigma[k] * sigma[k]);
      ++out.rank;
    } else {
      null_space += v.col(k) * v.col(k).transpose();
    }
  }
  std::vector<bool> grouped(static_cast<std::size_t>(count), false);
  for (Eigen::Index i = 0; i < count; ++i) {
    if (grouped[static_cast<std::size_t>(i)] || !(null_space(i, i) > kTakesPart * kTakesPart)) continue;
    // Whoever the projector onto the null space ties to i, directly or through others.
    std::vector<Eigen::Index> group{i};
    grouped[static_cast<std::size_t>(i)] = true;
    for (std::size_t next = 0; next < group.size(); ++next) {
      for (Eigen::Index j = 0; j < count; ++j) {
        if (grouped[static_cast<std::size_t>(j)] || !(std::abs(null_space(group[next], j)) > kTakesPart)) continue;
        grouped[static_cast<std::size_t>(j)] = true;
        group.push_back(j);
      }
    }
    std::vector<int> numbers;
    for (const Eigen::Index j : group) numbers.push_back(columns.numbers[static_cast<std::size_t>(j)]);
    std::sort(numbers.begin(), numbers.end());
    for (const int j : numbers) out.parameters[static_cast<std::size_t>(j)].state = Certainty::kUndetermined;
    out.combinations.push_back(std::move(numbers));
  }
  return columns.length.cwiseInverse().asDiagonal() * inverse * columns.length.cwiseInverse().asDiagonal();
}

}  // namespace

double student_quantile(int freedom, double confidence) {
  LISSOM_ASSERT(freedom >= 1 && confidence > 0 && confidence < 1);
  const boost::math::students_t distribution(freedom);
  return boost::math::quantile(boost::math::complement(distribution, 0.5 * (1 - confidence)));
}

FitStatistics fit_statistics(const MatX& jacobian, const VecX& residual, const std::vector<FittedParameter>& parameters,
                             double confidence) {
  const Eigen::Index m = jacobian.cols();
  LISSOM_ASSERT(jacobian.rows() == residual.size() && m == static_cast<Eigen::Index>(parameters.size()));
  FitStatistics out;
  out.residuals = static_cast<int>(residual.size());
  out.parameters.assign(parameters.size(), {Certainty::kDetermined, kNone, kNone});
  out.correlation = MatX::Constant(m, m, kNone);
  const Columns columns = effective(jacobian, parameters, out);
  const MatX inverse = inverse_gram(columns, out);
  out.freedom = out.residuals - out.rank;
  out.deviation = out.freedom > 0 ? residual.norm() / std::sqrt(static_cast<double>(out.freedom)) : kNone;
  out.quantile = out.freedom > 0 ? student_quantile(out.freedom, confidence) : kNone;
  std::vector<Eigen::Index> certain;
  for (Eigen::Index k = 0; k < columns.length.size(); ++k) {
    const auto i = static_cast<std::size_t>(columns.numbers[static_cast<std::size_t>(k)]);
    ParameterCertainty& own = out.parameters[i];
    if (own.state != Certainty::kDetermined) continue;
    certain.push_back(k);
    own.standard_error = out.deviation * std::sqrt(inverse(k, k));
    own.half_width = out.quantile * own.standard_error;
    if (own.half_width > parameters[i].reach) own.state = Certainty::kUncertain;
  }
  for (const Eigen::Index a : certain) {
    for (const Eigen::Index b : certain) {
      out.correlation(columns.numbers[static_cast<std::size_t>(a)], columns.numbers[static_cast<std::size_t>(b)]) =
          a == b ? 1 : inverse(a, b) / std::sqrt(inverse(a, a) * inverse(b, b));
    }
  }
  return out;
}

}  // namespace lissom
