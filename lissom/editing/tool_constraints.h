#pragma once
/// What the studio's tools keep: pinned points, pairs held together, points kept in a plane, a mirror symmetry of the plan.
/// They live in a document as named sets of plan points, so that every reader of the format keeps them
/// (docs/guide/document.md, "Sets of the studio"):
///
///   "pinned": [{"plan_point": "a"}, ...]       "in plane 1": [{"plan_point": "a"}, {"plan_point": "b"}, ...]
///   "attached 1": [{"plan_point": "a"}, {"plan_point": "b"}]
///   "symmetric x": {"point": [0, 0, 0]}        mirror images across the line x = 0
///
/// Sets of these names that say something else belong to the user and are left alone.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/model/model.h"

namespace lissom {

/// A line of the plan, at a right angle to an axis, across which things are mirrored.
struct PlanMirror {
  int axis = 0;   ///< the coordinate that changes its sign: 0 for x, 1 for y
  double at = 0;  ///< m, where the line crosses that axis

  Vec2 image(const Vec2& place) const {
    Vec2 other = place;
    other[axis] = 2 * at - place[axis];
    return other;
  }
};

struct ToolConstraints {
  std::vector<std::string> pinned;                   ///< names of points of the plan
  std::vector<std::array<std::string, 2>> attached;  ///< pairs that keep their distance
  std::vector<std::vector<std::string>> in_plane;    ///< at least three points each
  std::optional<PlanMirror> symmetric;

  bool none() const { return pinned.empty() && attached.empty() && in_plane.empty() && !symmetric; }
};

ToolConstraints constraints_of(const Model& model);

/// The model with these constraints instead of those that it has. Refused where a set of such a name belongs to the user.
Result<Model> with_constraints(Model model, const ToolConstraints& constraints);

}  // namespace lissom
