#pragma once
/// Stretch of one flat triangle of fabric: orthotropic St. Venant-Kirchhoff energy of the physical Green strain
/// E = 1/2 (F'F - I), constant over the triangle [thesis (3.23)-(3.30); mathematics 3.1, errata E12 to E15],
///   V = A (1/2 c11 E11^2 + 1/2 c22 E22^2 + c12 E11 E22 + 2 G E12^2),
/// with c11 = Y1 / (1 - mu^2), c22 = Y2 / (1 - mu^2), c12 = mu sqrt(Y1 Y2) / (1 - mu^2), G = sqrt(Y1 Y2) / (2 (1 + mu)).
/// Material axes 1 and 2 are the axes of the rest corners, which must run anticlockwise.
///
/// This material gives way below a stretch of 1/sqrt(3): pressed together further, single triangles would vanish, and with
/// them the smoothness of the bending energy. Yarns cannot be pressed to nothing either. So where the area falls below
/// kCrushedArea of the rest area,
///   A k (1 - r)^3 / r,  r = det(F'F) / kCrushedArea^2,  k = kCrushStiffness (c11 + c22)
/// is added, which is twice differentiable, and infinite for a triangle without area.

#include <cmath>

#include "lissom/mechanics/stencil_term.h"

namespace lissom {

/// Moduli of a sheet by its width, N/m.
template <class T>
struct SheetModuli {
  T c11, c22, c12, shear;

  static SheetModuli of(const T& y1, const T& y2, const T& mu) {
    using std::sqrt;
    const T mean = sqrt(y1 * y2), per = T(1) / (T(1) - mu * mu);
    return {y1 * per, y2 * per, mu * mean * per, mean / (T(2) * (T(1) + mu))};
  }
};

/// Second Piola-Kirchhoff tension, N/m, of a Green strain (E11, E22, E12).
template <class T>
struct SheetTension {
  T s11, s22, s12;
};

/// What is added where a triangle is crushed, by its rest area, N/m, and its derivatives by det(F'F).
template <class T>
struct SheetCrush {
  static constexpr double kCrushedArea = 0.32;     // of the rest area
  static constexpr double kCrushStiffness = 0.05;  // 0.7 of that area resists about as much as taut fabric pulls
  static constexpr double kBegin = kCrushedArea * kCrushedArea;

  T energy, first, second;

  /// det(F'F) below kBegin.
  static SheetCrush of(const SheetModuli<T>& c, const T& squared_area) {
    const T k = T(kCrushStiffness) * (c.c11 + c.c22), slope = T(1 / kBegin);
    const T r = squared_area * slope, gap = T(1) - r, per = T(1) / r, ratio = gap * per;
    return {k * gap * gap * ratio, -k * slope * ratio * (T(3) * gap + gap * ratio),
            k * slope * slope * T(2) * per * (T(3) * gap + T(3) * gap * ratio + gap * ratio * ratio)};
  }
};

struct MembraneStretch {
  static constexpr std::string_view kName = "membrane_stretch";
  static constexpr std::string_view kCitation = "orthotropic St. Venant-Kirchhoff sheet; mathematics 3.1";
  static constexpr int kDofs = 9;  // x1, x2, x3 (m)
  /// Rest corners X1, X2, X3 along the material axes (m, two each), Y1, Y2 (N/m), mu.
  static constexpr int kRest = 9;
  static constexpr bool kHasHessian = true;

  struct Stencil {
    std::array<int, kDofs> dofs;
    std::array<double, kRest> rest;
    Vec2 pre_stretch = Vec2::Ones();  ///< by which the rest corners were divided, where it grows with the load
  };
  /// Factors of the rest corners along the axes: 1 unless the pre-stretch grows with the load.
  struct Frozen {
    Vec2 corner;
  };
  Frozen frozen(const State& state, const Stencil& s) const {
    if (scaling == Scaling::kConstant) return {Vec2::Ones()};
    const Vec2 now = Vec2::Ones() + state.load_factor * (s.pre_stretch - Vec2::Ones());
    return {s.pre_stretch.cwiseQuotient(now)};
  }

  template <class T>
  static T value(std::span<const T, kDofs> x, std::span<const T, kRest> rest, const Frozen& f) {
    const T a1 = (rest[2] - rest[0]) * f.corner[0], a2 = (rest[3] - rest[1]) * f.corner[1];
    const T b1 = (rest[4] - rest[0]) * f.corner[0], b2 = (rest[5] - rest[1]) * f.corner[1];
    const T twice_area = a1 * b2 - a2 * b1;
    T f11 = T(0), f22 = T(0), f12 = T(0);
    for (int i = 0; i < 3; ++i) {
      const T d = x[3 + i] - x[i], e = x[6 + i] - x[i];
      const T f1 = (d * b2 - e * a2) / twice_area, f2 = (e * a1 - d * b1) / twice_area;
      f11 += f1 * f1;
      f22 += f2 * f2;
      f12 += f1 * f2;
    }
    const T e11 = T(0.5) * (f11 - T(1)), e22 = T(0.5) * (f22 - T(1)), e12 = T(0.5) * f12;
    const SheetModuli<T> c = SheetModuli<T>::of(rest[6], rest[7], rest[8]);
    T density =
        T(0.5) * c.c11 * e11 * e11 + T(0.5) * c.c22 * e22 * e22 + c.c12 * e11 * e22 + T(2) * c.shear * e12 * e12;
    const T squared_area = f11 * f22 - f12 * f12;
    if (squared_area < T(SheetCrush<T>::kBegin)) density += SheetCrush<T>::of(c, squared_area).energy;
    return T(0.5) * twice_area * density;
  }

  using Lane = Pack;
  template <class T>
  struct Local {
    std::array<T, kDofs> x;
    std::array<T, kRest> rest;
  };

  template <class T, class R>
  void gather(const State& state, const Stencil& s, const R* rest, int lane, Local<T>& local) const {
    for (int i = 0; i < kDofs; ++i) set_lane(local.x[i], lane, state.q[s.dofs[i]]);
    const Frozen f = frozen(state, s);
    for (int i = 0; i < kRest; ++i) set_lane(local.rest[i], lane, i < 6 ? rest[i] * R(f.corner[i % 2]) : rest[i]);
  }

  template <class T>
  static T energy(const Local<T>& a) {
    const Deformed<T> d(a);
    const T density = T(0.5) * (d.s.s11 * d.e11 + d.s.s22 * d.e22 + T(2) * d.s.s12 * d.e12);
    return d.area * (d.crushed ? density + d.crush.energy : density);
  }

  template <class T>
  static void derivatives(const Local<T>& a, T* gradient, T* hessian);

  std::vector<Stencil> stencils;
  Scaling scaling = Scaling::kConstant;

 private:
  /// What value and derivatives share. Shape functions 2 and 3 have the gradients (n21, n22), (n31, n32) by the material
  /// axes; that of shape function 1 is minus their sum.
  template <class T>
  struct Deformed {
    T area, n21, n22, n31, n32;
    T f1[3], f2[3];
    T f11, f22, f12;  // of F'F
    T e11, e22, e12;
    SheetModuli<T> c;
    SheetTension<T> s;    // without what is added where the triangle is crushed
    SheetCrush<T> crush;  // of crushed lanes, 0 in others; only there when `crushed`
    bool crushed;

    explicit Deformed(const Local<T>& a) : c(SheetModuli<T>::of(a.rest[6], a.rest[7], a.rest[8])) {
      const T a1 = a.rest[2] - a.rest[0], a2 = a.rest[3] - a.rest[1];
      const T b1 = a.rest[4] - a.rest[0], b2 = a.rest[5] - a.rest[1];
      const T twice_area = a1 * b2 - a2 * b1, per = T(1) / twice_area;
      area = T(0.5) * twice_area;
      n21 = b2 * per;
      n22 = -b1 * per;
      n31 = -a2 * per;
      n32 = a1 * per;
      f11 = f22 = f12 = T(0);
      for (int i = 0; i < 3; ++i) {
        const T d = a.x[3 + i] - a.x[i], e = a.x[6 + i] - a.x[i];
        f1[i] = d * n21 + e * n31;
        f2[i] = d * n22 + e * n32;
        f11 += f1[i] * f1[i];
        f22 += f2[i] * f2[i];
        f12 += f1[i] * f2[i];
      }
      e11 = T(0.5) * (f11 - T(1));
      e22 = T(0.5) * (f22 - T(1));
      e12 = T(0.5) * f12;
      s = {c.c11 * e11 + c.c12 * e22, c.c22 * e22 + c.c12 * e11, T(2) * c.shear * e12};
      crushed = find_crushed(f11 * f22 - f12 * f12);
    }

    bool find_crushed(const T& squared_area) requires(!std::is_same_v<T, Pack>) {
      if (!(squared_area < T(SheetCrush<T>::kBegin))) return false;
      crush = SheetCrush<T>::of(c, squared_area);
      return true;
    }
    /// Hardly ever any: lane by lane.
    bool find_crushed(const T& squared_area) requires std::is_same_v<T, Pack> {
      bool any = false;
      for (int l = 0; l < kLanes; ++l) any = any || squared_area[l] < SheetCrush<double>::kBegin;
      if (!any) return false;
      crush = {T(0), T(0), T(0)};
      for (int l = 0; l < kLanes; ++l) {
        if (!(squared_area[l] < SheetCrush<double>::kBegin)) continue;
        const auto one = SheetCrush<double>::of({c.c11[l], c.c22[l], c.c12[l], c.shear[l]}, squared_area[l]);
        crush.energy.set(l, one.energy);
        crush.first.set(l, one.first);
        crush.second.set(l, one.second);
      }
      return true;
    }

    /// Tensions with what is added: the derivative of det(F'F) by E is twice the adjugate of F'F.
    SheetTension<T> whole() const {
      if (!crushed) return s;
      const T twice = T(2) * crush.first;
      return {s.s11 + twice * f22, s.s22 + twice * f11, s.s12 - twice * f12};
    }

    /// Adds what is left of the second derivatives by f1 and f2, times the area, for the entries i and j.
    void add_crush(int i, int j, T& k11, T& k22, T& k12, T& k21) const {
      const auto q1 = [&](int n) { return f22 * f1[n] - f12 * f2[n]; };
      const auto q2 = [&](int n) { return f11 * f2[n] - f12 * f1[n]; };
      const T once = T(2) * area * crush.first, twice = T(4) * area * crush.second;
      k11 += twice * q1(i) * q1(j) - once * f2[i] * f2[j];
      k22 += twice * q2(i) * q2(j) - once * f1[i] * f1[j];
      k12 += twice * q1(i) * q2(j) + once * (T(2) * f1[i] * f2[j] - f2[i] * f1[j]);
      k21 += twice * q2(i) * q1(j) + once * (T(2) * f2[i] * f1[j] - f1[i] * f2[j]);
    }
  };
};

template <class T>
void MembraneStretch::derivatives(const Local<T>& a, T* gradient, T* hessian) {
  const Deformed<T> d(a);
  const T *f1 = d.f1, *f2 = d.f2;
  // Moduli and tensions times the area.
  const SheetTension<T> s = d.whole();
  const T s11 = d.area * s.s11, s22 = d.area * s.s22, s12 = d.area * s.s12;
  for (int i = 0; i < 3; ++i) {
    const T p1 = f1[i] * s11 + f2[i] * s12, p2 = f1[i] * s12 + f2[i] * s22;
    gradient[3 + i] = p1 * d.n21 + p2 * d.n22;
    gradient[6 + i] = p1 * d.n31 + p2 * d.n32;
    gradient[i] = -(gradient[3 + i] + gradient[6 + i]);
  }
  if (hessian == nullptr) return;

  // Second derivatives by the columns f1, f2 of F, then by the corners 2 and 3; corner 1 follows from translation.
  const T c11 = d.area * d.c.c11, c22 = d.area * d.c.c22, c12 = d.area * d.c.c12, shear = d.area * d.c.shear;
  const T n22_11 = d.n21 * d.n21, n22_22 = d.n22 * d.n22, n22_12 = d.n21 * d.n22;
  const T n33_11 = d.n31 * d.n31, n33_22 = d.n32 * d.n32, n33_12 = d.n31 * d.n32;
  const T n23_11 = d.n21 * d.n31, n23_22 = d.n22 * d.n32, n23_12 = d.n21 * d.n32, n23_21 = d.n22 * d.n31;
  T h22[3][3], h33[3][3], h23[3][3];  // h23: rows of corner 2, columns of corner 3
  for (int i = 0; i < 3; ++i) {
    const T c11_f1 = c11 * f1[i], c22_f2 = c22 * f2[i], shear_f1 = shear * f1[i], shear_f2 = shear * f2[i];
    const T c12_f1 = c12 * f1[i], c12_f2 = c12 * f2[i];
    for (int j = 0; j <= i; ++j) {
      T k11 = c11_f1 * f1[j] + shear_f2 * f2[j], k22 = c22_f2 * f2[j] + shear_f1 * f1[j];
      T k12 = c12_f1 * f2[j] + shear_f2 * f1[j], k21 = c12_f2 * f1[j] + shear_f1 * f2[j];  // k21 = k12 transposed
      if (d.crushed) d.add_crush(i, j, k11, k22, k12, k21);
      if (i == j) {
        k11 += s11;
        k22 += s22;
        k12 += s12;
        k21 += s12;
      }
      const T sum = k12 + k21;
      h22[i][j] = h22[j][i] = n22_11 * k11 + n22_22 * k22 + n22_12 * sum;
      h33[i][j] = h33[j][i] = n33_11 * k11 + n33_22 * k22 + n33_12 * sum;
      const T even = n23_11 * k11 + n23_22 * k22;
      h23[i][j] = even + n23_12 * k12 + n23_21 * k21;
      h23[j][i] = even + n23_12 * k21 + n23_21 * k12;
    }
  }
  const auto row = [&](int i) { return hessian + i * (i + 1) / 2; };
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const T h21 = -(h22[i][j] + h23[i][j]), h31 = -(h23[j][i] + h33[i][j]);  // columns of corner 1
      if (j <= i) {
        row(i)[j] = h22[i][j] + h23[i][j] + h23[j][i] + h33[i][j];
        row(3 + i)[3 + j] = h22[i][j];
        row(6 + i)[6 + j] = h33[i][j];
      }
      row(3 + i)[j] = h21;
      row(6 + i)[j] = h31;
      row(6 + i)[3 + j] = h23[j][i];
    }
  }
}

}  // namespace lissom
