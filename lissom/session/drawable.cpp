#include "lissom/session/drawable.h"

#include "lissom/mechanics/membrane_strain.h"
#include "lissom/session/fields.h"
#include "lissom/session/pose_files.h"
#include "lissom/session/study.h"

namespace lissom {

bool is_result(std::string_view text) {
  return text.substr(0, 200).find("\"lissom_result\"") != std::string_view::npos;
}

Result<Drawable> make_drawable(SavedResult saved) {
  const Result<std::vector<int>> pose = pose_numbers(saved.document.model, {saved.pose});
  if (!pose) return pose.error();
  Result<System> system = make_system(saved.document.model);
  if (!system) return system.error();
  if (const Status s = check_state(system.value(), saved.state); !s) return s.error();
  return Drawable{std::move(saved.document), std::move(system).value(), std::move(saved.state), pose.value().front(),
                  true};
}

Result<Drawable> make_drawable(Document document, const std::string& pose) {
  int number = -1;
  if (!pose.empty()) {
    const Result<std::vector<int>> found = pose_numbers(document.model, {pose});
    if (!found) return found.error();
    number = found.value().front();
  }
  Result<System> system = make_system(document.model);
  if (!system) return system.error();
  State state = drawn_state(system.value());
  return Drawable{std::move(document), std::move(system).value(), std::move(state), number, false};
}

Result<Drawing> draw(const Drawable& drawable, Shape shape) {
  const Model& model = drawable.document.model;
  const State state = shape == Shape::kRest ? drawn_state(drawable.system) : drawable.state;
  if (drawable.pose < 0) return draw_state({model, drawable.system, state}, nullptr);
  const Pose& pose = model.poses[drawable.pose];
  if (shape == Shape::kRest || !drawable.solved) return draw_state({model, drawable.system, state}, &pose);
  const Result<StaticProblem> problem =
      make_static_problem(model, drawable.system, pose, "/poses/" + std::to_string(drawable.pose));
  if (!problem) return problem.error();
  const VecX reaction = support_reactions(problem.value(), state);
  return draw_state({model, drawable.system, state, &reaction, stretch_share(pose, state.load_factor)}, &pose);
}

}  // namespace lissom
