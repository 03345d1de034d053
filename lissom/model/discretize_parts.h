#pragma once
/// Steps of `discretize` that share data; nobody else includes this.
///
/// Frames at nodes. Edge frames live at mid-edge, joints and clamps at nodes, half an edge away. A connection at rest is
///   rest = N_drawn N_rest^T F_rest,
/// N_drawn: material frame of the drawn curve at the node, N_rest: the same of the rest curve, F_rest: rest frame of the
/// edge. So the joint is glued to the drawn rod with the half-edge strain that the rod has at rest, which keeps clamps of
/// curved rods second-order accurate. As-drawn rods: rest = drawn edge frame, strain zero as drawn. Straight rods: rest =
/// N_drawn, tangent to the drawn curve at the node (a straight rod closed to a circle and clamped leaves the clamp along
/// the circle's tangent). Node tangents are those of the smooth curve; polylines have the direction of the edge itself.

#include <cstdint>
#include <string>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/geometry/frame.h"
#include "lissom/model/model.h"
#include "lissom/model/structure.h"

namespace lissom {

/// A rod cut into edges, drawn or at rest.
struct RodShape {
  std::vector<Vec3> points;         ///< m, (nodes x 3)
  std::vector<Vec3> node_tangents;  ///< unit (nodes x 3); empty: those of the edges
  std::vector<Vec3> edge_tangents;  ///< unit (edges x 3)
  std::vector<double> lengths;      ///< m (edges)
  std::vector<Frame> frames;        ///< (edges)
  bool closed = false;

  int edges() const { return static_cast<int>(lengths.size()); }
};

/// Everything known during discretisation.
struct Draft {
  const Model& model;
  Structure structure;
  std::vector<RodShape> drawn;          ///< by rod, on the merged nodes
  std::vector<RodShape> rest;           ///< by rod; empty unless the rest shape is a curve of its own
  std::vector<MembraneMesh> membranes;  ///< cut into triangles, on the points of the shape
  std::vector<int> passages;            ///< by node: how many rod ends and through-going rods meet there
  std::vector<Vec3> joint_normals;      ///< by node, zero where no rod with axes from joints ends
  size_t cut_rods_from = SIZE_MAX;      ///< rods from this one on come from the plan and are cut already
};

/// Error place of a rod, "/rods/3", and its name for messages.
std::string rod_place(size_t rod);
std::string rod_label(const Model& model, size_t rod);

/// Fills lengths and edge tangents from the points; kGeometry when an edge has no length or doubles back on the one before.
Status measure_edges(RodShape& shape, const std::string& where, const std::string& label);

/// discretize_nodes.cpp: numbers the nodes in the order of rods, membranes, solids; points within the merge distance become
/// the first of them.
Status merge_nodes(Draft& draft);

/// discretize_frames.cpp: material frames of the edges. `start`, `end`: joint normals, for MaterialAxes::kJoints.
/// Remarks (parallel directions, flips) are appended to `notes`, at most one per rod.
void set_frames(RodShape& shape, const MaterialAxes& axes, const Vec3& start, const Vec3& end, const std::string& label,
                std::vector<std::string>& notes);

/// The direction that the normal of each edge is to have, of axes that name directions; empty for others.
std::vector<Vec3> directions_of_normals(const RodShape& shape, const MaterialAxes& axes);

/// Whether a tangent is too close to a direction for that to give a normal.
bool parallel(const Vec3& tangent, const Vec3& normal);

/// Material frame of the curve at the start (or end) of an edge; the twist between neighbouring edges is shared out.
Frame node_frame(const RodShape& shape, int edge, bool at_end);

/// discretize_joint_normals.cpp: normals at the ends of rods whose axes come from joints [mathematics 2.4].
void set_joint_normals(Draft& draft);

/// discretize_rest.cpp: rest lengths, rest frames.
Status set_rest_shapes(Draft& draft);

/// Rest strain of the pair (edge, next edge) of a rod, local edge numbers.
PairStrain rest_strain(const Draft& draft, int rod, int edge, int next);

/// Frame of the connection edge at rest; see the top of this file.
Frame connection_rest(const Draft& draft, int rod, int edge, bool at_end);

/// discretize_joints.cpp: joints of the network and of the poses, and the pairs that no joint replaces.
Status set_joints_and_pairs(Draft& draft);

/// discretize_membranes.cpp: cuts membranes into triangles; then, on merged nodes, their triangles and hinges.
Status cut_membranes(Draft& draft, double refine);
Status set_membranes(Draft& draft);

/// discretize_solids.cpp: refuses what no solid can be; then, on merged nodes, their tetrahedra.
Status check_solids(const Draft& draft);
Status set_solids(Draft& draft);

/// discretize_supports.cpp: refuses poses in which a later support takes back the movement of an earlier one.
Status check_supports(const Draft& draft);

/// discretize_notes.cpp: remarks on turning angles, and on rod ends that lie on a rod or next to one without a joint.
void note_turning_angles(Draft& draft);
void note_loose_ends(Draft& draft);

/// The frame that makes `strain` with `first`, the inverse of pair_strain. Advancing by the negative strain goes back.
Frame advanced(const Frame& first, const PairStrain& strain);

}  // namespace lissom
