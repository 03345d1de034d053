#pragma once
/// What is asked of an equilibrium: quantities c(q, rest numbers) of one pose, with their derivatives. A goal makes a residual
/// of them: c wanted at a value, above or below it, with a weight and a scale (goal.h).

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "lissom/core/types.h"
#include "lissom/design/design.h"
#include "lissom/equilibrium/static_problem.h"

namespace lissom {

/// An equilibrium as objectives see it. Nothing is owned.
struct PoseShape {
  const Design& design;
  const Pose& pose;
  const StaticProblem& problem;
  const State& state;
};

using SparseRows = Eigen::SparseMatrix<double, Eigen::RowMajor>;

class Objective {
 public:
  virtual ~Objective() = default;

  /// "node positions", as in documents and reports.
  virtual std::string_view name() const = 0;
  /// SI unit of the components: "m", "N", "rad", "".
  virtual std::string_view unit() const = 0;
  virtual int size() const = 0;
  /// A deviation of a component that is felt, in its unit: 1 % of the size of the structure for lengths, and so on. Deviations
  /// over it compare between objectives and between structures of any size.
  virtual double scale(const PoseShape& shape) const = 0;

  /// The components, (size), SI.
  virtual void values(const PoseShape& shape, VecX& c) const = 0;

  /// d c / d q over all unknowns in global axes (rotation-vector increments for joint rotations) at fixed rest numbers,
  /// (size x unknowns), and d c / d rest numbers at fixed q, (size x RestNumbers::size).
  virtual void jacobian(const PoseShape& shape, SparseRows& by_q, SparseRows& by_numbers) const = 0;

  /// Whether `curvature` is known. Where it is not, methods that need exact second derivatives have to refuse the objective.
  virtual bool has_curvature() const { return true; }

  /// Second-order product: the change of (d c/d q)' y and (d c/d numbers)' y along q + e dq, numbers + e dn, as of the
  /// function anchored at the state. Adds to `by_q` (unknowns) and `by_numbers` (RestNumbers::size).
  virtual void curvature(const PoseShape& shape, const VecX& y, const VecX& dq, const VecX& dn, VecX& by_q,
                         VecX& by_numbers) const = 0;
};

}  // namespace lissom
