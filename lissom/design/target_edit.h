#pragma once
/// Pulling at a shape: a part of it is to be somewhere else, and the parameters that bring it there follow at once, to first
/// order, within their bounds and without moving what has to stay [mathematics (6.5), 6.3, 7].

#include <memory>
#include <vector>

#include "lissom/design/bound_map.h"
#include "lissom/design/hard_constraints.h"
#include "lissom/design/shape_response.h"

namespace lissom {

/// A node that is pulled.
struct PulledNode {
  int node = -1;
  double weight = 1;  ///< in (0, 1]
};

class TargetEdit {
 public:
  /// Of the least changes of the mapped parameters that do it about equally well the smallest is taken: their square counts
  /// `kLeastChange` times the largest eigenvalue of the normal matrix.
  static constexpr double kLeastChange = 1e-4;

  /// `stay`: how much all that is not pulled wants to stay where it is, against the pull: 0 as in (6.5), where a soft mode of
  /// the whole may answer to the pull at a single node.
  TargetEdit(std::shared_ptr<const ShapeResponse> response, HardConstraints constraints, std::vector<PulledNode> pulled,
             double stay);

  struct Answer {
    VecX p;      ///< SI, within the bounds
    VecX dq;     ///< change of all unknowns, global axes
    double rms;  ///< m, weighted, by which pulled nodes miss where they are wanted, to first order
  };
  /// `wanted`: m, (3 per pulled node): the displacements from the start.
  Answer answer(const VecX& wanted) const;

  const ShapeResponse& response() const { return *response_; }
  const std::shared_ptr<const ShapeResponse>& shared_response() const { return response_; }
  const HardConstraints& constraints() const { return constraints_; }
  const std::vector<PulledNode>& pulled() const { return pulled_; }

 private:
  void add_stay(double stay, MatX& normal) const;

  std::shared_ptr<const ShapeResponse> response_;
  HardConstraints constraints_;
  std::vector<PulledNode> pulled_;
  BoundMap map_;
  VecX u_, slope_;  ///< mapped parameters of the start, dp/du there
  ConstraintProjection projection_;
  MatX rows_;  ///< W S P, (3 per pulled node x m), by mapped parameters over scales
  Eigen::LLT<MatX> normal_;
};

/// How far parameters are from where they began, largest first: for people.
struct ParameterChange {
  int parameter = 0;
  double from = 0, to = 0;  ///< SI
  bool at_bound = false;
};
std::vector<ParameterChange> largest_changes(std::span<const Parameter> parameters, const VecX& from, const VecX& to,
                                             int most);

}  // namespace lissom
