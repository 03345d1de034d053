#pragma once
/// What a design may change and what it should reach: what `lissom optimize` works on. Names, places and numbers only; what
/// they become is said in design/brief_space.h and design/brief_goals.h [mathematics 5, 6].

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lissom/core/types.h"
#include "lissom/model/selector.h"

namespace lissom {

/// Half-extents of the rods of a network at `controls` places of each, joints shared.
struct RadiiBrief {
  int controls = 4;        ///< 2, 3 or 4
  Vec2 range{1e-3, 5e-3};  ///< m
};

/// Displacements of the same places in the shape as drawn.
struct RestShapeBrief {
  enum class Gauge {
    kFixSix,  ///< the drawing does not move or turn as a whole
    kFree,    ///< it may: where supports, targets or gravity tell places apart
  };
  int controls = 4;     ///< 2, 3 or 4
  double reach = 0.01;  ///< m, along each axis
  Gauge gauge = Gauge::kFixSix;
};

/// Lengths of straight rods, by factors of what is drawn.
struct LengthBrief {
  std::vector<std::string> rods;
  Vec2 factors{0.5, 2};
};

struct ModulusBrief {
  enum class Per { kMaterial, kRod };
  Per per = Per::kMaterial;
  Vec2 range{1e6, 1e10};  ///< Pa
};

/// Of all fabrics and membranes: those that have a range.
struct FabricBrief {
  std::optional<Vec2> stiffness;    ///< N/m, along both axes, their ratio stays
  std::optional<Vec2> stiffness_1;  ///< N/m
  std::optional<Vec2> stiffness_2;  ///< N/m
  std::optional<Vec2> poisson_ratio;
  std::optional<Vec2> thickness;    ///< m
  std::optional<Vec2> pre_stretch;  ///< along both axes, their ratio stays
};

/// Natural shapes of rods: what has a range.
struct NaturalBrief {
  std::vector<std::string> rods;    ///< empty: all
  std::optional<Vec2> curvature_b;  ///< 1/m
  std::optional<Vec2> curvature_n;  ///< 1/m
  std::optional<Vec2> twist;        ///< rad/m
  std::optional<Vec2> length_factor;
};

/// A load of a pose, the target of a soft pin, or the movement of a support.
struct LoadBrief {
  enum class Kind { kForce, kMoment, kPinTarget, kMove };
  Kind kind = Kind::kForce;
  std::string pose;                        ///< empty: the only one
  int number = 0;                          ///< in the pose's list, from 0
  std::optional<Vec2> size;                ///< bounds along its present direction, N, N m or m
  std::array<std::optional<Vec2>, 3> xyz;  ///< bounds of components
};

/// Of the plan: what has a range or a reach.
struct PlanBrief {
  enum class PreStretch { kCommon, kPerAxis };
  std::vector<std::string> points;        ///< control points that take part; empty: all
  std::optional<Vec2> radii;              ///< m, bounds
  std::optional<double> reach;            ///< how far points may move along x and y, over the size of the plan
  std::optional<Vec2> pre_stretch;        ///< bounds
  PreStretch axes = PreStretch::kCommon;  ///< whether both axes have their own
};

using ParameterKindBrief = std::variant<RadiiBrief, RestShapeBrief, LengthBrief, ModulusBrief, FabricBrief,
                                        NaturalBrief, LoadBrief, PlanBrief>;

/// A plane at whose sides a design agrees.
struct MirrorBrief {
  Vec3 normal = Vec3::UnitX();
  double offset = 0;     ///< m, of the plane along the normal
  double tolerance = 0;  ///< m, how far mirror images may be from each other; 0: 1e-4 of the size
};

enum class Freedom {
  kEach,          ///< parameters change one by one
  kCommonFactor,  ///< one factor multiplies them all
  kCommonValue,   ///< they all have one value
};

struct ParameterBrief {
  ParameterKindBrief what;
  std::optional<MirrorBrief> mirror;
  Freedom freedom = Freedom::kEach;
};

/// What a number should be.
struct GoalValue {
  enum class Kind { kReach, kAtMost, kAtLeast };
  Kind kind = Kind::kReach;
  double value = 0;  ///< SI
};

/// Where nodes should be.
struct PositionsGoal {
  Selector at;
  std::vector<Vec3> targets;    ///< m, one for each node, ascending; or one for every node of the structure
  std::vector<double> weights;  ///< of the targets; empty: equal
};
/// Mean place of a set of nodes.
struct PlaceGoal {
  Selector at;
  Vec3 target = Vec3::Zero();  ///< m
};
/// Angle from the direction from[0] -> from[1] to that of to[0] -> to[1], one node each.
struct AngleGoal {
  std::vector<Selector> from, to;
  std::optional<Vec3> axis;  ///< of signed angles
  GoalValue wanted;          ///< rad
};
/// Sum of what the supports of nodes carry.
struct ReactionGoal {
  Selector at;
  Vec3 axis = Vec3::UnitZ();
  GoalValue wanted;  ///< N
};
struct AreaGoal {
  std::vector<std::string> membranes;  ///< empty: all
  GoalValue wanted;                    ///< m^2
};
struct VolumeGoal {
  std::vector<std::string> membranes;  ///< empty: all
  GoalValue wanted;                    ///< m^3
};
struct MassGoal {
  std::vector<std::string> rods, membranes;  ///< both empty: everything
  GoalValue wanted;                          ///< kg
};
struct EnergyGoal {
  GoalValue wanted;  ///< J
};
/// Smaller principal stretch of every triangle.
struct StretchGoal {
  std::vector<std::string> membranes;  ///< empty: all
  GoalValue wanted;
};
/// Largest strain of the sections of rods, at every place where they bend.
struct StrainGoal {
  std::vector<std::string> rods;  ///< empty: all
  GoalValue wanted;
};
/// Stiffness of the softest mode.
struct StabilityGoal {
  GoalValue wanted;  ///< N/m
};

using GoalKindBrief = std::variant<PositionsGoal, PlaceGoal, AngleGoal, ReactionGoal, AreaGoal, VolumeGoal, MassGoal,
                                   EnergyGoal, StretchGoal, StrainGoal, StabilityGoal>;

enum class GoalStrength {
  kSoft,  ///< as near as the rest allows
  kHard,  ///< a constraint
};

struct GoalBrief {
  GoalKindBrief what;
  std::string pose;  ///< empty: the only one
  GoalStrength strength = GoalStrength::kSoft;
  double weight = 1;  ///< against the other goals
};

/// Wishes about the parameters; 0: none.
struct WishesBrief {
  double closeness = 0;   ///< weight of staying near the start
  double smoothness = 0;  ///< weight of being alike along rods: radii and rest shapes that change one by one
  double clearance = 0;   ///< m, between rods that share no joint
};

/// How it is worked on.
struct DesignSettings {
  enum class Control { kLineSearch, kTrustRegion };
  enum class Pins {
    kFixed,  ///< soft pins are as stiff as the poses say
    kAdaptive,  ///< that is where they begin; they end such that pinned nodes miss their places as much as goals are missed
  };
  std::string method = "structured_bfgs";  ///< one of brief_methods.h
  Control control = Control::kLineSearch;
  Pins pins = Pins::kFixed;
  int iterations = 100;  ///< at most, of each stage that has no limit of its own
  /// Convergence: share of what the best parameter promised at the start, and of what is left to be gained.
  double gradient_tolerance = 1e-6, decrease_tolerance = 1e-9;
  double constraint_tolerance = 1e-6;  ///< of hard goals, over their scales
  double solve_tolerance = 1e-8;       ///< of equilibria, largest unbalanced force over the loads
};

/// What may change in a first stage: few parameters first find the way for many.
struct StageBrief {
  std::vector<ParameterBrief> parameters;
  std::optional<int> iterations;  ///< at most; those of the settings when absent
};

struct Brief {
  std::vector<StageBrief> stages;          ///< worked on first, one after the other
  std::vector<ParameterBrief> parameters;  ///< of the last stage
  std::vector<GoalBrief> goals;
  WishesBrief wishes;
  DesignSettings settings;
};

}  // namespace lissom
