#include "lissom/mechanics/state.h"

#include <atomic>
#include <cmath>
#include <numbers>

#include "lissom/geometry/frame.h"
#include "lissom/mechanics/shape_matching.h"

namespace lissom {

namespace {

constexpr int kGrain = 512;

/// Twist between two frames near an expected value: full turns follow the expectation.
double unwrapped_twist(const Vec3& t1, const Vec3& b1, const Vec3& t2, const Vec3& b2, double expected) {
  const Vec3 carried = parallel_transport(t1, t2, b1);
  const double change = signed_angle(t2, carried, b2) - expected;
  return expected + (std::abs(change) < std::numbers::pi ? change : wrap_angle(change));
}

Frame connection_frame(const Connection& c, const Mat3& rotation) { return rotated(rotation, c.rest); }

double connection_twist(const Connection& c, const Mat3& rotation, const EdgeState& edge, double expected) {
  const Frame held = connection_frame(c, rotation);
  return c.direction > 0 ? unwrapped_twist(held.t, held.b, edge.t, edge.b, expected)
                         : unwrapped_twist(edge.t, edge.b, held.t, held.b, expected);
}

}  // namespace

State state_of_shape(const System& system, const VecX& positions, std::span<const Vec3> normals,
                     std::span<const Mat3> rotations, double load_factor) {
  const Structure& structure = system.structure;
  State state;
  state.q = VecX::Zero(system.layout.size());
  state.q.head(3 * system.layout.nodes()) = positions;
  state.load_factor = load_factor;
  state.edges.reserve(structure.edges.size());
  for (int i = 0; i < system.edge_count(); ++i) {
    const Vec3 e = state.position(structure.edges[i].node1) - state.position(structure.edges[i].node0);
    const double length = e.norm();
    const Frame frame = frame_from_normal(e / length, normals[i]);
    state.edges.push_back({frame.t, frame.b, frame.b, length});
  }
  state.joint_rotation.assign(rotations.begin(), rotations.end());
  state.joint_turn.assign(structure.joints.size(), Vec3::Zero());
  for (int j = 0; j < system.joint_count(); ++j) {
    if (structure.joints[j].kind == JointKind::kCorotational) {
      state.joint_rotation[j] = matched_rotation(system, j, state.edges, rotations[j]);
    }
  }
  for (int p = 0; p < static_cast<int>(structure.pairs.size()); ++p) {
    const EdgeState &first = state.edges[structure.pairs[p].edge0], &second = state.edges[structure.pairs[p].edge1];
    // The branch next to the rest twist: a rod drawn in its rest shape is not a full turn away from it.
    state.pair_twist.push_back(unwrapped_twist(first.t, first.b, second.t, second.b, structure.pairs[p].rest_twist));
  }
  for (const Connection& c : system.connections) {
    state.connection_twist.push_back(connection_twist(c, state.joint_rotation[c.joint], state.edges[c.edge], 0));
  }
  return state;
}

State drawn_state(const System& system) {
  const Structure& structure = system.structure;
  VecX positions(3 * system.layout.nodes());
  for (int i = 0; i < system.layout.nodes(); ++i) positions.segment<3>(3 * i) = structure.nodes[i];
  std::vector<Vec3> normals;
  for (const StructureEdge& edge : structure.edges) normals.push_back(edge.drawn.n);
  return state_of_shape(system, positions, normals, std::vector<Mat3>(structure.joints.size(), Mat3::Identity()), 0);
}

bool advance(const System& system, const State& from, const VecX& dq, State& to, ThreadPool* threads) {
  const Structure& structure = system.structure;
  const DofLayout& layout = system.layout;
  to.load_factor = from.load_factor;
  to.q = from.q;
  to.q.head(3 * layout.nodes() + layout.edges()) += dq.head(3 * layout.nodes() + layout.edges());
  to.edges.resize(from.edges.size());
  to.pair_twist.resize(from.pair_twist.size());
  to.connection_twist.resize(from.connection_twist.size());
  to.joint_rotation.resize(from.joint_rotation.size());
  to.joint_turn = from.joint_turn;

  std::atomic<bool> usable{true};
  parallel_for(threads, layout.edges(), kGrain, [&](int begin, int end) {
    for (int i = begin; i < end; ++i) {
      const StructureEdge& edge = structure.edges[i];
      const EdgeState& old = from.edges[i];
      const Vec3 e = to.q.segment<3>(3 * edge.node1) - to.q.segment<3>(3 * edge.node0);
      const double length = e.norm();
      if (!(length > 1e-9 * edge.rest_length) || !std::isfinite(length)) {
        usable = false;
        return;
      }
      EdgeState& now = to.edges[i];
      now.length = length;
      now.t = e / length;
      if (old.t.dot(now.t) < -0.999) {
        usable = false;
        return;
      }
      Vec3 b = parallel_transport(old.t, now.t, old.reference_b);
      b -= now.t * now.t.dot(b);
      now.reference_b = b.normalized();
      const double theta = to.q[layout.roll(i)];
      now.b = std::cos(theta) * now.reference_b + std::sin(theta) * now.t.cross(now.reference_b);
      if (!std::isfinite(theta)) usable = false;
    }
  });
  if (!usable) return false;

  const auto turned_by = [&](int edge) { return dq[layout.roll(edge)]; };
  parallel_for(threads, static_cast<int>(structure.pairs.size()), kGrain, [&](int begin, int end) {
    for (int p = begin; p < end; ++p) {
      const StructurePair& pair = structure.pairs[p];
      const EdgeState &first = to.edges[pair.edge0], &second = to.edges[pair.edge1];
      const double expected = from.pair_twist[p] + turned_by(pair.edge1) - turned_by(pair.edge0);
      to.pair_twist[p] = unwrapped_twist(first.t, first.b, second.t, second.b, expected);
    }
  });
  for (int j = 0; j < system.joint_count(); ++j) {
    const int r = layout.rotation(j);
    if (r >= 0) {
      const Vec3 turn = dq.segment<3>(r);
      if (!turn.allFinite()) return false;
      // Re-orthonormalised through the quaternion, so that a long history does not drift off the rotations.
      const Eigen::Quaterniond rotation(rotation_from_vector(turn) * from.joint_rotation[j]);
      to.joint_rotation[j] = rotation.normalized().toRotationMatrix();
      to.joint_turn[j] += turn;
    } else {
      to.joint_rotation[j] = matched_rotation(system, j, to.edges, from.joint_rotation[j]);
    }
  }
  for (int k = 0; k < static_cast<int>(system.connections.size()); ++k) {
    const Connection& c = system.connections[k];
    const int r = layout.rotation(c.joint);
    const double held = r >= 0 ? dq.segment<3>(r).dot(to.edges[c.edge].t) : 0;
    const double expected = from.connection_twist[k] + c.direction * (turned_by(c.edge) - held);
    to.connection_twist[k] = connection_twist(c, to.joint_rotation[c.joint], to.edges[c.edge], expected);
  }
  return true;
}

State rigidly_moved(const System& system, const State& from, const Mat3& rotation, const Vec3& pivot,
                    const Vec3& shift) {
  State to = from;
  for (int i = 0; i < system.layout.nodes(); ++i) {
    to.q.segment<3>(3 * i) = rotation * (from.position(i) - pivot) + pivot + shift;
  }
  for (EdgeState& edge : to.edges) {
    edge.t = rotation * edge.t;
    edge.reference_b = rotation * edge.reference_b;
    edge.b = rotation * edge.b;
  }
  for (Mat3& r : to.joint_rotation) r = rotation * r;
  return to;
}

double largest_turn(const System& system, const State& state, const VecX& dq) {
  double largest2 = 0;
  for (int i = 0; i < system.edge_count(); ++i) {
    const StructureEdge& edge = system.structure.edges[i];
    const Vec3 de = dq.segment<3>(3 * edge.node1) - dq.segment<3>(3 * edge.node0);
    const Vec3& t = state.edges[i].t;
    const double l = state.edges[i].length;
    largest2 = std::max(largest2, (de.squaredNorm() - std::pow(t.dot(de), 2)) / (l * l));
  }
  return std::sqrt(largest2);
}

}  // namespace lissom
