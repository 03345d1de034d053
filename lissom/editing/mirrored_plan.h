#pragma once
/// Mirror images of rods, and plans that stay their own mirror image while one side is edited.

#include <array>
#include <string_view>
#include <vector>

#include "lissom/editing/tool_constraints.h"

namespace lissom {

inline constexpr std::string_view kAxisWords[] = {"x", "y"};

/// Pairs of points that are each other's mirror image, within a millionth of the size; a point on the line is its own.
std::vector<std::array<int, 2>> pairs_of(const Plan& plan, const PlanMirror& mirror);

/// Adds the mirror images of rods. Points whose image is there share it, as points on the line do; rods whose image runs
/// through the same points already get none. How many were added.
int add_mirror_images(Model& model, const std::vector<int>& rods, const PlanMirror& mirror);

/// After an edit of a plan that was `before`: partners of points that were moved, or got other radii, follow. Where both
/// were changed, in ways that are not each other's image, both take the mean. Points on the line stay on it.
void keep_symmetry(const Plan& before, Plan& after, const PlanMirror& mirror);

}  // namespace lissom
