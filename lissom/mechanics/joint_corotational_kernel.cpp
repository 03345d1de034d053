#include "lissom/mechanics/joint_corotational_kernel.h"

#include <Eigen/Dense>
#include <array>

#include "lissom/mechanics/frame_pair.h"

namespace lissom {

namespace {

// Sizes known up to a bound: no heap, and one instantiation for joints of any number of edges.
constexpr int kMaxSize = 3 + 4 * kMaxCorotationalEdges;
using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, kMaxSize, kMaxSize>;
using Wide = Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::ColMajor, 3, kMaxSize>;
using Tall = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMaxSize, 1>;

Vec3 axial(const Mat3& m) { return 0.5 * Vec3(m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1)); }

FrameT<double> held_frame(const CorotationalEdge& edge, const Mat3& rotation) {
  return {rotation * edge.rest_frame.t, rotation * edge.rest_frame.b};
}

/// Rotation vector r of the joint as a function of the edges' rotation vectors w: first and second derivatives.
struct MatchedRotation {
  Wide first;                                          ///< 3 x 3k, dr/dw
  std::array<Wide, 3 * kMaxCorotationalEdges> second;  ///< 3 x 3k each: d2r/dw_u dw_v = second[u].col(v)
};

MatchedRotation matched_rotation_derivatives(const CorotationalEdge* edges, int count, const Mat3& rotation) {
  const int n = 3 * count;
  Mat3 covariance = Mat3::Zero();
  for (int i = 0; i < count; ++i) {
    const CorotationalEdge& e = edges[i];
    covariance += e.weight.t * e.frame.t * e.rest_frame.t.transpose() +
                  e.weight.n * e.frame.n() * e.rest_frame.n.transpose() +
                  e.weight.b * e.frame.b * e.rest_frame.b.transpose();
  }
  const Mat3 stretch = rotation.transpose() * covariance;
  const Mat3 s = 0.5 * (stretch + stretch.transpose());
  const Mat3 g = (s.trace() * Mat3::Identity() - s) * rotation.transpose();
  const Mat3 g_inverse = g.inverse();

  // N_u for every component u of w, then omega_u, S_u (3.20).
  std::array<Mat3, 3 * kMaxCorotationalEdges> n_u, s_u;
  std::array<Vec3, 3 * kMaxCorotationalEdges> omega;
  // What `change` of the frame's axes does to the covariance.
  const auto covariance_of = [&](const CorotationalEdge& e, const auto& change) -> Mat3 {
    return e.weight.t * change(e.frame.t) * e.rest_frame.t.transpose() +
           e.weight.n * change(e.frame.n()) * e.rest_frame.n.transpose() +
           e.weight.b * change(e.frame.b) * e.rest_frame.b.transpose();
  };
  for (int u = 0; u < n; ++u) {
    const CorotationalEdge& e = edges[u / 3];
    const Vec3 axis = Vec3::Unit(u % 3);
    n_u[u] = covariance_of(e, [&](const Vec3& x) -> Vec3 { return axis.cross(x); });
    omega[u] = 2 * g_inverse * axial(rotation.transpose() * n_u[u]);
    s_u[u] = rotation.transpose() * (n_u[u] - skew(omega[u]) * rotation * s);
  }
  MatchedRotation r;
  r.first.resize(3, n);
  for (int u = 0; u < n; ++u) r.second[u].resize(3, n);
  for (int u = 0; u < n; ++u) r.first.col(u) = omega[u];

  // omega_{u,v} (3.21), then the second derivative of the rotation vector: + 1/2 omega_u x omega_v.
  for (int u = 0; u < n; ++u) {
    for (int v = 0; v <= u; ++v) {
      Mat3 n_uv = -skew(omega[v]) * n_u[u];
      if (u / 3 == v / 3) {
        const CorotationalEdge& e = edges[u / 3];
        const Vec3 a = Vec3::Unit(u % 3), b = Vec3::Unit(v % 3);
        n_uv +=
            covariance_of(e, [&](const Vec3& x) -> Vec3 { return 0.5 * (a.cross(b.cross(x)) + b.cross(a.cross(x))); });
      }
      const Mat3 s_v = s_u[v].trace() * Mat3::Identity() - s_u[v];
      const Vec3 omega_uv = 2 * g_inverse * axial(rotation.transpose() * n_uv) -
                            g_inverse * (s_v * (rotation.transpose() * omega[u])) + omega[v].cross(omega[u]);
      const Vec3 second = omega_uv + 0.5 * omega[u].cross(omega[v]);
      r.second[u].col(v) = second;
      r.second[v].col(u) = second;
    }
  }
  return r;
}

}  // namespace

double corotational_energy(const CorotationalEdge* edges, int count, const Mat3& rotation) {
  double v = 0;
  for (int i = 0; i < count; ++i) {
    const FrameT<double> held = held_frame(edges[i], rotation);
    const std::span<const double, kPairRestCount> rest(edges[i].rest, kPairRestCount);
    v += edges[i].direction > 0 ? bend_twist_energy<double>(curvature(held, edges[i].frame), edges[i].twist, rest)
                                : bend_twist_energy<double>(curvature(edges[i].frame, held), edges[i].twist, rest);
  }
  return v;
}

void corotational_derivatives(const CorotationalEdge* edges, int count, const Mat3& rotation, double* gradient,
                              double* hessian) {
  const int n = 3 * count;
  // The explicit joint in (w_1 .. w_k, r).
  Tall g = Tall::Zero(n + 3);
  Square h = Square::Zero(n + 3, n + 3);
  for (int i = 0; i < count; ++i) {
    const CorotationalEdge& e = edges[i];
    const FrameT<double> held = held_frame(e, rotation);
    const bool leaves = e.direction > 0;
    const FramePairDerivatives d =
        frame_pair_derivatives(leaves ? held : e.frame, leaves ? e.frame : held, e.twist, e.rest, hessian != nullptr);
    const int at[2] = {leaves ? n : 3 * i, leaves ? 3 * i : n};
    for (int a = 0; a < 2; ++a) {
      g.segment<3>(at[a]) += d.gradient.segment<3>(3 * a);
      if (hessian == nullptr) continue;
      for (int b = 0; b < 2; ++b) h.block<3, 3>(at[a], at[b]) += d.hessian.block<3, 3>(3 * a, 3 * b);
    }
  }
  // r follows w.
  const MatchedRotation r = matched_rotation_derivatives(edges, count, rotation);
  const Vec3 g_r = g.tail<3>();
  const Tall g_w = g.head(n) + r.first.transpose().lazyProduct(g_r);

  // Chain to (e, theta) of each edge, then to nodes: e = direction (x_far - x_joint).
  Square w = Square::Zero(n, 4 * count);
  for (int i = 0; i < count; ++i) {
    w.block<3, 4>(3 * i, 4 * i) = edge_rotation_jacobian(edges[i].frame.t, edges[i].length);
    w.block<3, 3>(3 * i, 4 * i) *= edges[i].direction;
  }
  const Tall g_e = w.transpose().lazyProduct(g_w);
  const int dofs = 3 + 4 * count;
  for (int i = 0; i < dofs; ++i) gradient[i] = 0;
  for (int i = 0; i < count; ++i) {
    for (int c = 0; c < 3; ++c) {
      gradient[c] -= g_e[4 * i + c];
      gradient[3 + 3 * i + c] = g_e[4 * i + c];
    }
    gradient[3 + 3 * count + i] = g_e[4 * i + 3];
  }
  if (hessian == nullptr) return;

  const Square mixed = h.block(0, n, n, 3).lazyProduct(r.first);
  const Wide turned = h.block(n, n, 3, 3).lazyProduct(r.first);
  Square h_w = h.topLeftCorner(n, n);
  h_w += mixed;
  h_w += mixed.transpose();
  h_w += r.first.transpose().lazyProduct(turned);
  for (int u = 0; u < n; ++u) h_w.row(u) += g_r.transpose().lazyProduct(r.second[u]);
  const Square h_w_w = h_w.lazyProduct(w);
  Square h_e = w.transpose().lazyProduct(h_w_w);
  for (int i = 0; i < count; ++i) {
    Mat4 second = edge_rotation_curvature(g_w.segment<3>(3 * i), edges[i].frame.t, edges[i].length);
    // The sign of e cancels in the block by (e, e) and stays in the one by (e, theta).
    second.block<3, 1>(0, 3) *= edges[i].direction;
    second.block<1, 3>(3, 0) *= edges[i].direction;
    h_e.block<4, 4>(4 * i, 4 * i) += second;
  }
  // Columns of the map from unknowns to (e, theta): +-1 entries only.
  Square full = Square::Zero(dofs, dofs);
  const auto place = [&](int i, int c) { return c < 3 ? 3 + 3 * i + c : 3 + 3 * count + i; };
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < count; ++j) {
      for (int a = 0; a < 4; ++a) {
        for (int b = 0; b < 4; ++b) {
          const double k = h_e(4 * i + a, 4 * j + b);
          full(place(i, a), place(j, b)) += k;
          if (a < 3) full(a, place(j, b)) -= k;
          if (b < 3) full(place(i, a), b) -= k;
          if (a < 3 && b < 3) full(a, b) += k;
        }
      }
    }
  }
  for (int i = 0, k = 0; i < dofs; ++i) {
    for (int j = 0; j <= i; ++j, ++k) hessian[k] = full(i, j);
  }
}

}  // namespace lissom
