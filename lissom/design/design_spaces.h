#pragma once
/// How design spaces are put together: side by side, and behind a linear map that ties parameters to each other, leaves some
/// out, or looks along chosen directions [mathematics 6, (4.7)].

#include <memory>
#include <string>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/design/design_space.h"

namespace lissom {

using SpacePtr = std::shared_ptr<const DesignSpace>;

/// Parameters of spaces of the same base design side by side; each changes the design in turn. kConflict, with the names of
/// two parameters, where two spaces claim the same number.
class SumSpace final : public DesignSpace {
 public:
  static Result<SumSpace> make(std::vector<SpacePtr> parts);

  std::span<const Parameter> parameters() const override { return parameters_; }
  VecX start() const override;
  Result<Design> at(const VecX& p) const override;
  Result<Design> applied(Design design, const VecX& p) const override;
  DesignJacobian jacobian(const Design& design, const VecX& p) const override;
  VecX curvature(const Design& design, const VecX& p, const VecX& y, const VecX& v) const override;

 private:
  SumSpace() = default;
  VecX part(std::size_t k, const VecX& p) const { return p.segment(first_[k], parts_[k]->size()); }

  std::vector<SpacePtr> parts_;
  std::vector<int> first_;  // parameter of each part
  std::vector<Parameter> parameters_;
};

/// p = origin + Z a for the parameters p of another space.
class MappedSpace final : public DesignSpace {
 public:
  /// `parameters` with bounds lower < upper: as given. A parameter without (both 0) gets the exact range that keeps all p
  /// within their bounds, which is known only where each row of Z has a single entry; kRange where there is none (also where
  /// a p that no parameter reaches is outside of its bounds), kUnsupported for other rows. A scale of 0 is set to what moves
  /// some p by its own scale. With bounds as given p may leave its own, which `at` then says.
  static Result<MappedSpace> make(SpacePtr inner, VecX origin, SparseMatrix z, std::vector<Parameter> parameters);

  std::span<const Parameter> parameters() const override { return parameters_; }
  /// The nearest of this space to the start of the other (least squares), within the bounds.
  VecX start() const override { return start_; }
  Result<Design> at(const VecX& a) const override;
  Result<Design> applied(Design design, const VecX& a) const override;
  DesignJacobian jacobian(const Design& design, const VecX& a) const override;
  VecX curvature(const Design& design, const VecX& a, const VecX& y, const VecX& v) const override;

  /// p of the other space; beyond its bounds by rounding, it is at them.
  VecX inner_parameters(const VecX& a) const;

 private:
  MappedSpace() = default;

  SpacePtr inner_;
  VecX origin_, start_;
  SparseMatrix z_;
  std::vector<Parameter> parameters_;
};

/// One factor by which all parameters are multiplied, 1 at the start.
Result<MappedSpace> common_factor(SpacePtr space, const std::string& name);

/// The parameters numbered; all others stay at the start.
Result<MappedSpace> chosen_parameters(SpacePtr space, const std::vector<int>& numbers);

/// One parameter for each group, in place of its members; all others on their own. kConflict where a parameter is in two
/// groups, or the members are of several kinds.
Result<MappedSpace> tied_parameters(SpacePtr space, const std::vector<std::vector<int>>& groups);

/// Parameters of places that mirror each other at a plane are tied: radii agree, displacements and other vectors are mirror
/// images, moments turn the other way round. What lies in the plane stays in it. Parameters without a place stay on their own. kGeometry, with the name, where one has no mirror image within
/// `tolerance` (m); kUnsupported for vectors at planes that are not across x, y or z.
Result<MappedSpace> mirrored(SpacePtr space, const Vec3& normal, double offset, double tolerance);

/// Directions in parameter space, the columns of `z` (parameters x k), around the start: a = 0 there. `scales` and `reach`:
/// a change that is felt and the bound of each |a_i|.
Result<MappedSpace> spectral_space(SpacePtr space, const MatX& z, const VecX& scales, const VecX& reach,
                                   const std::string& name);

}  // namespace lissom
