#include "lissom/studio/kept_state.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "lissom/model/document.h"
#include "lissom/session/state_json.h"

namespace lissom {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

std::string write_kept_state(const ShapeSnapshot& shape) {
  if (!shape.state || !shape.mesh_of) return {};
  const Json json = {{"mesh_of", write_document(*shape.mesh_of, NetworkText::kRods)},
                     {"state", state_to_json(*shape.state)}};
  return json.dump();
}

std::optional<ShapeSnapshot> read_kept_state(std::string_view text) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object() || !json.contains("mesh_of") || !json["mesh_of"].is_string() || !json.contains("state")) {
    return std::nullopt;
  }
  Result<Model> model = read_document(json["mesh_of"].get<std::string>());
  Result<State> state = state_from_json(json["state"], "/state");
  if (!model || !state || !model.value().plan) return std::nullopt;
  Result<PlanMesh> mesh = PlanMesh::make(model.value());
  if (!mesh) return std::nullopt;
  return ShapeSnapshot{std::make_shared<const PlanMesh>(std::move(mesh).value()),
                       std::make_shared<const Model>(std::move(model).value()),
                       std::make_shared<const State>(std::move(state).value())};
}

}  // namespace lissom
