#pragma once
/// Codecs of the parts that several files of the document reader share.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lissom/model/codecs_json.h"
#include "lissom/model/model.h"

namespace lissom {

/// A curve as written: exactly one of the five kinds.
struct CurveEntry {
  std::optional<std::vector<Vec3>> polyline, spline, line;
  std::optional<Arc> arc;
  std::optional<Helix> helix;
  bool closed = false;
};

/// The keys of a curve, inside whatever object carries them.
void describe_curve(Fields& fields, CurveEntry& entry);
void to_model(Reader& reader, const CurveEntry& entry, Curve& curve);
void to_entry(const Curve& curve, CurveEntry& entry);

void describe(Fields& fields, CurveEntry& entry);
void describe(Fields& fields, Arc& arc);
void describe(Fields& fields, Helix& helix);
void describe(Fields& fields, Material& material);

/// "joints", {"normal": ...}, {"transport": ...} or {"per_point": ...}.
struct AxesOf {
  void read(Reader& reader, const JsonValue& json, MaterialAxes& axes) const;
  JsonValue write(const MaterialAxes& axes) const;
  JsonValue schema(Schema& schema) const;
};

/// "as_drawn", "straight", {"curvature_b": ...} or {"curve": ...}.
struct NaturalOf {
  void read(Reader& reader, const JsonValue& json, Natural& natural) const;
  JsonValue write(const Natural& natural) const;
  JsonValue schema(Schema& schema) const;
};

/// {"radius": ...} and the other ways to give a cross-section.
struct SectionOf {
  void read(Reader& reader, const JsonValue& json, SectionProfile& section) const;
  JsonValue write(const SectionProfile& section) const;
  JsonValue schema(Schema& schema) const;
};

/// What rods have in common besides their curve.
struct RodSettings {
  int edges = 0;
  double edge_length = 0;
  std::string material;
  SectionProfile section;
  MaterialAxes axes;
  Natural natural;
};
void describe_settings(Fields& fields, RodSettings& rod);
void apply(Reader& reader, const RodSettings& settings, Rod& rod);

struct RodOf {
  void read(Reader& reader, const JsonValue& json, Rod& rod) const;
  JsonValue write(const Rod& rod) const;
  JsonValue schema(Schema& schema) const;
};

/// One entry of "networks": the rods that it stands for, and the file when it names one.
struct NetworkPart {
  std::vector<Rod> rods;
  std::optional<NetworkFile> file;
};

/// A line network, expanded into rods. Only those that name a file are written.
struct NetworkOf {
  void read(Reader& reader, const JsonValue& json, NetworkPart& part) const;
  JsonValue write(const NetworkPart& part) const;
  JsonValue schema(Schema& schema) const;
};

/// A number that changes with anything in a document that describes these rods.
std::uint64_t fingerprint(std::span<const Rod> rods);

/// A fabric: its stiffness by width, or Young's modulus and thickness.
struct MembraneMaterialOf {
  void read(Reader& reader, const JsonValue& json, MembraneMaterial& material) const;
  JsonValue write(const MembraneMaterial& material) const;
  JsonValue schema(Schema& schema) const;
};

struct MembraneOf {
  void read(Reader& reader, const JsonValue& json, Membrane& membrane) const;
  JsonValue write(const Membrane& membrane) const;
  JsonValue schema(Schema& schema) const;
};

struct SolidOf {
  void read(Reader& reader, const JsonValue& json, Solid& solid) const;
  JsonValue write(const Solid& solid) const;
  JsonValue schema(Schema& schema) const;
};

/// A list of pulls.
struct FabricTestOf {
  void read(Reader& reader, const JsonValue& json, FabricTest& test) const;
  JsonValue write(const FabricTest& test) const;
  JsonValue schema(Schema& schema) const;
};

void describe(Fields& fields, Fabric& fabric);

/// Rods drawn on fabric.
struct PlanOf {
  void read(Reader& reader, const JsonValue& json, Plan& plan) const;
  JsonValue write(const Plan& plan) const;
  JsonValue schema(Schema& schema) const;
};

/// How a document names nodes.
struct SelectorOf {
  void read(Reader& reader, const JsonValue& json, Selector& selector) const;
  JsonValue write(const Selector& selector) const;
  JsonValue schema(Schema& schema) const;
};

struct NamedSetOf {
  void read(Reader& reader, const JsonValue& json, NamedSet& set) const { SelectorOf().read(reader, json, set.nodes); }
  JsonValue write(const NamedSet& set) const { return SelectorOf().write(set.nodes); }
  JsonValue schema(Schema& schema) const { return SelectorOf().schema(schema); }
};

struct SupportOf {
  void read(Reader& reader, const JsonValue& json, Support& support) const;
  JsonValue write(const Support& support) const;
  JsonValue schema(Schema& schema) const;
};

struct ExpectationOf {
  void read(Reader& reader, const JsonValue& json, Expectation& expectation) const;
  JsonValue write(const Expectation& expectation) const;
  JsonValue schema(Schema& schema) const;
};

struct PoseOf {
  void read(Reader& reader, const JsonValue& json, Pose& pose) const;
  JsonValue write(const Pose& pose) const;
  JsonValue schema(Schema& schema) const;
};

/// What a design may change and should reach.
struct BriefOf {
  void read(Reader& reader, const JsonValue& json, Brief& brief) const;
  JsonValue write(const Brief& brief) const;
  JsonValue schema(Schema& schema) const;
};

/// Which material numbers are unknown, and what was measured.
struct CalibrationOf {
  void read(Reader& reader, const JsonValue& json, Calibration& calibration) const;
  JsonValue write(const Calibration& calibration) const;
  JsonValue schema(Schema& schema) const;
};

struct MotionOf {
  void read(Reader& reader, const JsonValue& json, MotionCase& motion) const;
  JsonValue write(const MotionCase& motion) const;
  JsonValue schema(Schema& schema) const;
};

}  // namespace lissom
