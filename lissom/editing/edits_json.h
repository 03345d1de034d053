#pragma once
/// Edits of a drawn plan as data: {"name": "move_points", "moves": [...]}. What there is stands in one list, from which the
/// studio's page, the reader and the documentation take names, fields and sentences (docs/studio/protocol.md, "Edits").
/// Lengths are mm and angles degrees in edits, SI in the model.

#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/model/model.h"

namespace lissom {

/// How names fared in an edit. What is not listed kept its name, or went.
struct NameChanges {
  std::map<std::string, std::string> points;             ///< of points: old -> new
  std::map<std::string, std::vector<std::string>> rods;  ///< of rods of the plan: old -> those that took its place
};

/// What an edit makes of a model.
struct EditOutcome {
  Model model;
  std::string title{};               ///< of the step, for people: "Move point b1-l"
  std::vector<std::string> notes{};  ///< what else had to change, one sentence each
  NameChanges names{};
};

/// One field of an edit.
struct EditField {
  std::string_view name;
  std::string_view
      kind;  ///< "point", "points", "rod", "rods", "place", "pair", "number", "text", "flag", "choice", "list"
  std::string_view unit;  ///< "mm", "deg", or empty
  bool optional = false;
  std::string_view sentence;
};

class EditReader;  // edit_reader.h

/// One kind of edit.
struct EditInfo {
  std::string_view name;
  std::string_view sentence;
  std::span<const EditField> fields;
  /// Reads the fields and changes a copy of the model. apply_edit() does what is common to all edits.
  Result<EditOutcome> (*apply)(const Model& model, EditReader& edit);
};

/// All of them, in the order in which people look for them.
std::span<const EditInfo* const> edits();

/// The model after an edit. Strict: unknown fields and names, wrong kinds and numbers that are not finite are refused, with
/// the place in the edit ("/edit/points/2"). The result has passed Model::validate(). With a mirror symmetry among the
/// constraints (tool_constraints.h), what an edit does to points on one side happens to their partners as well.
Result<EditOutcome> apply_edit(const Model& model, const nlohmann::json& edit);

/// The list for the page: [{name, sentence, fields: [{name, kind, unit, optional, sentence}]}].
nlohmann::json edits_to_json();

/// JSON of a stranger: refuses syntax errors, repeated keys, invalid UTF-8, numbers beyond a double and brackets nested
/// deeper than `depth`.
Result<nlohmann::json> read_json(std::string_view text, int depth = 32);

}  // namespace lissom
