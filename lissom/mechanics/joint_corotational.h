#pragma once
/// Corotational joint of K edges: its rotation follows the edges by shape matching, so every edge feels every other
/// [thesis 3.2.3; Mueller et al. 2005; Barbic and Zhao 2011; mathematics 2.3; errata E8 to E11].
/// Unknowns: the joint's node, then the far node of each edge, then the roll of each edge.

#include "lissom/mechanics/joint_corotational_kernel.h"
#include "lissom/mechanics/joint_explicit.h"
#include "lissom/mechanics/shape_matching.h"

namespace lissom {

template <int K>
struct JointCorotational {
  static constexpr std::string_view kName = "joint_corotational";
  static constexpr std::string_view kCitation = "thesis 3.2.3; Barbic and Zhao 2011; mathematics 2.3";
  static constexpr int kDofs = 3 + 4 * K;
  static constexpr int kRest = K * kConnectionRestCount;
  static constexpr bool kHasHessian = true;

  struct Stencil {
    std::array<int, kDofs> dofs;
    std::array<double, kRest> rest;
    int joint;
    std::array<int, K> connection, edge, direction;
    std::array<Frame, K> rest_frame;
    JointWeights weights;
  };
  struct Frozen {
    CorotationalAnchors anchors;
  };
  Frozen frozen(const State& state, const Stencil& s) const {
    CorotationalAnchors f;
    f.count = K;
    f.weights = s.weights;
    f.rotation = state.joint_rotation[s.joint];
    for (int i = 0; i < K; ++i) {
      const EdgeState& e = state.edges[s.edge[i]];
      f.edge[i] = {e.t, e.reference_b, state.connection_twist[s.connection[i]], s.direction[i], s.rest_frame[i]};
    }
    return {f};
  }

  template <class T>
  static T value(std::span<const T, kDofs> x, std::span<const T, kRest> rest, const Frozen& f) {
    return corotational_value<T>(x.data(), rest.data(), f.anchors);
  }
  /// One dual type serves joints of any number of edges: its instantiation is what costs.
  static constexpr int kDualSize = kCorotationalDualSize;

  using Lane = double;
  template <class T>
  struct Local {
    CorotationalEdge edge[K];
    Mat3 rotation;
  };

  template <class T>
  void gather(const State& state, const Stencil& s, const double* rest, int, Local<T>& local) const {
    local.rotation = state.joint_rotation[s.joint];
    for (int i = 0; i < K; ++i) {
      const EdgeState& e = state.edges[s.edge[i]];
      const double* own = rest + i * kConnectionRestCount;
      local.edge[i] = {{e.t, e.b},
                       s.rest_frame[i],
                       e.length,
                       state.connection_twist[s.connection[i]],
                       s.direction[i],
                       connection_weights<double>(own, s.weights),
                       own};
    }
  }

  template <class T>
  static T energy(const Local<T>& a) {
    return corotational_energy(a.edge, K, a.rotation);
  }

  template <class T>
  static void derivatives(const Local<T>& a, T* gradient, T* hessian) {
    corotational_derivatives(a.edge, K, a.rotation, gradient, hessian);
  }

  std::vector<Stencil> stencils;
};

}  // namespace lissom
