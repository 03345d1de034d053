#include "lissom/equilibrium/start_smoothing.h"

#include <cmath>
#include <utility>

#include "lissom/equilibrium/edge_laplacian.h"
#include "lissom/geometry/frame.h"

namespace lissom {

namespace {

constexpr double kLongest = 3, kShortest = 1.0 / 3;  // times the rest length
constexpr double kMostTurn = 2;                      // rad, beyond the natural angle, between two edges
constexpr double kMostTwist = 2;                     // rad, beyond the natural twist, between two edges
constexpr int kParts = 8;                            // an edge must not turn around within one part of a move

/// Increments of the free joint rotations that turn every joint to the frames of its edges as they are.
VecX joint_turns(const StaticProblem& problem, const State& state) {
  const System& system = *problem.system;
  VecX dq = VecX::Zero(system.layout.size());
  for (int j = 0; j < system.joint_count(); ++j) {
    const int r = system.layout.rotation(j);
    if (r < 0 || problem.supports.kept()[r] < 0) continue;
    Mat3 covariance = 1e-3 * state.joint_rotation[j];  // decides where the edges leave a choice
    for (int k = system.first_connection[j]; k < system.first_connection[j + 1]; ++k) {
      const Connection& c = system.connections[k];
      const Frame now = state.edges[c.edge].material();
      covariance += now.t * c.rest.t.transpose() + now.b * c.rest.b.transpose() + now.n * c.rest.n.transpose();
    }
    dq.segment<3>(r) = vector_from_rotation(nearest_rotation(covariance) * state.joint_rotation[j].transpose());
  }
  return dq;
}

/// `state` moved by dq in parts, joints turned along; the last parts are left out when an edge vanishes on the way.
State moved_by(const StaticProblem& problem, const State& state, const VecX& dq) {
  const System& system = *problem.system;
  State at = state, next;
  const VecX part = dq / kParts;
  for (int k = 0; k < kParts && advance(system, at, part, next); ++k) {
    if (!advance(system, next, joint_turns(problem, next), at)) std::swap(at, next);
  }
  return at;
}

}  // namespace

bool is_crumpled(const System& system, const State& state) {
  for (int e = 0; e < system.edge_count(); ++e) {
    const double ratio = state.edges[e].length / system.rest.edges[e].length;
    if (!(ratio < kLongest) || !(ratio > kShortest)) return true;
  }
  const auto crumpled = [](const Vec3& t0, const Vec3& t1, double twist, const PairRest& rest) {
    const double natural = 2 * std::atan(0.5 * std::hypot(rest.kappa_1, rest.kappa_2));
    const double turn = std::atan2(t0.cross(t1).norm(), t0.dot(t1));
    return turn > natural + kMostTurn || std::abs(twist - rest.twist) > kMostTwist;
  };
  const Structure& structure = system.structure;
  for (size_t p = 0; p < structure.pairs.size(); ++p) {
    const StructurePair& pair = structure.pairs[p];
    if (crumpled(state.edges[pair.edge0].t, state.edges[pair.edge1].t, state.pair_twist[p], system.rest.pairs[p])) {
      return true;
    }
  }
  for (size_t k = 0; k < system.connections.size(); ++k) {
    const Connection& c = system.connections[k];
    const Vec3 held = state.joint_rotation[c.joint] * c.rest.t;
    if (crumpled(held, state.edges[c.edge].t, state.connection_twist[k], system.rest.connections[k])) return true;
  }
  return false;
}

State smoothed_start(const StaticProblem& problem, const State& state) {
  const System& system = *problem.system;
  const State drawn = drawn_state(system);
  const int nodes = system.layout.nodes();
  // Displacements u of the state; the free ones give way to (K + pull W) v = pull W u, K the edges' Laplacian.
  VecX u = VecX::Zero(system.layout.size());
  u.head(3 * nodes) = state.q.head(3 * nodes) - drawn.q.head(3 * nodes);
  VecX held = u;
  problem.potential.to_local(held);
  for (int i = 0; i < 3 * nodes; ++i) {
    if (problem.supports.kept()[i] >= 0) held[i] = 0;
  }
  problem.potential.to_global(held);

  EdgeLaplacian laplacian(problem);
  const double size = system.structure.size;
  VecX right_side = VecX::Zero(u.size()), v = VecX::Zero(u.size());
  State result = drawn;
  for (double reach = system.rest.mean_edge_length; reach < 1e4 * size; reach *= 2) {
    const double pull = 1 / (reach * reach);
    if (!laplacian.factorize(pull)) break;
    right_side.setZero();
    for (int i = 0; i < nodes; ++i) {
      right_side.segment<3>(3 * i) = pull * system.rest.node_length[i] * (u.segment<3>(3 * i) - held.segment<3>(3 * i));
    }
    // What the held ones pull along.
    for (int e = 0; e < system.edge_count(); ++e) {
      const StructureEdge& edge = system.structure.edges[e];
      const Vec3 difference =
          laplacian.weights()[e] * (held.segment<3>(3 * edge.node1) - held.segment<3>(3 * edge.node0));
      right_side.segment<3>(3 * edge.node0) += difference;
      right_side.segment<3>(3 * edge.node1) -= difference;
    }
    laplacian.solve(right_side, v);
    v += held;
    result = moved_by(problem, drawn, v);
    if (!is_crumpled(system, result)) break;
  }
  result.load_factor = state.load_factor;
  return result;
}

}  // namespace lissom
