#pragma once
/// The mesh on which a plan is computed while its control points move: kept while its triangles and edges stay good, made
/// anew when they do not [mathematics 6.2].

#include <string>

#include "lissom/mechanics/system.h"
#include "lissom/model/moved_plan.h"

namespace lissom {

/// From when on a mesh no longer fits.
struct MeshLimits {
  double angle_ratio = 0.6;   ///< smallest angle of a triangle over what it was when the mesh was made
  double length_ratio = 1.3;  ///< length of a rod edge over what it was, or the other way round
  double turn_ratio = 1.5;    ///< turn of a rod from edge to edge over what the plan allows
};

/// Whether a mesh still fits the plan.
struct MeshFit {
  bool good = true;
  std::string reason;  ///< in words, when it is not
};

class PlanMesh {
 public:
  /// Of the plan of `model`.
  static Result<PlanMesh> make(const Model& model, double refine = 1);

  const ExpandedPlan& as_made() const { return made_; }
  const PlanMap& map() const { return map_; }

  MeshFit fit(const Plan& plan, const MeshLimits& limits) const;

  /// The plan of `model`, which has the points and rods of the one that the mesh was made for, on this mesh.
  Result<ExpandedPlan> moved_to(const Model& model) const { return moved_plan(model, made_, map_); }

 private:
  PlanMesh(ExpandedPlan made, PlanMap map) : made_(std::move(made)), map_(std::move(map)) {}

  ExpandedPlan made_;
  PlanMap map_;
};

}  // namespace lissom
