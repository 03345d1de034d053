#include "lissom/design/log_space.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lissom/core/assert.h"

namespace lissom {

namespace {

constexpr double kShareOfRange = 0.1;  // that is felt, as in other spaces

bool positive_by_nature(ParameterKind kind) {
  switch (kind) {
    case ParameterKind::kYoungsModulus:
    case ParameterKind::kSheetStiffness:
    case ParameterKind::kThickness:
    case ParameterKind::kPreStretch:
    case ParameterKind::kLengthFactor:
      return true;
    default:
      return false;
  }
}

}  // namespace

Result<LogSpace> LogSpace::make(SpacePtr inner) {
  LogSpace out;
  for (Parameter parameter : inner->parameters()) {
    const bool logarithmic = positive_by_nature(parameter.kind);
    if (logarithmic) {
      if (!(parameter.lower > 0)) {
        return Error{ErrorCode::kRange, "/parameters", parameter.name + " may be 0 or less",
                     "give a positive lower bound"};
      }
      parameter.lower = std::log(parameter.lower);
      parameter.upper = std::log(parameter.upper);
      parameter.scale = kShareOfRange * (parameter.upper - parameter.lower);
    }
    out.logarithmic_.push_back(logarithmic);
    out.parameters_.push_back(std::move(parameter));
  }
  out.inner_start_ = inner->start();
  out.start_ = out.inner_start_;
  for (int i = 0; i < out.start_.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const Parameter& own = out.parameters_[k];
    if (out.logarithmic_[k]) out.start_[i] = std::clamp(std::log(out.start_[i]), own.lower, own.upper);
  }
  out.inner_ = std::move(inner);
  return out;
}

VecX LogSpace::values(const VecX& u) const {
  LISSOM_ASSERT(u.size() == size());
  VecX p = u;
  for (int i = 0; i < p.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (!logarithmic_[k]) continue;
    const Parameter& own = inner_->parameters()[k];
    p[i] = u[i] == start_[i] ? inner_start_[i] : std::clamp(std::exp(u[i]), own.lower, own.upper);
  }
  return p;
}

VecX LogSpace::slope(const VecX& u) const {
  VecX slope = values(u);
  for (int i = 0; i < slope.size(); ++i) {
    if (!logarithmic_[static_cast<std::size_t>(i)]) slope[i] = 1;
  }
  return slope;
}

Result<Design> LogSpace::at(const VecX& u) const {
  if (const Status s = check_bounds(parameters_, u); !s) return s.error();
  return inner_->at(values(u));
}

Result<Design> LogSpace::applied(Design design, const VecX& u) const {
  if (const Status s = check_bounds(parameters_, u); !s) return s.error();
  return inner_->applied(std::move(design), values(u));
}

DesignJacobian LogSpace::jacobian(const Design& design, const VecX& u) const {
  SparseMatrix slopes(size(), size());
  slopes = slope(u).asDiagonal();
  return chained(inner_->jacobian(design, values(u)), slopes);
}

VecX LogSpace::curvature(const Design& design, const VecX& u, const VecX& y, const VecX& v) const {
  const VecX p = values(u), slope = this->slope(u);
  VecX sum = slope.cwiseProduct(inner_->curvature(design, p, y, slope.cwiseProduct(v)));
  const SparseMatrix inputs = inner_->jacobian(design, p).inputs;
  if (inputs.cols() == 0) return sum;
  const VecX by_p = inputs.transpose() * y;
  // The second derivative of exp is its first one.
  for (int i = 0; i < sum.size(); ++i) {
    if (logarithmic_[static_cast<std::size_t>(i)]) sum[i] += slope[i] * v[i] * by_p[i];
  }
  return sum;
}

}  // namespace lissom
