#pragma once
/// A plan as ordinary rods and one membrane. Rods are polylines in z = 0 with normals along z, natural as drawn; the
/// fabric conforms to every node of every rod, ghosts included, and to no more.
///
/// Names. A rod keeps its name; where split points cut it into several, these are NAME-0, NAME-1, ... in its direction,
/// a closed one starting from its first split point. The membrane is called "fabric". Places on rods and the points of the
/// plan ({"plan_point": NAME}) are selected as usual.

#include <string>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/model/model.h"
#include "lissom/model/plan_sampling.h"
#include "lissom/model/structure.h"

namespace lissom {

inline constexpr const char* kFabricName = "fabric";

struct ExpandedPlan {
  PlanSamples samples;    ///< nodes and pieces of the rods of the plan
  std::vector<Rod> rods;  ///< printed ones, cut at splits; each edge of a polyline is one of the rod
  std::vector<std::vector<int>> rod_vertices;  ///< by rod: the vertex of the fabric at each of its nodes
  Membrane membrane;                           ///< MembraneMesh: nodes of `samples` first, then inner vertices
  std::vector<JointChoice> joints;             ///< balls at the split points
  double smallest_angle = 0;                   ///< rad, of the triangles
  double refine = 1;                           ///< by which the numbers of edges were multiplied
  std::vector<std::string> notes;

  const MembraneMesh& mesh() const { return std::get<MembraneMesh>(membrane.shape); }
};

/// Names of the rods that a plan expands to, in their order.
std::vector<std::string> plan_rod_names(const Plan& plan);

/// Expands `model.plan`, which has to be there. `refine` multiplies the numbers of edges.
Result<ExpandedPlan> expand_plan(const Model& model, double refine = 1);

/// The model with what its plan stands for appended to rods, membranes and joints; the plan stays, for selectors. The
/// appended rods are cut already.
Model with_plan_expanded(const Model& model, const ExpandedPlan& plan);

/// Discretises the model with what its plan was expanded to, as it stands.
Result<Structure> discretize(const Model& model, const ExpandedPlan& plan);

/// Radius of a spline between its control values: never less than a twentieth of the smaller at the ends of the piece.
double least_radius(double start, double end);

}  // namespace lissom
