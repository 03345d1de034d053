#include "lissom/session/design_checkpoint.h"

#include <nlohmann/json.hpp>

#include "lissom/session/document_file.h"
#include "lissom/session/layout_json.h"
#include "lissom/session/numbers_json.h"
#include "lissom/session/optimizer_json.h"
#include "lissom/session/state_json.h"

namespace lissom {

namespace {
using Json = nlohmann::ordered_json;
constexpr int kVersion = 2;

Result<DesignStep> step_from_json(const Json& json, const std::string& where) {
  JsonNumbers numbers(json, where);
  DesignStep step;
  step.stage = numbers.integer("stage");
  step.seconds = numbers.number("seconds");
  const VecX rms = numbers.vector("rms");
  const Json* record = numbers.object("record");
  if (!numbers.status()) return numbers.status().error();
  step.rms.assign(rms.begin(), rms.end());
  Result<DesignRecord> read = record_from_json(*record, where + "/record");
  if (!read) return read.error();
  step.record = std::move(read).value();
  return step;
}
}  // namespace

std::string design_fingerprint(const Model& model) {
  Model same = model;
  if (same.design) same.design->settings.iterations = DesignSettings().iterations;
  return document_hash(same);
}

std::string checkpoint_text(const DesignCheckpoint& checkpoint, const std::string& fingerprint) {
  Json json;
  json["lissom_design"] = kVersion;
  json["fingerprint"] = fingerprint;
  json["stage"] = checkpoint.stage;
  json["parameters"] = number_list(checkpoint.point.p);
  json["pin_factors"] = number_list(checkpoint.point.pin_factors);
  json["states"] = Json::array();
  for (const State& state : checkpoint.point.states) json["states"].push_back(state_to_json(state));
  json["descent"] = descent_to_json(checkpoint.descent);
  json["steps"] = Json::array();
  for (const DesignStep& step : checkpoint.steps) {
    json["steps"].push_back(
        {{"stage", step.stage}, {"seconds", step.seconds}, {"rms", step.rms}, {"record", record_to_json(step.record)}});
  }
  return json_lines(json);
}

Result<DesignCheckpoint> read_checkpoint(const std::string& text, const std::string& fingerprint,
                                         const std::string& where) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded() || !json.is_object() || !json.contains("lissom_design")) {
    return Error{ErrorCode::kSyntax, where, "this is not a checkpoint of a design", "was the file edited or cut off?"};
  }
  JsonNumbers numbers(json, where);
  if (numbers.integer("lissom_design") != kVersion) {
    return Error{ErrorCode::kUnsupported, where, "the checkpoint is of another version of lissom",
                 "start the run anew"};
  }
  if (numbers.text("fingerprint") != fingerprint) {
    return Error{ErrorCode::kConflict, where, "the checkpoint was made from another document or with other options",
                 "resume with what it was made from, or start anew without --resume"};
  }
  DesignCheckpoint checkpoint;
  checkpoint.stage = numbers.integer("stage");
  checkpoint.point.p = numbers.vector("parameters");
  checkpoint.point.pin_factors = numbers.vector("pin_factors");
  const Json* states = numbers.list("states");
  const Json* descent = numbers.object("descent");
  const Json* steps = numbers.list("steps");
  if (!numbers.status()) return numbers.status().error();
  for (std::size_t i = 0; i < states->size(); ++i) {
    Result<State> state = state_from_json((*states)[i], where + "/states/" + std::to_string(i));
    if (!state) return state.error();
    checkpoint.point.states.push_back(std::move(state).value());
  }
  Result<ConstrainedState> read = descent_from_json(*descent, where + "/descent");
  if (!read) return read.error();
  checkpoint.descent = std::move(read).value();
  for (const Json& entry : *steps) {
    Result<DesignStep> step = step_from_json(entry, where + "/steps");
    if (!step) return step.error();
    checkpoint.steps.push_back(std::move(step).value());
  }
  return checkpoint;
}

}  // namespace lissom
