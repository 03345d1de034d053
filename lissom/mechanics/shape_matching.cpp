#include "lissom/mechanics/shape_matching.h"

#include <Eigen/SVD>

namespace lissom {

Mat3 cross_covariance(const System& system, int joint, const std::vector<EdgeState>& edges) {
  Mat3 n = Mat3::Zero();
  for (int k = system.first_connection[joint]; k < system.first_connection[joint + 1]; ++k) {
    const Connection& c = system.connections[k];
    const EdgeState& edge = edges[c.edge];
    n += c.weight.t * edge.t * c.rest.t.transpose() + c.weight.n * edge.t.cross(edge.b) * c.rest.n.transpose() +
         c.weight.b * edge.b * c.rest.b.transpose();
  }
  return n;
}

bool is_degenerate(const Mat3& covariance) {
  const Eigen::JacobiSVD<Mat3> svd(covariance, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Vec3& s = svd.singularValues();
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  return s[1] + sign * s[2] <= 1e-6 * s.sum();
}

Mat3 matched_rotation(const System& system, int joint, const std::vector<EdgeState>& edges, const Mat3& previous) {
  Mat3 n = cross_covariance(system, joint, edges);
  if (is_degenerate(n)) {
    const double size = Eigen::JacobiSVD<Mat3>(n).singularValues().sum();
    n += 1e-3 * size * previous;
  }
  return nearest_rotation(n);
}

}  // namespace lissom
