#include "lissom/design/plan_design_space.h"

#include <utility>

#include "lissom/core/assert.h"

namespace lissom {

namespace {

Result<Design> design_of(Model model, const ExpandedPlan& plan) {
  Result<Structure> structure = discretize(model, plan);
  if (!structure) return structure.error();
  Result<System> system = make_system(model, std::move(structure).value());
  if (!system) return system.error();
  return Design{std::move(model), std::move(system).value()};
}

}  // namespace

Result<PlanDesignSpace> PlanDesignSpace::make(const Model& model, const PlanSpaceOptions& options,
                                              const MeshLimits& limits, double refine) {
  Result<PlanSpace> space = PlanSpace::make(model, options);  // checks the plan before it is cut up
  if (!space) return space.error();
  Result<PlanMesh> mesh = PlanMesh::make(model, refine);
  if (!mesh) return mesh.error();
  const auto shared = std::make_shared<const PlanMesh>(std::move(mesh).value());
  return assembled(std::move(space).value(), model, shared, shared->as_made(), limits);
}

Result<PlanDesignSpace> PlanDesignSpace::on_mesh(const Model& model, std::shared_ptr<const PlanMesh> mesh,
                                                 const PlanSpaceOptions& options, const MeshLimits& limits) {
  Result<PlanSpace> space = PlanSpace::make(model, options);
  if (!space) return space.error();
  const Result<ExpandedPlan> plan = mesh->moved_to(model);
  if (!plan) return plan.error();
  return assembled(std::move(space).value(), model, std::move(mesh), plan.value(), limits);
}

Result<PlanDesignSpace> PlanDesignSpace::assembled(PlanSpace space, const Model& model,
                                                   std::shared_ptr<const PlanMesh> mesh, const ExpandedPlan& plan,
                                                   const MeshLimits& limits) {
  Result<Design> base = design_of(model, plan);
  if (!base) return base.error();
  PlanDesignSpace out;
  out.space_ = std::make_shared<const PlanSpace>(std::move(space));
  out.mesh_ = std::move(mesh);
  out.limits_ = limits;
  out.base_ = std::make_shared<const Design>(std::move(base).value());
  return out;
}

Result<Design> PlanDesignSpace::applied(Design design, const VecX& p) const {
  if (Status s = check_bounds(parameters(), p); !s) return s.error();
  Result<Model> model = space_->model_at(design.model, p);
  if (!model) return model.error();
  const MeshFit fit = mesh_->fit(*model.value().plan, limits_);
  if (!fit.good) {
    return Error{ErrorCode::kConflict, "/plan", "the mesh does not fit this plan: " + fit.reason,
                 "move the points less, or go on from here with a mesh made anew"};
  }
  const Result<ExpandedPlan> plan = mesh_->moved_to(model.value());
  if (!plan) return plan.error();
  return design_of(std::move(model).value(), plan.value());
}

DesignJacobian PlanDesignSpace::jacobian(const Design& design, const VecX& p) const {
  (void)p;
  return {space_->rest_inputs(design.model, *mesh_, design.system), {}, {}};
}

VecX PlanDesignSpace::curvature(const Design& design, const VecX& p, const VecX& y, const VecX& v) const {
  (void)p;
  return space_->curvature(design.model, *mesh_, design.system, y, v);
}

}  // namespace lissom
