#pragma once
/// Explicit joint, one connection: the spring between a rod edge and the frame of a joint whose rotation is an unknown
/// [Zehnder et al. 2016; mathematics 2.1, 2.2; erratum E8]. Also the clamp: a joint whose rotation is prescribed.

#include <algorithm>

#include "lissom/mechanics/frame_pair.h"
#include "lissom/mechanics/stencil_term.h"

namespace lissom {

inline std::array<double, kConnectionRestCount> connection_rest_values(const PairRest& r) {
  return {r.kappa_1, r.kappa_2, r.twist, r.bend_1, r.bend_2, r.twist_stiffness, r.length, 0, 0, 0};
}

/// exp([r]) x for |r| of order one; the series is exact to rounding and smooth at r = 0 for duals, to third order too.
template <class T>
Vec3T<T> rotated_by_vector(const Vec3T<T>& r, const Vec3T<T>& x) {
  const T s = r.dot(r);
  T a(0), b(0);  // sin|r| / |r| and (1 - cos|r|) / |r|^2
  for (int k = primal(s) < 1e-4 ? 3 : 12; k >= 0; --k) {
    a = T(1) - s * a * (1.0 / ((2 * k + 2) * (2 * k + 3)));
    b = T(1) - s * b * (1.0 / ((2 * k + 3) * (2 * k + 4)));
  }
  b = b * T(0.5);
  const Vec3T<T> once = r.cross(x), twice = r.cross(once);
  return Vec3T<T>(x + once * a + twice * b);
}

struct JointExplicit {
  static constexpr std::string_view kName = "joint_explicit";
  static constexpr std::string_view kCitation = "Zehnder et al. 2016; mathematics 2.2";
  static constexpr int kDofs = 10;  // x0, x1 (m), theta (rad), r (rad)
  static constexpr int kRest = kConnectionRestCount;
  static constexpr bool kHasHessian = true;

  struct Stencil {
    std::array<int, kDofs> dofs;
    std::array<double, kRest> rest;
    int connection, edge, joint, direction;
    Frame rest_frame;
  };
  struct Frozen {
    Vec3 t, b;  // anchor of the edge
    Mat3 rotation;
    Frame rest_frame;
    double twist;
    int direction;
  };
  Frozen frozen(const State& state, const Stencil& s) const {
    const EdgeState& e = state.edges[s.edge];
    return {
        e.t,        e.reference_b, state.joint_rotation[s.joint], s.rest_frame, state.connection_twist[s.connection],
        s.direction};
  }

  template <class T>
  static T value(std::span<const T, kDofs> x, std::span<const T, kRest> rest, const Frozen& f) {
    const FrameT<T> edge = edge_frame<T>(Vec3T<T>(x[3] - x[0], x[4] - x[1], x[5] - x[2]), x[6], f.t, f.b);
    const Vec3T<T> turn(rest[kRestTurn], rest[kRestTurn + 1], rest[kRestTurn + 2]);
    const Vec3T<T> r(x[7], x[8], x[9]);
    const auto held_axis = [&](const Vec3& axis) {
      const Vec3T<T> at_rest = rotated_by_vector<T>(turn, axis.cast<T>());
      return rotated_by_vector<T>(r, Vec3T<T>(f.rotation.cast<T>() * at_rest));
    };
    const FrameT<T> held{held_axis(f.rest_frame.t), held_axis(f.rest_frame.b)};
    const auto spring = rest.template first<kPairRestCount>();
    return f.direction > 0 ? bend_twist_energy<T>(curvature(held, edge), twist(held, edge, f.twist), spring)
                           : bend_twist_energy<T>(curvature(edge, held), twist(edge, held, f.twist), spring);
  }

  using Lane = double;
  template <class T>
  struct Local {
    FrameT<double> edge, held;
    double length, twist;
    int direction;
    const double* rest;
  };

  template <class T>
  void gather(const State& state, const Stencil& s, const double* rest, int, Local<T>& local) const {
    const EdgeState& e = state.edges[s.edge];
    const Mat3& rotation = state.joint_rotation[s.joint];
    // The rest turn is 0 in every built term; it is an active variable of `value` for the mixed block only.
    local = {{e.t, e.b},  {rotation * s.rest_frame.t, rotation * s.rest_frame.b},
             e.length,    state.connection_twist[s.connection],
             s.direction, rest};
  }

  template <class T>
  static T energy(const Local<T>& a) {
    const std::span<const double, kPairRestCount> rest(a.rest, kPairRestCount);
    return a.direction > 0 ? bend_twist_energy<double>(curvature(a.held, a.edge), a.twist, rest)
                           : bend_twist_energy<double>(curvature(a.edge, a.held), a.twist, rest);
  }

  template <class T>
  static void derivatives(const Local<T>& a, T* gradient, T* hessian) {
    const bool leaves = a.direction > 0;
    const FramePairDerivatives d =
        frame_pair_derivatives(leaves ? a.held : a.edge, leaves ? a.edge : a.held, a.twist, a.rest, hessian != nullptr);
    const int edge_at = leaves ? 3 : 0, held_at = leaves ? 0 : 3;
    // The edge's rotation by (e, theta), the held frame's by r, then e = x1 - x0.
    const Eigen::Matrix<double, 3, 4> w = edge_rotation_jacobian(a.edge.t, a.length);
    const Vec4 g = w.transpose() * d.gradient.segment<3>(edge_at);
    for (int i = 0; i < 3; ++i) {
      gradient[i] = -g[i];
      gradient[3 + i] = g[i];
      gradient[7 + i] = d.gradient[held_at + i];
    }
    gradient[6] = g[3];
    if (hessian == nullptr) return;
    Eigen::Matrix<double, 7, 7> h;  // by (e, theta, r); only the lower triangle is read
    h.block<4, 4>(0, 0) = w.transpose() * d.hessian.block<3, 3>(edge_at, edge_at) * w +
                          edge_rotation_curvature(d.gradient.segment<3>(edge_at), a.edge.t, a.length);
    h.block<3, 4>(4, 0) = d.hessian.block<3, 3>(held_at, edge_at) * w;
    h.block<3, 3>(4, 4) = d.hessian.block<3, 3>(held_at, held_at);
    constexpr int kFrom[kDofs] = {0, 1, 2, 0, 1, 2, 3, 4, 5, 6};
    for (int i = 0; i < kDofs; ++i) {
      for (int j = 0; j <= i; ++j) {
        const double sign = (i < 3) != (j < 3) ? -1 : 1;
        // x0 and x1 come from the same entries, so that the place may lie above the diagonal of h.
        hessian[i * (i + 1) / 2 + j] = sign * h(std::max(kFrom[i], kFrom[j]), std::min(kFrom[i], kFrom[j]));
      }
    }
  }

  std::vector<Stencil> stencils;
};

}  // namespace lissom
