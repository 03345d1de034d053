#pragma once
/// A plan with its mesh as a design space: radii and places of control points and the pre-stretch, on the triangles that the
/// plan was first cut into [mathematics 6.2]. What does not fit these triangles is no design of this space.

#include <memory>

#include "lissom/core/result.h"
#include "lissom/design/design_space.h"
#include "lissom/design/plan_mesh.h"
#include "lissom/design/plan_space.h"

namespace lissom {

class PlanDesignSpace final : public DesignSpace {
 public:
  /// Of the plan of `model`, on a mesh of its own.
  static Result<PlanDesignSpace> make(const Model& model, const PlanSpaceOptions& options,
                                      const MeshLimits& limits = {}, double refine = 1);
  /// The same on a mesh that there is, of a plan with the same points and rods. kConflict where it does not fit.
  static Result<PlanDesignSpace> on_mesh(const Model& model, std::shared_ptr<const PlanMesh> mesh,
                                         const PlanSpaceOptions& options, const MeshLimits& limits = {});

  std::span<const Parameter> parameters() const override { return space_->parameters(); }
  VecX start() const override { return space_->values(*base_->model.plan); }
  /// kConflict, with what became of which rod or triangle, where the mesh does not fit the plan.
  Result<Design> at(const VecX& p) const override { return applied(*base_, p); }
  /// `design`: another state of the base, of which all that is not in the plan is kept as its model describes it.
  Result<Design> applied(Design design, const VecX& p) const override;
  DesignJacobian jacobian(const Design& design, const VecX& p) const override;
  VecX curvature(const Design& design, const VecX& p, const VecX& y, const VecX& v) const override;

  /// The design as drawn: what other spaces have to be made for, to be combined with this one.
  const std::shared_ptr<const Design>& base() const { return base_; }
  const std::shared_ptr<const PlanMesh>& mesh() const { return mesh_; }

 private:
  PlanDesignSpace() = default;
  static Result<PlanDesignSpace> assembled(PlanSpace space, const Model& model, std::shared_ptr<const PlanMesh> mesh,
                                           const ExpandedPlan& plan, const MeshLimits& limits);

  std::shared_ptr<const Design> base_;
  std::shared_ptr<const PlanSpace> space_;
  std::shared_ptr<const PlanMesh> mesh_;
  MeshLimits limits_;
};

}  // namespace lissom
