#pragma once
/// A pose whose load is what a pair of a force and a length prescribes, and what is measured on it.

#include <memory>
#include <string>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/design/design.h"
#include "lissom/design/objective.h"
#include "lissom/equilibrium/static_problem.h"
#include "lissom/model/calibration.h"

namespace lissom {

class LengthLoads {
 public:
  /// Of pose number `pose`. `where` is the place of `brief`, for errors: ends that are no nodes or at one place, a pose without
  /// a force to scale, no support that moves `to` alone.
  static Result<LengthLoads> make(const Design& base, int pose, const ForceLengthBrief& brief,
                                  const std::string& where);

  /// m, of the shape as drawn.
  double drawn_length() const { return drawn_length_; }

  /// The pose with its forces scaled so that their resultant has this size, N, with the sense in which they are described.
  Pose with_force(double force) const;
  /// The pose with `to` moved to where this is the length, m. kConflict, at `row`, where the supports do not make it.
  Result<Pose> with_length(double length, const std::string& row) const;

  /// The length, m, and the force of the supports on `to` in the direction in which it grows, N.
  std::shared_ptr<const Objective> length() const { return length_; }
  std::shared_ptr<const Objective> reaction() const { return reaction_; }

 private:
  LengthLoads(const Design& base, int pose) : base_(base), pose_(pose) {}
  const Pose& pose() const { return base_.model.poses[static_cast<std::size_t>(pose_)]; }
  Status find_ends(const ForceLengthBrief& brief, const std::string& where);
  Status find_pattern(const std::string& where);
  Status find_support(const std::string& where);

  const Design& base_;
  int pose_;
  std::vector<int> to_;
  Vec3 direction_ = Vec3::Zero();  // unit, in which the length grows
  double drawn_length_ = 0;        // m
  double resultant_ = 0;           // N, of the forces of the pose
  int support_ = -1;               // of the pose, that moves `to`
  std::shared_ptr<const Objective> length_, reaction_;
};

/// kConflict, at `where`, where the pose lets the part of one of the nodes lie anywhere.
Status check_held(const Design& base, const StaticProblem& problem, const std::vector<int>& nodes,
                  const std::string& pose, const std::string& where);

}  // namespace lissom
