#include "lissom/editing/edits_json.h"

#include <algorithm>
#include <fmt/format.h>

#include "lissom/core/nearest_name.h"
#include "lissom/editing/edit_list.h"
#include "lissom/editing/kept_references.h"
#include "lissom/editing/mirrored_plan.h"
#include "lissom/model/check_plan.h"
#include "lissom/model/json_value.h"

namespace lissom {

namespace {

constexpr const EditInfo* kEdits[] = {
    &kEditMovePoints, &kEditTransformPoints, &kEditAddRod,         &kEditInsertPoint, &kEditRemove,
    &kEditSetRadii,   &kEditSetRole,         &kEditSetSplit,       &kEditSetCurve,    &kEditSetClosed,
    &kEditSplitRod,   &kEditJoinRods,        &kEditMergePoints,    &kEditRename,      &kEditMirror,
    &kEditSetFabric,  &kEditSetPreStretch,   &kEditSetRods,        &kEditAddHole,     &kEditRemoveHole,
    &kEditStrengthen, &kEditSetTitle,        &kEditSetConstraints, &kEditSetDesign,
};

constexpr const char* kPlace = "/edit";

Result<const EditInfo*> info_of(const nlohmann::json& edit) {
  if (!edit.is_object()) {
    return Error{ErrorCode::kType, kPlace, "an edit is an object", "write {\"name\": \"move_points\", ...}"};
  }
  const auto name = edit.find("name");
  std::vector<std::string> names;
  for (const EditInfo* info : kEdits) names.emplace_back(info->name);
  if (name == edit.end() || !name->is_string()) {
    return Error{ErrorCode::kType, std::string(kPlace) + "/name", "the edit has no name", suggestion("", names)};
  }
  const std::string& wanted = name->get_ref<const std::string&>();
  for (const EditInfo* info : kEdits) {
    if (info->name == wanted) return info;
  }
  return Error{ErrorCode::kUnknown, std::string(kPlace) + "/name", fmt::format("there is no edit \"{}\"", wanted),
               suggestion(wanted, names)};
}

}  // namespace

std::span<const EditInfo* const> edits() { return kEdits; }

Result<EditOutcome> apply_edit(const Model& model, const nlohmann::json& edit) {
  const Result<const EditInfo*> info = info_of(edit);
  if (!info) return info.error();
  if (!model.plan) {
    return Error{ErrorCode::kConflict, kPlace, "this document has no plan to edit", "open one that is drawn on fabric"};
  }
  std::vector<std::string_view> keys{"name"};
  for (const EditField& field : info.value()->fields) keys.push_back(field.name);
  Status status;
  EditReader reader(edit, kPlace, *model.plan, status);
  reader.only(keys);
  if (!status) return status.error();
  Result<EditOutcome> outcome = info.value()->apply(model, reader);
  if (!outcome) return outcome;
  if (const std::optional<PlanMirror> mirror = constraints_of(model).symmetric) {
    keep_symmetry(*model.plan, *outcome.value().model.plan, *mirror);
  }
  if (Status s = check_plan(outcome.value().model); !s) return s.error();
  keep_references(model, outcome.value());
  if (Status s = outcome.value().model.validate(); !s) return s.error();
  return outcome;
}

nlohmann::json edits_to_json() {
  nlohmann::json list = nlohmann::json::array();
  for (const EditInfo* info : kEdits) {
    nlohmann::json fields = nlohmann::json::array();
    for (const EditField& field : info->fields) {
      fields.push_back({{"name", field.name},
                        {"kind", field.kind},
                        {"unit", field.unit},
                        {"optional", field.optional},
                        {"sentence", field.sentence}});
    }
    list.push_back({{"name", info->name}, {"sentence", info->sentence}, {"fields", std::move(fields)}});
  }
  return list;
}

Result<nlohmann::json> read_json(std::string_view text, int depth) {
  // Repeated keys, which nlohmann lets pass, and the depth of brackets are seen by our own reader.
  if (const Result<JsonValue> checked = parse_json(text, depth); !checked) return checked.error();
  nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_discarded()) return json;
  return Error{ErrorCode::kSyntax, {}, "this is not JSON that can be read", "are its numbers too large?"};
}

}  // namespace lissom
