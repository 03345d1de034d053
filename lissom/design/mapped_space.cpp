#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <utility>

#include "lissom/core/assert.h"
#include "lissom/design/design_spaces.h"
#include "lissom/design/linear_space.h"

namespace lissom {

namespace {

constexpr double kRounding = 1e-12;  // of a range

using RowMajor = Eigen::SparseMatrix<double, Eigen::RowMajor>;

bool has_bounds(const Parameter& parameter) { return parameter.lower != 0 || parameter.upper != 0; }

Error no_range(const std::string& name) {
  return {ErrorCode::kRange, "/parameters",
          fmt::format("no value of \"{}\" keeps all it acts on within their bounds", name),
          "widen the bounds, or start from within them"};
}

/// Ranges of those parameters that came without.
Status find_bounds(const DesignSpace& inner, const VecX& origin, const RowMajor& z,
                   std::vector<Parameter>& parameters) {
  std::vector<bool> wanted;
  for (Parameter& parameter : parameters) {
    wanted.push_back(!has_bounds(parameter));
    if (!wanted.back()) continue;
    parameter.lower = -std::numeric_limits<double>::infinity();
    parameter.upper = std::numeric_limits<double>::infinity();
  }
  for (int i = 0; i < z.rows(); ++i) {
    const Parameter& own = inner.parameters()[static_cast<std::size_t>(i)];
    const double slack = kRounding * (own.upper - own.lower);
    int entries = 0, column = -1;
    double value = 0;
    bool any = false;
    for (RowMajor::InnerIterator it(z, i); it; ++it) {
      if (it.value() == 0) continue;
      ++entries;
      column = static_cast<int>(it.col());
      value = it.value();
      any = any || wanted[static_cast<std::size_t>(column)];
    }
    if (entries == 0) {
      if (origin[i] >= own.lower - slack && origin[i] <= own.upper + slack) continue;
      return no_range(own.name);
    }
    if (!any) continue;
    if (entries > 1) {
      return Error{ErrorCode::kUnsupported, "/parameters",
                   fmt::format("\"{}\" hangs on several parameters, whose bounds do not follow from its own", own.name),
                   "give bounds of the combined parameters"};
    }
    Parameter& parameter = parameters[static_cast<std::size_t>(column)];
    const double a = (own.lower - origin[i]) / value, b = (own.upper - origin[i]) / value;
    parameter.lower = std::max(parameter.lower, std::min(a, b));
    parameter.upper = std::min(parameter.upper, std::max(a, b));
  }
  for (const Parameter& parameter : parameters) {
    if (!(parameter.lower < parameter.upper)) return no_range(parameter.name);
  }
  return {};
}

/// The least change of a parameter by which one of those that it acts on moves by its own scale.
double scale_of(const DesignSpace& inner, const SparseMatrix& z, int column) {
  double scale = std::numeric_limits<double>::infinity();
  for (SparseMatrix::InnerIterator it(z, column); it; ++it) {
    if (it.value() != 0) {
      scale = std::min(scale, inner.parameters()[static_cast<std::size_t>(it.row())].scale / std::abs(it.value()));
    }
  }
  return scale;
}

}  // namespace

Result<MappedSpace> MappedSpace::make(SpacePtr inner, VecX origin, SparseMatrix z, std::vector<Parameter> parameters) {
  LISSOM_ASSERT(origin.size() == inner->size() && z.rows() == origin.size());
  LISSOM_ASSERT(z.cols() == static_cast<Eigen::Index>(parameters.size()));
  if (Status s = find_bounds(*inner, origin, RowMajor(z), parameters); !s) return s.error();
  VecX lower(z.cols()), upper(z.cols());
  for (int j = 0; j < z.cols(); ++j) {
    Parameter& parameter = parameters[static_cast<std::size_t>(j)];
    const double scale = scale_of(*inner, z, j);
    if (!std::isfinite(scale)) {
      return Error{ErrorCode::kRange, "/parameters", fmt::format("\"{}\" acts on nothing", parameter.name),
                   "leave it out"};
    }
    if (parameter.scale == 0) parameter.scale = scale;
    lower[j] = parameter.lower;
    upper[j] = parameter.upper;
  }
  MappedSpace out;
  out.start_ = least_squares(z, inner->start() - origin, VecX::Zero(z.cols())).cwiseMax(lower).cwiseMin(upper);
  out.inner_ = std::move(inner);
  out.origin_ = std::move(origin);
  out.z_ = std::move(z);
  out.parameters_ = std::move(parameters);
  return out;
}

VecX MappedSpace::inner_parameters(const VecX& a) const {
  LISSOM_ASSERT(a.size() == size());
  VecX p = origin_ + z_ * a;
  for (int i = 0; i < p.size(); ++i) {
    const Parameter& own = inner_->parameters()[static_cast<std::size_t>(i)];
    const double slack = kRounding * (own.upper - own.lower);
    if (p[i] < own.lower && p[i] >= own.lower - slack) p[i] = own.lower;
    if (p[i] > own.upper && p[i] <= own.upper + slack) p[i] = own.upper;
  }
  return p;
}

Result<Design> MappedSpace::at(const VecX& a) const {
  if (Status s = check_bounds(parameters_, a); !s) return s.error();
  return inner_->at(inner_parameters(a));
}

Result<Design> MappedSpace::applied(Design design, const VecX& a) const {
  if (Status s = check_bounds(parameters_, a); !s) return s.error();
  return inner_->applied(std::move(design), inner_parameters(a));
}

DesignJacobian MappedSpace::jacobian(const Design& design, const VecX& a) const {
  return chained(inner_->jacobian(design, inner_parameters(a)), z_);
}

VecX MappedSpace::curvature(const Design& design, const VecX& a, const VecX& y, const VecX& v) const {
  return z_.transpose() * inner_->curvature(design, inner_parameters(a), y, z_ * v);
}

}  // namespace lissom
