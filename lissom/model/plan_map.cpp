#include "lissom/model/plan_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "lissom/geometry/hermite_curve.h"
#include "lissom/geometry/planar_arc.h"
#include "lissom/geometry/planar_smoothing.h"
#include "lissom/model/plan_map_parts.h"

namespace lissom {

namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

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

VecX PlanMap::radii(const VecX& controls) const {
  LISSOM_ASSERT(controls.size() == points());
  VecX radii = impl_->radius_weights * controls;
  for (const PieceEnds& piece : impl_->pieces) {
    radii[piece.node] = std::max(radii[piece.node], least_radius(controls[piece.start], controls[piece.end]));
  }
  return radii;
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
