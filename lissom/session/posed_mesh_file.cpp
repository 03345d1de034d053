#include "lissom/session/posed_mesh_file.h"

#include <nlohmann/json.hpp>

#include "lissom/session/layout_json.h"
#include "lissom/session/numbers_json.h"

namespace lissom {

namespace {

using Json = nlohmann::ordered_json;
constexpr int kVersion = 1;

VecX flat(const std::vector<Vec3>& places) {
  VecX values(3 * static_cast<Eigen::Index>(places.size()));
  for (std::size_t i = 0; i < places.size(); ++i) values.segment<3>(3 * static_cast<Eigen::Index>(i)) = places[i];
  return values;
}

Result<std::vector<Vec3>> places_of(const Json& json, const std::string& where) {
  JsonNumbers numbers(json, where);
  const VecX values = numbers.vector("targets");
  if (!numbers.status()) return numbers.status().error();
  std::vector<Vec3> places;
  for (Eigen::Index i = 0; i + 2 < values.size(); i += 3) places.emplace_back(values.segment<3>(i));
  return places;
}

}  // namespace

std::string posed_mesh_text(const PosedMesh& mesh, const std::string& hash) {
  Json json;
  json["lissom_posed_mesh"] = kVersion;
  json["project"] = hash;
  json["joints"] = mesh.joints;
  json["notes"] = mesh.notes;
  json["poses"] = Json::array();
  for (std::size_t k = 0; k < mesh.targets.size(); ++k) {
    json["poses"].push_back({{"name", mesh.model.poses[k].name}, {"targets", number_list(flat(mesh.targets[k]))}});
  }
  return json_lines(json);
}

Result<PosedMesh> read_posed_mesh(const std::string& text, const std::string& hash, Model model,
                                  const std::string& where) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded() || !json.is_object() || !json.contains("lissom_posed_mesh")) {
    return Error{ErrorCode::kSyntax, where, "this is not a posed rod mesh", "was the file edited or cut off?"};
  }
  JsonNumbers numbers(json, where);
  if (numbers.integer("lissom_posed_mesh") != kVersion || numbers.text("project") != hash) {
    return Error{ErrorCode::kConflict, where, "the project or one of its files has changed since", "start anew"};
  }
  PosedMesh mesh;
  mesh.joints = numbers.integer("joints");
  const Json* notes = numbers.list("notes");
  const Json* poses = numbers.list("poses");
  if (!numbers.status()) return numbers.status().error();
  for (const Json& note : *notes) {
    if (note.is_string()) mesh.notes.push_back(note.get<std::string>());
  }
  for (const Json& entry : *poses) {
    Result<std::vector<Vec3>> places = places_of(entry, where + "/poses");
    if (!places) return places.error();
    mesh.targets.push_back(std::move(places).value());
  }
  if (mesh.targets.size() != model.poses.size()) {
    return Error{ErrorCode::kConflict, where, "the document beside it has other poses", "start anew"};
  }
  mesh.model = std::move(model);
  return mesh;
}

}  // namespace lissom
