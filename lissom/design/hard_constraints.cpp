#include "lissom/design/hard_constraints.h"

#include <Eigen/Dense>

namespace lissom {

namespace {

constexpr double kNoSingularValue = 1e-8;  // of the largest

/// A set of places with the plane through them: normal, and the coordinates that moving planes are linear in.
struct FittedPlane {
  Vec3 middle = Vec3::Zero(), normal = Vec3::UnitZ();
  MatX moves;  ///< (places x 3): 1, u, v; what planes that shift and turn do to distances
};

FittedPlane plane_through(const std::vector<int>& nodes, const VecX& places) {
  FittedPlane plane;
  for (const int node : nodes) plane.middle += places.segment<3>(3 * node) / static_cast<double>(nodes.size());
  Mat3 spread = Mat3::Zero();
  for (const int node : nodes) {
    const Vec3 arm = places.segment<3>(3 * node) - plane.middle;
    spread += arm * arm.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Mat3> axes(spread);
  plane.normal = axes.eigenvectors().col(0);
  plane.moves.resize(static_cast<Eigen::Index>(nodes.size()), 3);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Vec3 arm = places.segment<3>(3 * nodes[i]) - plane.middle;
    plane.moves.row(static_cast<Eigen::Index>(i)) << 1, axes.eigenvectors().col(1).dot(arm),
        axes.eigenvectors().col(2).dot(arm);
  }
  return plane;
}

}  // namespace

int HardConstraints::size() const {
  std::size_t rows = 3 * (pinned.size() + attached.size());
  for (const std::vector<int>& set : in_plane) rows += set.size();
  return static_cast<int>(rows);
}

VecX violations(const HardConstraints& constraints, const VecX& reference, const VecX& places) {
  VecX values(constraints.size());
  Eigen::Index row = 0;
  const auto moved = [&](int node) -> Vec3 { return places.segment<3>(3 * node) - reference.segment<3>(3 * node); };
  for (const int node : constraints.pinned) {
    values.segment<3>(row) = moved(node);
    row += 3;
  }
  for (const auto& [a, b] : constraints.attached) {
    values.segment<3>(row) = moved(a) - moved(b);
    row += 3;
  }
  for (const std::vector<int>& set : constraints.in_plane) {
    const FittedPlane plane = plane_through(set, places);
    for (const int node : set) values[row++] = plane.normal.dot(places.segment<3>(3 * node) - plane.middle);
  }
  return values;
}

SparseRows constraint_jacobian(const HardConstraints& constraints, const VecX& places, int unknowns) {
  std::vector<Eigen::Triplet<double>> entries;
  int row = 0;
  for (const int node : constraints.pinned) {
    for (int k = 0; k < 3; ++k) entries.emplace_back(row++, 3 * node + k, 1.0);
  }
  for (const auto& [a, b] : constraints.attached) {
    for (int k = 0; k < 3; ++k, ++row) {
      entries.emplace_back(row, 3 * a + k, 1.0);
      entries.emplace_back(row, 3 * b + k, -1.0);
    }
  }
  for (const std::vector<int>& set : constraints.in_plane) {
    const FittedPlane plane = plane_through(set, places);
    const auto count = static_cast<Eigen::Index>(set.size());
    // Distances along the normal less those that a moved plane makes up for.
    const MatX pseudo = plane.moves.completeOrthogonalDecomposition().pseudoInverse();
    const MatX kept = MatX::Identity(count, count) - plane.moves * pseudo;
    for (Eigen::Index i = 0; i < count; ++i, ++row) {
      for (Eigen::Index j = 0; j < count; ++j) {
        for (int k = 0; k < 3; ++k) {
          entries.emplace_back(row, 3 * set[static_cast<std::size_t>(j)] + k, kept(i, j) * plane.normal[k]);
        }
      }
    }
  }
  SparseRows jacobian(constraints.size(), unknowns);
  jacobian.setFromTriplets(entries.begin(), entries.end());
  return jacobian;
}

MatX constraint_response(const HardConstraints& constraints, const VecX& places, const MatX& response) {
  const int rows = constraints.size();
  MatX k(rows + constraints.ties.rows(), response.cols());
  k.topRows(rows) = constraint_jacobian(constraints, places, static_cast<int>(response.rows())) * response;
  if (constraints.ties.rows() > 0) k.bottomRows(constraints.ties.rows()) = constraints.ties;
  return k;
}

ConstraintProjection::ConstraintProjection(const MatX& k) {
  if (k.rows() == 0) return;
  // Lengths and plain numbers meet here: each row counts by itself.
  const VecX norms = k.rowwise().norm();
  const VecX weights = (norms.array() > kNoSingularValue * norms.maxCoeff()).select(norms.cwiseInverse(), 1);
  const Eigen::BDCSVD<MatX> svd(weights.asDiagonal() * k, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const VecX& values = svd.singularValues();
  Eigen::Index rank = 0;
  while (rank < values.size() && values[rank] > kNoSingularValue * values[0] && values[rank] > 0) ++rank;
  range_ = svd.matrixV().leftCols(rank);
  to_range_ =
      values.head(rank).cwiseInverse().asDiagonal() * svd.matrixU().leftCols(rank).transpose() * weights.asDiagonal();
}

void ConstraintProjection::apply(MatX& x) const {
  if (range_.cols() > 0) x -= range_ * (range_.transpose() * x);
}

VecX ConstraintProjection::of(const VecX& v) const {
  if (range_.cols() == 0) return v;
  return v - range_ * (range_.transpose() * v);
}

VecX ConstraintProjection::least_change(const VecX& values) const { return range_ * (to_range_ * values); }

}  // namespace lissom
