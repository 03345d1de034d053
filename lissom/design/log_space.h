#pragma once
/// Stiffnesses by their logarithms. What is known of a modulus beforehand is its order of magnitude, and measured lengths and
/// forces hang on it like powers: on a logarithmic scale steps are shares, and a range of decades is no wider than one of a
/// Poisson ratio.

#include <memory>
#include <vector>

#include "lissom/design/design_spaces.h"

namespace lissom {

/// Parameters u of another space: p = exp(u), in its SI unit, where p is positive by its nature (moduli, stiffnesses of fabrics,
/// thickness, pre-stretch, factors of lengths), p = u else. Names and kinds are those of p, bounds and scales those of u.
class LogSpace final : public DesignSpace {
 public:
  /// kRange where such a parameter may be 0 or less.
  static Result<LogSpace> make(SpacePtr inner);

  std::span<const Parameter> parameters() const override { return parameters_; }
  VecX start() const override { return start_; }
  Result<Design> at(const VecX& u) const override;
  Result<Design> applied(Design design, const VecX& u) const override;
  DesignJacobian jacobian(const Design& design, const VecX& u) const override;
  VecX curvature(const Design& design, const VecX& u, const VecX& y, const VecX& v) const override;

  const DesignSpace& inner() const { return *inner_; }
  /// p, within its bounds, at the start to the last bit that of the other space; d p / d u, the diagonal.
  VecX values(const VecX& u) const;
  VecX slope(const VecX& u) const;

 private:
  LogSpace() = default;

  SpacePtr inner_;
  std::vector<bool> logarithmic_;
  std::vector<Parameter> parameters_;
  VecX start_, inner_start_;  // u and p
};

}  // namespace lissom
