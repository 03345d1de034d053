#include "lissom/session/modes_json.h"

#include <nlohmann/json.hpp>

#include "lissom/session/layout_json.h"

namespace lissom {

namespace {

using Json = nlohmann::ordered_json;

enum class Shapes { kWith, kWithout };

Json numbers(const VecX& values) { return std::vector<double>(values.data(), values.data() + values.size()); }

Json body(const PoseModes& result, Shapes shapes) {
  Json json;
  json["pose"] = result.pose;
  const VerdictInfo& info = verdict_info(result.equilibrium.verdict);
  json["verdict"] = {{"name", info.name}, {"exit_code", info.exit_code}, {"message", result.equilibrium.message}};
  Json soft = Json::array(), vibrations = Json::array();
  for (const Mode& mode : result.equilibrium.modes) {
    Json entry = {{"stiffness_N_per_m", mode.stiffness}};
    if (shapes == Shapes::kWith) entry["shape"] = numbers(mode.shape);
    soft.push_back(std::move(entry));
  }
  for (const NaturalMode& mode : result.vibrations) {
    Json entry = {{"frequency_Hz", mode.frequency},
                  {"growth_rate_per_s", mode.growth_rate},
                  {"bending", mode.bending},
                  {"axial", mode.axial},
                  {"torsional", mode.torsional}};
    if (shapes == Shapes::kWith) entry["shape"] = numbers(mode.shape);
    vibrations.push_back(std::move(entry));
  }
  json["softest"] = std::move(soft);
  json["vibrations"] = std::move(vibrations);
  json["remark"] = result.remark;
  return json;
}

}  // namespace

std::string modes_text(const Document& document, const PoseModes& result) {
  Json json;
  json["lissom_modes"] = 1;
  json["document"] = {
      {"name", document.name}, {"title", document.model.title}, {"hash", document_hash(document.model)}};
  json.update(body(result, Shapes::kWith));
  return json_lines(json);
}

std::string modes_summary(const PoseModes& result) {
  Json json = body(result, Shapes::kWithout);
  json["files"] = file_list(result.files);
  return json_line(json);
}

}  // namespace lissom
