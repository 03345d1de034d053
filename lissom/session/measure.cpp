// From one entry of a document to the numbers it claims something about: poses, resolutions, combinations.

#include <algorithm>
#include <cmath>

#include "lissom/core/nearest_name.h"
#include "lissom/model/sampling.h"
#include "lissom/session/quantities.h"

namespace lissom {

namespace {

Result<std::vector<int>> pose_indices(const Model& model, const Expectation& e, const std::string& where) {
  std::vector<int> indices;
  std::vector<std::string> names;
  for (const Pose& pose : model.poses) names.push_back(pose.name);
  for (const std::string& wanted : e.poses) {
    const auto found = std::find(names.begin(), names.end(), wanted);
    if (found == names.end()) {
      return Error{ErrorCode::kUnknown, where + "/poses", "there is no pose \"" + wanted + "\"",
                   suggestion(wanted, names)};
    }
    indices.push_back(static_cast<int>(found - names.begin()));
  }
  if (e.poses.empty()) {
    for (int i = 0; i < static_cast<int>(names.size()); ++i) indices.push_back(i);
  }
  if (!indices.empty()) return indices;
  return Error{ErrorCode::kConflict, "/poses", "the document has no pose to measure in", "add one"};
}

/// Factors by which all rods are refined to have the resolutions asked for.
Result<std::vector<double>> refinements(const Model& model, const Expectation& e, const std::string& where) {
  if (e.edges.empty()) return std::vector<double>{1};
  const Rod* rod = model.rods.empty() ? nullptr : &model.rods.front();
  for (const Rod& candidate : model.rods) {
    if (candidate.name == e.rod) rod = &candidate;
  }
  if (rod == nullptr || (!e.rod.empty() && rod->name != e.rod)) {
    return Error{ErrorCode::kUnknown, where + "/rod", "there is no rod \"" + e.rod + "\"", "name one of the rods"};
  }
  const Result<int> base = edge_count(*rod, 1, where + "/rod");
  if (!base) return base.error();
  std::vector<double> factors;
  for (const int edges : e.edges) {
    factors.push_back(static_cast<double>(edges) / base.value());
    const Result<int> got = edge_count(*rod, factors.back(), where + "/edges");
    if (!got) return got.error();
    if (got.value() != edges) {
      return Error{ErrorCode::kRange, where + "/edges",
                   "the rod needs at least " + std::to_string(got.value()) + " edges, " + std::to_string(edges) +
                       " are asked for",
                   "ask for more"};
    }
  }
  return factors;
}

/// Slope of the least-squares line through (log N_i, log |q_i - q_(i+1)|), sign changed.
Result<double> convergence_order(const std::vector<int>& edges, const std::vector<double>& q,
                                 const std::string& where) {
  const double ratio = static_cast<double>(edges[1]) / edges[0];
  double n = 0, sum_x = 0, sum_y = 0, sum_xx = 0, sum_xy = 0;
  for (size_t i = 0; i + 1 < q.size(); ++i) {
    if (std::abs(static_cast<double>(edges[i + 1]) / edges[i] / ratio - 1) > 0.01 || !(ratio > 1)) {
      return Error{ErrorCode::kRange, where + "/edges", "the order needs resolutions that grow by a constant factor",
                   "write for example [20, 40, 80, 160]"};
    }
    const double x = std::log(edges[i]), y = std::log(std::abs(q[i] - q[i + 1]));
    n += 1;
    sum_x += x;
    sum_y += y;
    sum_xx += x * x;
    sum_xy += x * y;
  }
  return -(n * sum_xy - sum_x * sum_y) / (n * sum_xx - sum_x * sum_x);
}

Result<double> combined_resolutions(const Expectation& e, const std::vector<double>& q, const std::string& where) {
  const size_t n = q.size();
  if (e.combine != "order" && e.combine != "limit") return q.front();
  for (size_t i = 1; i < n; ++i) {
    if (e.edges[i] > e.edges[i - 1]) continue;
    return Error{ErrorCode::kRange, where + "/edges", "the resolutions have to grow", "write for example [20, 40, 80]"};
  }
  if (e.combine == "order") return convergence_order(e.edges, q, where);
  const double ratio = static_cast<double>(e.edges[n - 1]) / e.edges[n - 2];
  return q[n - 1] + (q[n - 1] - q[n - 2]) / (ratio * ratio - 1);
}

/// Says which of `edges` and `combine` do not go together.
Status check_combination(const Expectation& e, size_t poses, const std::string& where) {
  const bool over_edges = e.combine == "order" || e.combine == "limit";
  const bool over_pair = e.combine == "difference" || e.combine == "ratio";
  if (!e.combine.empty() && !over_edges && !over_pair) {
    const std::vector<std::string> known{"difference", "ratio", "order", "limit"};
    return Error{ErrorCode::kUnknown, where + "/combine", "measurements cannot be combined by \"" + e.combine + "\"",
                 suggestion(e.combine, known)};
  }
  const size_t needed = e.combine == "order" ? 3 : e.combine == "limit" ? 2 : 1;
  if ((over_edges && e.edges.size() < needed) || (!over_edges && e.edges.size() > 1)) {
    return Error{ErrorCode::kConflict, where + "/edges",
                 over_edges ? "\"" + e.combine + "\" needs at least " + std::to_string(needed) + " resolutions"
                            : "several resolutions need \"combine\"",
                 "write \"combine\": \"order\" with \"edges\": [20, 40, 80, 160], for example"};
  }
  if (over_pair && !e.to && poses != 2) {
    return Error{ErrorCode::kConflict, where + "/combine", "\"" + e.combine + "\" needs \"to\" or exactly two poses",
                 "name the second place, or two poses"};
  }
  return {};
}

}  // namespace

Result<std::vector<double>> measure(Study& study, const Expectation& e, const std::string& where) {
  if (const Status status = check_expectation(e); !status) {
    Error error = status.error();
    error.where = where + "/" + error.where;
    return error;
  }
  const NamedQuantity quantity = find_quantity(e.quantity).value();
  const bool posed = quantity.info->poses != PoseUse::kNone;
  const Result<std::vector<int>> poses = posed ? pose_indices(study.model(), e, where) : std::vector<int>{-1};
  if (!poses) return poses.error();
  if (const Status status = check_combination(e, poses.value().size(), where); !status) return status.error();
  const Result<std::vector<double>> factors = refinements(study.model(), e, where);
  if (!factors) return factors.error();

  const auto at_resolutions = [&](const Selector& at, const std::vector<int>& in) -> Result<double> {
    std::vector<double> values;
    for (const double refine : factors.value()) {
      const Result<double> value = quantity.measure({study, e, at, in, refine, where});
      if (!value) return value;
      values.push_back(value.value());
    }
    return combined_resolutions(e, values, where);
  };
  const auto compared = [&](const Result<double>& a, const Result<double>& b) -> Result<double> {
    if (!a) return a;
    if (!b) return b;
    return e.combine == "difference" ? a.value() - b.value() : a.value() / b.value();
  };
  const bool pair = e.combine == "difference" || e.combine == "ratio";
  std::vector<Result<double>> results;
  if (quantity.info->poses == PoseUse::kTogether) {
    results.push_back(at_resolutions(e.at, poses.value()));
  } else if (pair && !e.to) {
    results.push_back(compared(at_resolutions(e.at, {poses.value()[0]}), at_resolutions(e.at, {poses.value()[1]})));
  } else {
    for (const int pose : poses.value()) {
      results.push_back(pair ? compared(at_resolutions(e.at, {pose}), at_resolutions(*e.to, {pose}))
                             : at_resolutions(e.at, {pose}));
    }
  }
  std::vector<double> values;
  for (const Result<double>& result : results) {
    if (!result) return result.error();
    values.push_back(result.value());
  }
  return values;
}

}  // namespace lissom
