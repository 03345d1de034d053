#pragma once
/// What plan_map.cpp and plan_map_derivatives.cpp share; nobody else includes this.

#include <array>
#include <memory>
#include <mutex>
#include <vector>

#include "lissom/core/linear_solver.h"
#include "lissom/model/plan_map.h"

namespace lissom {

/// A node on an arc: it hangs on three points of the plan, not linearly.
struct ArcNode {
  int node = 0;
  std::array<int, 3> points{};  ///< from, to, other
  double place = 0;
};

/// A node between two points of a rod, for radii.
struct PieceEnds {
  int node = 0, start = 0, end = 0;
};

struct PlanMap::Impl {
  int points = 0, nodes = 0, vertices = 0;
  SparseMatrix node_weights;    ///< (N x C), rows of arc nodes are empty
  SparseMatrix radius_weights;  ///< (N x C)
  std::vector<ArcNode> arcs;
  std::vector<PieceEnds> pieces;
  SparseMatrix coupling;                ///< (V - N x N), -L_c
  std::unique_ptr<LinearSolver> inner;  ///< factor of L_b; absent when no vertex is inside
  mutable std::mutex inner_in_use;      ///< solvers share work space between their const members
  MatX inner_weights;                   ///< (V - N x C), only without arcs
  std::vector<std::array<int, 3>> triangles;
  std::vector<double> angles;  ///< rad, smallest of each triangle as expanded

  /// Harmonic: the inner rows that go with these rows of nodes.
  MatX extended(const MatX& node_rows) const {
    MatX rows = coupling * node_rows;
    solve_inside(rows);
    return rows;
  }
  /// L_b^-1, in place.
  void solve_inside(MatX& rows) const {
    const std::scoped_lock lock(inner_in_use);
    if (inner) inner->solve_many(rows, rows);
  }

  Status set_laplacian(const MembraneMesh& mesh);
  void set_weights(const Plan& plan, const PlanSamples& samples);
  MatX arc_rows(const MatX& controls) const;  ///< (2N x 2C) of the arc nodes
};

}  // namespace lissom
