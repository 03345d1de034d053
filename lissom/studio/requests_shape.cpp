#include <fmt/format.h>

#include "lissom/studio/branch_shapes.h"
#include "lissom/studio/desk.h"
#include "lissom/studio/request_handlers.h"

namespace lissom {

using Json = nlohmann::json;

Answer answer_settle(Desk& desk, int page, Ask& ask) {
  (void)page;
  const std::optional<std::string> from = ask.optional_text("from");
  if (!ask.status()) return ask.status().error();
  if (from && *from != "flat" && *from != "present") {
    return Error{ErrorCode::kUnknown, "/from", "shapes settle from the present one, or from \"flat\"",
                 "give \"flat\" or leave it out"};
  }
  return desk.settle(from == "flat");
}

Answer answer_look(Desk& desk, int page, Ask& ask) {
  (void)page;
  const int pose = ask.has("pose") ? ask.integer("pose", 0) : -1;
  if (!ask.status()) return ask.status().error();
  if (Status s = desk.look(pose); !s) return s.error();
  return Json::object();
}

Answer answer_hold(Desk& desk, int page, Ask& ask) {
  (void)page, (void)ask;
  desk.set_following(Desk::Following::kHeld);
  return Json::object();
}

Answer answer_run(Desk& desk, int page, Ask& ask) {
  (void)page, (void)ask;
  desk.set_following(Desk::Following::kRunning);
  return Json::object();
}

Answer answer_fields(Desk& desk, int page, Ask& ask) {
  (void)page;
  ShownFields fields = desk.shape().fields();
  if (ask.has("rods")) fields.rods = ask.text("rods");
  if (ask.has("fabric")) fields.fabric = ask.text("fabric");
  if (!ask.status()) return ask.status().error();
  if (Status s = check_fields(fields); !s) return s.error();
  desk.shape().show_fields(fields);
  return Json::object();
}

Answer answer_branches(Desk& desk, int page, Ask& ask) {
  (void)page, (void)ask;
  if (Status s = desk.branches().find(); !s) return s.error();
  return Json::object();
}

Answer answer_branch_take(Desk& desk, int page, Ask& ask) {
  (void)page;
  const int branch = ask.integer("branch", 0);
  if (!ask.status()) return ask.status().error();
  if (Status s = desk.branches().take(branch); !s) return s.error();
  return Json::object();
}

Answer answer_cancel(Desk& desk, int page, Ask& ask) {
  (void)page;
  const std::string job = ask.text("job");
  if (!ask.status()) return ask.status().error();
  return Json{{"cancelled", desk.jobs().cancel(job)}};
}

}  // namespace lissom
