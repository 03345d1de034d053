#pragma once
/// Order of all rest numbers of a structure, and of what they are computed from: two flat lists, so that derivatives can
/// be chained. Rest numbers are those of `RestState` that energies use; rest inputs are places, sections, pre-stretches and
/// moduli, on which a design acts.

#include <span>

#include "lissom/core/types.h"
#include "lissom/mechanics/strain.h"
#include "lissom/mechanics/system.h"

namespace lissom {

/// A pair's rest numbers in the order of PairRestIndex.
template <class T>
void write_pair(const PairRestT<T>& rest, T* out) {
  out[kKappa1] = rest.kappa_1;
  out[kKappa2] = rest.kappa_2;
  out[kRestTwist] = rest.twist;
  out[kBend1] = rest.bend_1;
  out[kBend2] = rest.bend_2;
  out[kTwistStiffness] = rest.twist_stiffness;
  out[kPairLength] = rest.length;
}

enum EdgeNumber { kEdgeLength, kEdgeStretch, kEdgeMass, kEdgeNumbers };
/// Corners along the material axes (two each), moduli, area, and the lengths of the sides that start at each corner.
enum TriangleNumber {
  kCorner = 0,
  kSheetStiffness1 = 6,
  kSheetStiffness2,
  kSheetPoisson,
  kTriangleArea,
  kSide,
  kTriangleNumbers = kSide + 3
};
enum HingeNumber { kHingeStiffness, kHingeAngle, kHingeNumbers };
/// Corners (three each), Lame's parameters, volume.
enum TetrahedronNumber { kTetrahedronCorner = 0, kLambda = 12, kMu, kTetrahedronVolume, kTetrahedronNumbers };

/// A tetrahedron's rest numbers in the order of TetrahedronNumber.
template <class T>
void write_tetrahedron(const TetrahedronRestT<T>& rest, T* out) {
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 3; ++k) out[kTetrahedronCorner + 3 * i + k] = rest.corner[i][k];
  }
  out[kLambda] = rest.lambda;
  out[kMu] = rest.mu;
  out[kTetrahedronVolume] = rest.volume;
}

class RestNumbers {
 public:
  explicit RestNumbers(const Structure& structure)
      : pairs_(kEdgeNumbers * static_cast<int>(structure.edges.size())),
        connections_(pairs_ + kPairRestCount * static_cast<int>(structure.pairs.size())) {
    int count = 0;
    for (const StructureJoint& joint : structure.joints) count += static_cast<int>(joint.connections.size());
    triangles_ = connections_ + kConnectionRestCount * count;
    hinges_ = triangles_ + kTriangleNumbers * static_cast<int>(structure.triangles.size());
    tetrahedra_ = hinges_ + kHingeNumbers * static_cast<int>(structure.hinges.size());
    size_ = tetrahedra_ + kTetrahedronNumbers * static_cast<int>(structure.tetrahedra.size());
  }

  int edge(int e, int number) const { return kEdgeNumbers * e + number; }
  int pair(int p, int number) const { return pairs_ + kPairRestCount * p + number; }
  int connection(int k, int number) const { return connections_ + kConnectionRestCount * k + number; }
  int triangle(int t, int number) const { return triangles_ + kTriangleNumbers * t + number; }
  int hinge(int h, int number) const { return hinges_ + kHingeNumbers * h + number; }
  int tetrahedron(int t, int number) const { return tetrahedra_ + kTetrahedronNumbers * t + number; }
  int size() const { return size_; }

 private:
  int pairs_ = 0, connections_ = 0, triangles_ = 0, hinges_ = 0, tetrahedra_ = 0, size_ = 0;
};

/// Inputs: places of nodes in the drawing (m), half-extents of edges along n and b (m), pre-stretches of membranes along
/// axes 1 and 2, Young's moduli of rods (Pa), their natural lengths over those of the shapes that describe them, and where
/// these are constant natural curvatures towards b and n (1/m) and twist (rad/m); of membranes stiffness 1 and 2 (N/m),
/// Poisson's ratio, thickness (m); of solids Young's modulus (Pa).
class RestInputs {
 public:
  explicit RestInputs(const Structure& structure)
      : extents_(3 * static_cast<int>(structure.nodes.size())),
        rods_(extents_ + 2 * static_cast<int>(structure.edges.size())),
        membranes_(rods_ + kRodInputs * static_cast<int>(structure.rods.size())),
        solids_(membranes_ + kMembraneInputs * static_cast<int>(structure.membranes.size())),
        size_(solids_ + static_cast<int>(structure.solids.size())) {}

  int position(int node) const { return 3 * node; }
  int extent_n(int edge) const { return extents_ + 2 * edge; }
  int extent_b(int edge) const { return extents_ + 2 * edge + 1; }
  int youngs_modulus(int rod) const { return rods_ + kRodInputs * rod; }
  int length_factor(int rod) const { return rods_ + kRodInputs * rod + 1; }
  /// Rate 0, 1, 2: curvature towards b, towards n, twist. 0 and without effect on rods of another natural shape.
  int natural_rate(int rod, int rate) const { return rods_ + kRodInputs * rod + 2 + rate; }
  int pre_stretch(int membrane, int axis) const { return membranes_ + kMembraneInputs * membrane + axis; }
  int sheet_stiffness(int membrane, int axis) const { return membranes_ + kMembraneInputs * membrane + 2 + axis; }
  int sheet_poisson(int membrane) const { return membranes_ + kMembraneInputs * membrane + 4; }
  int thickness(int membrane) const { return membranes_ + kMembraneInputs * membrane + 5; }
  int solid_modulus(int solid) const { return solids_ + solid; }
  int size() const { return size_; }

 private:
  static constexpr int kRodInputs = 5, kMembraneInputs = 6;
  int extents_ = 0, rods_ = 0, membranes_ = 0, solids_ = 0, size_ = 0;
};

/// All rest numbers, in the order of RestNumbers; those of RestState.
VecX rest_number_values(const System& system);

/// All inputs of a system's rest numbers, in the order of RestInputs.
VecX rest_input_values(const Model& model, const System& system);

}  // namespace lissom
