#include <algorithm>

#include "lissom/core/file_io.h"
#include "lissom/model/document.h"
#include "lissom/model/entries_json.h"
#include "lissom/model/import_network.h"

namespace lissom {
namespace {

constexpr std::pair<std::string_view, NetworkRods> kRodChoices[] = {{"chains", NetworkRods::kChains},
                                                                    {"segments", NetworkRods::kSegments}};

struct NetworkEntry {
  std::string name;
  std::optional<std::vector<Vec3>> points;
  std::optional<std::vector<std::vector<int>>> lines;
  std::optional<std::string> file, unit;
  NetworkRods rods = NetworkRods::kChains;
  double chain_angle = kChainAngle;
  RodSettings settings;
};

void describe(Fields& fields, NetworkEntry& network) {
  fields
      .field("name", network.name, TextOf{false}, kRequired,
             "Its rods are called NAME-0, NAME-1, ... in the order of the lines.")
      .field("points", network.points, ListOf<VectorOf>{{Measure::kLength}, 2}, kOptional,
             "Points, counted from 0 (or give file).")
      .field("lines", network.lines, ListOf<ListOf<IntegerOf>>{{{}, 2}, 1}, kOptional,
             "One rod each: the numbers of the points that it runs through.")
      .field("file", network.file, TextOf{false}, kOptional,
             "OBJ file with l elements, in the folder of the document or below it (instead of points and lines).")
      .field("unit", network.unit, TextOf{false}, kOptional,
             "Unit of the coordinates in the file; that of bare lengths in this document when absent.")
      .field("rods", network.rods, ChoiceOf<NetworkRods>{kRodChoices}, kOptional,
             "Of a file: lines that go on smoothly are one rod, or every straight piece is one.")
      .field("chain_angle", network.chain_angle, NumberOf{Measure::kAngle, kPositive}, kOptional,
             "Of a file: a sharper corner ends a rod.");
  describe_settings(fields, network.settings);
}

constexpr ObjectOf<NetworkEntry> kNetwork{"network"};

void read_lines(Reader& reader, const NetworkEntry& entry, const Rod& common, std::vector<Rod>& rods) {
  const Reader::Step in_lines(reader, "lines");
  for (std::size_t i = 0; i < entry.lines->size() && !reader.failed(); ++i) {
    const Reader::Step in_line(reader, i);
    const std::vector<int>& line = (*entry.lines)[i];
    Polyline polyline;
    for (std::size_t j = 0; j < line.size(); ++j) {
      const std::size_t number = static_cast<std::size_t>(line[j]);
      if (number >= entry.points->size()) {
        const Reader::Step step(reader, j);
        return reader.fail(ErrorCode::kUnknown, "there is no point " + std::to_string(number),
                           "the points are counted from 0 to " + std::to_string(entry.points->size() - 1));
      }
      polyline.points.push_back((*entry.points)[number]);
    }
    polyline.closed = polyline.points.size() > 3 && line.front() == line.back();
    if (polyline.closed) polyline.points.pop_back();
    Rod& rod = rods.emplace_back(common);
    rod.name = entry.name + "-" + std::to_string(i);
    rod.curve = std::move(polyline);
  }
}

/// Metres per unit of the file; sets `text` to the unit.
double scale_of(Reader& reader, const NetworkEntry& entry, std::string& text) {
  const Reader::Step step(reader, "unit");
  Unit unit = *reader.units.units[static_cast<std::size_t>(Measure::kLength)];
  if (entry.unit) {
    Result<Unit> parsed = parse_unit(*entry.unit);
    if (!parsed) {
      reader.fail(parsed.error());
      return 0;
    }
    unit = std::move(parsed).value();
  }
  const Result<double> scale = to_si("1", unit);
  if (!(unit.dimension == dimension(Measure::kLength)) || !scale) {
    reader.fail(ErrorCode::kUnit, "expected a unit of length such as \"mm\", got one of " + in_words(unit.dimension));
    return 0;
  }
  text = unit.text;
  return scale.value();
}

/// A mistake in the file, told at the place where the document names it.
void fail_in_file(Reader& reader, const std::string& file, const Error& error) {
  const bool has_line = error.where.starts_with(file);
  reader.fail(error.code, (has_line ? error.where : file) + ": " + error.message, error.hint);
}

void read_drawing(Reader& reader, const NetworkEntry& entry, const Rod& common, NetworkPart& part) {
  NetworkFile& network = part.file.emplace();
  network.name = entry.name;
  network.file = *entry.file;
  network.rods = entry.rods;
  network.chain_angle = entry.chain_angle;
  NetworkOptions options;
  options.scale = scale_of(reader, entry, network.unit);
  if (reader.failed()) return;
  options.rods = entry.rods;
  options.chain_angle = entry.chain_angle;
  options.edges_per_segment = std::max(common.edges, 1);
  const Reader::Step step(reader, "file");
  const Result<std::string> text = read_file_below(reader.folder, *entry.file, kLargestDocument);
  if (!text) return reader.fail(text.error());
  const Result<ObjLines> lines = read_obj_lines(text.value(), *entry.file);
  if (!lines) return fail_in_file(reader, *entry.file, lines.error());
  Result<ImportedNetwork> drawing = import_network(lines.value(), options);
  if (!drawing) return fail_in_file(reader, *entry.file, drawing.error());
  for (Rod& drawn : drawing.value().model.rods) {
    Rod& rod = part.rods.emplace_back(common);
    rod.name = entry.name + "-" + std::to_string(part.rods.size() - 1);
    rod.curve = std::move(drawn.curve);
    if (common.edges > 0) rod.edges = drawn.edges;
  }
  for (const std::string& note : drawing.value().notes) network.notes.push_back(*entry.file + ": " + note);
  network.rod_count = static_cast<int>(part.rods.size());
  network.edges_per_piece = common.edges;
  network.fingerprint = fingerprint(part.rods);
}

/// Either points and lines or a file, and nothing that belongs to the other.
bool agrees(Reader& reader, const NetworkEntry& entry, const JsonValue& json) {
  if (entry.file) {
    for (const char* key : {"points", "lines"}) {
      if (!json.find(key)) continue;
      reader.fail(ErrorCode::kConflict, "both \"file\" and \"" + std::string(key) + "\" are given", "keep one of them");
    }
    return !reader.failed();
  }
  for (const char* key : {"points", "lines"}) {
    if (json.find(key)) continue;
    reader.fail(ErrorCode::kType, "the key \"" + std::string(key) + "\" is missing in this network",
                "give \"points\" and \"lines\", or a \"file\" with a drawing");
  }
  for (const char* key : {"unit", "rods", "chain_angle"}) {
    if (!json.find(key)) continue;
    const Reader::Step step(reader, key);
    reader.fail(ErrorCode::kConflict, "\"" + std::string(key) + "\" belongs to networks that are read from a file",
                "remove it");
  }
  return !reader.failed();
}

}  // namespace

void NetworkOf::read(Reader& reader, const JsonValue& json, NetworkPart& part) const {
  NetworkEntry entry;
  kNetwork.read(reader, json, entry);
  if (reader.failed() || !agrees(reader, entry, json)) return;
  Rod common;
  apply(reader, entry.settings, common);
  if (reader.failed()) return;
  if (entry.file) {
    read_drawing(reader, entry, common, part);
  } else {
    read_lines(reader, entry, common, part.rods);
  }
}

JsonValue NetworkOf::write(const NetworkPart& part) const {
  const Rod& rod = part.rods.front();
  const NetworkFile& network = *part.file;
  NetworkEntry entry;
  entry.name = network.name;
  entry.file = network.file;
  entry.unit = network.unit;
  entry.rods = network.rods;
  entry.chain_angle = network.chain_angle;
  entry.settings = {network.edges_per_piece, rod.edge_length, rod.material, rod.section, rod.axes, rod.natural};
  return kNetwork.write(entry);
}

JsonValue NetworkOf::schema(Schema& schema) const { return kNetwork.schema(schema); }

}  // namespace lissom
