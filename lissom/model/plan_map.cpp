#include "lissom/model/plan_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lissom/core/linear_solver.h"
#include "lissom/geometry/hermite_curve.h"
#include "lissom/geometry/planar_arc.h"
#include "lissom/geometry/planar_smoothing.h"

namespace lissom {

namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

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

/// Cotangent Laplacian of the mesh, (V x V) [mathematics 6.2].
SparseMatrix laplacian(const MembraneMesh& mesh) {
  Triplets entries;
  entries.reserve(mesh.triangles.size() * 12);
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int i = t[(k + 1) % 3], j = t[(k + 2) % 3];
      const Vec3 u = mesh.points[static_cast<std::size_t>(i)] - mesh.points[static_cast<std::size_t>(t[k])];
      const Vec3 v = mesh.points[static_cast<std::size_t>(j)] - mesh.points[static_cast<std::size_t>(t[k])];
      const double w = 0.5 * u.dot(v) / u.cross(v).norm();
      entries.emplace_back(i, i, w);
      entries.emplace_back(j, j, w);
      entries.emplace_back(i, j, -w);
      entries.emplace_back(j, i, -w);
    }
  }
  const auto n = static_cast<Eigen::Index>(mesh.points.size());
  SparseMatrix matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

}  // namespace

struct PlanMap::Impl {
  int points = 0, nodes = 0, vertices = 0;
  SparseMatrix node_weights;    ///< (N x C), rows of arc nodes are empty
  SparseMatrix radius_weights;  ///< (N x C)
  std::vector<ArcNode> arcs;
  std::vector<PieceEnds> pieces;
  SparseMatrix coupling;                ///< (V - N x N), -L_c
  std::unique_ptr<LinearSolver> inner;  ///< factor of L_b; absent when no vertex is inside
  MatX inner_weights;                   ///< (V - N x C), only without arcs
  std::vector<std::array<int, 3>> triangles;
  std::vector<double> angles;  ///< rad, smallest of each triangle as expanded

  /// Harmonic: the inner rows that go with these rows of nodes.
  MatX extended(const MatX& node_rows) const {
    MatX rows = coupling * node_rows;
    if (inner) inner->solve_many(rows, rows);
    return rows;
  }

  Status set_laplacian(const MembraneMesh& mesh);
  void set_weights(const Plan& plan, const PlanSamples& samples);
  MatX arc_rows(const MatX& controls) const;  ///< (2N x 2C) of the arc nodes
};

Status PlanMap::Impl::set_laplacian(const MembraneMesh& mesh) {
  const SparseMatrix whole = laplacian(mesh);
  const Eigen::Index n = nodes, m = vertices - nodes;
  coupling = -whole.block(n, 0, m, n);
  if (m == 0) return {};
  const SparseMatrix inside = whole.block(n, n, m, m);
  std::vector<int> indices, offsets{0}, kept(static_cast<std::size_t>(m));
  for (int j = 0; j < inside.outerSize(); ++j) {
    kept[static_cast<std::size_t>(j)] = j;
    for (SparseMatrix::InnerIterator entry(inside, j); entry; ++entry) {
      if (entry.row() < j) continue;
      indices.push_back(static_cast<int>(entry.row()));
      if (entry.row() != j) indices.push_back(j);
      offsets.push_back(static_cast<int>(indices.size()));
    }
  }
  const SparsePattern pattern(static_cast<int>(m), indices, offsets);
  std::vector<double> values(static_cast<std::size_t>(pattern.nonzeros()), 0);
  for (int j = 0; j < inside.outerSize(); ++j) {
    for (SparseMatrix::InnerIterator entry(inside, j); entry; ++entry) {
      if (entry.row() < j) continue;
      values[static_cast<std::size_t>(pattern.slot(static_cast<int>(entry.row()), j))] = entry.value();
    }
  }
  inner = std::make_unique<LinearSolver>(pattern, kept);
  if (inner->factorize(values).positive_definite) return {};
  return Error{ErrorCode::kGeometry, "/plan/fabric", "the triangles of the fabric are too thin to move with the points",
               "use a shorter edge length of the fabric"};
}

void PlanMap::Impl::set_weights(const Plan& plan, const PlanSamples& samples) {
  Triplets places, radii;
  for (int i = 0; i < points; ++i) {
    places.emplace_back(i, i, 1);
    radii.emplace_back(i, i, 1);
  }
  std::vector<HermiteCurve<PointWeights>> curves;
  for (const PlanRod& rod : plan.rods) {
    std::vector<PointWeights> controls;
    for (const int i : rod.points) controls.emplace_back(i);
    curves.emplace_back(controls, rod.closed);
  }
  const auto add = [](Triplets& list, int node, const PointWeights& weights) {
    for (int k = 0; k < weights.count; ++k) {
      const std::size_t i = static_cast<std::size_t>(k);
      list.emplace_back(node, weights.point[i], weights.weight[i]);
    }
  };
  samples.each_inner(plan.points.size(), [&](std::size_t r, int piece, int step, int steps, std::size_t number) {
    const PlanRod& rod = plan.rods[r];
    const int node = static_cast<int>(number);
    const double s = double(step) / steps;
    const std::size_t k = static_cast<std::size_t>(piece);
    const int start = rod.points[k], end = rod.points[(k + 1) % rod.points.size()];
    const PointWeights weights = curves[r].point(piece, s);
    add(radii, node, weights);
    pieces.push_back({node, start, end});
    if (rod.curve == PlanCurve::kSpline) add(places, node, weights);
    if (rod.curve == PlanCurve::kStraight) add(places, node, (1 - s) * PointWeights(start) + s * PointWeights(end));
    if (rod.curve == PlanCurve::kArc) {
      const ArcPiece arc = arc_piece(rod, piece);
      arcs.push_back({node, {rod.points[arc.from], rod.points[arc.to], rod.points[arc.other]}, s});
    }
  });
  node_weights.resize(nodes, points);
  node_weights.setFromTriplets(places.begin(), places.end());
  radius_weights.resize(nodes, points);
  radius_weights.setFromTriplets(radii.begin(), radii.end());
}

PlanMap::PlanMap(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
PlanMap::~PlanMap() = default;
PlanMap::PlanMap(PlanMap&&) noexcept = default;
PlanMap& PlanMap::operator=(PlanMap&&) noexcept = default;

int PlanMap::points() const { return impl_->points; }
int PlanMap::nodes() const { return impl_->nodes; }
int PlanMap::vertices() const { return impl_->vertices; }
bool PlanMap::linear() const { return impl_->arcs.empty(); }

Result<PlanMap> PlanMap::make(const Plan& plan, const ExpandedPlan& expanded) {
  auto impl = std::make_unique<Impl>();
  const MembraneMesh& mesh = expanded.mesh();
  impl->points = static_cast<int>(plan.points.size());
  impl->nodes = static_cast<int>(expanded.samples.nodes.size());
  impl->vertices = static_cast<int>(mesh.points.size());
  impl->triangles = mesh.triangles;
  for (const auto& [a, b, c] : mesh.triangles) {
    const auto at = [&](int i) -> Vec2 { return mesh.points[static_cast<std::size_t>(i)].head<2>(); };
    impl->angles.push_back(smallest_angle(at(a), at(b), at(c)));
  }
  impl->set_weights(plan, expanded.samples);
  if (Status s = impl->set_laplacian(mesh); !s) return s.error();
  if (impl->arcs.empty()) impl->inner_weights = impl->extended(MatX(impl->node_weights));
  return PlanMap(std::move(impl));
}

MatX PlanMap::positions(const MatX& controls) const {
  LISSOM_ASSERT(controls.rows() == points() && controls.cols() == 2);
  MatX all(vertices(), 2);
  MatX on_rods = impl_->node_weights * controls;
  for (const ArcNode& arc : impl_->arcs) {
    const auto at = [&](std::size_t k) {
      return PlanarPoint<double>(controls(arc.points[k], 0), controls(arc.points[k], 1));
    };
    const auto [x, y] = arc_point(at(0), at(1), at(2), arc.place);
    on_rods.row(arc.node) << x, y;
  }
  all.topRows(nodes()) = on_rods;
  all.bottomRows(vertices() - nodes()) = linear() ? MatX(impl_->inner_weights * controls) : impl_->extended(on_rods);
  return all;
}

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

VecX PlanMap::radii(const VecX& controls) const {
  LISSOM_ASSERT(controls.size() == points());
  VecX radii = impl_->radius_weights * controls;
  for (const PieceEnds& piece : impl_->pieces) {
    radii[piece.node] = std::max(radii[piece.node], least_radius(controls[piece.start], controls[piece.end]));
  }
  return radii;
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

MeshQuality PlanMap::quality(const MatX& positions) const {
  MeshQuality quality{std::numbers::pi, std::numeric_limits<double>::infinity(), -1};
  for (std::size_t t = 0; t < impl_->triangles.size(); ++t) {
    const auto at = [&](std::size_t k) -> Vec2 { return positions.row(impl_->triangles[t][k]).transpose(); };
    const double angle = smallest_angle(at(0), at(1), at(2));
    quality.smallest_angle = std::min(quality.smallest_angle, angle);
    if (angle / impl_->angles[t] >= quality.ratio) continue;
    quality.ratio = angle / impl_->angles[t];
    quality.triangle = static_cast<int>(t);
  }
  return quality;
}

}  // namespace lissom
