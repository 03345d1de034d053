#pragma once
/// What edits of a plan have in common: names, new points, rods that have lost points, words.

#include <string>
#include <string_view>
#include <vector>

#include "lissom/model/model.h"

namespace lissom {

inline PlanPoint& point_of(Plan& plan, int number) { return plan.points[static_cast<std::size_t>(number)]; }
inline const PlanPoint& point_of(const Plan& plan, int number) { return plan.points[static_cast<std::size_t>(number)]; }
inline PlanRod& rod_of(Plan& plan, int number) { return plan.rods[static_cast<std::size_t>(number)]; }
inline const PlanRod& rod_of(const Plan& plan, int number) { return plan.rods[static_cast<std::size_t>(number)]; }

/// m, largest distance of a point from the first one, as check_plan() measures the size.
double plan_size(const Plan& plan);

/// "p1", "p2", ...: the first that no point has.
std::string unused_point_name(const Plan& plan);
/// "rod1", "rod2", ...: the first that nothing has.
std::string unused_rod_name(const Model& model);
/// The number of the rod of this name, which is there.
std::size_t rod_number(const Plan& plan, std::string_view name);

/// A point with an unused name at a place that is rounded; its number.
int add_point(Plan& plan, const Vec2& at, double r_n, double r_b);
double rounded_radius(double radius);  ///< m, never 0

/// The point nearest to a place; -1 when there is none.
int nearest_point(const Plan& plan, const Vec2& to);

/// Rods after some of their points have gone, or have become the same: repeated ones are left out, what is a ring now is
/// closed, arcs that are none any more become splines or straight, rods with less than two points go, and so do points
/// that no rod uses. Says what is not plain.
void mend_rods(Plan& plan, std::vector<std::string>& notes);
/// Takes these points out of all rods.
void take_out(Plan& plan, const std::vector<int>& points);
void drop_rods(Plan& plan, const std::vector<int>& rods);
void drop_unused_points(Plan& plan);

/// "point a", "3 points".
std::string points_in_words(const Plan& plan, const std::vector<int>& points);
std::string rods_in_words(const Plan& plan, const std::vector<int>& rods);
/// "Raise the stretch to 1.46".
std::string stretch_title(const Vec2& from, const Vec2& to);
/// "1.3 mm".
std::string length_in_words(double metres);

}  // namespace lissom
