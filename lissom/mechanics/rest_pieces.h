#pragma once
/// The rest numbers of one edge, pair, connection, triangle or hinge as a function of its own few inputs, for doubles and
/// duals. Only rest_jacobian.cpp includes this.

#include <array>

#include "lissom/mechanics/rest_formulas.h"
#include "lissom/mechanics/rest_numbers.h"
#include "lissom/mechanics/system.h"
#include "lissom/model/membrane_formulas.h"
#include "lissom/model/natural_formulas.h"
#include "lissom/model/section_formulas.h"

namespace lissom {

/// What all pieces below draw from.
struct RestSource {
  const Model& model;
  const System& system;
  RestNumbers numbers;
  RestInputs inputs;

  RestSource(const Model& m, const System& s) : model(m), system(s), numbers(s.structure), inputs(s.structure) {}
  const Structure& structure() const { return system.structure; }
  const StructureRod& rod(int edge) const { return structure().rods[structure().edges[edge].rod]; }
  const Vec3& normal(int edge) const { return structure().edges[edge].natural_normal; }
};

/// Of a rod: E, length factor, three natural rates.
inline constexpr int kRodInputs = 5;

/// Inputs and outputs of one piece: where its local variables come from and its results go.
template <int Inputs, int Outputs>
struct RestPlaces {
  static constexpr int kInputs = Inputs, kOutputs = Outputs;
  std::array<int, Inputs> input;
  std::array<int, Outputs> output;

  void place(int& at, const RestSource& s, int node) {
    for (int c = 0; c < 3; ++c) input[at++] = s.inputs.position(node) + c;
  }
  void section(int& at, const RestSource& s, int edge) {
    input[at++] = s.inputs.extent_n(edge);
    input[at++] = s.inputs.extent_b(edge);
  }
  /// E, length factor, natural rates.
  void rod(int& at, const RestSource& s, int edge) {
    for (int i = 0; i < kRodInputs; ++i) input[at++] = s.inputs.youngs_modulus(s.structure().edges[edge].rod) + i;
  }
};

template <class T>
Vec3T<T> point(const T* x) {
  return {x[0], x[1], x[2]};
}

template <class T>
T distance(const Vec3T<T>& a, const Vec3T<T>& b) {
  using std::sqrt;
  const Vec3T<T> d = b - a;
  return sqrt(d.dot(d));
}

/// x: r_n, r_b.
template <class T>
SectionStiffnessT<T> section_of(const RestSource& s, int edge, const T* x, const T& youngs_modulus) {
  const Section& section = s.structure().edges[edge].section;
  return section_stiffness<T>(section.shape, x[0], x[1], section.wall, youngs_modulus,
                              *s.model.material(s.rod(edge).material), s.model.torsion);
}

/// Rest frame of an edge: its normal is as close to `normal` as the edge allows.
template <class T>
FrameT<T> rest_frame(const Vec3T<T>& x0, const Vec3T<T>& x1, const Vec3& normal) {
  using std::sqrt;
  const Vec3T<T> t = (x1 - x0) * (T(1) / distance<T>(x0, x1));
  const Vec3T<T> b = Vec3T<T>(normal.cast<T>()).cross(t);
  return {t, b * (T(1) / sqrt(b.dot(b)))};
}

/// Rest length of an edge that is described apart from the drawing.
template <class T>
T described_length(const RestSource& s, int edge, const T& length_factor) {
  return length_factor * T(s.structure().edges[edge].rest_length / s.rod(edge).length_factor);
}

/// Inputs: x0, x1, section, rod. Outputs: EdgeNumber.
struct EdgeRestPiece : RestPlaces<8 + kRodInputs, kEdgeNumbers> {
  int edge;
  EdgeRestPiece(const RestSource& s, int e) : edge(e) {
    int at = 0;
    place(at, s, s.structure().edges[e].node0);
    place(at, s, s.structure().edges[e].node1);
    section(at, s, e);
    rod(at, s, e);
    for (int i = 0; i < kOutputs; ++i) output[i] = s.numbers.edge(e, i);
  }
  static int count(const RestSource& s) { return s.system.edge_count(); }

  template <class T>
  void compute(const RestSource& s, const T* in, T* out) const {
    const bool drawn = !s.normal(edge).isZero();
    const T length = drawn ? in[9] * distance<T>(point(in), point(in + 3)) : described_length<T>(s, edge, in[9]);
    const EdgeRestT<T> rest = edge_rest<T>(length, section_of(s, edge, in + 6, in[8]));
    out[kEdgeLength] = rest.length;
    out[kEdgeStretch] = rest.stretch;
    out[kEdgeMass] = rest.mass;
  }
};

/// Inputs: x0, x1, x2, both sections, rod. Outputs: PairRestIndex.
struct PairRestPiece : RestPlaces<13 + kRodInputs, kPairRestCount> {
  int pair;
  PairRestPiece(const RestSource& s, int p) : pair(p) {
    const StructurePair& own = s.structure().pairs[p];
    int at = 0;
    place(at, s, s.structure().edges[own.edge0].node0);
    place(at, s, s.structure().edges[own.edge0].node1);
    place(at, s, s.structure().edges[own.edge1].node1);
    section(at, s, own.edge0);
    section(at, s, own.edge1);
    rod(at, s, own.edge0);
    for (int i = 0; i < kOutputs; ++i) output[i] = s.numbers.pair(p, i);
  }
  static int count(const RestSource& s) { return static_cast<int>(s.structure().pairs.size()); }

  template <class T>
  void compute(const RestSource& s, const T* in, T* out) const {
    const StructurePair& own = s.structure().pairs[pair];
    const SectionStiffnessT<T> s0 = section_of(s, own.edge0, in + 9, in[13]),
                               s1 = section_of(s, own.edge1, in + 11, in[13]);
    const Vec3 &normal = s.normal(own.edge0), &next = s.normal(own.edge1);
    if (normal.isZero()) {
      const T l0 = described_length<T>(s, own.edge0, in[14]), l1 = described_length<T>(s, own.edge1, in[14]);
      Curvature<T> k{T(own.rest_kappa_1), T(own.rest_kappa_2)};
      T twist(own.rest_twist);
      if (s.rod(own.edge0).natural_rates) {
        const T between = (l0 + l1) * T(0.5);
        k = natural_curvature<T>(in[15], in[16], between);
        twist = in[17] * between;
      }
      write_pair(pair_rest<T>(k, twist, l0, l1, s0, s1), out);
      return;
    }
    const Vec3T<T> x0 = point(in), x1 = point(in + 3), x2 = point(in + 6);
    const FrameT<T> first = rest_frame(x0, x1, normal), second = rest_frame(x1, x2, next);
    write_pair(pair_rest<T>(curvature(first, second), twist(first, second, own.rest_twist),
                            in[14] * distance<T>(x0, x1), in[14] * distance<T>(x1, x2), s0, s1),
               out);
  }
};

/// Inputs: x0, x1, section, rod. Outputs: PairRestIndex, then the turn of the rest frame.
struct ConnectionRestPiece : RestPlaces<8 + kRodInputs, kConnectionRestCount> {
  int number, edge;
  ConnectionRestPiece(const RestSource& s, int k) : number(k), edge(s.system.connections[k].edge) {
    int at = 0;
    place(at, s, s.structure().edges[edge].node0);
    place(at, s, s.structure().edges[edge].node1);
    section(at, s, edge);
    rod(at, s, edge);
    for (int i = 0; i < kOutputs; ++i) output[i] = s.numbers.connection(k, i);
  }
  static int count(const RestSource& s) { return static_cast<int>(s.system.connections.size()); }

  template <class T>
  void compute(const RestSource& s, const T* in, T* out) const {
    const SectionStiffnessT<T> section = section_of(s, edge, in + 6, in[8]);
    const Vec3& normal = s.normal(edge);
    for (int i = 0; i < 3; ++i) out[kRestTurn + i] = T(0);
    if (!normal.isZero()) {
      const Vec3T<T> x0 = point(in), x1 = point(in + 3);
      write_pair(connection_rest<T>(in[9] * distance<T>(x0, x1), section), out);
      write_turn(s, rest_frame(x0, x1, normal), out);
      return;
    }
    const T length = described_length<T>(s, edge, in[9]);
    write_pair(connection_rest<T>(length, section), out);
    if (s.rod(edge).natural_rates) write_turn(s, natural_frame<T>(s, in + 10, length), out);
  }

  /// The frame half an edge away from the joint, for these natural rates.
  template <class T>
  FrameT<T> natural_frame(const RestSource& s, const T* rates, const T& length) const {
    const double side = s.system.connections[number].direction;
    const Vec3& present = *s.rod(edge).natural_rates;
    const double half = side * 0.5 * s.structure().edges[edge].rest_length;
    const Curvature<double> back = natural_curvature<double>(present[0], present[1], -half);
    const Frame& before = s.system.connections[number].rest;
    const FrameT<double> joint = advanced<double>({before.t, before.b}, back, -present[2] * half);
    const T away = length * T(0.5 * side);
    return advanced<T>({joint.t.cast<T>(), joint.b.cast<T>()}, natural_curvature<T>(rates[0], rates[1], away),
                       rates[2] * away);
  }

  /// The axial vector of F F0' is the rotation vector but for terms of third order.
  template <class T>
  void write_turn(const RestSource& s, const FrameT<T>& now, T* out) const {
    const Frame& before = s.system.connections[number].rest;
    const Vec3T<T> axial = (Vec3T<T>(before.t.cast<T>()).cross(now.t) + Vec3T<T>(before.b.cast<T>()).cross(now.b) +
                            Vec3T<T>(before.n.cast<T>()).cross(now.n())) *
                           T(0.5);
    for (int i = 0; i < 3; ++i) out[kRestTurn + i] = axial[i];
  }
};

/// Rest shape of a triangle; in: three points; sheet: pre-stretches, stiffnesses, Poisson's ratio; `multiplier`: of the
/// stiffnesses.
template <class T>
TriangleRestT<T> triangle_of(const StructureMembrane& membrane, const std::array<Vec3T<T>, 3>& x, const T* sheet,
                             double multiplier) {
  return triangle_rest<T>(material_corners<T>(x, membrane.warp_angle), sheet[0], sheet[1], T(multiplier) * sheet[2],
                          T(multiplier) * sheet[3], sheet[4]);
}

inline void sheet_inputs(const RestSource& s, int membrane, int* input) {
  for (int axis = 0; axis < 2; ++axis) {
    input[axis] = s.inputs.pre_stretch(membrane, axis);
    input[2 + axis] = s.inputs.sheet_stiffness(membrane, axis);
  }
  input[4] = s.inputs.sheet_poisson(membrane);
}

/// Inputs: three points, pre-stretches, stiffnesses, Poisson's ratio. Outputs: TriangleNumber.
struct TriangleRestPiece : RestPlaces<14, kTriangleNumbers> {
  int membrane;
  double multiplier;
  TriangleRestPiece(const RestSource& s, int t)
      : membrane(s.structure().triangles[t].membrane), multiplier(s.structure().triangles[t].stiffness) {
    int at = 0;
    for (const int node : s.structure().triangles[t].node) place(at, s, node);
    sheet_inputs(s, membrane, input.data() + at);
    for (int i = 0; i < kOutputs; ++i) output[i] = s.numbers.triangle(t, i);
  }
  static int count(const RestSource& s) { return static_cast<int>(s.structure().triangles.size()); }

  template <class T>
  void compute(const RestSource& s, const T* in, T* out) const {
    using std::sqrt;
    const TriangleRestT<T> rest = triangle_of<T>(s.structure().membranes[membrane],
                                                 {point(in), point(in + 3), point(in + 6)}, in + 9, multiplier);
    for (int i = 0; i < 3; ++i) {
      out[kCorner + 2 * i] = rest.corner[i].x();
      out[kCorner + 2 * i + 1] = rest.corner[i].y();
      const Eigen::Matrix<T, 2, 1> side = rest.corner[(i + 1) % 3] - rest.corner[i];
      out[kSide + i] = sqrt(side.dot(side));
    }
    out[kSheetStiffness1] = rest.stiffness_1;
    out[kSheetStiffness2] = rest.stiffness_2;
    out[kSheetPoisson] = rest.poisson_ratio;
    out[kTriangleArea] = rest.area;
  }
};

/// Inputs: the hinge's four points, pre-stretches, stiffnesses, Poisson's ratio, thickness. Outputs: HingeNumber.
struct HingeRestPiece : RestPlaces<18, kHingeNumbers> {
  int hinge;
  HingeRestPiece(const RestSource& s, int h) : hinge(h) {
    const StructureHinge& own = s.structure().hinges[h];
    int at = 0;
    for (const int node : own.node) place(at, s, node);
    sheet_inputs(s, own.membrane, input.data() + at);
    input[at + 5] = s.inputs.thickness(own.membrane);
    for (int i = 0; i < kOutputs; ++i) output[i] = s.numbers.hinge(h, i);
  }
  static int count(const RestSource& s) { return static_cast<int>(s.structure().hinges.size()); }

  template <class T>
  void compute(const RestSource& s, const T* in, T* out) const {
    const StructureHinge& own = s.structure().hinges[hinge];
    const StructureMembrane& membrane = s.structure().membranes[own.membrane];
    const Vec3T<T> x0 = point(in), x1 = point(in + 3), x2 = point(in + 6), x3 = point(in + 9);
    const T* sheet = in + 12;
    const TriangleRestT<T> left = triangle_of<T>(membrane, {x0, x1, x2}, sheet, 1);
    const TriangleRestT<T> right = triangle_of<T>(membrane, {x1, x0, x3}, sheet, 1);
    const T bend = T(membrane.bending) * sheet_bend(sheet[2], sheet[3], sheet[4], sheet[5]);
    const T angle = membrane.rest_folds == RestFolds::kAsDrawn ? fold_angle(x0, x1, x2, x3) : T(0);
    const HingeRestT<T> rest = hinge_rest(left, 0, right, bend, multipliers(s.structure(), own), angle);
    out[kHingeStiffness] = rest.stiffness;
    out[kHingeAngle] = rest.angle;
  }
};

}  // namespace lissom
