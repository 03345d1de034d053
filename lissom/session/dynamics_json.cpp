#include "lissom/session/dynamics_json.h"

#include <nlohmann/json.hpp>

#include "lissom/session/layout_json.h"

namespace lissom {

namespace {

using Json = nlohmann::ordered_json;

Json head(const PlayedMotion& played) {
  const MotionResult& r = played.result;
  const MotionVerdictInfo& info = motion_verdict_info(r.verdict);
  Json json;
  json["motion"] = played.motion;
  json["verdict"] = {{"name", info.name}, {"exit_code", info.exit_code}, {"message", r.message}};
  json["time"] = {{"value", r.last_time}, {"unit", "s"}};
  json["steps"] = r.steps;
  json["rejected_steps"] = r.rejected_steps;
  json["iterations"] = r.iterations;
  json["balance_error"] = r.balance_error();
  return json;
}

}  // namespace

std::string dynamics_text(const Document& document, const MotionCase& motion, const PlayedMotion& played) {
  Json json;
  json["lissom_motion"] = 1;
  json["document"] = {
      {"name", document.name}, {"title", document.model.title}, {"hash", document_hash(document.model)}};
  json["pose"] = motion.pose;
  json.update(head(played));
  json["columns"] = played.table.columns;
  json["records"] = played.table.rows;
  const VecX& q = played.result.last.q;
  json["last_unknowns"] = std::vector<double>(q.data(), q.data() + q.size());
  return json_lines(json);
}

std::string dynamics_summary(const PlayedMotion& played) {
  Json json = head(played);
  json["records"] = played.table.rows.size();
  json["files"] = file_list(played.files);
  return json_line(json);
}

}  // namespace lissom
