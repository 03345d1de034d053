#include "lissom/design/live_design.h"

#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "lissom/design/carry_over.h"
#include "lissom/equilibrium/rigid_drift.h"

namespace lissom {

namespace {

bool same_rods(const Plan& a, const Plan& b) {
  if (a.points.size() != b.points.size() || a.rods.size() != b.rods.size()) return false;
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    if (a.points[i].name != b.points[i].name || a.points[i].split != b.points[i].split) return false;
  }
  for (std::size_t r = 0; r < a.rods.size(); ++r) {
    const PlanRod &x = a.rods[r], &y = b.rods[r];
    if (x.name != y.name || x.points != y.points || x.curve != y.curve || x.role != y.role || x.closed != y.closed) {
      return false;
    }
  }
  const auto same_holes = [&] { return a.fabric.holes == b.fabric.holes && a.fabric.outline == b.fabric.outline; };
  return same_holes() && a.edge_length == b.edge_length && a.max_turn == b.max_turn &&
         a.fabric.edge_length == b.fabric.edge_length && a.fabric.min_angle == b.fabric.min_angle;
}

Result<System> system_of(const Model& model, const ExpandedPlan& plan) {
  Result<Structure> structure = discretize(model, plan);
  if (!structure) return structure.error();
  return make_system(model, std::move(structure).value());
}

Status check_editable(const Model& model, int pose, const SolveOptions& solve) {
  if (!model.plan) {
    return Error{ErrorCode::kConflict, "/plan", "there is no plan to edit", "describe the structure by a plan"};
  }
  if (pose < 0 || pose >= static_cast<int>(model.poses.size())) {
    return Error{ErrorCode::kUnknown, "/poses", fmt::format("there is no pose number {}", pose),
                 "choose one of the poses"};
  }
  return solve.validate();
}

}  // namespace

Result<std::unique_ptr<LiveDesign>> LiveDesign::make(const Model& model, int pose, const Options& options,
                                                     const Context& context) {
  if (Status s = check_editable(model, pose, options.solve); !s) return s.error();
  Result<PlanMesh> made = PlanMesh::make(model, options.refine);
  if (!made) return made.error();
  const auto mesh = std::make_shared<const PlanMesh>(std::move(made).value());
  Result<System> system = system_of(model, mesh->as_made());
  if (!system) return system.error();
  std::unique_ptr<LiveDesign> design(new LiveDesign(pose, options, context));
  if (Status s = design->furnish(model, mesh, mesh->as_made(), std::move(system).value()); !s) return s.error();
  design->equilibrium_ = design->solver_->settle(start_state(*design->problem_, design->pose_of(model)), 1);
  return design;
}

Result<std::unique_ptr<LiveDesign>> LiveDesign::at(const Model& model, int pose, std::shared_ptr<const PlanMesh> mesh,
                                                   const State& equilibrium, const Options& options,
                                                   const Context& context) {
  if (Status s = check_editable(model, pose, options.solve); !s) return s.error();
  std::unique_ptr<LiveDesign> design(new LiveDesign(pose, options, context));
  if (Status s = design->take(model, std::move(mesh), equilibrium); !s) return s.error();
  return design;
}

Status LiveDesign::furnish(const Model& model, std::shared_ptr<const PlanMesh> mesh, ExpandedPlan expanded,
                           System system) {
  Result<StaticProblem> problem = make_static_problem(model, system, pose_of(model), place());
  if (!problem) return problem.error();
  solver_.reset();
  problem_.reset();
  model_ = model;
  mesh_ = std::move(mesh);
  expanded_ = std::move(expanded);
  system_ = std::move(system);
  problem_.emplace(std::move(problem).value());
  problem_->system = &system_;
  solver_ = std::make_unique<LiveSolver>(*problem_, options_.solve, context_);
  if (options_.watch) {
    solver_->set_watch([this](const State& state, double residual) { options_.watch(*this, state, residual); });
  }
  return {};
}

Status LiveDesign::take(const Model& model, std::shared_ptr<const PlanMesh> mesh, const State& equilibrium) {
  if (Status s = check_editable(model, pose_, options_.solve); !s) return s;
  Result<ExpandedPlan> expanded = mesh->moved_to(model);
  if (!expanded) return expanded.error();
  Result<System> system = system_of(model, expanded.value());
  if (!system) return system.error();
  if (equilibrium.q.size() != system.value().layout.size() ||
      static_cast<int>(equilibrium.edges.size()) != system.value().edge_count()) {
    return Error{ErrorCode::kConflict, place(), "the kept shape has another mesh than its plan",
                 "release the plan anew"};
  }
  if (Status s = furnish(model, std::move(mesh), std::move(expanded).value(), std::move(system).value()); !s) return s;
  equilibrium_ = solver_->settle(equilibrium, equilibrium.load_factor);
  return {};
}

Result<DesignChange> LiveDesign::change(const Model& changed, const MeshLimits& limits) {
  if (!changed.plan) {
    return Error{ErrorCode::kConflict, "/plan", "the changed model has no plan", "describe the structure by a plan"};
  }
  if (pose_ >= static_cast<int>(changed.poses.size())) {
    return Error{ErrorCode::kUnknown, "/poses", "the changed model has lost the pose that is shown",
                 "keep the pose, or open the design anew"};
  }
  if (!same_rods(*model_.plan, *changed.plan)) return remesh(changed, "points or rods were added or taken away");
  const MeshFit fit = mesh_->fit(*changed.plan, limits);
  return fit.good ? follow(changed) : remesh(changed, fit.reason);
}

Result<DesignChange> LiveDesign::follow(const Model& changed) {
  Result<ExpandedPlan> expanded = mesh_->moved_to(changed);
  if (!expanded) return expanded.error();
  Result<System> system = system_of(changed, expanded.value());
  if (!system) return system.error();
  if (!renew_numbers(changed, pose_of(changed), place(), std::move(system).value(), system_, *problem_)) {
    // Other supports or loads: the mesh is good, but patterns and factors are not.
    return remesh(changed, "supports or loads were changed");
  }
  model_ = changed;
  expanded_ = std::move(expanded).value();
  solver_->renew_terms();
  equilibrium_ = solver_->resettle(equilibrium_.state);
  return DesignChange{false, {}, solver_->following()};
}

Result<DesignChange> LiveDesign::remesh(const Model& changed, std::string reason) {
  Result<PlanMesh> made = PlanMesh::make(changed, options_.refine);
  if (!made) return made.error();
  const auto mesh = std::make_shared<const PlanMesh>(std::move(made).value());
  Result<System> system = system_of(changed, mesh->as_made());
  if (!system) return system.error();
  // The old fabric where the plan is now tells best which point of it is which.
  const bool same = same_rods(*model_.plan, *changed.plan);
  Result<ExpandedPlan> moved = same ? mesh_->moved_to(changed) : Result<ExpandedPlan>(expanded_);
  const PlanStage from{same && moved ? *changed.plan : *model_.plan, moved ? moved.value() : expanded_, system_};
  const CarriedShape start = carried_over(from, equilibrium_.state, {*changed.plan, mesh->as_made(), system.value()});
  if (Status s = furnish(changed, mesh, mesh->as_made(), std::move(system).value()); !s) return s.error();
  equilibrium_ = solver_->settle(start.state, start.state.load_factor, start.strains);
  DesignChange change{true, std::move(reason), {}};
  const int nodes = system_.layout.nodes();
  State laid = start.state;
  lay_down(*problem_, laid);
  change.following.moved = (equilibrium_.state.q - laid.q).head(3 * nodes).norm() / std::sqrt(nodes);
  return change;
}

}  // namespace lissom
