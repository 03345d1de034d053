#include <algorithm>
#include <fmt/format.h>

#include "lissom/studio/desk.h"
#include "lissom/studio/remedies.h"
#include "lissom/studio/request_handlers.h"

namespace lissom {

using Json = nlohmann::json;

Answer answer_edit(Desk& desk, int page, Ask& ask) {
  (void)page;
  const Json& edit = ask.object("edit");
  if (!ask.status()) return ask.status().error();
  return desk.edit(edit);
}

Answer answer_drag(Desk& desk, int page, Ask& ask) {
  const int number = ask.integer("drag", 1);
  const Json& edit = ask.object("edit");
  if (!ask.status()) return ask.status().error();
  return desk.drag(page, number, edit);
}

Answer answer_drag_end(Desk& desk, int page, Ask& ask) {
  (void)page;
  const int number = ask.integer("drag", 1);
  const Json& edit = ask.object("edit");
  if (!ask.status()) return ask.status().error();
  return desk.end_drag(number, edit);
}

Answer answer_drag_cancel(Desk& desk, int page, Ask& ask) {
  (void)page;
  (void)ask.integer("drag", 1);
  if (!ask.status()) return ask.status().error();
  desk.cancel_drag();
  return Json::object();
}

Answer answer_undo(Desk& desk, int page, Ask& ask) {
  (void)page, (void)ask;
  return desk.go_to(std::max(desk.history().at() - 1, 0));
}

Answer answer_redo(Desk& desk, int page, Ask& ask) {
  (void)page, (void)ask;
  return desk.go_to(std::min(desk.history().at() + 1, desk.history().size()));
}

Answer answer_go_to(Desk& desk, int page, Ask& ask) {
  (void)page;
  const int step = ask.integer("step", 0);
  if (!ask.status()) return ask.status().error();
  return desk.go_to(step);
}

Answer answer_remedy(Desk& desk, int page, Ask& ask) {
  (void)page;
  const int number = ask.integer("warning", 0);
  if (!ask.status()) return ask.status().error();
  const std::vector<Warning>& warnings = desk.shape().warnings();
  if (number >= static_cast<int>(warnings.size())) {
    return Error{ErrorCode::kUnknown, "/warning", fmt::format("there is no warning {} any more", number),
                 "look at the warnings as they are now"};
  }
  return take_remedy(desk, warnings[static_cast<std::size_t>(number)]);
}

}  // namespace lissom
