#pragma once
/// What has to stay as it is while a shape is explored or pulled at: pinned nodes, pairs that keep their offset, nodes that
/// keep in a plane; and ties between parameters, as of mirror images [mathematics 7, with K = dC/dq S].

#include <array>
#include <memory>
#include <vector>

#include "lissom/core/types.h"
#include "lissom/design/objective.h"

namespace lissom {

/// Nodes of a structure.
struct HardConstraints {
  std::vector<int> pinned;
  std::vector<std::array<int, 2>> attached;
  std::vector<std::vector<int>> in_plane;  ///< at least three nodes each
  MatX ties;                               ///< (rows x m): rows (p / scale) keep their value

  int size() const;  ///< of C, without ties
  bool none() const { return size() == 0 && ties.rows() == 0; }
};

/// C(q), m: how far places are from what they keep to, given `reference`: places (3 per node, m) that fulfil it.
VecX violations(const HardConstraints& constraints, const VecX& reference, const VecX& places);

/// d C / d q, (size x unknowns), where C is small: planes turn and shift with their nodes.
SparseRows constraint_jacobian(const HardConstraints& constraints, const VecX& places, int unknowns);

/// K over parameters in scales, (size + ties x m): d C / d q times the response, then the ties.
MatX constraint_response(const HardConstraints& constraints, const VecX& places, const MatX& response);

/// P = I - V V': onto the changes that leave C alone; redundant constraints do no harm [mathematics 7, for (6.4)].
class ConstraintProjection {
 public:
  ConstraintProjection() = default;
  explicit ConstraintProjection(const MatX& k);

  /// In place, over rows of a vector or matrix (m x any).
  void apply(MatX& x) const;
  VecX of(const VecX& v) const;
  /// The smallest x for which K x comes nearest to `values`.
  VecX least_change(const VecX& values) const;
  int rank() const { return static_cast<int>(range_.cols()); }

 private:
  MatX range_;     ///< V, (m x rank), orthonormal
  MatX to_range_;  ///< V' times the pseudoinverse of K, (rank x rows)
};

}  // namespace lissom
