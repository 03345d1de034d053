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
constexpr int kVersion = 1;
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
  json["parameters"] = number_list(checkpoint.point.p);
  json["states"] = Json::array();
  for (const State& state : checkpoint.point.states) json["states"].push_back(state_to_json(state));
  json["descent"] = descent_to_json(checkpoint.descent);
  json["seconds"] = checkpoint.seconds;
  json["rms"] = checkpoint.rms;
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
  checkpoint.point.p = numbers.vector("parameters");
  const Json* states = numbers.list("states");
  const Json* descent = numbers.object("descent");
  const VecX seconds = numbers.vector("seconds");
  const Json* rms = numbers.list("rms");
  if (!numbers.status()) return numbers.status().error();
  for (std::size_t i = 0; i < states->size(); ++i) {
    Result<State> state = state_from_json((*states)[i], where + "/states/" + std::to_string(i));
    if (!state) return state.error();
    checkpoint.point.states.push_back(std::move(state).value());
  }
  Result<ConstrainedState> read = descent_from_json(*descent, where + "/descent");
  if (!read) return read.error();
  checkpoint.descent = std::move(read).value();
  checkpoint.seconds.assign(seconds.begin(), seconds.end());
  for (const Json& entry : *rms) {
    const Json row{{"rms", entry}};
    JsonNumbers own(row, where);
    const VecX values = own.vector("rms");
    if (!own.status()) return own.status().error();
    checkpoint.rms.emplace_back(values.begin(), values.end());
  }
  return checkpoint;
}

}  // namespace lissom
