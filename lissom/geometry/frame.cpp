#include "lissom/geometry/frame.h"

#include <Eigen/SVD>
#include <cmath>
#include <numbers>

namespace lissom {

Frame rotated(const Mat3& rotation, const Frame& frame) {
  return {rotation * frame.t, rotation * frame.b, rotation * frame.n};
}

Frame frame_from_normal(const Vec3& tangent, const Vec3& normal) {
  const Vec3 t = tangent.normalized();
  Vec3 n = normal - t * t.dot(normal);
  if (n.norm() <= 1e-8 * normal.norm() || normal.norm() == 0) {
    int smallest = 0;
    t.cwiseAbs().minCoeff(&smallest);
    const Vec3 axis = Vec3::Unit(smallest);
    n = axis - t * t.dot(axis);
  }
  n.normalize();
  return {t, n.cross(t), n};
}

Vec3 parallel_transport(const Vec3& a, const Vec3& b, const Vec3& x) {
  const double c = a.dot(b);
  if (1 + c < 1e-10) {
    int smallest = 0;
    a.cwiseAbs().minCoeff(&smallest);
    const Vec3 axis = Vec3::Unit(smallest);
    const Vec3 u = (axis - a * a.dot(axis)).normalized();
    const Vec3 half_turn = 2 * u * u.dot(x) - x;
    return parallel_transport(-a, b, half_turn);
  }
  const Vec3 s = a.cross(b);
  return c * x + s.cross(x) + s * (s.dot(x) / (1 + c));
}

double signed_angle(const Vec3& axis, const Vec3& u, const Vec3& v) {
  return std::atan2(axis.dot(u.cross(v)), u.dot(v));
}

double wrap_angle(double x) {
  constexpr double kPi = std::numbers::pi;
  const double y = x - 2 * kPi * std::floor((x + kPi) / (2 * kPi));
  return y <= -kPi ? y + 2 * kPi : y;
}

Mat3 skew(const Vec3& a) {
  Mat3 m;
  m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return m;
}

Mat3 rotation_from_vector(const Vec3& r) {
  const double angle2 = r.squaredNorm();
  const Mat3 w = skew(r);
  double a = 1 - angle2 / 6, b = 0.5 - angle2 / 24;
  if (angle2 > 1e-8) {
    const double angle = std::sqrt(angle2);
    a = std::sin(angle) / angle;
    b = (1 - std::cos(angle)) / angle2;
  }
  return Mat3::Identity() + a * w + b * w * w;
}

Vec3 vector_from_rotation(const Mat3& rotation) {
  const Eigen::AngleAxisd turn(rotation);
  return turn.angle() * turn.axis();
}

Mat3 left_jacobian(const Vec3& r) {
  const double angle2 = r.squaredNorm();
  const Mat3 w = skew(r);
  double a = 0.5 - angle2 / 24, b = 1.0 / 6 - angle2 / 120;
  if (angle2 > 1e-6) {
    const double angle = std::sqrt(angle2);
    a = (1 - std::cos(angle)) / angle2;
    b = (angle - std::sin(angle)) / (angle2 * angle);
  }
  return Mat3::Identity() + a * w + b * w * w;
}

Mat3 nearest_rotation(const Mat3& matrix) {
  const Eigen::JacobiSVD<Mat3> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  return svd.matrixU() * Vec3(1, 1, sign).asDiagonal() * svd.matrixV().transpose();
}

}  // namespace lissom
