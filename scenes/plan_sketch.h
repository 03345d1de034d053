#pragma once
/// A plan that grows rod by rod and stays drawable: rods that cross get a common point there, and what comes too near to
/// something else is turned down.

#include <optional>
#include <vector>

#include "lissom/model/plan.h"
#include "lissom/model/plan_sampling.h"

namespace lissom::scene_models {

class PlanSketch {
 public:
  /// `clearance`: m, how near rods and points may come to each other where they do not meet.
  explicit PlanSketch(double clearance) : clearance_(clearance) {}

  const Plan& plan() const { return plan_; }
  double clearance() const { return clearance_; }
  int add_point(const Vec2& at);
  /// A rod of the outline, which the others may touch at its points but not cross. Nothing is looked at.
  void add_outline(PlanRod rod);
  /// When the outline is there. False when it crosses itself or comes too near to itself.
  bool close_outline();

  /// Adds a rod through these points, which may be new, with common points where it crosses others. False, and nothing
  /// has changed, when it does not fit. New points are those from `first_new` on; they go when the rod does.
  bool add_rod(PlanRod rod, std::size_t first_new);

  bool inside(const Vec2& p) const;
  /// m, from the nearest rod.
  double distance_to_rods(const Vec2& p) const;
  bool is_outline(std::size_t rod) const { return rod < outline_rods_; }

 private:
  struct Crossing {
    std::size_t other = 0;  // rod
    std::size_t own_piece = 0, other_piece = 0;
    Vec2 at = Vec2::Zero();
  };
  struct Segment {
    int from = 0, to = 0;  // nodes
    int rod = 0, piece = 0;
    double along = 0;  // m, of its middle
  };

  bool sample();
  std::optional<Crossing> first_crossing(std::size_t rod) const;
  bool fits() const;
  bool points_fit() const;
  bool corners_fit() const;
  bool pair_fits(const Segment& a, const Segment& b) const;

  double clearance_;
  Plan plan_;
  std::size_t outline_rods_ = 0;
  PlanSamples samples_;
  std::vector<Segment> segments_;
  std::vector<double> lengths_;  // m, of the rods
};

}  // namespace lissom::scene_models
