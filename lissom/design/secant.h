#pragma once
/// Approximate Hessians of an objective 1/2 |r(p)|^2 from first derivatives along the way [mathematics 5.3]. With S = dr/dp the
/// Hessian is S'S, which is known, and sum_i r_i d^2 r_i / dp^2, which is learned from how gradients change: Gauss-Newton
/// leaves the second part out and creeps where residuals stay large.

#include <array>
#include <string_view>
#include <utility>

#include "lissom/core/types.h"

namespace lissom {

enum class SecantRule {
  kGaussNewton,      ///< S'S alone
  kBfgs,             ///< the whole Hessian from secants; S'S is not used
  kStructuredBfgs,   ///< S'S + D by a BFGS update of the sum; stays positive definite [Dennis, Martinez, Tapia 1989]
  kDennisGayWelsch,  ///< S'S + D, D by a sized update of its own; may be indefinite [NL2SOL 1981; erratum E20]
};

struct SecantInfo {
  SecantRule rule;
  std::string_view name, meaning;
};
/// All rules, for options and help.
std::array<SecantInfo, 4> secant_rules();

/// What a step has shown. With k the new point and k - 1 the one before:
struct SecantStep {
  VecX step;               ///< s = p_k - p_{k-1}
  VecX gradient_change;    ///< y = S_k' r_k - S_{k-1}' r_{k-1}
  VecX structured_change;  ///< y# = (S_k - S_{k-1})' r_k: the second part of the Hessian times s, to first order
  MatX gram;               ///< S_k' S_k
};

/// What an approximation consists of, to be kept between iterations and sessions.
struct SecantMemory {
  MatX second;            ///< D; of kBfgs the whole
  bool has_step = false;  ///< of kBfgs
  int resets = 0;
};

class SecantHessian {
 public:
  /// For `parameters` parameters, in units in which they compare with each other.
  SecantHessian(SecantRule rule, int parameters);
  SecantHessian(SecantRule rule, SecantMemory memory);

  /// Takes a step in. One that tells nothing, or would spoil the approximation, resets it instead: see `resets`.
  void learn(const SecantStep& step);
  /// The approximation at a point with this S'S.
  MatX at(const MatX& gram) const;
  void forget();
  int resets() const { return memory_.resets; }
  /// Whether `at` looks at J'J, which costs as many solves as there are parameters.
  bool needs_gram() const { return rule_ != SecantRule::kBfgs || !memory_.has_step; }
  /// Whether anything beyond J'J is known.
  bool has_memory() const { return memory_.has_step || (memory_.second.array() != 0).any(); }
  const SecantMemory& memory() const { return memory_; }
  SecantMemory take_memory() && { return std::move(memory_); }

 private:
  void reset();
  void bfgs(const SecantStep& s);
  void structured_bfgs(const SecantStep& s);
  void dennis_gay_welsch(const SecantStep& s);

  SecantRule rule_;
  SecantMemory memory_;
};

}  // namespace lissom
