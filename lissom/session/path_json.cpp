#include "lissom/session/path_json.h"

#include <nlohmann/json.hpp>

#include "lissom/session/layout_json.h"

namespace lissom {

namespace {

using Json = nlohmann::ordered_json;

Json table_json(const Table& table) {
  Json rows = Json::array();
  for (const std::vector<double>& row : table.rows) {
    Json entry = Json::object();
    for (size_t i = 0; i < row.size(); ++i) entry[table.columns[i]] = row[i];
    rows.push_back(std::move(entry));
  }
  return rows;
}

Json critical_json(const PathResult& path) {
  Json list = Json::array();
  for (const CriticalPoint& point : path.critical) {
    list.push_back({{"kind", critical_kind_name(point.kind)},
                    {"load_factor", point.load_factor},
                    {"lowest_stiffness_N_per_m", point.mode.stiffness},
                    {"negative_modes_before", point.negative_before},
                    {"negative_modes_after", point.negative_after}});
  }
  return list;
}

Json head(const FollowedPose& followed) {
  Json json;
  json["pose"] = followed.pose;
  json["end"] = {{"name", path_end_info(followed.path.end).name},
                 {"exit_code", path_end_info(followed.path.end).exit_code},
                 {"message", followed.path.message}};
  json["critical"] = critical_json(followed.path);
  json["factorizations"] = followed.path.factorizations;
  json["watched"] = followed.watched;
  return json;
}

}  // namespace

std::string path_text(const Document& document, const FollowedPose& followed) {
  Json json;
  json["lissom_path"] = 1;
  json["document"] = {
      {"name", document.name}, {"title", document.model.title}, {"hash", document_hash(document.model)}};
  json.update(head(followed));
  Json modes = Json::array();
  for (const CriticalPoint& point : followed.path.critical) {
    const std::vector<double> shape(point.mode.shape.data(), point.mode.shape.data() + point.mode.shape.size());
    const std::vector<double> unknowns(point.state.q.data(), point.state.q.data() + point.state.q.size());
    modes.push_back({{"unknowns", unknowns}, {"mode", shape}});
  }
  json["critical_states"] = std::move(modes);
  json["points"] = table_json(followed.table);
  return json_lines(json);
}

std::string path_summary(const FollowedPose& followed) {
  Json json = head(followed);
  json["points"] = table_json(followed.table);
  json["files"] = file_list(followed.files);
  return json_line(json);
}

}  // namespace lissom
