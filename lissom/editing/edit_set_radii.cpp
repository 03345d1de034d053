#include <cmath>
#include <fmt/format.h>

#include "lissom/editing/edit_list.h"
#include "lissom/editing/plan_tools.h"

namespace lissom {

namespace {

constexpr EditField kFields[] = {
    {"points", "points", "", false, "Which points."},
    {"r_n_mm", "number", "mm", true, "Radius of the rods there, out of the plane."},
    {"r_b_mm", "number", "mm", true, "Radius of the rods there, in the plane."},
    {"factor", "number", "", true, "Multiplies both radii, instead."},
};

std::string title_of(const std::string& where, std::optional<double> r_n, std::optional<double> r_b) {
  if (!r_b) return fmt::format("Make rods {} high at {}", length_in_words(2 * *r_n), where);
  if (!r_n) return fmt::format("Make rods {} wide at {}", length_in_words(2 * *r_b), where);
  return fmt::format("Make rods {} high and {} wide at {}", length_in_words(2 * *r_n), length_in_words(2 * *r_b),
                     where);
}

Result<EditOutcome> apply(const Model& model, EditReader& edit) {
  const std::vector<int> points = edit.points("points");
  const std::optional<double> r_n = edit.optional_length("r_n_mm"), r_b = edit.optional_length("r_b_mm");
  const std::optional<double> factor = edit.has("factor") ? std::optional(edit.positive("factor")) : std::nullopt;
  if (factor && (r_n || r_b)) {
    edit.fail(ErrorCode::kConflict, "factor", "both radii and a factor are given", "keep one of them");
  }
  if (!factor && !r_n && !r_b) edit.fail(ErrorCode::kType, {}, "no radius is given", "give r_n_mm, r_b_mm or factor");
  if (r_n && !(*r_n > 0)) edit.fail(ErrorCode::kRange, "r_n_mm", "the radius has to be positive");
  if (r_b && !(*r_b > 0)) edit.fail(ErrorCode::kRange, "r_b_mm", "the radius has to be positive");
  if (edit.failed()) return edit.error();
  EditOutcome out{model};
  for (const int i : points) {
    PlanPoint& point = point_of(*out.model.plan, i);
    point.r_n = factor ? rounded_radius(*factor * point.r_n) : r_n.value_or(point.r_n);
    point.r_b = factor ? rounded_radius(*factor * point.r_b) : r_b.value_or(point.r_b);
  }
  const std::string where = points_in_words(*model.plan, points);
  out.title = factor ? fmt::format("Make rods {:.3g} % {} at {}", 100 * std::abs(*factor - 1),
                                   *factor < 1 ? "thinner" : "thicker", where)
                     : title_of(where, r_n, r_b);
  return out;
}

}  // namespace

constinit const EditInfo kEditSetRadii = {"set_radii", "Sets the radii of rods at points.", kFields, apply};

}  // namespace lissom
