#pragma once
/// Strain of one tetrahedron of an elastic solid: the stable neo-Hookean energy [Smith, de Goes, Kim 2018, eq. (13);
/// docs/energies/solid_stretch.md], constant over the tetrahedron,
///   V = V0 (mu/2 (tr(F'F) - 3) - mu (J - 1) + (lambda + mu)/2 (J - 1)^2),  J = det F,
/// with Lame's parameters lambda, mu (Pa): for small strains it is linear elasticity of exactly these.
///
/// It is finite and smooth for every F, also for tetrahedra that are flat or inside out, and pushes those back. So a solve
/// may start from, and pass through, what a barrier against inversion forbids: supports that were moved far at once. The
/// price is that a load can turn a tetrahedron inside out for good; results say when one is. We leave out the term
/// -mu/2 log(tr(F'F) + 1) that the paper adds: it only makes a tetrahedron that has shrunk to a point unstable, which no
/// solve from a drawn shape meets; without it the energy is a polynomial, and 0 without stress at rest.

#include <string_view>

#include "lissom/mechanics/stencil_term.h"

namespace lissom {

struct SolidStretch {
  static constexpr std::string_view kName = "solid_stretch";
  static constexpr std::string_view kCitation = "Smith, de Goes, Kim 2018; docs/energies/solid_stretch.md";
  static constexpr int kDofs = 12;  // x1, x2, x3, x4 (m)
  static constexpr int kRest = 14;  // rest corners X1, X2, X3, X4 (m, three each), lambda, mu (Pa)
  static constexpr bool kHasHessian = true;

  struct Stencil {
    std::array<int, kDofs> dofs;
    std::array<double, kRest> rest;
  };
  struct Frozen {};
  Frozen frozen(const State&, const Stencil&) const { return {}; }

  template <class T>
  static T value(std::span<const T, kDofs> x, std::span<const T, kRest> rest, const Frozen&) {
    const auto sides = [](const auto& at) {
      std::array<Vec3T<T>, 3> e;
      for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) e[i][k] = at[3 * i + 3 + k] - at[k];
      }
      return e;
    };
    const std::array<Vec3T<T>, 3> e = sides(x), rest_e = sides(rest);
    const Vec3T<T> n0 = rest_e[1].cross(rest_e[2]), n1 = rest_e[2].cross(rest_e[0]), n2 = rest_e[0].cross(rest_e[1]);
    const T six_volumes = rest_e[0].dot(n0), per = T(1) / six_volumes;
    T squares = T(0);
    for (int i = 0; i < 3; ++i) {
      // Row i of F is the sum of the sides' components i times the gradients of the shape functions.
      const Vec3T<T> row = (n0 * e[0][i] + n1 * e[1][i] + n2 * e[2][i]) * per;
      squares += row.dot(row);
    }
    const T change = e[0].dot(e[1].cross(e[2])) * per - T(1);
    const T &lambda = rest[12], &mu = rest[13];
    return six_volumes * T(1.0 / 6) *
           (T(0.5) * mu * (squares - T(3)) - mu * change + T(0.5) * (lambda + mu) * change * change);
  }

  using Lane = Pack;
  /// Sides from the first corner, drawn and at rest.
  template <class T>
  struct Local {
    std::array<Vec3T<T>, 3> e, rest;
    T lambda, mu;
  };

  template <class T, class R>
  void gather(const State& state, const Stencil& s, const R* rest, int lane, Local<T>& local) const {
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 3; ++k) {
        set_lane(local.e[i][k], lane, state.q[s.dofs[3 * i + 3 + k]] - state.q[s.dofs[k]]);
        set_lane(local.rest[i][k], lane, rest[3 * i + 3 + k] - rest[k]);
      }
    }
    set_lane(local.lambda, lane, rest[12]);
    set_lane(local.mu, lane, rest[13]);
  }

  template <class T>
  static T energy(const Local<T>& a) {
    return Deformed<T>(a).energy(a);
  }

  template <class T>
  static void derivatives(const Local<T>& a, T* gradient, T* hessian);

  std::vector<Stencil> stencils;

 private:
  /// In the sides e: tr(F'F) = sum over i, j of m_ij e_i e_j with m_ij = grad N_i grad N_j, and J = e_0 (e_1 x e_2) / 6 V0.
  template <class T>
  struct Deformed {
    T volume, per, change;  // V0, 1 / (6 V0), J - 1
    T m00, m11, m22, m10, m20, m21;
    std::array<Vec3T<T>, 3> c;  // dJ / de

    explicit Deformed(const Local<T>& a) {
      const Vec3T<T> n0 = a.rest[1].cross(a.rest[2]), n1 = a.rest[2].cross(a.rest[0]), n2 = a.rest[0].cross(a.rest[1]);
      const T six_volumes = a.rest[0].dot(n0);
      volume = six_volumes * T(1.0 / 6);
      per = T(1) / six_volumes;
      const T per2 = per * per;
      m00 = per2 * n0.dot(n0);
      m11 = per2 * n1.dot(n1);
      m22 = per2 * n2.dot(n2);
      m10 = per2 * n1.dot(n0);
      m20 = per2 * n2.dot(n0);
      m21 = per2 * n2.dot(n1);
      c = {Vec3T<T>(a.e[1].cross(a.e[2]) * per), Vec3T<T>(a.e[2].cross(a.e[0]) * per),
           Vec3T<T>(a.e[0].cross(a.e[1]) * per)};
      change = a.e[0].dot(c[0]) - T(1);
    }

    T energy(const Local<T>& a) const {
      const T squares = m00 * a.e[0].dot(a.e[0]) + m11 * a.e[1].dot(a.e[1]) + m22 * a.e[2].dot(a.e[2]) +
                        T(2) * (m10 * a.e[1].dot(a.e[0]) + m20 * a.e[2].dot(a.e[0]) + m21 * a.e[2].dot(a.e[1]));
      return volume * (T(0.5) * a.mu * (squares - T(3)) - a.mu * change + T(0.5) * (a.lambda + a.mu) * change * change);
    }
  };
};

/// In the sides, with p = V0 ((lambda + mu) (J - 1) - mu):
///   gradient_i = V0 mu sum_j m_ij e_j + p c_i,  hessian_ij = V0 (mu m_ij I + (lambda + mu) c_i c_j') + p d c_i / d e_j,
/// d c_0 / d e_1 = -[e_2]x / 6 V0 and so on round. The first corner follows from translation.
template <class T>
void SolidStretch::derivatives(const Local<T>& a, T* gradient, T* hessian) {
  using V = Vec3T<T>;
  const Deformed<T> d(a);
  const T shear = d.volume * a.mu, bulk = d.volume * (a.lambda + a.mu), p = bulk * d.change - shear;
  const T m[3][3] = {{d.m00, d.m10, d.m20}, {d.m10, d.m11, d.m21}, {d.m20, d.m21, d.m22}};
  for (int i = 0; i < 3; ++i) {
    const V pull = a.e[0] * m[i][0] + a.e[1] * m[i][1] + a.e[2] * m[i][2];
    for (int k = 0; k < 3; ++k) gradient[3 * i + 3 + k] = shear * pull[k] + p * d.c[i][k];
  }
  for (int k = 0; k < 3; ++k) gradient[k] = -(gradient[3 + k] + gradient[6 + k] + gradient[9 + k]);
  if (hessian == nullptr) return;

  T h[3][3][3][3];  // by the sides: [block row][block column][k][l], block column <= block row
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j <= i; ++j) {
      const T along = shear * m[i][j];
      for (int k = 0; k < 3; ++k) {
        const T bulk_c = bulk * d.c[i][k];
        for (int l = 0; l < 3; ++l) h[i][j][k][l] = bulk_c * d.c[j][l];
        h[i][j][k][k] += along;
      }
      if (i == j) continue;
      // Sides i and j follow each other in the cycle 0, 1, 2 where i - j is 1; where it is 2, j comes after i.
      const V w = a.e[3 - i - j] * (i - j == 1 ? p * d.per : -(p * d.per));
      h[i][j][0][1] -= w[2];
      h[i][j][0][2] += w[1];
      h[i][j][1][0] += w[2];
      h[i][j][1][2] -= w[0];
      h[i][j][2][0] -= w[1];
      h[i][j][2][1] += w[0];
    }
  }
  const auto row = [&](int i) { return hessian + i * (i + 1) / 2; };
  for (int k = 0; k < 3; ++k) {
    for (int l = 0; l < 3; ++l) {
      const T from_0 = h[0][0][k][l] + h[1][0][l][k] + h[2][0][l][k];
      const T from_1 = h[1][0][k][l] + h[1][1][k][l] + h[2][1][l][k];
      const T from_2 = h[2][0][k][l] + h[2][1][k][l] + h[2][2][k][l];
      row(3 + k)[l] = -from_0;
      row(6 + k)[l] = -from_1;
      row(9 + k)[l] = -from_2;
      row(6 + k)[3 + l] = h[1][0][k][l];
      row(9 + k)[3 + l] = h[2][0][k][l];
      row(9 + k)[6 + l] = h[2][1][k][l];
      if (l > k) continue;
      row(k)[l] = from_0 + from_1 + from_2;
      for (int i = 0; i < 3; ++i) row(3 * i + 3 + k)[3 * i + 3 + l] = h[i][i][k][l];
    }
  }
}

}  // namespace lissom
