#include "lissom/model/entries_json.h"
#include "lissom/model/limits.h"

namespace lissom {
namespace {

struct RodEntry {
  std::string name;
  CurveEntry curve;
  RodSettings settings;
};

void describe(Fields& fields, RodEntry& rod) {
  fields.field("name", rod.name, TextOf{false}, kRequired, "Name of the rod, used by selectors.");
  describe_curve(fields, rod.curve);
  describe_settings(fields, rod.settings);
}

constexpr ObjectOf<RodEntry> kRod{"rod"};

}  // namespace

void describe_settings(Fields& fields, RodSettings& rod) {
  fields.field("edges", rod.edges, IntegerOf{1, kMostNodes}, kOptional, "Number of edges (or give edge_length).")
      .field("edge_length", rod.edge_length, NumberOf{Measure::kLength, kPositive}, kOptional,
             "Length that the edges should have (or give edges).")
      .field("material", rod.material, TextOf{false}, kRequired,
             "Name of a material of the document or of the library.")
      .field("section", rod.section, SectionOf(), kRequired, "Cross-section.")
      .field("axes", rod.axes, AxesOf(), kOptional, "Where the material axis n points.")
      .field("natural", rod.natural, NaturalOf(), kOptional, "The shape that is free of stress.");
}

void apply(Reader& reader, const RodSettings& settings, Rod& rod) {
  if ((settings.edges > 0) == (settings.edge_length > 0)) {
    const bool both = settings.edges > 0;
    return reader.fail(
        both ? ErrorCode::kConflict : ErrorCode::kType,
        both ? "both \"edges\" and \"edge_length\" are given" : "neither \"edges\" nor \"edge_length\" is given",
        both ? "keep one of them" : "say into how many edges the rod is cut, for example \"edges\": 50");
  }
  rod.edges = settings.edges;
  rod.edge_length = settings.edge_length;
  rod.material = settings.material;
  rod.section = settings.section;
  rod.axes = settings.axes;
  rod.natural = settings.natural;
}

void describe(Fields& fields, Material& material) {
  fields
      .field("youngs_modulus", material.youngs_modulus, NumberOf{Measure::kStress, kPositive}, kRequired,
             "Young's modulus.")
      .field("poisson_ratio", material.poisson_ratio, NumberOf{Measure::kRatio, between(-1, 0.5)}, kRequired,
             "Poisson ratio.")
      .field("density", material.density, NumberOf{Measure::kDensity, kNotNegative}, kOptional,
             "Density; 0 is weightless.")
      .field("strain_limit", material.strain_limit, NumberOf{Measure::kRatio, kPositive}, kOptional,
             "Largest strain in use (yield or fatigue).")
      .field("source", material.source, TextOf(), kOptional, "Where the numbers come from.");
}

void RodOf::read(Reader& reader, const JsonValue& json, Rod& rod) const {
  RodEntry entry;
  kRod.read(reader, json, entry);
  if (!reader.failed()) to_model(reader, entry.curve, rod.curve);
  if (reader.failed()) return;
  rod.name = entry.name;
  apply(reader, entry.settings, rod);
}

JsonValue RodOf::write(const Rod& rod) const {
  RodEntry entry;
  entry.name = rod.name;
  to_entry(rod.curve, entry.curve);
  entry.settings = {rod.edges, rod.edge_length, rod.material, rod.section, rod.axes, rod.natural};
  return kRod.write(entry);
}

JsonValue RodOf::schema(Schema& schema) const { return kRod.schema(schema); }

std::uint64_t fingerprint(std::span<const Rod> rods) {
  std::uint64_t hash = 14695981039346656037ULL;  // FNV-1a
  for (const Rod& rod : rods) {
    for (const char c : print_json(RodOf().write(rod))) {
      hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
    }
  }
  return hash;
}

}  // namespace lissom
