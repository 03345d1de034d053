#include "lissom/mechanics/frame_pair.h"

#include "lissom/geometry/frame.h"

namespace lissom {

namespace {

/// Curvature kappa = (kappa b) . a with a = (a1 + a2) / 2: gradient by (w1, w2), and Hessian unless null.
double curvature_derivatives(const Vec3& t1, const Vec3& t2, const Vec3& a1, const Vec3& a2, Vec6& gradient,
                             Mat6* hessian) {
  const double c = t1.dot(t2), chi = 1 + c;
  const Vec3 s = t1.cross(t2), kb = 2 * s / chi, a = 0.5 * (a1 + a2);
  const double kappa = kb.dot(a), p1 = t1.dot(a), p2 = t2.dot(a);
  const Vec3 u1 = p1 * t2 - c * a, u2 = c * a - p2 * t1;
  const Vec3 g1 = (2 / chi) * u1 - 0.5 * kappa * kb + 0.5 * a1.cross(kb);
  const Vec3 g2 = (2 / chi) * u2 + 0.5 * kappa * kb + 0.5 * a2.cross(kb);
  gradient << g1, g2;
  if (hessian == nullptr) return kappa;

  // The table of 1.5: column block j holds derivatives by w_j.
  const Mat3 zero = Mat3::Zero(), identity = Mat3::Identity();
  const Mat3 dt1[2] = {-skew(t1), zero}, dt2[2] = {zero, -skew(t2)};
  const Mat3 da1[2] = {-skew(a1), zero}, da2[2] = {zero, -skew(a2)};
  const Vec3 dc[2] = {s, -s}, dkappa[2] = {g1, g2};
  const Mat3 dkb[2] = {(2 / chi) * (t1 * t2.transpose() - c * identity) - 0.5 * kb * kb.transpose(),
                       (2 / chi) * (c * identity - t2 * t1.transpose()) + 0.5 * kb * kb.transpose()};
  const Vec3 dp1[2] = {0.5 * t1.cross(a2), 0.5 * a2.cross(t1)};
  const Vec3 dp2[2] = {0.5 * a1.cross(t2), 0.5 * t2.cross(a1)};
  Mat3 d1[2], d2[2];
  for (int j = 0; j < 2; ++j) {
    const Mat3 da = 0.5 * (da1[j] + da2[j]);
    d1[j] = (2 / chi) * (t2 * dp1[j].transpose() + p1 * dt2[j] - a * dc[j].transpose() - c * da) -
            (2 / (chi * chi)) * u1 * dc[j].transpose() - 0.5 * kb * dkappa[j].transpose() - 0.5 * kappa * dkb[j] +
            0.5 * (skew(a1) * dkb[j] - skew(kb) * da1[j]);
    d2[j] = (2 / chi) * (a * dc[j].transpose() + c * da - t1 * dp2[j].transpose() - p2 * dt1[j]) -
            (2 / (chi * chi)) * u2 * dc[j].transpose() + 0.5 * kb * dkappa[j].transpose() + 0.5 * kappa * dkb[j] +
            0.5 * (skew(a2) * dkb[j] - skew(kb) * da2[j]);
  }
  // Symmetrising the diagonal blocks is exact: from left-trivialised to exponential coordinates.
  hessian->block<3, 3>(0, 0) = 0.5 * (d1[0] + d1[0].transpose());
  hessian->block<3, 3>(3, 3) = 0.5 * (d2[1] + d2[1].transpose());
  hessian->block<3, 3>(0, 3) = d1[1];
  hessian->block<3, 3>(3, 0) = d1[1].transpose();
  return kappa;
}

}  // namespace

FramePairDerivatives frame_pair_derivatives(const FrameT<double>& first, const FrameT<double>& second, double twist,
                                            const double* rest, bool with_hessian) {
  const Vec3 &t1 = first.t, &t2 = second.t, n1 = first.n(), n2 = second.n();
  Vec6 gradient[3];
  const double strain[3] = {curvature_derivatives(t1, t2, n1, n2, gradient[0], nullptr),
                            curvature_derivatives(t1, t2, -first.b, -second.b, gradient[1], nullptr), twist};
  const double chi = 1 + t1.dot(t2);
  const Vec3 tt = (t1 + t2) / chi, kb = 2 * t1.cross(t2) / chi;
  gradient[2] << -tt, tt;
  const double stiffness[3] = {rest[kBend1], rest[kBend2], rest[kTwistStiffness]};
  double c[3], moment[3];
  FramePairDerivatives d;
  d.gradient.setZero();
  for (int i = 0; i < 3; ++i) {
    c[i] = stiffness[i] / rest[kPairLength];
    moment[i] = c[i] * (strain[i] - rest[kKappa1 + i]);
    d.gradient += moment[i] * gradient[i];
  }
  if (!with_hessian) return d;

  // A curvature is linear in its director, so both are differentiated twice in one go, weighted by their moments.
  Vec6 weighted_gradient;
  curvature_derivatives(t1, t2, moment[0] * n1 - moment[1] * first.b, moment[0] * n2 - moment[1] * second.b,
                        weighted_gradient, &d.hessian);
  const Mat3 diagonal = (0.25 * moment[2]) * (tt * kb.transpose() + kb * tt.transpose());
  const Mat3 mixed = moment[2] * (skew(t2) / chi - 0.5 * tt * kb.transpose());
  d.hessian.block<3, 3>(0, 0) += diagonal;
  d.hessian.block<3, 3>(3, 3) += diagonal;
  d.hessian.block<3, 3>(0, 3) += mixed;
  d.hessian.block<3, 3>(3, 0) += mixed.transpose();
  for (int i = 0; i < 3; ++i) d.hessian += c[i] * gradient[i] * gradient[i].transpose();
  return d;
}

Eigen::Matrix<double, 3, 4> edge_rotation_jacobian(const Vec3& t, double length) {
  Eigen::Matrix<double, 3, 4> w;
  w << skew(t) / length, t;
  return w;
}

Mat4 edge_rotation_curvature(const Vec3& g, const Vec3& t, double length) {
  const Vec3 gt = g.cross(t);
  const Vec3 mixed = (g - t * t.dot(g)) / (2 * length);
  Mat4 k = Mat4::Zero();
  k.block<3, 3>(0, 0) = -(gt * t.transpose() + t * gt.transpose()) / (length * length);
  k.block<3, 1>(0, 3) = mixed;
  k.block<1, 3>(3, 0) = mixed.transpose();
  return k;
}

}  // namespace lissom
