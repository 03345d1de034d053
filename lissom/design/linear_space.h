#pragma once
/// Parameters on which the numbers of a design hang in a linear way: values = offset + Z p for the numbers that have a row in
/// Z, all others stay [mathematics 6, (4.7)]. Radii, rest shapes, moduli, natural strains and loads are such spaces.

#include <memory>
#include <vector>

#include "lissom/design/design_space.h"
#include "lissom/design/design_values.h"

namespace lissom {

/// Z, by kind of numbers. Without columns: none of this kind.
struct PoseRows {
  SparseMatrix loads;  ///< (LoadNumbers::size x m)
  SparseMatrix moves;  ///< (3 supports x m)
};
struct LinearRows {
  SparseMatrix inputs;          ///< (RestInputs::size x m)
  std::vector<PoseRows> poses;  ///< one per pose, or none at all
};

class LinearSpace final : public DesignSpace {
 public:
  /// Where values are at p = 0.
  enum class Offset {
    kZero,  ///< values are Z p: the design at the start is the nearest of the space to the base
    kBase,  ///< chosen such that the design at `start` is the base
  };

  /// kRange where a bound or scale is no number or the start is outside of the bounds.
  static Result<LinearSpace> make(std::shared_ptr<const Design> base, std::vector<Parameter> parameters, VecX start,
                                  LinearRows rows, Offset offset);

  std::span<const Parameter> parameters() const override { return parameters_; }
  VecX start() const override { return start_; }
  Result<Design> at(const VecX& p) const override;
  Result<Design> applied(Design design, const VecX& p) const override;
  DesignJacobian jacobian(const Design& design, const VecX& p) const override;

  const LinearRows& rows() const { return rows_; }

 private:
  LinearSpace() = default;

  std::shared_ptr<const Design> base_;
  std::vector<Parameter> parameters_;
  VecX start_;
  LinearRows rows_;
  /// Rows of one kind that are not empty: values there are offset + Z (p - origin).
  struct Claimed {
    std::vector<int> rows;
    VecX offset;
    Claimed() = default;
    Claimed(const SparseMatrix& z, const VecX& present, Offset choice);
    void set(const SparseMatrix& z, const VecX& step, VecX& values) const;
  };
  VecX origin_;
  Claimed inputs_;
  bool claims_places_ = false;          // of nodes
  std::vector<Claimed> loads_, moves_;  // by pose
};

/// The x with least |Z x - y|, nearest to `guess` where there are several, by conjugate gradients.
VecX least_squares(const SparseMatrix& z, const VecX& y, const VecX& guess);

}  // namespace lissom
