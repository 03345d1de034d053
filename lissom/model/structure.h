#pragma once
/// A discretised model: nodes, edges, interior vertices and joints, with the numbers of the drawn and the rest shape.
/// Still without DoFs: `DofLayout` numbers them, `RestState` turns sections and rest shapes into stiffnesses.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/core/types.h"
#include "lissom/geometry/frame.h"
#include "lissom/model/model.h"

namespace lissom {

/// One straight edge of a rod, from node0 to node1 in the direction of the rod.
struct StructureEdge {
  int node0 = -1, node1 = -1;
  int rod = -1;
  double rest_length = 0;  ///< m
  Section section;         ///< at the middle of the edge
  Frame drawn;             ///< material frame of the drawn shape
  Frame rest;              ///< material frame of the rest shape; equals `drawn` up to a rigid motion per rod
  /// The direction that the normal follows, as near as the edge allows, on a rod that is natural as drawn with normals
  /// from directions; zero elsewhere. What has one follows its drawing by formulas alone.
  Vec3 natural_normal = Vec3::Zero();
};

/// An interior vertex of a rod: edge0 arrives, edge1 leaves. Absent where a joint cuts the rod.
struct StructurePair {
  int edge0 = -1, edge1 = -1;
  double rest_kappa_1 = 0, rest_kappa_2 = 0;  ///< integrated natural curvature, dimensionless [mathematics 1.3]
  double rest_twist = 0;                      ///< rad
};

/// One rod edge held by a joint. Relative rest orientation = rest frame of the edge seen from the joint.
struct JointConnection {
  int edge = -1;
  int direction = 1;  ///< +1: the edge leaves the joint in rod direction, -1: it arrives
  Frame rest;         ///< frame of the connection edge when the joint rotation is the identity
};

/// A point where rod ends meet, or a rod end or interior node that needs a frame (clamps, moments, prescribed turns).
struct StructureJoint {
  int node = -1;
  JointKind kind = JointKind::kExplicit;  ///< never kBall
  bool from_pose = false;                 ///< exists only because a pose holds, turns or loads the frame here
  std::vector<JointConnection> connections;
};

struct StructureRod {
  std::string name;
  std::string material;    ///< name
  std::vector<int> nodes;  ///< edges + 1 entries, or as many as edges when closed
  std::vector<int> edges;
  bool closed = false;
  double length_factor = 1;  ///< natural length over that of the shape that describes it
  /// Natural curvatures towards b and n (1/m) and twist (rad/m) of a rod with constant ones; nothing for others.
  std::optional<Vec3> natural_rates;
};

/// One flat piece of a membrane.
struct StructureTriangle {
  std::array<int, 3> node{-1, -1, -1};  ///< anticlockwise seen from the side of the normal
  int membrane = -1;
  /// m, corners of the drawn triangle along the material axes 1 and 2; at rest they are divided by the pre-stretch.
  std::array<Vec2, 3> corner;
  double stiffness = 1, density = 1;  ///< multipliers of the membrane's material
};

/// An edge between two triangles of a membrane: node0 -> node1, node2 in the triangle on its left, node3 on its right.
struct StructureHinge {
  std::array<int, 4> node{-1, -1, -1, -1};
  int membrane = -1;
  std::array<int, 2> triangle{-1, -1};  ///< left, right
  double rest_angle = 0;                ///< rad, 0 for membranes drawn in a plane
};

struct StructureMembrane {
  std::string name;
  std::string material;             ///< name
  Vec2 pre_stretch = Vec2::Ones();  ///< along axes 1 and 2
  double warp_angle = 0;            ///< rad, from x to axis 1 in the drawing
  double bending = 1;               ///< multiplier of the bending stiffness
  RestFolds rest_folds = RestFolds::kAsDrawn;
  std::vector<int> nodes;  ///< of each vertex of the shape, in its order
  int first_triangle = 0, triangles = 0;
};

/// One piece of a solid.
struct StructureTetrahedron {
  std::array<int, 4> node{-1, -1, -1, -1};  ///< (b - a) x (c - a) points to d
  int solid = -1;
  double stiffness = 1, density = 1;  ///< multipliers of the solid's material
};

struct StructureSolid {
  std::string name;
  std::string material;    ///< name
  std::vector<int> nodes;  ///< of each point of the solid, in its order
  int first_tetrahedron = 0, tetrahedra = 0;
};

struct Structure {
  std::vector<Vec3> nodes;  ///< m, drawn positions (n x 3)
  std::vector<StructureEdge> edges;
  std::vector<StructurePair> pairs;
  std::vector<StructureJoint> joints;
  std::vector<StructureRod> rods;
  std::vector<StructureTriangle> triangles;
  std::vector<StructureHinge> hinges;
  std::vector<StructureMembrane> membranes;
  std::vector<StructureTetrahedron> tetrahedra;
  std::vector<StructureSolid> solids;
  std::vector<int> component;  ///< connected part of each node, 0-based
  int components = 0;
  double size = 0;                 ///< m, diagonal of the bounding box of the drawn shape
  double mean_edge_length = 0;     ///< m
  std::vector<std::string> notes;  ///< remarks worth telling the user (turning angles above 20 degrees, ...)

  int rod_index(std::string_view name) const;  ///< -1 when unknown
};

/// Cuts the rods into edges, merges shared points, sets up frames, joints and rest strains. `refine` multiplies every
/// number of edges (convergence studies).
Result<Structure> discretize(const Model& model, double refine = 1);

/// Node numbers of a selection, ascending, without repeats. An empty selection is an error naming `where`.
Result<std::vector<int>> select(const Model& model, const Structure& structure, const Selector& selector,
                                const std::string& where);

/// The strains of an ordered pair of frames [mathematics 1.3]: integrated curvatures and the twist in (-pi, pi].
struct PairStrain {
  double kappa_1 = 0, kappa_2 = 0, twist = 0;
};
PairStrain pair_strain(const Frame& first, const Frame& second);

}  // namespace lissom
