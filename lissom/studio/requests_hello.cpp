#include "lissom/editing/edits_json.h"
#include "lissom/editing/plan_json.h"
#include "lissom/editing/templates.h"
#include "lissom/model/material.h"
#include "lissom/model/membrane.h"
#include "lissom/session/fields.h"
#include "lissom/studio/desk.h"
#include "lissom/studio/request_handlers.h"

namespace lissom {

namespace {

using Json = nlohmann::json;

constexpr int kProtocol = 1;

Json fields_json() {
  Json rods = Json::array(), fabric = Json::array();
  for (const FieldInfo& field : field_list()) {
    if (field.place == Field::Place::kNode) continue;
    Json entry = {{"name", field.name}, {"unit", field.display_unit}, {"sentence", field.description}};
    (field.place == Field::Place::kEdge ? rods : fabric).push_back(std::move(entry));
  }
  return {{"rods", rods}, {"fabric", fabric}};
}

Json templates_json() {
  Json list = Json::array();
  for (const Template& entry : templates()) {
    list.push_back({{"name", entry.name},
                    {"title", entry.title},
                    {"sentence", entry.sentence},
                    {"lines_mm", plan_lines_json(entry.make())}});
  }
  return list;
}

Json materials_json() {
  Json rods = Json::array(), fabric = Json::array();
  for (const Material& material : material_library()) rods.push_back(material.name);
  for (const MembraneMaterial& material : membrane_library()) fabric.push_back(material.name);
  return {{"rods", rods}, {"fabric", fabric}};
}

}  // namespace

Answer answer_hello(Desk& desk, int page, Ask& ask) {
  const int protocol = ask.integer("protocol", 1);
  if (!ask.status()) return ask.status().error();
  if (protocol != kProtocol) {
    return Error{ErrorCode::kUnsupported, "/protocol", "this page is of another version of lissom", "reload the page"};
  }
  // The answer comes first, then everything that there is to know.
  desk.inbox().hand_over([&desk, page] { desk.greet(page); });
  return Json{{"protocol", kProtocol},
              {"version", LISSOM_VERSION},
              {"folder", desk.store().folder().filename().string()},
              {"edits", edits_to_json()},
              {"fields", fields_json()},
              {"shown_fields", {{"rods", desk.shape().fields().rods}, {"fabric", desk.shape().fields().fabric}}},
              {"templates", templates_json()},
              {"materials", materials_json()}};
}

}  // namespace lissom
