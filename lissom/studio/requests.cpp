#include "lissom/studio/requests.h"

#include <string>
#include <vector>

#include "lissom/core/nearest_name.h"
#include "lissom/studio/desk.h"
#include "lissom/studio/event_json.h"
#include "lissom/studio/request_handlers.h"

namespace lissom {

namespace {

using Json = nlohmann::json;
using Needs = RequestInfo::Needs;

constexpr bool kAnotherShape = true;

constexpr RequestInfo kRequests[] = {
    {"hello", answer_hello, Needs::kNothing},
    {"probe", answer_probe, Needs::kNothing},
    {"edit", answer_edit, Needs::kPlan, kAnotherShape},
    {"drag", answer_drag, Needs::kPlan, kAnotherShape},
    {"drag_end", answer_drag_end, Needs::kPlan, kAnotherShape},
    {"drag_cancel", answer_drag_cancel, Needs::kPlan, kAnotherShape},
    {"undo", answer_undo, Needs::kPlan, kAnotherShape},
    {"redo", answer_redo, Needs::kPlan, kAnotherShape},
    {"go_to", answer_go_to, Needs::kPlan, kAnotherShape},
    {"remedy", answer_remedy},
    {"new", answer_new, Needs::kNothing, kAnotherShape},
    {"open", answer_open, Needs::kNothing, kAnotherShape},
    {"files", answer_files, Needs::kNothing},
    {"save", answer_save, Needs::kDocument},
    {"recover", answer_recover, Needs::kNothing, kAnotherShape},
    {"settle", answer_settle, Needs::kPlan, kAnotherShape},
    {"look", answer_look, Needs::kDocument},
    {"hold", answer_hold},
    {"run", answer_run},
    {"fields", answer_fields, Needs::kNothing},
    {"branches", answer_branches},
    {"branch_take", answer_branch_take},
    {"cancel", answer_cancel, Needs::kNothing},
    {"modes", answer_modes},
    {"mode_adopt", answer_mode_adopt},
    {"handle_begin", answer_handle_begin},
    {"handle_move", answer_handle_move},
    {"handle_radius", answer_handle_radius},
    {"handle_accept", answer_handle_accept},
    {"handle_cancel", answer_handle_cancel},
    {"export", answer_export, Needs::kDocument},
    {"picture", answer_picture, Needs::kNothing},
};

const RequestInfo* find(const std::string& name) {
  for (const RequestInfo& request : kRequests) {
    if (request.name == name) return &request;
  }
  return nullptr;
}

Answer answer_of(Desk& desk, int page, const Json& body) {
  Ask ask(body);
  const std::string verb = ask.text("do");
  if (!ask.status()) return ask.status().error();
  const RequestInfo* request = find(verb);
  if (request == nullptr) {
    std::vector<std::string> names;
    for (const RequestInfo& known : kRequests) names.emplace_back(known.name);
    return Error{ErrorCode::kUnknown, "/do", "there is no request \"" + verb + "\"", suggestion(verb, names)};
  }
  if (request->needs != Needs::kNothing && !desk.has_document()) {
    return Error{ErrorCode::kConflict, {}, "nothing is open", "open a file, a design or a template first"};
  }
  if (request->needs == Needs::kPlan && !desk.has_plan()) {
    return Error{ErrorCode::kUnsupported,
                 {},
                 "this structure was not drawn as a plan: it is here to be looked at",
                 "open or draw a plan to edit"};
  }
  return request->answer(desk, page, ask);
}

}  // namespace

Json answer_request(Desk& desk, int page, const Json& body) {
  const auto id = body.find("id");
  Json answer = {{"id", id != body.end() && id->is_number_integer() ? *id : Json(nullptr)}};
  Answer made = answer_of(desk, page, body);
  answer["ok"] = static_cast<bool>(made);
  if (made) {
    answer.update(made.value());
  } else {
    answer["error"] = error_json(made.error());
  }
  return answer;
}

bool asks_for_another_shape(const Json& body) {
  const auto verb = body.find("do");
  if (verb == body.end() || !verb->is_string()) return false;
  const RequestInfo* request = find(verb->get<std::string>());
  return request != nullptr && request->another_shape;
}

Answer answer_probe(Desk& desk, int page, Ask& ask) {
  (void)desk, (void)page;
  return Json{{"x", ask.value("x")}};
}

}  // namespace lissom
