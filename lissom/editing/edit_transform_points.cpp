#include <cmath>
#include <fmt/format.h>

#include "lissom/editing/edit_list.h"
#include "lissom/editing/people_units.h"
#include "lissom/editing/plan_tools.h"

namespace lissom {

namespace {

constexpr EditField kFields[] = {
    {"points", "points", "", false, "Which points."},
    {"about_mm", "place", "mm", true, "The place that scaling and turning leave alone; the middle of the points."},
    {"move_mm", "place", "mm", true, "By how much they move along x and y, after scaling and turning."},
    {"turn_deg", "number", "deg", true, "By how much they turn, anticlockwise, after scaling."},
    {"scale", "pair", "", true, "Factors along x and y."},
};

std::string title_of(const EditReader& edit, const std::string& what, double turn) {
  const bool move = edit.has("move_mm"), scale = edit.has("scale"), turns = edit.has("turn_deg");
  if (turns && !move && !scale) return fmt::format("Turn {} by {:.4g} degrees", what, degrees_of(turn));
  if (scale && !move && !turns) return "Scale " + what;
  return move && !scale && !turns ? "Move " + what : "Move, turn and scale " + what;
}

Result<EditOutcome> apply(const Model& model, EditReader& edit) {
  const std::vector<int> points = edit.points("points");
  Vec2 about = Vec2::Zero();
  for (const int i : points) about += point_of(*model.plan, i).at / double(points.size());
  if (edit.has("about_mm")) about = edit.place("about_mm");
  const Vec2 move = edit.has("move_mm") ? edit.place("move_mm") : Vec2::Zero();
  const double turn = edit.optional_angle("turn_deg").value_or(0);
  const Vec2 scale = edit.has("scale") ? edit.pair("scale") : Vec2::Ones();
  if (scale[0] == 0 || scale[1] == 0)
    edit.fail(ErrorCode::kRange, "scale", "a factor is 0", "give factors other than 0");
  if (edit.failed()) return edit.error();
  EditOutcome out{model};
  const double c = std::cos(turn), s = std::sin(turn);
  for (const int i : points) {
    Vec2& at = point_of(*out.model.plan, i).at;
    const Vec2 from = (at - about).cwiseProduct(scale);
    const Vec2 to = about + Vec2(c * from.x() - s * from.y(), s * from.x() + c * from.y()) + move;
    at = {rounded_length(to.x()), rounded_length(to.y())};
  }
  out.title = title_of(edit, points_in_words(*model.plan, points), turn);
  return out;
}

}  // namespace

constinit const EditInfo kEditTransformPoints = {"transform_points", "Moves, turns and scales points together.",
                                                 kFields, apply};

}  // namespace lissom
