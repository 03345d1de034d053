#pragma once
/// Bending of a sheet at the edge x0-x1 between the triangles (x0, x1, x2) and (x1, x0, x3): the discrete shell
/// V = k/2 (theta - theta0)^2 with k = D |e|^2 / (A1 + A2) of the rest shape [Grinspun et al. 2003; mathematics 3.2,
/// erratum E16]. theta > 0: the triangles fold away from their normals; it stays within (-pi, pi].

#include <cmath>

#include "lissom/mechanics/stencil_term.h"
#include "lissom/mechanics/strain.h"
#include "lissom/model/membrane_formulas.h"

namespace lissom {

struct MembraneBend {
  static constexpr std::string_view kName = "membrane_bend";
  static constexpr std::string_view kCitation = "Grinspun et al. 2003; mathematics 3.2";
  static constexpr int kDofs = 12;  // x0, x1 of the edge, x2 on its left, x3 on its right (m)
  static constexpr int kRest = 2;   // stiffness k (N m), rest angle theta0 (rad)
  static constexpr bool kHasHessian = true;

  struct Stencil {
    std::array<int, kDofs> dofs;
    std::array<double, kRest> rest;
  };
  struct Frozen {};
  Frozen frozen(const State&, const Stencil&) const { return {}; }

  template <class T>
  static T value(std::span<const T, kDofs> x, std::span<const T, kRest> rest, const Frozen&) {
    const auto at = [&](int i) { return Vec3T<T>(x[i], x[i + 1], x[i + 2]); };
    const T change = fold_angle<T>(at(0), at(3), at(6), at(9)) - rest[1];
    return T(0.5) * rest[0] * change * change;
  }

  using Lane = Pack;
  template <class T>
  struct Local {
    Vec3T<T> e, u, v;  // from x0 to x1, x2, x3
    T stiffness, rest_angle;
  };

  template <class T, class R>
  void gather(const State& state, const Stencil& s, const R* rest, int lane, Local<T>& local) const {
    for (int i = 0; i < 3; ++i) {
      const double x0 = state.q[s.dofs[i]];
      set_lane(local.e[i], lane, state.q[s.dofs[3 + i]] - x0);
      set_lane(local.u[i], lane, state.q[s.dofs[6 + i]] - x0);
      set_lane(local.v[i], lane, state.q[s.dofs[9 + i]] - x0);
    }
    set_lane(local.stiffness, lane, rest[0]);
    set_lane(local.rest_angle, lane, rest[1]);
  }

  template <class T>
  static T energy(const Local<T>& a) {
    const T change = Fold<T>(a).angle() - a.rest_angle;
    return T(0.5) * a.stiffness * change * change;
  }

  template <class T>
  static void derivatives(const Local<T>& a, T* gradient, T* hessian);

  std::vector<Stencil> stencils;

 private:
  /// The two triangles seen from their edge: unit tangent t, unit normals m, and per triangle the inverse of its height
  /// above the edge and where along the edge the foot of the height is (0 at x0, 1 at x1).
  template <class T>
  struct Fold {
    Vec3T<T> t, m1, m2;
    T per_length, per_height1, per_height2, foot1, foot2;

    explicit Fold(const Local<T>& a) {
      using std::sqrt;
      const T length = sqrt(a.e.dot(a.e));
      per_length = T(1) / length;
      t = a.e * per_length;
      const Vec3T<T> normal1 = t.cross(a.u), normal2 = a.v.cross(t);
      per_height1 = T(1) / T(sqrt(normal1.dot(normal1)));
      per_height2 = T(1) / T(sqrt(normal2.dot(normal2)));
      m1 = normal1 * per_height1;
      m2 = normal2 * per_height2;
      foot1 = a.u.dot(t) * per_length;
      foot2 = a.v.dot(t) * per_length;
    }
    T angle() const {
      using std::atan2;
      const Vec3T<T> turn = m1.cross(m2);
      return atan2(t.dot(turn), m1.dot(m2));
    }
  };
};

/// In the vectors e, u, v from x0 the angle has the gradient
///   theta_u = -m1 / h1,  theta_v = -m2 / h2,  theta_e = -(foot1 theta_u + foot2 theta_v),
/// and, with w the unit vector from the edge into a triangle and W = (m w' + w m') / h^2, the second derivatives
///   theta_uu = W1,  theta_uv = 0,  theta_ue = -foot1 W1 + t m1' / (l h1),
///   theta_ee = sum over both of foot^2 W - foot (t m' + m t') / (l h) + m w' / l^2.
template <class T>
void MembraneBend::derivatives(const Local<T>& a, T* gradient, T* hessian) {
  using V = Vec3T<T>;
  const Fold<T> f(a);
  const T moment = a.stiffness * (f.angle() - a.rest_angle);
  const V gu = f.m1 * -f.per_height1, gv = f.m2 * -f.per_height2;
  const V ge = gu * -f.foot1 - gv * f.foot2;
  for (int i = 0; i < 3; ++i) {
    gradient[3 + i] = moment * ge[i];
    gradient[6 + i] = moment * gu[i];
    gradient[9 + i] = moment * gv[i];
    gradient[i] = -(gradient[3 + i] + gradient[6 + i] + gradient[9 + i]);
  }
  if (hessian == nullptr) return;

  const V w1 = f.m1.cross(f.t), w2 = f.t.cross(f.m2);
  const T scale1 = moment * f.per_height1 * f.per_height1, scale2 = moment * f.per_height2 * f.per_height2;
  const T slope1 = moment * f.per_length * f.per_height1, slope2 = moment * f.per_length * f.per_height2;
  const T across = moment * f.per_length * f.per_length;
  const V along = f.m1 * (slope1 * f.foot1) + f.m2 * (slope2 * f.foot2);
  const V ke = ge * a.stiffness, ku = gu * a.stiffness, kv = gv * a.stiffness;
  T h[3][3][3][3];  // by e, u, v: [block row][block column][i][j], block column <= block row
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const T big_w1 = scale1 * (f.m1[i] * w1[j] + w1[i] * f.m1[j]);
      const T big_w2 = scale2 * (f.m2[i] * w2[j] + w2[i] * f.m2[j]);
      h[0][0][i][j] = f.foot1 * f.foot1 * big_w1 + f.foot2 * f.foot2 * big_w2 - f.t[i] * along[j] - along[i] * f.t[j] +
                      across * (f.m1[i] * w1[j] + f.m2[i] * w2[j]) + ke[i] * ge[j];
      h[1][0][i][j] = slope1 * f.t[i] * f.m1[j] - f.foot1 * big_w1 + ku[i] * ge[j];
      h[2][0][i][j] = slope2 * f.t[i] * f.m2[j] - f.foot2 * big_w2 + kv[i] * ge[j];
      h[1][1][i][j] = big_w1 + ku[i] * gu[j];
      h[2][1][i][j] = kv[i] * gu[j];
      h[2][2][i][j] = big_w2 + kv[i] * gv[j];
    }
  }
  const auto row = [&](int i) { return hessian + i * (i + 1) / 2; };
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      // Column sums of the block rows: moving x0 alone moves e, u and v by the opposite.
      const T from_e = h[0][0][i][j] + h[1][0][j][i] + h[2][0][j][i];
      const T from_u = h[1][0][i][j] + h[1][1][i][j] + h[2][1][j][i];
      const T from_v = h[2][0][i][j] + h[2][1][i][j] + h[2][2][i][j];
      row(3 + i)[j] = -from_e;
      row(6 + i)[j] = -from_u;
      row(9 + i)[j] = -from_v;
      row(6 + i)[3 + j] = h[1][0][i][j];
      row(9 + i)[3 + j] = h[2][0][i][j];
      row(9 + i)[6 + j] = h[2][1][i][j];
      if (j > i) continue;
      row(i)[j] = from_e + from_u + from_v;
      row(3 + i)[3 + j] = h[0][0][i][j];
      row(6 + i)[6 + j] = h[1][1][i][j];
      row(9 + i)[9 + j] = h[2][2][i][j];
    }
  }
}

}  // namespace lissom
