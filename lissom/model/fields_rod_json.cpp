#include "lissom/model/entries_json.h"

namespace lissom {
namespace {

/// What rods have in common besides their curve.
struct RodSettings {
  int edges = 0;
  double edge_length = 0;
  std::string material;
  SectionProfile section;
  MaterialAxes axes;
  Natural natural;
};

void describe_settings(Fields& fields, RodSettings& rod) {
  fields.field("edges", rod.edges, IntegerOf{1, 10'000'000}, kOptional, "Number of edges (or give edge_length).")
      .field("edge_length", rod.edge_length, NumberOf{Measure::kLength, kPositive}, kOptional,
             "Length that the edges should have (or give edges).")
      .field("material", rod.material, TextOf{false}, kRequired,
             "Name of a material of the document or of the library.")
      .field("section", rod.section, SectionOf(), kRequired, "Cross-section.")
      .field("axes", rod.axes, AxesOf(), kOptional, "Where the material axis n points.")
      .field("natural", rod.natural, NaturalOf(), kOptional, "The shape that is free of stress.");
}

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

struct NetworkEntry {
  std::string name;
  std::vector<Vec3> points;
  std::vector<std::vector<int>> lines;
  RodSettings settings;
};

void describe(Fields& fields, NetworkEntry& network) {
  fields
      .field("name", network.name, TextOf{false}, kRequired,
             "Its rods are called NAME-0, NAME-1, ... in the order of the lines.")
      .field("points", network.points, ListOf<VectorOf>{{Measure::kLength}, 2}, kRequired, "Points, counted from 0.")
      .field("lines", network.lines, ListOf<ListOf<IntegerOf>>{{{}, 2}, 1}, kRequired,
             "One rod each: the numbers of the points that it runs through.");
  describe_settings(fields, network.settings);
}

constexpr ObjectOf<RodEntry> kRod{"rod"};
constexpr ObjectOf<NetworkEntry> kNetwork{"network"};

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

}  // namespace

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

void NetworkOf::read(Reader& reader, const JsonValue& json, std::vector<Rod>& rods) const {
  NetworkEntry entry;
  kNetwork.read(reader, json, entry);
  if (reader.failed()) return;
  Rod common;
  apply(reader, entry.settings, common);
  const Reader::Step in_lines(reader, "lines");
  for (std::size_t i = 0; i < entry.lines.size() && !reader.failed(); ++i) {
    const Reader::Step in_line(reader, i);
    Polyline polyline;
    for (std::size_t j = 0; j < entry.lines[i].size(); ++j) {
      const std::size_t number = static_cast<std::size_t>(entry.lines[i][j]);
      if (number >= entry.points.size()) {
        const Reader::Step step(reader, j);
        return reader.fail(ErrorCode::kUnknown, "there is no point " + std::to_string(number),
                           "the points are counted from 0 to " + std::to_string(entry.points.size() - 1));
      }
      polyline.points.push_back(entry.points[number]);
    }
    polyline.closed = polyline.points.size() > 3 && entry.lines[i].front() == entry.lines[i].back();
    if (polyline.closed) polyline.points.pop_back();
    Rod& rod = rods.emplace_back(common);
    rod.name = entry.name + "-" + std::to_string(i);
    rod.curve = std::move(polyline);
  }
}

JsonValue NetworkOf::schema(Schema& schema) const { return kNetwork.schema(schema); }

}  // namespace lissom
