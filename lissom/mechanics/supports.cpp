#include "lissom/mechanics/supports.h"

#include <cmath>
#include <map>
#include <numbers>

#include "lissom/core/assert.h"
#include "lissom/geometry/frame.h"
#include "lissom/mechanics/supports_builder.h"

namespace lissom {

Result<Supports> Supports::make(const Model& model, const System& system, const Pose& pose, const std::string& where,
                                NullMotions null_motions) {
  SupportsBuilder builder(model, system, pose, where);
  return builder.build(null_motions);
}

VecX Supports::prescribed_increment(const System& system, const State& state, double load_factor) const {
  VecX dq;
  prescribed_increment(system, state, load_factor, dq);
  return dq;
}

void Supports::prescribed_increment(const System& system, const State& state, double load_factor, VecX& dq) const {
  dq.setZero(system.layout.size());
  const auto masked = [&](int first, const Vec3& wanted) {
    // Only along the held axes.
    Vec3 step = wanted;
    if (const LocalAxes* local = axes_at(first); local != nullptr) {
      Vec3 in_axes = local->axes.transpose() * wanted;
      for (int i = 0; i < 3; ++i) {
        if (!held_[first + i]) in_axes[i] = 0;
      }
      return Vec3(local->axes * in_axes);
    }
    for (int i = 0; i < 3; ++i) {
      if (!held_[first + i]) step[i] = 0;
    }
    return step;
  };
  for (const HeldPosition& held : positions_) {
    const int at = system.layout.position(held.node);
    const Mat3 rotation = rotation_from_vector(load_factor * held.turn);
    const Vec3 target = system.structure.nodes[held.node] + load_factor * held.move + rotation * held.arm - held.arm;
    const Vec3 wanted = masked(at, target - state.q.segment<3>(at)), others = dq.segment<3>(at);
    dq.segment<3>(at) += held.along * (wanted - others);
  }
  for (const HeldRotation& held : rotations_) {
    const int at = system.layout.rotation(held.joint);
    // First the known change of the prescribed turn (any number of turns), then what is left to its exact value.
    const Vec3 change = (load_factor - state.load_factor) * held.turn;
    const Mat3 target = rotation_from_vector(load_factor * held.turn);
    const Mat3 reached = rotation_from_vector(change) * state.joint_rotation[held.joint];
    bool all = true;
    for (int i = 0; i < 3; ++i) all = all && held_[at + i];
    const Vec3 rest = all ? vector_from_rotation(target * reached.transpose()) : Vec3(Vec3::Zero());
    dq.segment<3>(at) = masked(at, rest.norm() < 1e-12 ? change : Vec3(change + rest));
  }
  for (const HeldRoll& held : rolls_) {
    const int at = system.layout.roll(held.edge);
    if (held.turn.isZero()) {
      dq[at] = -state.q[at];
      continue;
    }
    // The material binormal turns rigidly with the clamp; the reference frame is carried by parallel transport.
    const StructureEdge& edge = system.structure.edges[held.edge];
    const Mat3 rotation = rotation_from_vector(load_factor * held.turn);
    const Vec3 t = (rotation * (system.structure.nodes[edge.node1] - system.structure.nodes[edge.node0])).normalized();
    const EdgeState& now = state.edges[held.edge];
    const Vec3 reference = parallel_transport(now.t, t, now.reference_b);
    const double angle = signed_angle(t, reference, rotation * held.b);
    const double expected = state.q[at] + (load_factor - state.load_factor) * held.turn.dot(t);
    dq[at] = expected + wrap_angle(angle - expected) - state.q[at];
  }
}

const LocalAxes* Supports::axes_at(int first_dof) const {
  for (const LocalAxes& local : local_axes_) {
    if (local.first_dof == first_dof) return &local;
  }
  return nullptr;
}

template <class Column>
SparseMatrix Supports::held_by(const System& system, int columns, const Column& column) const {
  // By node and column, in global axes; later supports of a node act on what earlier ones left.
  std::map<int, std::map<int, Mat3>> by_node;
  for (const HeldPosition& held : positions_) {
    const int at = system.layout.position(held.node);
    const LocalAxes* local = axes_at(at);
    const Mat3 axes = local == nullptr ? Mat3(Mat3::Identity()) : local->axes;
    const Vec3 mask(held_[at] ? 1 : 0, held_[at + 1] ? 1 : 0, held_[at + 2] ? 1 : 0);
    std::map<int, Mat3>& follows = by_node[held.node];
    for (auto& [other, matrix] : follows) matrix -= held.along * matrix;
    if (const int own = column(held); own >= 0) {
      follows.try_emplace(own, Mat3::Zero()).first->second +=
          held.along * (axes * mask.asDiagonal() * axes.transpose());
    }
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& [node, follows] : by_node) {
    const int at = system.layout.position(node);
    const LocalAxes* local = axes_at(at);
    for (const auto& [first, matrix] : follows) {
      const Mat3 rows = local == nullptr ? matrix : Mat3(local->axes.transpose() * matrix);
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
          if (rows(i, j) != 0) entries.emplace_back(at + i, first + j, rows(i, j));
        }
      }
    }
  }
  SparseMatrix matrix(system.layout.size(), columns);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

SparseMatrix Supports::held_by_places(const System& system) const {
  return held_by(system, 3 * system.layout.nodes(), [](const HeldPosition& held) { return 3 * held.node; });
}

SparseMatrix Supports::held_by_moves(const System& system) const {
  return held_by(system, 3 * supports_, [](const HeldPosition& held) { return held.moves ? 3 * held.support : -1; });
}

void Supports::take_places(const Supports& other) {
  LISSOM_ASSERT(other.held_ == held_);
  positions_ = other.positions_;
  rotations_ = other.rotations_;
  rolls_ = other.rolls_;
}

void Supports::restrict(const VecX& local, VecX& free) const {
  free.resize(unknowns_);
  for (int i = 0; i < static_cast<int>(kept_.size()); ++i) {
    if (kept_[i] >= 0) free[kept_[i]] = local[i];
  }
}

void Supports::expand(const VecX& free, VecX& local) const {
  local.resize(static_cast<int>(kept_.size()));
  for (int i = 0; i < static_cast<int>(kept_.size()); ++i) local[i] = kept_[i] >= 0 ? free[kept_[i]] : 0;
}

bool Supports::moves() const {
  for (const HeldPosition& p : positions_) {
    if (!p.move.isZero() || !p.turn.isZero()) return true;
  }
  for (const HeldRotation& r : rotations_) {
    if (!r.turn.isZero()) return true;
  }
  return false;
}

}  // namespace lissom
