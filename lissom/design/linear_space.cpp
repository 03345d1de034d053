#include "lissom/design/linear_space.h"

#include <Eigen/IterativeLinearSolvers>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "lissom/core/assert.h"
#include "lissom/design/redrawn.h"
#include "lissom/mechanics/supports.h"

namespace lissom {

namespace {

std::vector<int> rows_in_use(const SparseMatrix& matrix) {
  std::vector<bool> used(static_cast<std::size_t>(matrix.rows()), false);
  for (int c = 0; c < matrix.outerSize(); ++c) {
    for (SparseMatrix::InnerIterator it(matrix, c); it; ++it) {
      if (it.value() != 0) used[static_cast<std::size_t>(it.row())] = true;
    }
  }
  std::vector<int> rows;
  for (int i = 0; i < static_cast<int>(used.size()); ++i) {
    if (used[static_cast<std::size_t>(i)]) rows.push_back(i);
  }
  return rows;
}

Status check_parameter(const Parameter& parameter, double start) {
  const auto fail = [&](const char* what, const char* hint) {
    return Error{ErrorCode::kRange, "/parameters",
                 fmt::format("{}: {} (from {:g} to {:g} around {:g})", parameter.name, what, parameter.lower,
                             parameter.upper, start),
                 hint};
  };
  if (!(parameter.lower < parameter.upper)) return fail("the range is empty", "give a lower and a larger upper bound");
  if (!(parameter.scale > 0) || !std::isfinite(parameter.scale)) {
    return fail("its scale is not a positive number", "give finite bounds or a scale");
  }
  if (!(start >= parameter.lower && start <= parameter.upper)) {
    return fail("the present value is outside of the range", "widen the range");
  }
  return {};
}

}  // namespace

Result<LinearSpace> LinearSpace::make(std::shared_ptr<const Design> base, std::vector<Parameter> parameters, VecX start,
                                      LinearRows rows, Offset offset) {
  LISSOM_ASSERT(start.size() == static_cast<Eigen::Index>(parameters.size()));
  for (int i = 0; i < start.size(); ++i) {
    if (Status s = check_parameter(parameters[static_cast<std::size_t>(i)], start[i]); !s) return s.error();
  }
  LinearSpace out;
  out.base_ = std::move(base);
  out.parameters_ = std::move(parameters);
  out.start_ = std::move(start);
  out.rows_ = std::move(rows);
  out.origin_ = offset == Offset::kBase ? out.start_ : VecX(VecX::Zero(out.start_.size()));
  const DesignValues values = values_of(*out.base_);
  out.inputs_ = Claimed(out.rows_.inputs, values.inputs, offset);
  const int places = 3 * static_cast<int>(out.base_->system.structure.nodes.size());
  out.claims_places_ = !out.inputs_.rows.empty() && out.inputs_.rows.front() < places;
  LISSOM_ASSERT(out.rows_.poses.empty() || out.rows_.poses.size() == values.poses.size());
  for (std::size_t k = 0; k < out.rows_.poses.size(); ++k) {
    out.loads_.emplace_back(out.rows_.poses[k].loads, values.poses[k].loads, offset);
    out.moves_.emplace_back(out.rows_.poses[k].moves, values.poses[k].moves, offset);
  }
  return out;
}

LinearSpace::Claimed::Claimed(const SparseMatrix& z, const VecX& present, Offset choice) {
  LISSOM_ASSERT(z.cols() == 0 || z.rows() == present.size());
  rows = rows_in_use(z);
  offset = VecX::Zero(static_cast<Eigen::Index>(rows.size()));
  for (std::size_t k = 0; k < rows.size() && choice == Offset::kBase; ++k) {
    offset[static_cast<Eigen::Index>(k)] = present[rows[k]];
  }
}

void LinearSpace::Claimed::set(const SparseMatrix& z, const VecX& step, VecX& values) const {
  if (rows.empty()) return;
  const VecX change = z * step;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    values[rows[k]] = offset[static_cast<Eigen::Index>(k)] + change[rows[k]];
  }
}

Result<Design> LinearSpace::at(const VecX& p) const { return applied(*base_, p); }

Result<Design> LinearSpace::applied(Design design, const VecX& p) const {
  if (Status s = check_bounds(parameters_, p); !s) return s.error();
  DesignValues values = values_of(design);
  if (claims_places_ && !has_own_normals(design.system.structure)) {
    // Also where nothing has moved yet: derivatives there are of a drawing whose normals stay.
    const Eigen::Index places = 3 * static_cast<Eigen::Index>(design.system.structure.nodes.size());
    if (Status s = redraw(design.model, design.system.structure, values.inputs.head(places)); !s) return s.error();
    Result<System> system = make_system(design.model, std::move(design.system.structure));
    if (!system) return system.error();
    design.system = std::move(system).value();
  }
  const VecX step = p - origin_;
  inputs_.set(rows_.inputs, step, values.inputs);
  for (std::size_t k = 0; k < rows_.poses.size(); ++k) {
    loads_[k].set(rows_.poses[k].loads, step, values.poses[k].loads);
    moves_[k].set(rows_.poses[k].moves, step, values.poses[k].moves);
  }
  return with_values(std::move(design), values);
}

DesignJacobian LinearSpace::jacobian(const Design& design, const VecX& p) const {
  (void)p;
  DesignJacobian jacobian{rows_.inputs, {}, {}};
  for (std::size_t k = 0; k < rows_.poses.size(); ++k) {
    PoseJacobian own{rows_.poses[k].loads, {}};
    if (rows_.poses[k].moves.cols() > 0) {
      const Result<Supports> supports = Supports::make(design.model, design.system, design.model.poses[k],
                                                       fmt::format("/poses/{}", k), NullMotions::kKeep);
      LISSOM_ASSERT(supports);  // those of the base were made, and all designs select the same nodes
      own.held = supports.value().held_by_moves(design.system) * rows_.poses[k].moves;
    }
    jacobian.poses.push_back(std::move(own));
  }
  return jacobian;
}

VecX least_squares(const SparseMatrix& z, const VecX& y, const VecX& guess) {
  if (z.cols() == 0) return guess;
  Eigen::LeastSquaresConjugateGradient<SparseMatrix> solver(z);
  solver.setTolerance(1e-15);
  solver.setMaxIterations(10 * z.cols() + 100);
  // The correction is what is solved for, so that a guess that fits is kept to the last bit.
  return guess + solver.solve(y - z * guess);
}

}  // namespace lissom
