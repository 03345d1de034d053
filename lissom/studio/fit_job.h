#pragma once
/// The job `fit`: from the accepted linear answer to a design whose equilibrium comes nearest to it [mathematics (6.6)].

#include <functional>
#include <memory>
#include <optional>

#include "lissom/core/context.h"
#include "lissom/design/optimizer_state.h"
#include "lissom/design/shape_fit.h"

namespace lissom {

class Desk;

struct FitTask {
  std::shared_ptr<const ShapeResponse> response;
  HardConstraints constraints;
  ShapeTarget target;
  std::shared_ptr<const PlanMesh> mesh;
  std::shared_ptr<const Model> mesh_of;
  int revision = 0;  ///< of the plan that it begins at
};

/// Ends as one step of history, unless the design has become another one in between.
void start_fit(Desk& desk, FitTask task);

struct FitRecord {
  int iteration = 0;
  double distance = 0;  ///< m
  double value = 0;
};
/// Until it is near enough, or no longer gets nearer. `tell`: after each iteration. Nothing: ended by the context.
std::optional<DesignVerdict> run_fit(ShapeFit& fit, const Context& context,
                                     const std::function<void(const FitRecord&)>& tell);

}  // namespace lissom
