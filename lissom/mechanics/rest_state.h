#pragma once
/// Numbers implied by the undeformed shape and the sections: rest lengths, natural strains, stiffnesses, masses.

#include <array>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/model/structure.h"

namespace lissom {

/// Per rod edge. T: double, or a dual where derivatives are wanted.
template <class T>
struct EdgeRestT {
  T length = 0;        ///< m
  T stretch = 0;       ///< E A, N
  T mass = 0;          ///< kg
  T roll_inertia = 0;  ///< kg m^2
  T gyration2 = 0;     ///< m^2, polar second moment of the section over its area
};
using EdgeRest = EdgeRestT<double>;

/// Bending and twist spring of an ordered pair of frames: interior vertex, or rod edge against its joint.
template <class T>
struct PairRestT {
  T kappa_1 = 0, kappa_2 = 0, twist = 0;          ///< natural strains, integrated (dimensionless, rad)
  T bend_1 = 0, bend_2 = 0, twist_stiffness = 0;  ///< B_1, B_2, beta, N m^2
  T length = 0;                                   ///< integration length, m [mathematics 1.4]
};
using PairRest = PairRestT<double>;

/// Per membrane triangle.
template <class T>
struct TriangleRestT {
  std::array<Eigen::Matrix<T, 2, 1>, 3> corner;  ///< m, along the material axes: the drawn corners over the pre-stretch
  T stiffness_1 = 0, stiffness_2 = 0;            ///< N/m
  T poisson_ratio = 0;
  T area = 0;  ///< m^2, at rest
};
using TriangleRest = TriangleRestT<double>;

/// Per edge between two triangles.
template <class T>
struct HingeRestT {
  T stiffness = 0;  ///< N m, D |e|^2 / (A_1 / s_1 + A_2 / s_2) with the multipliers s [mathematics 3.2, erratum E16]
  T angle = 0;      ///< rad
};
using HingeRest = HingeRestT<double>;

/// Per tetrahedron of a solid.
template <class T>
struct TetrahedronRestT {
  std::array<Eigen::Matrix<T, 3, 1>, 4> corner;  ///< m
  T lambda = 0, mu = 0;                          ///< Pa, Lame's parameters
  T volume = 0;                                  ///< m^3
};
using TetrahedronRest = TetrahedronRestT<double>;

/// Rest numbers of a whole structure, in the order of its edges, pairs, and connections (joint by joint).
struct RestState {
  std::vector<EdgeRest> edges;
  std::vector<PairRest> pairs;
  std::vector<PairRest> connections;  ///< natural strains 0; length = half the rest length of the edge (erratum E8)
  std::vector<TriangleRest> triangles;
  std::vector<HingeRest> hinges;  ///< stiffness 0 where a membrane does not resist bending
  std::vector<TetrahedronRest> tetrahedra;
  std::vector<double>
      node_mass;  ///< kg, half of each incident edge, a third of each triangle, a quarter of each tetrahedron
  std::vector<double> node_length;  ///< m, half of each incident edge: where distributed loads go
  std::vector<double> node_area;    ///< m^2, a third of each incident triangle at rest
  std::vector<double> node_volume;  ///< m^3, a quarter of each incident tetrahedron at rest
  double total_mass = 0;            ///< kg
  double mean_edge_length = 0;      ///< m, of rods; of triangles and tetrahedra where there are none
  double max_stretch = 0;           ///< N, largest E A
  double max_tension = 0;           ///< N/m, largest tension of a drawn membrane that only its pre-stretch strains
};

Result<RestState> make_rest_state(const Model& model, const Structure& structure);

}  // namespace lissom
