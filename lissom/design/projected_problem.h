#pragma once
/// The inverse problem of a structure whose attempts are brought into equilibrium by a projection in total space instead of
/// energy minimisation [mathematics 5.5], to compare the two within any method of the reduced problem.
///
/// An attempt at x predicts states by S (x - x_k), then projects. The projection moves x too: what it settles at is the
/// equilibrium of x', near x within the bounds. Residual and value of the attempt are those at x', and when it is accepted the
/// point is at x', which methods have to read back (Optimizer does; what secant rules learn is the step x' - x_k). The
/// model of a step thus foretells x, not x': the projection may give away a part of the decrease, or, where it is
/// target-weighted, add to it. Where the projection stalls, jumps or ends at an unstable state, the attempt is done again at x
/// by energy minimisation.

#include <memory>
#include <optional>
#include <string>

#include "lissom/design/structure_problem.h"
#include "lissom/design/total_projection.h"

namespace lissom {

/// How attempts came into equilibrium.
struct ProjectionCounts {
  int projected = 0;
  int iterations = 0;       ///< of projections
  int fallbacks = 0;        ///< to energy minimisation: stalled, jumped, ...
  int unstable = 0;         ///< of these: equilibria that are not stable
  std::string last_reason;  ///< of a fallback
};

class ProjectedProblem final : public ReducedProblem {
 public:
  /// At the point of `problem`, which has to outlive this and is moved by `accept`. Errors are those of TotalSpace.
  static Result<std::unique_ptr<ProjectedProblem>> make(StructureProblem& problem, const ProjectionOptions& options,
                                                        const Context& context);

  const ProjectionCounts& counts() const { return counts_; }
  /// x' of the last attempt, settled.
  const VecX& attempted_x() const { return attempted_x_; }

  int size() const override { return problem_->size(); }
  std::string parameter_name(int i) const override { return problem_->parameter_name(i); }
  const VecX& lower() const override { return problem_->lower(); }
  const VecX& upper() const override { return problem_->upper(); }
  const VecX& x() const override { return problem_->x(); }
  double value() const override { return problem_->value(); }
  const VecX& residual() const override { return problem_->residual(); }
  const VecX& gradient() override { return problem_->gradient(); }
  const MatX& gram() override { return problem_->gram(); }
  VecX jacobian_times(const VecX& v) override { return problem_->jacobian_times(v); }
  VecX jacobian_transposed_times(const VecX& w) override { return problem_->jacobian_transposed_times(w); }
  VecX hessian_times(const VecX& v) override { return problem_->hessian_times(v); }
  Attempt attempt(const VecX& x) override;
  const VecX& attempted_residual() const override;
  void accept() override;
  DesignEffort effort() const override;

 private:
  ProjectedProblem(StructureProblem& problem, std::unique_ptr<TotalSpace> space, const ProjectionOptions& options,
                   const Context& context)
      : problem_(&problem), space_(std::move(space)), options_(options), context_(context) {}
  /// Reason why not, unless the space stands at a stable equilibrium near the prediction.
  std::optional<std::string> settle(const VecX& x);

  StructureProblem* problem_;
  std::unique_ptr<TotalSpace> space_;
  ProjectionOptions options_;
  Context context_;
  ProjectionCounts counts_;
  std::optional<DesignPoint> projected_;  // the last attempt; none: by energy minimisation
  VecX attempted_x_, attempted_residual_;
};

}  // namespace lissom
