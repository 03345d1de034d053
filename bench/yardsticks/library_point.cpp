#include "bench/yardsticks/library_point.h"

#include <cmath>

namespace lissom {

LibraryPoint::LibraryPoint(ReducedProblem& problem)
    : problem_(problem), best_(problem.x()), best_value_(problem.value()) {}

/// Makes x the last attempt, unless it is that already.
bool LibraryPoint::settle(const VecX& x) {
  if (attempted_.size() == x.size() && attempted_ == x) return attempt_settled_;
  const Attempt attempt = problem_.attempt(x);
  ++report_.attempts;
  attempted_ = x;
  attempted_value_ = attempt.value;
  attempt_settled_ = attempt.outcome == Outcome::kSettled && std::isfinite(attempt.value);
  report_.failed += !attempt_settled_;
  return attempt_settled_;
}

bool LibraryPoint::value(const VecX& x, double& h) {
  const VecX inside = x.cwiseMax(problem_.lower()).cwiseMin(problem_.upper());
  if (inside == problem_.x()) {
    h = problem_.value();
    return true;
  }
  if (!settle(inside)) return false;
  h = attempted_value_;
  return true;
}

bool LibraryPoint::gradient(const VecX& x, VecX& g) {
  const VecX inside = x.cwiseMax(problem_.lower()).cwiseMin(problem_.upper());
  if (inside != problem_.x()) {
    if (!settle(inside)) return false;
    problem_.accept();
    attempted_.resize(0);  // predictions start elsewhere now
    if (problem_.value() < best_value_) {
      best_value_ = problem_.value();
      best_ = problem_.x();
    }
  }
  g = problem_.gradient();
  ++report_.gradients;
  return g.allFinite();
}

YardstickReport LibraryPoint::finish() {
  if (problem_.x() != best_ && settle(best_)) problem_.accept();
  report_.value = problem_.value();
  return report_;
}

}  // namespace lissom
