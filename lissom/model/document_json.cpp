#include <charconv>
#include <span>

#include "lissom/model/document.h"
#include "lissom/model/entries_json.h"

namespace lissom {
namespace {

constexpr std::pair<std::string_view, TorsionModel> kTorsions[] = {{"saint_venant", TorsionModel::kSaintVenant},
                                                                   {"polar", TorsionModel::kPolar}};
constexpr std::pair<std::string_view, JointKind> kJointKinds[] = {
    {"explicit", JointKind::kExplicit}, {"corotational", JointKind::kCorotational}, {"ball", JointKind::kBall}};
constexpr std::pair<std::string_view, JointWeights> kJointWeights[] = {{"energy", JointWeights::kEnergy},
                                                                       {"thesis", JointWeights::kThesis}};

struct VersionOf {
  void read(Reader& reader, const JsonValue& json, int& version) const {
    IntegerOf{1}.read(reader, json, version);
    if (reader.failed() || version <= kDocumentVersion) return;
    reader.fail(ErrorCode::kUnsupported,
                "the document has version " + std::to_string(version) + ", this lissom reads versions up to " +
                    std::to_string(kDocumentVersion),
                "update lissom");
  }
  JsonValue write(int version) const { return JsonValue::integer(version); }
  JsonValue schema(Schema&) const { return JsonValue::object().set("const", JsonValue::integer(kDocumentVersion)); }
};

/// The unit of bare numbers of one measure.
struct UnitOf {
  Measure measure;
  void read(Reader& reader, const JsonValue& json, std::optional<Unit>& unit) const {
    const MeasureInfo& what = info(measure);
    if (!json.is(JsonValue::Kind::kString))
      return reader.fail_kind("a unit such as \"" + std::string(what.si_unit) + "\"", json);
    Result<Unit> parsed = parse_unit(json.text);
    if (!parsed) return reader.fail(parsed.error());
    if (!compatible(dimension(measure), parsed.value().dimension)) {
      return reader.fail(ErrorCode::kUnit, "expected a unit of " + std::string(what.name) + " such as \"" +
                                               std::string(what.si_unit) + "\", got one of " +
                                               in_words(parsed.value().dimension));
    }
    unit = std::move(parsed).value();
  }
  JsonValue write(const std::optional<Unit>& unit) const { return unit ? JsonValue::string(unit->text) : JsonValue(); }
  JsonValue schema(Schema& schema) const { return TextOf{false}.schema(schema); }
};

/// A member that is itself optional would be emplaced; this hides it from the visitor.
struct UnitSlot {
  std::optional<Unit> unit;
};
struct UnitSlotOf {
  Measure measure;
  void read(Reader& reader, const JsonValue& json, UnitSlot& slot) const {
    UnitOf{measure}.read(reader, json, slot.unit);
  }
  JsonValue write(const UnitSlot& slot) const { return UnitOf{measure}.write(slot.unit); }
  JsonValue schema(Schema& schema) const { return UnitOf{measure}.schema(schema); }
};

struct UnitsEntry {
  std::array<UnitSlot, kMeasures> slots;
  UnitsEntry() {
    const UnitSettings defaults;
    for (std::size_t i = 0; i < slots.size(); ++i) slots[i].unit = defaults.units[i];
  }
};

void describe(Fields& fields, UnitsEntry& units) {
  for (std::size_t i = 0; i < units.slots.size(); ++i) {
    const Measure measure = static_cast<Measure>(i);
    if (measure == Measure::kRatio) continue;
    const MeasureInfo& what = info(measure);
    fields.field(what.key, units.slots[i], UnitSlotOf{measure}, kOptional,
                 "Unit of a bare number that is " + std::string(what.article) +
                     (what.default_unit.empty() ? "; without it such a number needs its own unit." : "."));
  }
}

constexpr ObjectOf<UnitsEntry> kUnits{"list of units"};

/// Read first, and taken over by the reader for everything after.
struct UnitsOf {
  void read(Reader& reader, const JsonValue& json, UnitsEntry& units) const {
    kUnits.read(reader, json, units);
    for (std::size_t i = 0; i < units.slots.size(); ++i) reader.units.units[i] = units.slots[i].unit;
  }
  JsonValue write(const UnitsEntry& units) const { return kUnits.write(units); }
  JsonValue schema(Schema& schema) const { return kUnits.schema(schema); }
};

/// A distance, or "never".
struct MergeDistanceOf {
  static constexpr NumberOf kDistance{Measure::kLength, kPositive};
  void read(Reader& reader, const JsonValue& json, double& value) const {
    if (json.is(JsonValue::Kind::kString) && json.text == "never") {
      value = -1;
    } else {
      kDistance.read(reader, json, value);
    }
  }
  JsonValue write(double value) const {
    if (value == 0) return {};
    return value < 0 ? JsonValue::string("never") : kDistance.write(value);
  }
  JsonValue schema(Schema& schema) const {
    return any_of({JsonValue::object().set("const", JsonValue::string("never")), kDistance.schema(schema)});
  }
};

struct JointsEntry {
  JointKind kind = JointKind::kExplicit;
  JointWeights weights = JointWeights::kEnergy;
  std::vector<JointChoice> exceptions;
  double merge_distance = 0;
};

struct DocumentEntry {
  int version = kDocumentVersion;
  UnitsEntry units;
  Model model;
  JointsEntry joints;
  std::vector<NetworkPart> networks;
};

void describe(Fields& fields, JointsEntry& joints) {
  fields
      .field("kind", joints.kind, ChoiceOf<JointKind>{kJointKinds}, kOptional,
             "How rods that meet hold each other: with a rotation of its own, with one that follows the rods, or not "
             "at all.")
      .field("weights", joints.weights, ChoiceOf<JointWeights>{kJointWeights}, kOptional,
             "Weights of corotational joints.")
      .field("exceptions", joints.exceptions, ListOf<ObjectOf<JointChoice>>{{"joint"}}, kOptional,
             "Joints of another kind.")
      .field("merge_distance", joints.merge_distance, MergeDistanceOf(), kOptional,
             "Nodes closer than this are one, or \"never\"; a millionth of the size when absent.");
}

void describe(Fields& fields, DocumentEntry& document) {
  Model& m = document.model;
  fields.field("lissom", document.version, VersionOf(), kRequired, "Version of the format.")
      .field("title", m.title, TextOf(), kOptional, "What this is.")
      .field("source", m.source, TextOf(), kOptional, "Where the description comes from.")
      .field("units", document.units, UnitsOf(), kOptional, "Units of bare numbers.")
      .field("torsion", m.torsion, ChoiceOf<TorsionModel>{kTorsions}, kOptional,
             "Torsion constant of sections: Saint-Venant's, or the polar second moment of area.")
      .field("materials", m.materials, TableOf<ObjectOf<Material>, Material>{{"material"}, &Material::name}, kOptional,
             "Materials besides the library, by name.")
      .field("rods", m.rods, ListOf<RodOf>{}, kOptional, "Rods.")
      .field("networks", document.networks, ListOf<NetworkOf>{}, kOptional, "Line networks, expanded into rods.")
      .field("membrane_materials", m.membrane_materials,
             TableOf<MembraneMaterialOf, MembraneMaterial>{{}, &MembraneMaterial::name}, kOptional,
             "Fabrics besides the library, by name.")
      .field("membranes", m.membranes, ListOf<MembraneOf>{}, kOptional, "Pieces of fabric.")
      .field("solids", m.solids, ListOf<SolidOf>{}, kOptional, "Elastic bodies.")
      .field("fabric_tests", m.fabric_tests, TableOf<FabricTestOf, FabricTest>{{}, &FabricTest::name}, kOptional,
             "Stretch tests of strips of fabric, by name, to which `lissom fit-fabric` fits moduli.")
      .field("plan", m.plan, PlanOf(), kOptional, "Rods drawn flat on pre-stretched fabric, besides the others.")
      .field("joints", document.joints, ObjectOf<JointsEntry>{"joint settings"}, kOptional,
             "How rods that meet hold each other.")
      .field("sets", m.sets, TableOf<NamedSetOf, NamedSet>{{}, &NamedSet::name}, kOptional, "Named sets of nodes.")
      .field("poses", m.poses, ListOf<PoseOf>{}, kOptional, "Situations: what is held, moved and loaded.")
      .field("motions", m.motions, ListOf<MotionOf>{}, kOptional, "Motions in time.")
      .field("design", m.design, BriefOf(), kOptional, "What `lissom optimize` may change, and what it should reach.")
      .field("calibration", m.calibration, CalibrationOf(), kOptional,
             "What `lissom calibrate` is to find, and from which measurements.")
      .field("expect", m.expectations, ListOf<ExpectationOf>{}, kOptional, "Numbers that `lissom verify` checks.");
}

constexpr ObjectOf<DocumentEntry> kDocument{"document"};

/// Which entry of "networks" the rods after the plain ones come from.
struct NetworkPlace {
  std::size_t entry = 0, rods = 0;
  bool from_file = false;
};

/// Plain rods first, then those of networks, those read from files last: then the files can be named again.
Model assembled(DocumentEntry&& document, std::vector<NetworkPlace>& places) {
  Model model = std::move(document.model);
  for (const bool files : {false, true}) {
    for (std::size_t i = 0; i < document.networks.size(); ++i) {
      NetworkPart& part = document.networks[i];
      if (part.file.has_value() != files) continue;
      places.push_back({i, part.rods.size(), files});
      for (Rod& rod : part.rods) model.rods.push_back(std::move(rod));
      if (files) model.network_files.push_back(std::move(*part.file));
    }
  }
  model.joint_kind = document.joints.kind;
  model.joint_weights = document.joints.weights;
  model.joints = std::move(document.joints.exceptions);
  model.merge_distance = document.joints.merge_distance;
  return model;
}

/// Moves the rods that are as their files say from the plain rods to networks. All or nothing: the order of rods counts.
void name_files(DocumentEntry& document) {
  std::vector<Rod>& rods = document.model.rods;
  std::size_t count = 0;
  for (const NetworkFile& file : document.model.network_files) count += static_cast<std::size_t>(file.rod_count);
  if (count > rods.size()) return;
  const std::size_t plain = rods.size() - count;
  std::size_t first = plain;
  std::vector<NetworkPart> networks;
  for (const NetworkFile& file : document.model.network_files) {
    const std::size_t size = static_cast<std::size_t>(file.rod_count);
    const std::span<const Rod> own(rods.data() + first, size);
    if (size == 0 || fingerprint(own) != file.fingerprint) return;
    networks.push_back({{own.begin(), own.end()}, file});
    first += size;
  }
  rods.resize(plain);
  document.networks = std::move(networks);
}

/// Rods of networks come after the others; a mistake in one of them is reported where the document says it.
std::string place_in_document(const std::string& where, std::size_t plain_rods,
                              const std::vector<NetworkPlace>& networks) {
  constexpr std::string_view kRods = "/rods/";
  if (!where.starts_with(kRods)) return where;
  std::size_t index = 0;
  const char* end = where.data() + where.size();
  const auto [rest, code] = std::from_chars(where.data() + kRods.size(), end, index);
  if (code != std::errc() || index < plain_rods) return where;
  index -= plain_rods;
  for (const NetworkPlace& place : networks) {
    if (index >= place.rods) {
      index -= place.rods;
      continue;
    }
    const std::string network = "/networks/" + std::to_string(place.entry), tail(rest, end);
    const bool in_curve = tail.empty() || tail.starts_with("/polyline") || tail.starts_with("/line");
    if (!in_curve) return network + tail;
    return network + (place.from_file ? "/file" : "/lines/" + std::to_string(index));
  }
  return where;
}

}  // namespace

// Found by argument-dependent lookup, hence in the namespace of the struct.
void describe(Fields& fields, JointChoice& choice) {
  fields.field("at", choice.at, SelectorOf(), kRequired, "Which joints.")
      .field("kind", choice.kind, ChoiceOf<JointKind>{kJointKinds}, kRequired, "Their kind.");
}

Result<Model> read_document(std::string_view text, const std::filesystem::path& folder) {
  if (text.size() > kLargestDocument) {
    return Error{ErrorCode::kFile,
                 {},
                 "the document is larger than " + std::to_string(kLargestDocument >> 20) + " MB",
                 "is it the right file?"};
  }
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  const Result<JsonValue> json = parse_json(text, kDeepestDocument);
  if (!json) return json.error();
  if (!json.value().is(JsonValue::Kind::kObject) || !json.value().find("lissom")) {
    return Error{ErrorCode::kType,
                 {},
                 "this is not a lissom document: the key \"lissom\" with the version is missing",
                 "a document begins with {\"lissom\": 1, ...}"};
  }
  Reader reader(folder);
  DocumentEntry document;
  kDocument.read(reader, json.value(), document);
  if (reader.failed()) return reader.error();
  const std::size_t plain_rods = document.model.rods.size();
  std::vector<NetworkPlace> networks;
  Model model = assembled(std::move(document), networks);
  if (const Status status = model.validate(); !status) {
    Error error = status.error();
    error.where = place_in_document(error.where, plain_rods, networks);
    return error;
  }
  return model;
}

std::string write_document(const Model& model, NetworkText networks) {
  DocumentEntry document;
  document.model = model;
  if (networks == NetworkText::kFiles) name_files(document);
  document.joints = {model.joint_kind, model.joint_weights, model.joints, model.merge_distance};
  return print_json(kDocument.write(document));
}

std::string document_schema() {
  Schema schema;
  const JsonValue root = kDocument.schema(schema);
  JsonValue json = JsonValue::object();
  json.set("$schema", JsonValue::string("https://json-schema.org/draft/2020-12/schema"));
  json.set("title", JsonValue::string("lissom document, version " + std::to_string(kDocumentVersion)));
  json.set("$ref", *root.find("$ref"));
  json.set("$defs", schema.definitions());
  return print_json(json);
}

}  // namespace lissom
