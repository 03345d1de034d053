#include <Eigen/Dense>
#include <type_traits>

#include "lissom/core/traced_dual.h"
#include "lissom/mechanics/joint_corotational_kernel.h"
#include "lissom/mechanics/joint_explicit.h"

namespace lissom {

namespace {

/// Newton steps of matched_turn. Every step makes derivatives of one order more exact once the values are; away from the
/// anchor the first steps find the values. Traced numbers are at the anchor: one step against its rounding, three for the
/// orders.
template <class T>
constexpr int kMatchingSteps = std::is_same_v<T, TracedDual> ? 4 : 12;

/// Nearest rotation to N near R0, as the rotation vector r with R = exp([r]) R0: Newton's method on the moment
/// axl(N R') = 0, carried out in duals so that derivatives come out exactly (R0 already solves it for the values).
template <class T>
Vec3T<T> matched_turn(const Eigen::Matrix<T, 3, 3>& covariance, const Mat3& r0, int steps) {
  const Eigen::Matrix<T, 3, 3> m = covariance * r0.transpose().cast<T>();
  Vec3T<T> r(T(0), T(0), T(0));
  for (int k = 0; k < steps; ++k) {
    // Columns of exp([r]); moment(r) = sum_j (R e_j) x (M e_j); Jacobian at the values: -(tr S I - S).
    Vec3T<T> moment(T(0), T(0), T(0));
    Mat3 jacobian = Mat3::Zero();
    for (int j = 0; j < 3; ++j) {
      const Vec3T<T> axis = rotated_by_vector<T>(r, Vec3(Vec3::Unit(j)).cast<T>());
      const Vec3T<T> column = m.col(j);
      moment += axis.cross(column);
      const Vec3 a(primal(axis[0]), primal(axis[1]), primal(axis[2]));
      const Vec3 c(primal(column[0]), primal(column[1]), primal(column[2]));
      jacobian += c * a.transpose() - a.dot(c) * Mat3::Identity();
    }
    const Mat3 inverse = (-0.5 * (jacobian + jacobian.transpose())).inverse();
    r += inverse.cast<T>() * moment;
  }
  return r;
}

}  // namespace

template <class T>
void corotational_frames(const T* x, const T* rest, const CorotationalAnchors& f, FrameT<T>* edge, FrameT<T>* held) {
  Eigen::Matrix<T, 3, 3> covariance;
  covariance.setConstant(T(0));
  for (int i = 0; i < f.count; ++i) {
    const T* r = rest + i * kConnectionRestCount;
    const T sign(f.edge[i].direction);
    const Vec3T<T> e((x[3 + 3 * i] - x[0]) * sign, (x[4 + 3 * i] - x[1]) * sign, (x[5 + 3 * i] - x[2]) * sign);
    edge[i] = edge_frame<T>(e, x[3 + 3 * f.count + i], f.edge[i].t, f.edge[i].reference_b);
    const Vec3T<T> turn(r[kRestTurn], r[kRestTurn + 1], r[kRestTurn + 2]);
    FrameT<T>& at_rest = held[i];
    at_rest.t = rotated_by_vector<T>(turn, f.edge[i].rest_frame.t.template cast<T>());
    at_rest.b = rotated_by_vector<T>(turn, f.edge[i].rest_frame.b.template cast<T>());
    const ConnectionWeights<T> w = connection_weights<T>(r, f.weights);
    covariance += (edge[i].t * w.t) * at_rest.t.transpose() + (edge[i].n() * w.n) * at_rest.n().transpose() +
                  (edge[i].b * w.b) * at_rest.b.transpose();
  }
  const Vec3T<T> turn = matched_turn<T>(covariance, f.rotation, kMatchingSteps<T>);
  for (int i = 0; i < f.count; ++i) {
    const auto held_axis = [&](const Vec3T<T>& axis) {
      return rotated_by_vector<T>(turn, Vec3T<T>(f.rotation.template cast<T>() * axis));
    };
    held[i] = {held_axis(held[i].t), held_axis(held[i].b)};
  }
}

template <class T>
T corotational_value(const T* x, const T* rest, const CorotationalAnchors& f) {
  std::array<FrameT<T>, kMaxCorotationalEdges> edge, held;
  corotational_frames(x, rest, f, edge.data(), held.data());
  T v(0);
  for (int i = 0; i < f.count; ++i) {
    const std::span<const T, kPairRestCount> spring(rest + i * kConnectionRestCount, kPairRestCount);
    const FrameT<T>&first = f.edge[i].direction > 0 ? held[i] : edge[i],
          &second = f.edge[i].direction > 0 ? edge[i] : held[i];
    v += bend_twist_energy<T>(curvature(first, second), twist(first, second, f.edge[i].twist), spring);
  }
  return v;
}

template double corotational_value<double>(const double*, const double*, const CorotationalAnchors&);
template Dual2<kCorotationalDualSize> corotational_value<Dual2<kCorotationalDualSize>>(
    const Dual2<kCorotationalDualSize>*, const Dual2<kCorotationalDualSize>*, const CorotationalAnchors&);
template void corotational_frames<double>(const double*, const double*, const CorotationalAnchors&, FrameT<double>*,
                                          FrameT<double>*);
template void corotational_frames<TracedDual>(const TracedDual*, const TracedDual*, const CorotationalAnchors&,
                                              FrameT<TracedDual>*, FrameT<TracedDual>*);
template TracedDual corotational_value<TracedDual>(const TracedDual*, const TracedDual*, const CorotationalAnchors&);

}  // namespace lissom
