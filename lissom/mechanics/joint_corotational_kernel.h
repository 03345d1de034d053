#pragma once
/// Closed-form derivatives of the corotational joint for any number of edges [mathematics 2.3].

#include <array>

#include "lissom/geometry/frame.h"
#include "lissom/mechanics/strain.h"
#include "lissom/model/model.h"

namespace lissom {

/// Weights of tangents, normals and binormals in shape matching, from the rest numbers of a connection.
template <class T>
struct ConnectionWeights {
  T t, n, b;
};

/// kEnergy: the weights with which sum w_t |t - R tbar|^2 + w_n |n - R nbar|^2 + w_b |b - R bbar|^2 resists a small
/// rotation about n, b, t with B_1, B_2, beta over the half edge, as the springs of the joint do. The matched rotation is
/// then, to first order, the one that minimises their energy: the joint is as soft as an explicit one. Tangents and
/// normals alone (erratum E10) can match two of the three stiffnesses only; see docs/energies/joints.md.
template <class T>
ConnectionWeights<T> connection_weights(const T* rest, JointWeights kind) {
  if (kind == JointWeights::kThesis) return {rest[kBend1] + rest[kBend2], rest[kTwistStiffness], T(0)};
  const T per_length = T(0.5) / rest[kPairLength];
  return {(rest[kBend1] + rest[kBend2] - rest[kTwistStiffness]) * per_length,
          (rest[kTwistStiffness] + rest[kBend2] - rest[kBend1]) * per_length,
          (rest[kTwistStiffness] + rest[kBend1] - rest[kBend2]) * per_length};
}

/// Joints of 2 to this many edges can be corotational.
inline constexpr int kMaxCorotationalEdges = 8;
/// Active variables of the automatic derivatives: all unknowns of the largest joint and five rest quantities.
inline constexpr int kCorotationalDualSize = 3 + 4 * kMaxCorotationalEdges + 5;

/// History of one joint and its edges, constant while the unknowns vary.
struct CorotationalAnchors {
  struct Edge {
    Vec3 t = Vec3::UnitX(), reference_b = Vec3::UnitY();
    double twist = 0;
    int direction = 1;
    Frame rest_frame;
  };
  int count = 0;
  std::array<Edge, kMaxCorotationalEdges> edge;
  Mat3 rotation = Mat3::Identity();
  JointWeights weights = JointWeights::kEnergy;
};

/// Frames of the edges, and the frames that the joint holds against them, by the same unknowns and numbers as below; count
/// each. T is double, or TracedDual at the anchor.
template <class T>
void corotational_frames(const T* x, const T* rest, const CorotationalAnchors& anchors, FrameT<T>* edge,
                         FrameT<T>* held);

/// Energy by (joint node, far nodes, rolls) and the connections' rest numbers; T is double,
/// Dual2<kCorotationalDualSize>, or TracedDual at the anchor.
template <class T>
T corotational_value(const T* x, const T* rest, const CorotationalAnchors& anchors);

/// One edge of a corotational joint in a state.
struct CorotationalEdge {
  FrameT<double> frame;
  Frame rest_frame;
  double length, twist;
  int direction;
  ConnectionWeights<double> weight;
  const double* rest;  ///< PairRestIndex order
};

double corotational_energy(const CorotationalEdge* edges, int count, const Mat3& rotation);

/// Gradient (3 + 4 count) by (joint node, far nodes, rolls) and, unless null, the lower triangle of the Hessian by rows.
void corotational_derivatives(const CorotationalEdge* edges, int count, const Mat3& rotation, double* gradient,
                              double* hessian);

}  // namespace lissom
