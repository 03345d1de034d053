#pragma once
/// Corotational joint of K edges: its rotation follows the edges by shape matching, so every edge feels every other
/// [thesis 3.2.3; Mueller et al. 2005; Barbic and Zhao 2011; mathematics 2.3; errata E8 to E11].
/// Unknowns: the joint's node, then the far node of each edge, then the roll of each edge.

#include "lissom/mechanics/joint_corotational_kernel.h"
#include "lissom/mechanics/joint_explicit.h"
#include "lissom/mechanics/shape_matching.h"

namespace lissom {

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

template <int K>
struct JointCorotational {
  static constexpr std::string_view kName = "joint_corotational";
  static constexpr std::string_view kCitation = "thesis 3.2.3; Barbic and Zhao 2011; mathematics 2.3";
  static constexpr int kDofs = 3 + 4 * K;
  static constexpr int kRest = K * kConnectionRestCount;
  static constexpr bool kHasHessian = true;

  struct Stencil {
    std::array<int, kDofs> dofs;
    std::array<double, kRest> rest;
    int joint;
    std::array<int, K> connection, edge, direction;
    std::array<Frame, K> rest_frame;
    JointWeights weights;
  };
  struct Frozen {
    std::array<Vec3, K> t, b;
    std::array<double, K> twist;
    Mat3 rotation;
    const Stencil* stencil;
  };
  Frozen frozen(const State& state, const Stencil& s) const {
    Frozen f;
    for (int i = 0; i < K; ++i) {
      const EdgeState& e = state.edges[s.edge[i]];
      f.t[i] = e.t;
      f.b[i] = e.reference_b;
      f.twist[i] = state.connection_twist[s.connection[i]];
    }
    f.rotation = state.joint_rotation[s.joint];
    f.stencil = &s;
    return f;
  }

  template <class T>
  static T value(std::span<const T, kDofs> x, std::span<const T, kRest> rest, const Frozen& f) {
    const Stencil& s = *f.stencil;
    std::array<FrameT<T>, K> edge, at_rest;
    Eigen::Matrix<T, 3, 3> covariance;
    covariance.setConstant(T(0));
    for (int i = 0; i < K; ++i) {
      const T* r = rest.data() + i * kConnectionRestCount;
      const T sign(s.direction[i]);
      const Vec3T<T> e((x[3 + 3 * i] - x[0]) * sign, (x[4 + 3 * i] - x[1]) * sign, (x[5 + 3 * i] - x[2]) * sign);
      edge[i] = edge_frame<T>(e, x[3 + 3 * K + i], f.t[i], f.b[i]);
      const Vec3T<T> turn(r[kRestTurn], r[kRestTurn + 1], r[kRestTurn + 2]);
      at_rest[i].t = rotated_by_vector<T>(turn, s.rest_frame[i].t.template cast<T>());
      at_rest[i].b = rotated_by_vector<T>(turn, s.rest_frame[i].b.template cast<T>());
      const ConnectionWeights<T> w = connection_weights<T>(r, s.weights);
      covariance += (edge[i].t * w.t) * at_rest[i].t.transpose() + (edge[i].n() * w.n) * at_rest[i].n().transpose();
    }
    const Vec3T<T> turn = matched_turn<T>(covariance, f.rotation, kMatchingSteps);
    T v(0);
    for (int i = 0; i < K; ++i) {
      const auto held_axis = [&](const Vec3T<T>& axis) {
        return rotated_by_vector<T>(turn, Vec3T<T>(f.rotation.cast<T>() * axis));
      };
      const FrameT<T> held{held_axis(at_rest[i].t), held_axis(at_rest[i].b)};
      const std::span<const T, kPairRestCount> spring(rest.data() + i * kConnectionRestCount, kPairRestCount);
      v += s.direction[i] > 0
               ? bend_twist_energy<T>(curvature(held, edge[i]), twist(held, edge[i], f.twist[i]), spring)
               : bend_twist_energy<T>(curvature(edge[i], held), twist(edge[i], held, f.twist[i]), spring);
    }
    return v;
  }

  using Lane = double;
  template <class T>
  struct Local {
    CorotationalEdge edge[K];
    Mat3 rotation;
  };

  template <class T>
  void gather(const State& state, const Stencil& s, int, Local<T>& local) const {
    local.rotation = state.joint_rotation[s.joint];
    for (int i = 0; i < K; ++i) {
      const EdgeState& e = state.edges[s.edge[i]];
      const double* rest = s.rest.data() + i * kConnectionRestCount;
      const ConnectionWeights<double> w = connection_weights<double>(rest, s.weights);
      local.edge[i] = {{e.t, e.b}, s.rest_frame[i], e.length,
                       state.connection_twist[s.connection[i]], s.direction[i], w.t, w.n, rest};
    }
  }

  template <class T>
  static T energy(const Local<T>& a) {
    return corotational_energy(a.edge, K, a.rotation);
  }

  template <class T>
  static void derivatives(const Local<T>& a, T* gradient, T* hessian) {
    corotational_derivatives<K>(a.edge, a.rotation, gradient, hessian);
  }

  /// Newton steps of matched_turn: two give the derivatives, the rest the values away from the anchor.
  static constexpr int kMatchingSteps = 12;

  std::vector<Stencil> stencils;
};

}  // namespace lissom
