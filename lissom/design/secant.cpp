#include "lissom/design/secant.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "lissom/core/assert.h"

namespace lissom {

namespace {

constexpr double kFlat = 1e-8;  // y's of less than this share of |y| |s| tells nothing

}  // namespace

std::array<SecantInfo, 4> secant_rules() {
  return {{{SecantRule::kGaussNewton, "gauss_newton", "products of first derivatives alone"},
           {SecantRule::kBfgs, "bfgs", "all second derivatives from changes of the gradient"},
           {SecantRule::kStructuredBfgs, "structured_bfgs",
            "products of first derivatives, and the rest from changes of the gradient; positive definite"},
           {SecantRule::kDennisGayWelsch, "dennis_gay_welsch",
            "products of first derivatives, and the rest from changes of the gradient; may be indefinite"}}};
}

SecantHessian::SecantHessian(SecantRule rule, int parameters)
    : rule_(rule), memory_{MatX::Zero(parameters, parameters)} {}

SecantHessian::SecantHessian(SecantRule rule, SecantMemory memory) : rule_(rule), memory_(std::move(memory)) {
  LISSOM_ASSERT(memory_.second.rows() == memory_.second.cols());
}

void SecantHessian::forget() {
  memory_.second.setZero();
  memory_.has_step = false;
}

void SecantHessian::reset() {
  forget();
  ++memory_.resets;
}

MatX SecantHessian::at(const MatX& gram) const {
  if (rule_ == SecantRule::kGaussNewton) return gram;
  // Before its first step BFGS knows nothing better than the products of first derivatives.
  if (rule_ == SecantRule::kBfgs) return memory_.has_step ? memory_.second : gram;
  return gram + memory_.second;
}

void SecantHessian::learn(const SecantStep& s) {
  LISSOM_ASSERT(s.step.size() == memory_.second.rows() && s.gradient_change.size() == memory_.second.rows());
  if (!s.step.allFinite() || !s.gradient_change.allFinite()) return reset();
  switch (rule_) {
    case SecantRule::kGaussNewton:
      return;
    case SecantRule::kBfgs:
      return bfgs(s);
    case SecantRule::kStructuredBfgs:
      return structured_bfgs(s);
    case SecantRule::kDennisGayWelsch:
      return dennis_gay_welsch(s);
  }
}

void SecantHessian::bfgs(const SecantStep& s) {
  const VecX& y = s.gradient_change;
  const double ys = y.dot(s.step);
  if (!(ys > kFlat * y.norm() * s.step.norm())) return reset();
  if (!memory_.has_step) {  // scaled so that it has the size of the curvature just seen
    memory_.second = MatX::Identity(y.size(), y.size()) * (y.squaredNorm() / ys);
    memory_.has_step = true;
  }
  const VecX image = memory_.second * s.step;
  memory_.second += y * y.transpose() / ys - image * image.transpose() / s.step.dot(image);
}

void SecantHessian::structured_bfgs(const SecantStep& s) {
  const MatX sum = s.gram + memory_.second;
  const VecX image = sum * s.step, y = s.gram * s.step + s.structured_change;
  const double ys = y.dot(s.step), curvature = s.step.dot(image);
  // `sum` has to be positive definite for the update to be so too.
  if (!(curvature > 0) || !(ys > kFlat * curvature) || Eigen::LLT<MatX>(sum).info() != Eigen::Success) return reset();
  memory_.second += y * y.transpose() / ys - image * image.transpose() / curvature;
}

void SecantHessian::dennis_gay_welsch(const SecantStep& s) {
  const VecX &y = s.gradient_change, &structured = s.structured_change;
  const double ys = y.dot(s.step);
  if (!(std::abs(ys) > kFlat * y.norm() * s.step.norm())) return reset();
  // Sizing: what was learned on large residuals is too large for small ones.
  const double known = std::abs(s.step.dot(memory_.second * s.step)), seen = std::abs(s.step.dot(structured));
  const double size = known > seen ? seen / known : 1;
  const VecX z = structured - size * (memory_.second * s.step);
  memory_.second = size * memory_.second + (z * y.transpose() + y * z.transpose()) / ys -
                   (z.dot(s.step) / (ys * ys)) * (y * y.transpose());
}

}  // namespace lissom
