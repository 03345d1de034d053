#include "lissom/design/parameters_of.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <vector>

#include "lissom/design/design_values.h"
#include "lissom/design/linear_space.h"

namespace lissom {

namespace {

constexpr int kMostSteps = 4;        // of Gauss-Newton: one is enough for linear spaces, but for rounding
constexpr double kAgreement = 1e-7;  // over the number itself or the size of what it counts
constexpr double kRounding = 1e-9;   // of a range, by which parameters may be outside of it

/// All numbers in one row, and how large a difference is felt.
struct Row {
  VecX values, felt;
};

Row row_of(const Design& design) {
  const DesignValues all = values_of(design);
  const double size = design.system.structure.size;
  const int places = 3 * static_cast<int>(design.system.structure.nodes.size());
  std::vector<double> values, felt;
  const auto append = [&](const VecX& part, double least) {
    for (const double value : part) {
      values.push_back(value);
      felt.push_back(std::max(std::abs(value), least));
    }
  };
  append(all.inputs.head(places), size);
  append(all.inputs.tail(all.inputs.size() - places), 1e-9);
  for (const PoseValues& pose : all.poses) {
    append(pose.loads, 1e-9);
    append(pose.moves, size);
  }
  return {Eigen::Map<const VecX>(values.data(), static_cast<Eigen::Index>(values.size())),
          Eigen::Map<const VecX>(felt.data(), static_cast<Eigen::Index>(felt.size()))};
}

/// d row / d (p / scale), each row over what is felt. Movements of supports are left out: they are compared, not fitted.
SparseMatrix rows_by_parameters(const DesignSpace& space, const Design& design, const VecX& p, const Row& row) {
  const DesignJacobian jacobian = space.jacobian(design, p);
  const DesignValues sizes = values_of(design);
  std::vector<Eigen::Triplet<double>> entries;
  const auto append = [&](const SparseMatrix& part, Eigen::Index first) {
    for (int column = 0; column < part.outerSize(); ++column) {
      const double scale = space.parameters()[static_cast<std::size_t>(column)].scale;
      for (SparseMatrix::InnerIterator it(part, column); it; ++it) {
        const Eigen::Index at = first + it.row();
        entries.emplace_back(static_cast<int>(at), column, it.value() * scale / row.felt[at]);
      }
    }
  };
  append(jacobian.inputs, 0);
  Eigen::Index first = sizes.inputs.size();
  for (std::size_t k = 0; k < sizes.poses.size(); ++k) {
    if (k < jacobian.poses.size()) append(jacobian.poses[k].loads, first);
    first += sizes.poses[k].loads.size() + sizes.poses[k].moves.size();
  }
  SparseMatrix rows(row.values.size(), space.size());
  rows.setFromTriplets(entries.begin(), entries.end());
  return rows;
}

/// The parameters that bounds allow, and whether that makes a difference beyond rounding.
struct Bounded {
  VecX p;
  bool cut = false;
};

Bounded within_bounds(std::span<const Parameter> parameters, VecX p) {
  Bounded bounded{std::move(p), false};
  for (Eigen::Index i = 0; i < bounded.p.size(); ++i) {
    const Parameter& parameter = parameters[static_cast<std::size_t>(i)];
    const double inside = std::clamp(bounded.p[i], parameter.lower, parameter.upper);
    bounded.cut = bounded.cut || std::abs(inside - bounded.p[i]) > kRounding * (parameter.upper - parameter.lower);
    bounded.p[i] = inside;
  }
  return bounded;
}

}  // namespace

Result<VecX> parameters_of(const DesignSpace& space, const Design& design) {
  const Row wanted = row_of(design);
  VecX p = space.start();
  double last = -1;
  for (int i = 0;; ++i) {
    const Result<Design> made = space.at(p);
    if (!made) return made.error();
    const Row row = row_of(made.value());
    if (row.values.size() != wanted.values.size()) {
      return Error{ErrorCode::kConflict, "", "the designs have other nodes, joints, triangles or loads",
                   "stages have to work on one structure"};
    }
    const VecX missing = (wanted.values - row.values).cwiseQuotient(wanted.felt);
    const double most = missing.cwiseAbs().maxCoeff();
    // Rounding is as near as one gets, and stops getting nearer.
    if (most <= kAgreement && (i == kMostSteps || (last >= 0 && most > 0.5 * last) || most == 0)) return p;
    last = most;
    const SparseMatrix rows = rows_by_parameters(space, made.value(), p, wanted);
    const VecX step = least_squares(rows, missing, VecX::Zero(p.size()));
    Eigen::Index worst = 0;
    const double left = (missing - rows * step).cwiseAbs().maxCoeff(&worst);
    if (i == kMostSteps) {
      return Error{
          ErrorCode::kConflict, "",
          fmt::format("the parameters cannot make the design: a number of it is {:.6g}, the nearest is {:.6g}",
                      wanted.values[worst], wanted.values[worst] - wanted.felt[worst] * (missing - rows * step)[worst]),
          "let a later stage change at least what the ones before it did"};
    }
    for (Eigen::Index j = 0; j < p.size(); ++j) p[j] += step[j] * space.parameters()[static_cast<std::size_t>(j)].scale;
    Bounded bounded = within_bounds(space.parameters(), std::move(p));
    if (bounded.cut && left <= kAgreement) return std::move(bounded.p);
    p = std::move(bounded.p);
  }
}

}  // namespace lissom
