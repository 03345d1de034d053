#pragma once
/// Pulling at a shape: a part of it is to be somewhere else, and the parameters that bring it there follow at once, to first
/// order, within their bounds and without moving what has to stay [mathematics (6.5), 6.3, 7].

#include <Eigen/Cholesky>
#include <array>
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
  /// `kLeastChange` times the largest eigenvalue of the normal matrix at the start.
  static constexpr double kLeastChange = 1e-4;
  /// Times which the least change may count more: the larger, the shorter is the way that the parameters go.
  static constexpr std::array<double, 3> kCautions{1, 10, 100};

  /// `stay`: how much all that is not pulled wants to stay where it is, against the pull: 0 as in (6.5), where a soft mode of
  /// the whole may answer to the pull at a single node. Motions that are softer than others count more, for of them a response
  /// to first order foretells least.
  TargetEdit(std::shared_ptr<const ShapeResponse> response, HardConstraints constraints, std::vector<PulledNode> pulled,
             double stay);

  struct Answer {
    VecX p;      ///< SI, within the bounds
    VecX dq;     ///< S times the change of p: of all unknowns, global axes
    double rms;  ///< m, weighted, by which pulled nodes miss where they are wanted, to first order
  };
  /// `wanted`: m, (3 per pulled node): the displacements from the start. `caution`: index into kCautions.
  Answer answer(const VecX& wanted, int caution = 0) const;
  /// A share, in (0, 1], of the way to an answer to `wanted`: constraints and bounds hold there, too.
  Answer shortened(const Answer& answer, const VecX& wanted, double share) const;

  const ShapeResponse& response() const { return *response_; }
  const std::shared_ptr<const ShapeResponse>& shared_response() const { return response_; }
  const HardConstraints& constraints() const { return constraints_; }
  const std::vector<PulledNode>& pulled() const { return pulled_; }

 private:
  /// A change of the mapped parameters over scales, and what it comes to.
  struct Trial {
    VecX change, x;    ///< mapped; of the parameters themselves, over scales
    double value = 0;  ///< of what is minimised, but for a constant
  };
  /// How mapped parameters answer where they are.
  struct Slope {
    VecX slope;  ///< dp/du
    ConstraintProjection projection;
    Eigen::LLT<MatX> normal;
  };
  VecX weighted(const VecX& wanted) const;
  double miss(const VecX& x, const VecX& weighted) const;
  Trial trial(const VecX& change, const VecX& pull, double least) const;
  Slope slope_at(const VecX& change, double least) const;
  /// Gauss and Newton's, into what leaves the constraints alone.
  VecX step(const Trial& from, const Slope& slope, const VecX& pull, double least) const;
  double least_change(int caution) const;
  MatX stay_rows(double stay) const;
  MatX soft_rows(double stay) const;
  MatX normal_at(const VecX& slope, const ConstraintProjection& projection) const;

  std::shared_ptr<const ShapeResponse> response_;
  HardConstraints constraints_;
  std::vector<PulledNode> pulled_;
  double total_ = 0;  ///< of the squared weights
  BoundMap map_;
  VecX p_, u_;                 ///< parameters of the start, inside the bounds, SI; mapped
  MatX k_;                     ///< K over parameters in scales, (constraints x m)
  MatX rows_;                  ///< W S, (3 per pulled node x m)
  MatX gram_;                  ///< of these rows and of those that want to stay, (m x m)
  double largest_ = 0;         ///< eigenvalue of the normal matrix of the start
  std::vector<Slope> slopes_;  ///< at the start, per caution
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
