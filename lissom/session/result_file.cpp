#include "lissom/session/result_file.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <span>

#include "lissom/mechanics/membrane_strain.h"
#include "lissom/model/document.h"
#include "lissom/session/layout_json.h"
#include "lissom/session/state_json.h"
#include "lissom/session/totals.h"
#include "lissom/session/warnings.h"

namespace lissom {

namespace {

using Json = nlohmann::ordered_json;

Json energies_of(const Equilibrium& e) {
  Json terms = Json::object();
  for (const EnergyShare& share : e.energy_shares) terms[share.term] = share.energy;
  return terms;
}

Json modes_of(const Equilibrium& e) {
  Json modes = Json::array();
  for (const Mode& mode : e.modes) modes.push_back(mode.stiffness);
  return modes;
}

Json worst_of(const Equilibrium& e) {
  Json list = Json::array();
  for (const WorstElement& w : e.worst) {
    Json entry = {{"what", w.what}};
    if (w.triangle < 0) entry["rod"] = w.rod;
    if (w.triangle >= 0) entry["membrane"] = w.membrane;
    if (w.node >= 0) entry["node"] = w.node;
    if (w.edge >= 0) entry["edge"] = w.edge;
    if (w.triangle >= 0) entry["triangle"] = w.triangle;
    entry["value"] = w.value;
    entry["unit"] = w.unit.empty() ? "1" : w.unit;
    list.push_back(std::move(entry));
  }
  return list;
}

Json records_of(const Equilibrium& e) {
  Json list = Json::array();
  for (const IterationRecord& r : e.records) {
    list.push_back({{"iteration", r.iteration},
                    {"load_factor", r.load_factor},
                    {"energy", r.energy},
                    {"residual", r.residual},
                    {"shift", r.shift},
                    {"step", r.step},
                    {"turn", r.turn},
                    {"factorizations", r.factorizations}});
  }
  return list;
}

Json verdict_of(const Equilibrium& e) {
  const VerdictInfo& info = verdict_info(e.verdict);
  return {{"name", info.name}, {"exit_code", info.exit_code}, {"message", e.message}};
}

Json point(const Vec3& p) { return Json::array({p.x(), p.y(), p.z()}); }

Json totals_of(const Totals& t) {
  return {{"low", point(t.low)},
          {"high", point(t.high)},
          {"height", t.height},
          {"area", t.area},
          {"rest_area", t.rest_area},
          {"slack_area", t.slack_area},
          {"smallest_stretch", t.smallest_stretch},
          {"units", {{"length", "m"}, {"area", "m^2"}}}};
}

Json warnings_of(const std::vector<Warning>& warnings) {
  Json list = Json::array();
  for (const Warning& w : warnings) {
    list.push_back({{"what", w.what}, {"where", w.where}, {"value", w.value}, {"unit", w.unit}, {"remedy", w.remedy}});
  }
  return list;
}

Json summary_of(const Pose& pose, const System& system, const std::vector<std::string>& removed, const Equilibrium& e,
                const std::vector<Warning>& warnings) {
  Json json;
  json["pose"] = pose.name;
  json["verdict"] = verdict_of(e);
  json["load_factor"] = e.state.load_factor;
  json["residual"] = {{"value", e.residual}, {"tolerance", e.tolerance}, {"unit", "N"}};
  json["iterations"] = e.iterations;
  json["factorizations"] = e.factorizations;
  json["unknowns"] = system.layout.size();
  json["energy"] = {{"total", e.energy}, {"terms", energies_of(e)}, {"unit", "J"}};
  json["modes"] = {{"stiffness", modes_of(e)}, {"negative", e.negative_modes}, {"unit", "N/m"}};
  json["worst"] = worst_of(e);
  if (!system.structure.triangles.empty() && e.verdict != Verdict::kBadStart) {
    const double share = stretch_share(pose, e.state.load_factor);
    json["totals"] = totals_of(totals(system, e.state, share));
  }
  const bool watched = !system.structure.triangles.empty() || !system.structure.tetrahedra.empty();
  if (watched && e.verdict != Verdict::kBadStart) json["warnings"] = warnings_of(warnings);
  json["removed_motions"] = removed;
  json["notes"] = system.structure.notes;
  return json;
}

}  // namespace

std::string result_text(const Document& document, const Pose& pose, const System& system,
                        const std::vector<std::string>& removed_motions, const Equilibrium& equilibrium,
                        const std::vector<Warning>& warnings) {
  Json json;
  json["lissom_result"] = kResultVersion;
  json["document"] = {{"name", document.name},
                      {"title", document.model.title},
                      {"hash", document_hash(document.model)},
                      {"text", write_document(document.model, NetworkText::kRods)}};
  json.update(summary_of(pose, system, removed_motions, equilibrium, warnings));
  json["records"] = records_of(equilibrium);
  const VecX& reaction = equilibrium.reaction;
  json["reaction"] = std::span<const double>(reaction.data(), static_cast<size_t>(reaction.size()));
  json["state"] = state_to_json(equilibrium.state);
  return json_lines(json);
}

std::string result_summary(const Pose& pose, const System& system, const std::vector<std::string>& removed_motions,
                           const Equilibrium& equilibrium, const std::vector<Warning>& warnings,
                           const std::vector<std::filesystem::path>& files) {
  Json json = summary_of(pose, system, removed_motions, equilibrium, warnings);
  json["files"] = file_list(files);
  return json_line(json);
}

Result<SavedResult> read_result(std::string_view text, const std::string& name) {
  const Json json = Json::parse(text, nullptr, false);
  const auto wrong = [&](const std::string& where, const std::string& message) {
    return Error{ErrorCode::kSyntax, name + where, message, "name a file that `lissom solve` has written"};
  };
  if (json.is_discarded() || !json.is_object() || !json.contains("lissom_result")) {
    return wrong("", "this is not a result of lissom");
  }
  if (!json["lissom_result"].is_number_integer() || json["lissom_result"].get<long long>() != kResultVersion) {
    return wrong(": /lissom_result", "the result has another version than this lissom reads");
  }
  const auto text_at = [&](const Json& object, const char* key) -> std::string {
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
  };
  const auto document = json.find("document"), state = json.find("state");
  if (document == json.end() || !document->is_object()) return wrong(": /document", "the document is missing");
  if (state == json.end()) return wrong(": /state", "the state is missing");
  Result<Model> model = read_document(text_at(*document, "text"));
  if (!model) return wrong(": /document/text", "its document cannot be read: " + model.error().text());
  Result<State> restored = state_from_json(*state, name + ": /state");
  if (!restored) return restored.error();
  SavedResult saved;
  saved.document.name = text_at(*document, "name");
  saved.document.model = std::move(model).value();
  saved.pose = text_at(json, "pose");
  if (saved.document.model.pose(saved.pose) == nullptr) return wrong(": /pose", "its document has no such pose");
  const auto verdict = json.find("verdict");
  if (verdict != json.end() && verdict->is_object()) saved.verdict = text_at(*verdict, "name");
  saved.state = std::move(restored).value();
  return saved;
}

Status check_state(const System& system, const State& state) {
  const auto differs = [](const char* what, size_t got, size_t wanted) {
    return Error{ErrorCode::kConflict,
                 {},
                 "the result belongs to another structure: it has " + std::to_string(got) + " " + what + ", this one " +
                     std::to_string(wanted),
                 "resume from a result of this document"};
  };
  const Structure& s = system.structure;
  if (state.edges.size() != s.edges.size()) return differs("edges", state.edges.size(), s.edges.size());
  if (state.q.size() != system.layout.size()) {
    return differs("unknowns", static_cast<size_t>(state.q.size()), static_cast<size_t>(system.layout.size()));
  }
  if (state.joint_rotation.size() != s.joints.size())
    return differs("joints", state.joint_rotation.size(), s.joints.size());
  if (state.joint_turn.size() != s.joints.size())
    return differs("turns of joints", state.joint_turn.size(), s.joints.size());
  if (state.pair_twist.size() != s.pairs.size())
    return differs("inner vertices", state.pair_twist.size(), s.pairs.size());
  if (state.connection_twist.size() != system.connections.size()) {
    return differs("rod ends at joints", state.connection_twist.size(), system.connections.size());
  }
  for (const StructureEdge& edge : s.edges) {
    const size_t e = static_cast<size_t>(&edge - s.edges.data());
    const double length = (state.position(edge.node1) - state.position(edge.node0)).norm();
    if (std::abs(length - state.edges[e].length) <= 1e-9 * length) continue;
    return Error{ErrorCode::kConflict,
                 {},
                 "the result belongs to another structure: its edges join other nodes",
                 "resume from a result of this document"};
  }
  return {};
}

}  // namespace lissom
