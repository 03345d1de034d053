#include "lissom/design/total_run.h"

#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "lissom/core/assert.h"
#include "lissom/design/optimizer_state.h"

namespace lissom {

namespace {

double clock_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

Eliminated::Eliminated(const TotalSpace& space)
    : gradient(space.gradient()), sensitivity(space.sensitivity()), back(-space.solve(space.constraint())) {
  reduced = onto(gradient);
  jacobian = space.residual_by_state() * sensitivity + MatX(space.residual_by_x());
  residual_back = space.residual_by_state() * back;
}

VecX Eliminated::along(const VecX& v) const {
  VecX z(sensitivity.rows() + v.size());
  z << sensitivity * v, v;
  return z;
}

VecX Eliminated::onto(const VecX& w) const {
  return sensitivity.transpose() * w.head(sensitivity.rows()) + w.tail(sensitivity.cols());
}

VecX Eliminated::step(const VecX& v) const {
  VecX z = along(v);
  z.head(back.size()) += back;
  return z;
}

TotalRun::TotalRun(TotalSpace& space_of, const TotalOptions& options_of, const Context& context, TotalResult& result)
    : space(space_of), options(options_of), context_(context), result_(result), began_(clock_seconds()) {}

double TotalRun::seconds() const { return clock_seconds() - began_; }

const Eliminated& TotalRun::eliminated() {
  if (!eliminated_) eliminated_.emplace(space);
  return *eliminated_;
}

std::string TotalRun::worst() const {
  if (!in_equilibrium()) return space.worst_force();
  const auto largest = largest_entries(promise_, 1);
  if (largest.empty()) return "no gradient is left";
  return fmt::format("a gradient of {:.3g} is left in {}", largest[0].value,
                     space.parameter_name(largest[0].parameter));
}

void TotalRun::end(TotalVerdict verdict, const std::string& reason) {
  result_.verdict = verdict;
  result_.message = total_verdict_info(verdict).sentence;
  if (!reason.empty()) result_.message += "; " + reason;
  result_.value = space.value();
  result_.imbalance = space.imbalance();
  result_.gradient = first_gradient_ > 0 ? record.gradient / first_gradient_ : 0;
  result_.negative = space.negative();
  result_.iterations = static_cast<int>(result_.records.size());
  result_.effort = space.effort();
  result_.seconds = seconds();
}

bool TotalRun::look() {
  eliminated_.reset();
  const double gradient = record.gradient;  // the last one known, where there is none here
  record = {};
  record.gradient = gradient;
  record.iteration = static_cast<int>(result_.records.size());
  const Status linear = space.linearize();
  if (!linear) return end(TotalVerdict::kBadStart, linear.error().text()), false;
  record.value = space.value();
  record.imbalance = space.imbalance();
  record.negative = space.negative();
  if (!space.is_regular()) return end(TotalVerdict::kSingular, space.singular()), false;
  const VecX g = space.gradient();
  const VecX reduced = g.tail(space.parameters()) - space.mixed().transpose() * space.solve(g.head(space.states()));
  if (!reduced.allFinite()) return end(TotalVerdict::kBadStart, space.worst_force()), false;
  promise_ = first_order_promise(space.x(), reduced, space.lower(), space.upper());
  record.gradient = promise_.cwiseAbs().maxCoeff();
  if (first_gradient_ < 0) first_gradient_ = record.gradient;
  if (in_equilibrium()) {
    if (options.value_tolerance > 0 && space.value() <= options.value_tolerance) {
      return end(TotalVerdict::kGoodEnough), false;
    }
    if (record.gradient <= options.gradient_tolerance * first_gradient_) return end(TotalVerdict::kConverged), false;
  }
  if (record.iteration >= options.max_iterations) return end(TotalVerdict::kIterationLimit, worst()), false;
  if (cancelled()) return end(TotalVerdict::kCancelled), false;
  return true;
}

void TotalRun::finish_iteration() {
  record.effort = space.effort();
  record.seconds = seconds();
  result_.records.push_back(record);
  if (!context_.progress && !context_.log) return;
  const std::string detail = fmt::format("h {:.3g}, forces {:.3g} of what is accepted", record.value, record.imbalance);
  context_.report({.task = "design", .iteration = record.iteration, .detail = detail});
  if (context_.log) context_.log(detail);
}

}  // namespace lissom
