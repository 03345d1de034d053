#pragma once
/// What a pose holds: which unknowns are left, how prescribed ones move with the load factor, and which motions without
/// any stiffness were taken out, with the reason.

#include <span>
#include <string>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/mechanics/null_motions.h"
#include "lissom/mechanics/potential.h"
#include "lissom/mechanics/state.h"
#include "lissom/model/model.h"

namespace lissom {

class Supports {
 public:
  /// `where` is the JSON pointer of the pose, for errors.
  static Result<Supports> make(const Model& model, const System& system, const Pose& pose, const std::string& where,
                               NullMotions null_motions = NullMotions::kRemove);

  /// Per unknown of the layout (in local axes): its number among the free ones, or -1.
  std::span<const int> kept() const { return kept_; }
  int unknowns() const { return unknowns_; }
  const std::vector<LocalAxes>& local_axes() const { return local_axes_; }
  /// Whether this unknown is held by the pose itself and not by the removal of a null motion: reactions act there.
  bool held_by_pose(int dof) const { return held_[dof]; }

  /// Increment (global axes) that brings every prescribed unknown of `state` to its place at `load_factor`; free
  /// unknowns are 0.
  VecX prescribed_increment(const System& system, const State& state, double load_factor) const;
  /// The same into an existing vector.
  void prescribed_increment(const System& system, const State& state, double load_factor, VecX& dq) const;

  /// How unknowns that are held follow the drawn places of nodes: d held unknowns / d drawn positions, (unknowns x 3 nodes),
  /// rows in local axes. Movements on top of them count as fixed.
  SparseMatrix held_by_places(const System& system) const;
  /// How they follow `move` of the supports, at load factor 1: d held unknowns / d moves, (unknowns x 3 supports of the pose),
  /// rows in local axes.
  SparseMatrix held_by_moves(const System& system) const;
  bool same_held(const Supports& other) const { return held_ == other.held_; }
  /// Holds the same unknowns at the places of `other`, which holds the same ones.
  void take_places(const Supports& other);

  /// Free entries of a vector in local axes, and the other way round (held entries 0).
  void restrict(const VecX& local, VecX& free) const;
  void expand(const VecX& free, VecX& local) const;

  /// One sentence per motion that was taken out because nothing resists it.
  const std::vector<std::string>& removed_motions() const { return removed_; }
  /// Parts (Structure::component) that nothing holds: all their six rigid motions were taken out.
  const std::vector<int>& free_parts() const { return free_parts_; }
  /// Whether anything moves with the load factor.
  bool moves() const;

 private:
  /// A node moved by `move`, or turned with a clamp about `pivot`.
  struct HeldPosition {
    int node;
    Vec3 move = Vec3::Zero();
    Vec3 arm = Vec3::Zero();        ///< m, from the pivot at rest, when turned
    Vec3 turn = Vec3::Zero();       ///< rad at load factor 1
    Mat3 along = Mat3::Identity();  ///< projector onto the directions that this support holds
    int support = -1;               ///< of the pose
    bool moves = true;              ///< by Support::move
  };
  struct HeldRotation {
    int joint;
    Vec3 turn = Vec3::Zero();  ///< rad at load factor 1
  };
  struct HeldRoll {
    int edge;
    Vec3 b = Vec3::Zero();  ///< binormal at rest
    Vec3 turn = Vec3::Zero();
  };

  friend class SupportsBuilder;
  /// d held unknowns / d whatever `column(held)` counts, by three, -1: nothing; (unknowns x columns), rows in local axes.
  template <class Column>
  SparseMatrix held_by(const System& system, int columns, const Column& column) const;
  const LocalAxes* axes_at(int first_dof) const;  ///< null where they are x, y, z

  std::vector<int> kept_;
  std::vector<bool> held_;
  int supports_ = 0;  // of the pose
  int unknowns_ = 0;
  std::vector<LocalAxes> local_axes_;
  std::vector<HeldPosition> positions_;
  std::vector<HeldRotation> rotations_;
  std::vector<HeldRoll> rolls_;
  std::vector<std::string> removed_;
  std::vector<int> free_parts_;
};

}  // namespace lissom
