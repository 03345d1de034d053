#pragma once
/// One situation of a structure: what is held, moved and loaded, and along which path of the load factor.

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lissom/core/types.h"
#include "lissom/model/selector.h"

namespace lissom {

enum class SupportKind {
  kPin,        ///< position held, rotation free
  kClamp,      ///< position and frame held; the rod springs from the clamp frame over half an edge (second order)
  kClampEdge,  ///< the end edge held: both its nodes and its roll; the free length starts at its middle
  kFree,       ///< only the listed directions and rotations are held
  kSymmetry,   ///< mirror plane: no displacement along `normal`, no rotation about axes in the plane
};

/// Prescribed kinematics of a set of nodes. Displacements and rotations are reached at load factor 1 and are
/// proportional to the load factor in between and beyond.
struct Support {
  Selector at;
  SupportKind kind = SupportKind::kPin;
  std::vector<Vec3> directions;  ///< kFree: unit vectors along which the displacement is held (at most 3, orthogonal)
  std::vector<Vec3> rotations;   ///< kFree: unit axes about which the rotation is held (needs a frame at the node)
  bool roll = false;             ///< kFree: roll angles of all edges between selected nodes are held
  Vec3 normal = Vec3::UnitZ();   ///< kSymmetry
  Vec3 move = Vec3::Zero();      ///< m, displacement at load factor 1 (components along free directions are ignored)
  std::optional<double> move_inwards;  ///< m, displacement towards the centroid of the set, in addition to `move`
  double shrink = 0;  ///< share by which the distance to the centroid of the set has become less at load factor 1
  /// Linear map F that takes drawn places X to F X at load factor 1, in addition to `move`.
  Mat3 deform = Mat3::Identity();
  Vec3 turn_axis = Vec3::UnitZ();
  double turn_angle = 0;  ///< rad at load factor 1; any number of turns
};

/// Soft pin: V = 1/2 stiffness |x - target|^2.
struct SoftPin {
  Selector at;
  double stiffness = 0;        ///< N/m
  std::optional<Vec3> target;  ///< m; where the node is drawn when absent
};

enum class Scaling {
  kProportional,  ///< multiplied by the load factor
  kConstant,      ///< acts in full at every load factor
};

struct PointForce {
  Selector at;
  Vec3 force = Vec3::Zero();  ///< N, dead load on each selected node
  bool shared = false;        ///< true: `force` is the sum over the set, split equally
  Scaling scaling = Scaling::kProportional;
};

struct PointMoment {
  Selector at;
  Vec3 moment = Vec3::Zero();  ///< N m, axes fixed in space
  Scaling scaling = Scaling::kProportional;
};

struct LineLoad {
  std::vector<std::string> rods;         ///< empty: all
  Vec3 force_per_length = Vec3::Zero();  ///< N per m of rest length, dead
  Scaling scaling = Scaling::kProportional;
};

/// Dead load along the rim of membranes: on the edges whose ends are both selected, half of it at each end.
struct EdgeLoad {
  Selector at;
  Vec3 force_per_length = Vec3::Zero();  ///< N per m of rest length
  Scaling scaling = Scaling::kProportional;
};

struct Gravity {
  Vec3 acceleration = Vec3(0, 0, -9.81);  ///< m/s^2
  Scaling scaling = Scaling::kProportional;
};

/// Load factors that `path` visits.
struct LoadPath {
  double from = 0;
  double to = 1;
  int steps = 10;  ///< recorded states; the solver subdivides on its own
  enum class Follow { kLoad, kArcLength } follow = Follow::kLoad;
  bool stop_at_critical = false;
  bool switch_branch = false;  ///< continue on the bifurcating branch at the first bifurcation
};

/// A shape to start from instead of the drawn one, for structures that start at a critical point.
struct Seed {
  enum class Shape {
    kBump,    ///< half-sine along each rod, or the sag of a net between what is held
    kSaddle,  ///< a smooth polynomial without symmetry, mostly a saddle, over the plan [convergence 4]
  };
  Shape shape = Shape::kBump;
  Vec3 direction = Vec3::UnitZ();
  double amplitude = 0;  ///< m, largest height; 0: the drawn shape itself
};

/// Form finding of membranes: their rest shape is renewed until nothing moves (equilibrium/form_finding.h).
struct FormFinding {
  int rounds = 200;         ///< at most
  double tolerance = 1e-6;  ///< largest movement across the membrane in a round, over the size of the structure
};

/// Rigid motions that no support prevents.
enum class RigidMotion {
  kRemoveNeutral,  ///< taken out where the loads do no work on them, so that nothing could tell one place from another
  kRemove,  ///< also taken out where the loads balance but prefer one orientation (small-load studies of free parts)
};

struct Pose {
  std::string name;
  RigidMotion rigid_motion = RigidMotion::kRemoveNeutral;
  std::vector<Support> supports;
  std::vector<SoftPin> soft_pins;
  std::vector<PointForce> forces;
  std::vector<PointMoment> moments;
  std::vector<LineLoad> line_loads;
  std::vector<EdgeLoad> edge_loads;
  std::optional<Gravity> gravity;
  /// Proportional: at load factor f a pre-stretch s is 1 + f (s - 1), so that a path finds where the flat shape buckles.
  Scaling stretch_scaling = Scaling::kConstant;
  std::optional<LoadPath> path;
  /// Absent: none, but a flat plan with rods on pre-stretched membranes starts from a saddle of 5 % of its extent towards
  /// +z: the flat shape is an exact saddle point of the energy. Of two mirror images this one is found.
  std::optional<Seed> seed;
  std::optional<FormFinding> form_finding;
  /// Every node and roll stays where it is drawn: energies and internal forces of a prescribed shape.
  bool frozen = false;
};

}  // namespace lissom
