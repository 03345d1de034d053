#include <utility>
#include <vector>

#include "lissom/core/assert.h"
#include "lissom/design/structure_problem.h"

namespace lissom {

Result<bool> StructureProblem::stiffen_pins(const VecX& factors) {
  LISSOM_ASSERT(factors.size() == pin_factors_.size() && factors.minCoeff() > 0);
  const Result<Design> changed = design_at(p_, pin_factors_.cwiseProduct(factors));
  if (!changed) return changed.error();
  const std::vector<PoseEnd> ends = follow(changed.value());
  bool any = false;
  Eigen::Index at = 0;  // residuals are in the order of the poses
  for (std::size_t k = 0; k < poses_.size(); ++k) {
    const auto i = static_cast<Eigen::Index>(k);
    const bool settled = ends[k].outcome == Outcome::kSettled;
    double before = 0, after = 0;
    for (const int g : by_pose_[k]) {
      const Goal& goal = effective_[static_cast<std::size_t>(g)];
      before += residual_.segment(at, goal.objective->size()).squaredNorm();
      at += goal.objective->size();
      if (!settled) continue;
      const PoseShape shape = shape_of(changed.value(), static_cast<int>(k), poses_[k]->attempted().state);
      after += goal_residual(goal, shape).squaredNorm();
    }
    if (!settled || factors[i] == 1 || !(after <= before)) continue;
    poses_[k]->accept();
    pin_factors_[i] *= factors[i];
    any = true;
  }
  Result<Design> design = design_at(p_, pin_factors_);
  if (!design) return design.error();
  design_ = std::move(design).value();
  settle_point();
  return any;
}

}  // namespace lissom
