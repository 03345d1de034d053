#include <vector>

#include "lissom/core/dual.h"
#include "lissom/geometry/planar_arc.h"
#include "lissom/model/plan_map_parts.h"

namespace lissom {

namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

}  // namespace

MatX PlanMap::Impl::arc_rows(const MatX& controls) const {
  using Dual = Dual1<6>;
  MatX rows = MatX::Zero(2 * nodes, 2 * points);
  for (const ArcNode& arc : arcs) {
    const auto at = [&](int k) {
      const int i = arc.points[static_cast<std::size_t>(k)];
      return PlanarPoint<Dual>(Dual::variable(controls(i, 0), 2 * k), Dual::variable(controls(i, 1), 2 * k + 1));
    };
    const auto [x, y] = arc_point(at(0), at(1), at(2), arc.place);
    for (int k = 0; k < 6; ++k) {
      const int column = 2 * arc.points[static_cast<std::size_t>(k / 2)] + k % 2;
      rows(2 * arc.node, column) += x.g[static_cast<std::size_t>(k)];
      rows(2 * arc.node + 1, column) += y.g[static_cast<std::size_t>(k)];
    }
  }
  return rows;
}

SparseMatrix PlanMap::position_jacobian(const MatX& controls) const {
  const int n = nodes(), inner = vertices() - n;
  Triplets entries;
  const auto add = [&](int row, int column, double value) {
    if (value != 0) entries.emplace_back(row, column, value);
  };
  for (int j = 0; j < impl_->node_weights.outerSize(); ++j) {
    for (SparseMatrix::InnerIterator entry(impl_->node_weights, j); entry; ++entry) {
      for (int d = 0; d < 2; ++d) add(2 * static_cast<int>(entry.row()) + d, 2 * j + d, entry.value());
    }
  }
  if (linear()) {
    for (int j = 0; j < points(); ++j) {
      for (int i = 0; i < inner; ++i) {
        for (int d = 0; d < 2; ++d) add(2 * (n + i) + d, 2 * j + d, impl_->inner_weights(i, j));
      }
    }
  } else {
    const MatX arcs = impl_->arc_rows(controls);
    for (int column = 0; column < 2 * points(); ++column) {
      for (int row = 0; row < 2 * n; ++row) add(row, column, arcs(row, column));
    }
    // Harmonic extension of x and of y, each with respect to every control coordinate.
    for (int d = 0; d < 2; ++d) {
      MatX rows = MatX::Zero(n, 2 * points());
      for (int row = 0; row < n; ++row) rows.row(row) = arcs.row(2 * row + d);
      for (int j = 0; j < points(); ++j) rows.col(2 * j + d) += impl_->node_weights.col(j);
      const MatX inside = impl_->extended(rows);
      for (int column = 0; column < 2 * points(); ++column) {
        for (int i = 0; i < inner; ++i) add(2 * (n + i) + d, column, inside(i, column));
      }
    }
  }
  SparseMatrix jacobian(2 * vertices(), 2 * points());
  jacobian.setFromTriplets(entries.begin(), entries.end());
  return jacobian;
}

MatX PlanMap::position_curvature(const MatX& controls, const MatX& y, const MatX& v) const {
  LISSOM_ASSERT(y.rows() == vertices() && v.rows() == points());
  MatX result = MatX::Zero(points(), 2);
  if (linear()) return result;
  // What inner vertices ask of the nodes that they follow.
  MatX inside = y.bottomRows(vertices() - nodes());
  impl_->solve_inside(inside);
  const MatX weights = y.topRows(nodes()) + impl_->coupling.transpose() * inside;
  using Dual = Dual2<6>;
  for (const ArcNode& arc : impl_->arcs) {
    const auto at = [&](int k) {
      const int i = arc.points[static_cast<std::size_t>(k)];
      return PlanarPoint<Dual>(Dual::variable(controls(i, 0), 2 * k), Dual::variable(controls(i, 1), 2 * k + 1));
    };
    const auto [x0, x1] = arc_point(at(0), at(1), at(2), arc.place);
    const Dual sum = x0 * Dual(weights(arc.node, 0)) + x1 * Dual(weights(arc.node, 1));
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) {
        result(arc.points[static_cast<std::size_t>(i / 2)], i % 2) +=
            sum.hessian(i, j) * v(arc.points[static_cast<std::size_t>(j / 2)], j % 2);
      }
    }
  }
  return result;
}

SparseMatrix PlanMap::radius_jacobian(const VecX& controls) const {
  const VecX free = impl_->radius_weights * controls;
  std::vector<int> held(static_cast<std::size_t>(nodes()), -1);  // the point that the least radius hangs on
  for (const PieceEnds& piece : impl_->pieces) {
    if (free[piece.node] >= least_radius(controls[piece.start], controls[piece.end])) continue;
    held[static_cast<std::size_t>(piece.node)] = controls[piece.start] <= controls[piece.end] ? piece.start : piece.end;
  }
  Triplets entries;
  for (int j = 0; j < impl_->radius_weights.outerSize(); ++j) {
    for (SparseMatrix::InnerIterator entry(impl_->radius_weights, j); entry; ++entry) {
      if (held[static_cast<std::size_t>(entry.row())] < 0) entries.emplace_back(entry.row(), j, entry.value());
    }
  }
  for (int i = 0; i < nodes(); ++i) {
    const int j = held[static_cast<std::size_t>(i)];
    if (j >= 0) entries.emplace_back(i, j, least_radius(1, 1));
  }
  SparseMatrix jacobian(nodes(), points());
  jacobian.setFromTriplets(entries.begin(), entries.end());
  return jacobian;
}

}  // namespace lissom
