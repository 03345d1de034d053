#pragma once
/// What may change in a design, as numbers p with bounds, and how all that a solve depends on follows from them
/// [mathematics 6]. Spaces compose: see design_spaces.h.

#include <span>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/design/design.h"
#include "lissom/design/parameter.h"

namespace lissom {

/// How a pose follows the parameters by itself, besides the structure. Matrices without columns: not at all.
struct PoseJacobian {
  SparseMatrix loads;  ///< d load numbers / d p (LoadNumbers::size x m)
  SparseMatrix held;   ///< d held unknowns / d p (unknowns x m), rows in local axes, at load factor 1
};

/// First derivatives of all that a solve depends on, at one design. Matrices without columns: zero.
struct DesignJacobian {
  SparseMatrix inputs;              ///< d rest inputs / d p (RestInputs::size x m)
  SparseMatrix numbers;             ///< d rest numbers / d p at fixed rest inputs (RestNumbers::size x m)
  std::vector<PoseJacobian> poses;  ///< one per pose of the model, or none at all
};

class DesignSpace {
 public:
  virtual ~DesignSpace() = default;

  virtual std::span<const Parameter> parameters() const = 0;
  int size() const { return static_cast<int>(parameters().size()); }

  /// p of the design that the space was made for.
  virtual VecX start() const = 0;

  /// The design with parameters p; everything else stays as it was. kRange, with the parameter's name, outside of the bounds
  /// or where p is not finite; kConflict where p would need other nodes, joints or triangles.
  virtual Result<Design> at(const VecX& p) const = 0;

  /// The same changes made to a design of the same nodes, joints and triangles that other spaces have changed before; what
  /// they changed and this space does not claim stays. kUnsupported for spaces that cannot be combined.
  virtual Result<Design> applied(Design design, const VecX& p) const;

  virtual DesignJacobian jacobian(const Design& design, const VecX& p) const = 0;

  /// The second-order part: d/de [ (d inputs/dp)' y ] along p + e v, with y over RestInputs (m). Zero for linear spaces.
  virtual VecX curvature(const Design& design, const VecX& p, const VecX& y, const VecX& v) const {
    (void)design, (void)y, (void)v;
    return VecX::Zero(p.size());
  }
};

/// Derivatives by y where those by p are known and dp = d_p dy: every matrix that has columns times d_p.
DesignJacobian chained(DesignJacobian jacobian, const SparseMatrix& d_p);

/// kRange, with the name of the first parameter that is outside of its bounds or not finite.
Status check_bounds(std::span<const Parameter> parameters, const VecX& p);

}  // namespace lissom
