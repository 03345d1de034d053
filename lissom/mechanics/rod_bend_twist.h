#pragma once
/// Anisotropic bending and twist at an interior vertex of a rod, between the edges x0-x1 and x1-x2
/// [Bergou et al. 2010; Jawed, Novelia, O'Reilly 2018; mathematics 1.3 to 1.7, errata E3 to E6].
/// The hand-written derivatives are the classical closed forms (1.7), summed over the strains before they are expanded.

#include "lissom/mechanics/stencil_term.h"
#include "lissom/mechanics/strain.h"

namespace lissom {

struct RodBendTwist {
  static constexpr std::string_view kName = "rod_bend_twist";
  static constexpr std::string_view kCitation = "Bergou et al. 2010; Jawed et al. 2018; mathematics 1.3-1.7";
  static constexpr int kDofs = 11;  // x0, x1, x2 (m), theta1, theta2 (rad)
  static constexpr int kRest = kPairRestCount;
  static constexpr bool kHasHessian = true;

  struct Stencil {
    std::array<int, kDofs> dofs;
    std::array<double, kRest> rest;
    int pair, edge0, edge1;
  };
  struct Frozen {
    Vec3 t1, b1, t2, b2;  // anchor tangents and reference binormals
    double twist;         // rad, at the anchor: the branch
  };
  Frozen frozen(const State& state, const Stencil& s) const {
    const EdgeState &e0 = state.edges[s.edge0], &e1 = state.edges[s.edge1];
    return {e0.t, e0.reference_b, e1.t, e1.reference_b, state.pair_twist[s.pair]};
  }

  template <class T>
  static T value(std::span<const T, kDofs> x, std::span<const T, kRest> rest, const Frozen& f) {
    const Vec3T<T> e1(x[3] - x[0], x[4] - x[1], x[5] - x[2]);
    const Vec3T<T> e2(x[6] - x[3], x[7] - x[4], x[8] - x[5]);
    const FrameT<T> first = edge_frame<T>(e1, x[9], f.t1, f.b1);
    const FrameT<T> second = edge_frame<T>(e2, x[10], f.t2, f.b2);
    return bend_twist_energy<T>(curvature(first, second), twist(first, second, f.twist), rest);
  }

  using Lane = Pack;
  template <class T>
  struct Local {
    FrameT<T> first, second;
    T length1, length2, twist;
    std::array<T, kRest> rest;
  };

  template <class T, class R>
  void gather(const State& state, const Stencil& s, const R* rest, int lane, Local<T>& local) const {
    const EdgeState &e0 = state.edges[s.edge0], &e1 = state.edges[s.edge1];
    set_lane(local.first.t, lane, e0.t);
    set_lane(local.first.b, lane, e0.b);
    set_lane(local.second.t, lane, e1.t);
    set_lane(local.second.b, lane, e1.b);
    set_lane(local.length1, lane, e0.length);
    set_lane(local.length2, lane, e1.length);
    set_lane(local.twist, lane, state.pair_twist[s.pair]);
    for (int i = 0; i < kRest; ++i) set_lane(local.rest[i], lane, rest[i]);
  }

  template <class T>
  static T energy(const Local<T>& a) {
    return bend_twist_energy<T>(curvature(a.first, a.second), a.twist, a.rest);
  }

  template <class T>
  static void derivatives(const Local<T>& a, T* gradient, T* hessian);

  std::vector<Stencil> stencils;
};

template <class T>
void RodBendTwist::derivatives(const Local<T>& a, T* gradient, T* hessian) {
  using V = Vec3T<T>;
  const V &t1 = a.first.t, &t2 = a.second.t, &b1 = a.first.b, &b2 = a.second.b;
  const V n1 = a.first.n(), n2 = a.second.n();
  const T chi = T(1) + t1.dot(t2), per_chi = T(1) / chi;
  const V kb = t1.cross(t2) * (T(2) * per_chi);
  const V tt = (t1 + t2) * per_chi;
  const V an = (n1 + n2) * per_chi, ab = (b1 + b2) * -per_chi;  // the vectors a-tilde of kappa_1 and kappa_2
  const T kappa1 = kb.dot(an) * chi * T(0.5), kappa2 = kb.dot(ab) * chi * T(0.5);
  const T per_length = T(1) / a.rest[kPairLength];
  const T c1 = a.rest[kBend1] * per_length, c2 = a.rest[kBend2] * per_length, c3 = a.rest[kTwistStiffness] * per_length;
  const T s1 = c1 * (kappa1 - a.rest[kKappa1]), s2 = c2 * (kappa2 - a.rest[kKappa2]),
          s3 = c3 * (a.twist - a.rest[kRestTwist]);
  const T per_l1 = T(1) / a.length1, per_l2 = T(1) / a.length2;

  // Gradients of the three strains by (e1, theta1, e2, theta2).
  T g[3][8];
  const V a1 = t2.cross(an), a2 = t2.cross(ab), d1 = t1.cross(an), d2 = t1.cross(ab);
  for (int i = 0; i < 3; ++i) {
    g[0][i] = (a1[i] - kappa1 * tt[i]) * per_l1;
    g[1][i] = (a2[i] - kappa2 * tt[i]) * per_l1;
    g[2][i] = kb[i] * per_l1 * T(0.5);
    g[0][4 + i] = (d1[i] + kappa1 * tt[i]) * -per_l2;
    g[1][4 + i] = (d2[i] + kappa2 * tt[i]) * -per_l2;
    g[2][4 + i] = kb[i] * per_l2 * T(0.5);
  }
  g[0][3] = kb.dot(b1) * T(-0.5);
  g[0][7] = kb.dot(b2) * T(-0.5);
  g[1][3] = kb.dot(n1) * T(-0.5);
  g[1][7] = kb.dot(n2) * T(-0.5);
  g[2][3] = T(-1);
  g[2][7] = T(1);

  T ge[8];
  for (int i = 0; i < 8; ++i) ge[i] = s1 * g[0][i] + s2 * g[1][i] + s3 * g[2][i];
  for (int i = 0; i < 3; ++i) {
    gradient[i] = -ge[i];
    gradient[3 + i] = ge[i] - ge[4 + i];
    gradient[6 + i] = ge[4 + i];
  }
  gradient[9] = ge[3];
  gradient[10] = ge[7];
  if (hessian == nullptr) return;

  // Blocks of the Hessian by (e1, theta1), (e2, theta2): Gauss-Newton part and strain-weighted second derivatives.
  const T c_g[3] = {c1, c2, c3};
  T w[3][8];
  for (int k = 0; k < 3; ++k) {
    for (int i = 0; i < 8; ++i) w[k][i] = c_g[k] * g[k][i];
  }
  const auto gauss_newton = [&](int i, int j) { return w[0][i] * g[0][j] + w[1][i] * g[1][j] + w[2][i] * g[2][j]; };

  const T kappa_s = s1 * kappa1 + s2 * kappa2, kappa_chi = kappa_s * per_chi;
  const V as1 = n1 * s1 - b1 * s2, as2 = n2 * s1 - b2 * s2;  // sums of s_i a_i
  const V as = (as1 + as2) * per_chi;
  const V big_a = t2.cross(as), big_d = t1.cross(as);
  const V u1 = (as1 - (t1 + tt) * s3) * T(0.25), u2 = (as2 - (t2 + tt) * s3) * T(0.25);
  const V half_kb = kb * (T(0.5) * s3);
  const V cross_part = t1 * (s3 * per_chi) - as;             // its skew matrix enters the mixed block
  const V ds1 = b1 * s1 + n1 * s2, ds2 = b2 * s1 + n2 * s2;  // sums of s_i d_i
  const V v1 = t2.cross(ds1) * per_chi, v2 = t2.cross(ds2) * per_chi;
  const V w1 = t1.cross(ds1) * per_chi, w2 = t1.cross(ds2) * per_chi;
  const T p1 = kb.dot(ds1) * T(0.5), p2 = kb.dot(ds2) * T(0.5);
  const T per_11 = per_l1 * per_l1, per_22 = per_l2 * per_l2, per_12 = per_l1 * per_l2;

  T e11[3][3], e22[3][3], e12[3][3];
  for (int i = 0; i < 3; ++i) {
    const V skew_row = i == 0   ? V(T(0), -cross_part[2], cross_part[1])
                       : i == 1 ? V(cross_part[2], T(0), -cross_part[0])
                                : V(-cross_part[1], cross_part[0], T(0));
    for (int j = 0; j < 3; ++j) {
      const T tt_ij = T(2) * kappa_s * tt[i] * tt[j];
      if (j <= i) {
        T h11 = tt_ij - big_a[i] * tt[j] - tt[i] * big_a[j] + kappa_chi * t1[i] * t1[j] + kb[i] * u1[j] + u1[i] * kb[j];
        T h22 = tt_ij + big_d[i] * tt[j] + tt[i] * big_d[j] + kappa_chi * t2[i] * t2[j] + kb[i] * u2[j] + u2[i] * kb[j];
        if (i == j) {
          h11 -= kappa_chi;
          h22 -= kappa_chi;
        }
        e11[i][j] = e11[j][i] = h11 * per_11 + gauss_newton(i, j);
        e22[i][j] = e22[j][i] = h22 * per_22 + gauss_newton(4 + i, 4 + j);
      }
      T h12 =
          tt_ij - kappa_chi * t1[i] * t2[j] - big_a[i] * tt[j] + tt[i] * big_d[j] + skew_row[j] - half_kb[i] * tt[j];
      if (i == j) h12 -= kappa_chi;
      e12[i][j] = h12 * per_12 + gauss_newton(i, 4 + j);
    }
  }
  T e1t[2][3], e2t[2][3];  // (theta_j, e_i)
  for (int i = 0; i < 3; ++i) {
    e1t[0][i] = (p1 * tt[i] - v1[i]) * per_l1 + gauss_newton(3, i);
    e1t[1][i] = (p2 * tt[i] - v2[i]) * per_l1 + gauss_newton(7, i);
    e2t[0][i] = (p1 * tt[i] + w1[i]) * per_l2 + gauss_newton(3, 4 + i);
    e2t[1][i] = (p2 * tt[i] + w2[i]) * per_l2 + gauss_newton(7, 4 + i);
  }

  const auto row = [&](int i) { return hessian + i * (i + 1) / 2; };
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (j <= i) {
        row(i)[j] = e11[i][j];
        row(3 + i)[3 + j] = e11[i][j] - e12[i][j] - e12[j][i] + e22[i][j];
        row(6 + i)[6 + j] = e22[i][j];
      }
      row(3 + i)[j] = e12[j][i] - e11[i][j];
      row(6 + i)[j] = -e12[j][i];
      row(6 + i)[3 + j] = e12[j][i] - e22[i][j];
    }
  }
  for (int k = 0; k < 2; ++k) {
    for (int i = 0; i < 3; ++i) {
      row(9 + k)[i] = -e1t[k][i];
      row(9 + k)[3 + i] = e1t[k][i] - e2t[k][i];
      row(9 + k)[6 + i] = e2t[k][i];
    }
  }
  row(9)[9] = kb.dot(as1) * T(-0.5) + gauss_newton(3, 3);
  row(10)[9] = gauss_newton(3, 7);
  row(10)[10] = kb.dot(as2) * T(-0.5) + gauss_newton(7, 7);
}

}  // namespace lissom
