#pragma once
/// What all methods in total space share: when to end, records, and Newton's matrices eliminated to the parameters.

#include <optional>
#include <string>

#include "lissom/design/total_methods.h"

namespace lissom {

/// Derivatives at a point with the states eliminated by factors of stiffness: along z = (S v, v) states stay in equilibrium to
/// first order, (back, 0) brings them there. The null-space form of all steps that satisfy J d = -c.
struct Eliminated {
  VecX gradient;       ///< of h over (u, x)
  MatX sensitivity;    ///< S (n x m)
  VecX back;           ///< -H^-1 c (n)
  VecX reduced;        ///< S'h_u + h_x (m)
  MatX jacobian;       ///< R_u S + R_x (residuals x m)
  VecX residual_back;  ///< R_u back

  explicit Eliminated(const TotalSpace& space);

  /// (S v, v) and its transpose applied.
  VecX along(const VecX& v) const;
  VecX onto(const VecX& w) const;
  /// The step (back + S v, v).
  VecX step(const VecX& v) const;
};

/// A run under way.
class TotalRun {
 public:
  TotalRun(TotalSpace& space, const TotalOptions& options, const Context& context, TotalResult& result);

  TotalSpace& space;
  const TotalOptions& options;
  TotalRecord record;  ///< of the iteration under way

  /// Linearises at the point and begins a record. False: there is a verdict.
  bool look();
  /// At the point, made when first asked for: as many back solves as there are parameters.
  const Eliminated& eliminated();
  double first_gradient() const { return first_gradient_; }
  /// Whether the forces at the point are as small as solves leave them.
  bool in_equilibrium() const { return space.imbalance() <= 1; }
  /// Ends the iteration that `look` began.
  void finish_iteration();
  void end(TotalVerdict verdict, const std::string& reason = {});
  bool cancelled() const { return context_.cancelled(); }
  /// What is worst at the point: forces, or else the parameter that promises most.
  std::string worst() const;

 private:
  double seconds() const;

  const Context& context_;
  TotalResult& result_;
  std::optional<Eliminated> eliminated_;
  VecX promise_;
  double first_gradient_ = -1;
  double began_ = 0;
};

/// Each runs until there is a verdict.
void run_lagrange(TotalRun& run);
void run_penalty(TotalRun& run);

}  // namespace lissom
