#include "lissom/design/goal.h"

#include <algorithm>
#include <cmath>

#include "lissom/core/assert.h"

namespace lissom {

namespace {

/// What a difference from the target is multiplied with.
VecX factors(const Goal& goal) { return (goal.weight * goal.weights).cwiseSqrt() / goal.scale; }

VecX deviation_of(const Goal& goal, const VecX& c) { return factors(goal).cwiseProduct(c - goal.target); }

/// Factors where the residual counts, 0 elsewhere.
VecX counting(const Goal& goal, const VecX& deviation) {
  VecX f = factors(goal);
  for (int i = 0; i < f.size(); ++i) {
    const bool counts = goal.kind == GoalKind::kReach || (goal.kind == GoalKind::kAtMost && deviation[i] > 0) ||
                        (goal.kind == GoalKind::kAtLeast && deviation[i] < 0);
    if (!counts) f[i] = 0;
  }
  return f;
}

Error refuse(ErrorCode code, const std::string& where, const std::string& message, const std::string& hint) {
  return {code, where, message, hint};
}

Status check_weights(const VecX& weights, const std::string& where) {
  for (int i = 0; i < weights.size(); ++i) {
    if (weights[i] >= 0 && std::isfinite(weights[i])) continue;
    return refuse(ErrorCode::kRange, where + "/" + std::to_string(i), "the weight is negative or not finite",
                  "give a weight of 0 or more");
  }
  if (weights.size() > 0 && weights.maxCoeff() > 0) return {};
  return refuse(ErrorCode::kRange, where, "no place has a weight above 0",
                "give some place a weight, or leave the goal out");
}

Status check_size(const Goal& goal, const VecX& numbers, const std::string& where) {
  if (numbers.size() == goal.objective->size()) return {};
  return refuse(ErrorCode::kConflict, where,
                std::to_string(numbers.size()) + " numbers for the " + std::to_string(goal.objective->size()) +
                    " components of \"" + std::string(goal.objective->name()) + "\"",
                "give one number for each component");
}

}  // namespace

Result<VecX> weights_of_places(const VecX& places, int components, const std::string& where) {
  if (Status s = check_weights(places, where); !s) return s.error();
  const VecX scaled = places / places.maxCoeff();  // the sum of huge weights has to stay finite
  const VecX shares = scaled / scaled.sum();
  VecX weights(places.size() * components);
  for (int i = 0; i < weights.size(); ++i) weights[i] = shares[i / components];
  return weights;
}

Status check_goal(const Goal& goal, const std::string& where) {
  LISSOM_ASSERT(goal.objective != nullptr);
  if (Status s = check_size(goal, goal.target, where + "/target"); !s) return s;
  if (Status s = check_size(goal, goal.weights, where + "/weights"); !s) return s;
  for (int i = 0; i < goal.target.size(); ++i) {
    if (std::isfinite(goal.target[i])) continue;
    return refuse(ErrorCode::kRange, where + "/target/" + std::to_string(i),
                  "the target of " + goal.name + " is not finite", "give a number, or weight 0 to what has no target");
  }
  if (Status s = check_weights(goal.weights, where + "/weights"); !s) return s;
  if (!(goal.scale > 0 && std::isfinite(goal.scale))) {
    return refuse(ErrorCode::kRange, where + "/scale", "the scale of " + goal.name + " is not positive",
                  "give a deviation that is felt");
  }
  if (!(goal.weight > 0 && std::isfinite(goal.weight))) {
    return refuse(ErrorCode::kRange, where + "/weight", "the weight of " + goal.name + " is not positive",
                  "give a positive weight, or leave the goal out");
  }
  return {};
}

Status check_curvature(const Goal& goal) {
  if (goal.objective->has_curvature()) return {};
  return refuse(ErrorCode::kUnsupported, goal.name,
                "exact second derivatives of \"" + std::string(goal.objective->name()) + "\" are not known",
                "use a method that needs first derivatives only, such as Gauss-Newton");
}

VecX goal_deviation(const Goal& goal, const PoseShape& shape) {
  VecX c;
  goal.objective->values(shape, c);
  return deviation_of(goal, c);
}

VecX goal_residual(GoalKind kind, const VecX& deviation) {
  switch (kind) {
    case GoalKind::kReach:
      break;
    case GoalKind::kAtMost:
      return deviation.cwiseMax(0);
    case GoalKind::kAtLeast:
      return deviation.cwiseMin(0);
  }
  return deviation;
}

VecX goal_residual(const Goal& goal, const PoseShape& shape) {
  return goal_residual(goal.kind, goal_deviation(goal, shape));
}

void goal_jacobian(const Goal& goal, const PoseShape& shape, SparseRows& by_q, SparseRows& by_numbers) {
  const VecX f = counting(goal, goal_deviation(goal, shape));
  goal.objective->jacobian(shape, by_q, by_numbers);
  by_q = f.asDiagonal() * by_q;
  by_numbers = f.asDiagonal() * by_numbers;
}

void add_goal_second_order(const Goal& goal, const PoseShape& shape, SecondOrder part, const VecX& dq, const VecX& dn,
                           VecX& by_q, VecX& by_numbers) {
  const VecX deviation = goal_deviation(goal, shape), f = counting(goal, deviation);
  SparseRows j_q, j_numbers;
  goal.objective->jacobian(shape, j_q, j_numbers);
  const VecX change = f.cwiseProduct(f).cwiseProduct(j_q * dq + j_numbers * dn);
  by_q += j_q.transpose() * change;
  by_numbers += j_numbers.transpose() * change;
  if (part == SecondOrder::kGaussNewton) return;
  LISSOM_ASSERT(goal.objective->has_curvature());
  goal.objective->curvature(shape, f.cwiseProduct(deviation), dq, dn, by_q, by_numbers);
}

VecX wish_residual(const ParameterGoal& wish, const VecX& p) {
  VecX deviation = wish.rows * (p - wish.target);
  if (wish.level.size() > 0) deviation -= wish.level;
  return std::sqrt(wish.weight) * goal_residual(wish.kind, deviation);
}

SparseMatrix wish_jacobian(const ParameterGoal& wish, const VecX& p) {
  if (wish.kind == GoalKind::kReach) return std::sqrt(wish.weight) * wish.rows;
  const VecX counts = wish_residual(wish, p).unaryExpr([](double r) { return r == 0 ? 0.0 : 1.0; });
  return SparseMatrix(std::sqrt(wish.weight) * counts.asDiagonal() * wish.rows).pruned();
}

}  // namespace lissom
