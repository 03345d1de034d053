#pragma once
/// The rest numbers of one tetrahedron as a function of its own few inputs, beside those of rest_pieces.h. Only
/// rest_jacobian.cpp includes this.

#include "lissom/mechanics/rest_pieces.h"

namespace lissom {

/// Inputs: four points, Young's modulus. Outputs: TetrahedronNumber.
struct TetrahedronRestPiece : RestPlaces<13, kTetrahedronNumbers> {
  double multiplier, poisson_ratio;
  TetrahedronRestPiece(const RestSource& s, int t) {
    const StructureTetrahedron& own = s.structure().tetrahedra[t];
    multiplier = own.stiffness;
    poisson_ratio = s.model.material(s.structure().solids[own.solid].material)->poisson_ratio;
    int at = 0;
    for (const int node : own.node) place(at, s, node);
    input[at] = s.inputs.solid_modulus(own.solid);
    for (int i = 0; i < kOutputs; ++i) output[i] = s.numbers.tetrahedron(t, i);
  }
  static int count(const RestSource& s) { return static_cast<int>(s.structure().tetrahedra.size()); }

  template <class T>
  void compute(const RestSource&, const T* in, T* out) const {
    const TetrahedronRestT<T> rest = tetrahedron_rest<T>({point(in), point(in + 3), point(in + 6), point(in + 9)},
                                                         T(multiplier) * in[12], poisson_ratio);
    write_tetrahedron(rest, out);
  }
};

}  // namespace lissom
