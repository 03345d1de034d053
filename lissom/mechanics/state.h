#pragma once
/// Configuration of a system: unknowns and their history. Reference frames, twists and joint rotations are part of it:
/// they are copied, saved and restored with it.

#include <span>
#include <vector>

#include "lissom/core/parallel.h"
#include "lissom/core/types.h"
#include "lissom/mechanics/system.h"

namespace lissom {

/// Frame of one edge: tangent, time-parallel reference binormal, material binormal; normals are t x b.
struct EdgeState {
  Vec3 t = Vec3::UnitX();
  Vec3 reference_b = Vec3::UnitY();
  Vec3 b = Vec3::UnitY();
  double length = 0;  ///< m, present

  Frame material() const { return {t, b, t.cross(b)}; }
};

/// Energies, gradients and Hessians of a state are those of the function whose anchors are this state's frames
/// [mathematics 1.2]: a state is always its own anchor.
struct State {
  VecX q;  ///< DofLayout order; the rotation increments of joints are always 0
  std::vector<EdgeState> edges;
  std::vector<double> pair_twist;        ///< rad, per interior vertex, any number of turns
  std::vector<double> connection_twist;  ///< rad, per joint connection, any number of turns
  std::vector<Mat3> joint_rotation;      ///< per joint, of both kinds
  std::vector<Vec3> joint_turn;          ///< rad, per joint: sum of the rotation increments, on which moments do work
  double load_factor = 0;                ///< multiplies proportional loads and prescribed motions

  Vec3 position(int node) const { return q.segment<3>(3 * node); }
};

/// The drawn shape, at load factor 0.
State drawn_state(const System& system);

/// A shape put together: positions of nodes (3 per node, m), directions near which the material normals of the edges lie,
/// rotations of the joints (of corotational ones where shape matching starts from). Reference frames are the material frames,
/// twists those nearest to rest.
State state_of_shape(const System& system, const VecX& positions, std::span<const Vec3> normals,
                     std::span<const Mat3> rotations, double load_factor);

/// `from` moved by dq: positions and rolls add, joint rotations turn by exp([r]), frames are carried along by parallel
/// transport, twists keep their branch. Storage of `to` is reused; `to` may not be `from`. Returns false, with `to`
/// unusable, when an edge vanishes or turns around within the step, or a number is not finite.
[[nodiscard]] bool advance(const System& system, const State& from, const VecX& dq, State& to,
                           ThreadPool* threads = nullptr);

/// Rigid motion x -> R (x - pivot) + pivot + shift of the whole state, frames and joint rotations included.
State rigidly_moved(const System& system, const State& from, const Mat3& rotation, const Vec3& pivot,
                    const Vec3& shift);

/// Largest angle by which dq turns an edge, rad: max |(I - t t') d_e| / length.
double largest_turn(const System& system, const State& state, const VecX& dq);

}  // namespace lissom
