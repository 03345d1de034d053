#include "lissom/model/brief_json.h"
#include "lissom/model/document.h"
#include "lissom/model/rod_mesh_document.h"

namespace lissom {
namespace {

constexpr std::pair<std::string_view, PatternTopology::Shape> kPatterns[] = {
    {"hexagons", PatternTopology::Shape::kHexagons},
    {"quads", PatternTopology::Shape::kQuads},
    {"triangles", PatternTopology::Shape::kTriangles}};
constexpr std::pair<std::string_view, DeformerBrief::Kind> kDeformers[] = {{"shell", DeformerBrief::Kind::kShell},
                                                                           {"solid", DeformerBrief::Kind::kSolid}};

constexpr NumberOf kLength{Measure::kLength, kPositive};

/// A unit of length, as metres.
struct LengthUnitOf {
  void read(Reader& reader, const JsonValue& json, double& metres) const {
    if (!json.is(JsonValue::Kind::kString)) return reader.fail_kind("a unit of length such as \"mm\"", json);
    const Result<Unit> unit = parse_unit(json.text);
    if (!unit) return reader.fail(unit.error());
    const Result<double> scale = to_si("1", unit.value());
    if (!(unit.value().dimension == dimension(Measure::kLength)) || !scale) {
      return reader.fail(ErrorCode::kUnit,
                         "expected a unit of length such as \"mm\", got one of " + in_words(unit.value().dimension));
    }
    metres = scale.value();
  }
  JsonValue write(double metres) const {
    for (const std::string_view text : {"mm", "cm", "m", "in"}) {
      const Result<Unit> unit = parse_unit(text);
      if (unit.ok() && to_si("1", unit.value()).value() == metres) return JsonValue::string(text);
    }
    return {};
  }
  JsonValue schema(Schema&) const { return type_schema("string"); }
};

struct TopologyEntry {
  std::optional<CellTopology> cells;
  std::optional<DualTopology> dual;
  std::optional<PatternTopology> pattern;
  std::optional<DrawnTopology> lines;
};

void describe(Fields& fields, TopologyEntry& entry) {
  fields
      .field("cells", entry.cells, ObjectOf<CellTopology>{"cells"}, kOptional,
             "Cells of nearest points on the surface, rods between them.")
      .field("dual", entry.dual, ObjectOf<DualTopology>{"dual"}, kOptional,
             "Rods between neighbouring triangles of the decimated surface.")
      .field("pattern", entry.pattern, ObjectOf<PatternTopology>{"pattern"}, kOptional, "A regular pattern on a sheet.")
      .field("lines", entry.lines, ObjectOf<DrawnTopology>{"drawn lines"}, kOptional, "Lines of a drawing.");
}

struct TopologyOf {
  static ObjectOf<TopologyEntry> object() { return {"topology"}; }
  void read(Reader& reader, const JsonValue& json, Topology& topology) const {
    TopologyEntry e;
    object().read(reader, json, e);
    if (reader.failed()) return;
    if (!exactly_one(reader,
                     {{"cells", e.cells.has_value()},
                      {"dual", e.dual.has_value()},
                      {"pattern", e.pattern.has_value()},
                      {"lines", e.lines.has_value()}},
                     "how rods lie on the surface")) {
      return;
    }
    if (e.cells) topology = *e.cells;
    if (e.dual) topology = *e.dual;
    if (e.pattern) topology = *e.pattern;
    if (e.lines) topology = *e.lines;
  }
  JsonValue write(const Topology& topology) const {
    TopologyEntry e;
    const auto put = [&topology]<class T>(std::optional<T>& slot) {
      if (const T* what = std::get_if<T>(&topology)) slot = *what;
    };
    put(e.cells);
    put(e.dual);
    put(e.pattern);
    put(e.lines);
    return object().write(e);
  }
  JsonValue schema(Schema& schema) const { return object().schema(schema); }
};

/// [from, to], each [x, y, z].
struct MovedPointOf {
  static constexpr VectorOf kPlace{Measure::kLength};
  void read(Reader& reader, const JsonValue& json, std::array<Vec3, 2>& pair) const {
    std::vector<Vec3> both;
    ListOf<VectorOf>{kPlace, 2, 2}.read(reader, json, both);
    if (!reader.failed()) pair = {both[0], both[1]};
  }
  JsonValue write(const std::array<Vec3, 2>& pair) const {
    return ListOf<VectorOf>{kPlace, 2, 2}.write(std::vector<Vec3>{pair[0], pair[1]});
  }
  JsonValue schema(Schema& schema) const { return ListOf<VectorOf>{kPlace, 2, 2}.schema(schema); }
};

struct StageIterationsOf {
  static constexpr IntegerOf kCount{0, 100'000};
  void read(Reader& reader, const JsonValue& json, std::array<int, 4>& counts) const {
    std::vector<int> list;
    ListOf<IntegerOf>{kCount, 4, 4}.read(reader, json, list);
    if (!reader.failed()) std::copy(list.begin(), list.end(), counts.begin());
  }
  JsonValue write(const std::array<int, 4>& counts) const {
    return ListOf<IntegerOf>{kCount, 4, 4}.write(std::vector<int>(counts.begin(), counts.end()));
  }
  JsonValue schema(Schema& schema) const { return ListOf<IntegerOf>{kCount, 4, 4}.schema(schema); }
};

struct ProjectVersionOf {
  void read(Reader& reader, const JsonValue& json, int& version) const {
    IntegerOf{1}.read(reader, json, version);
    if (reader.failed() || version <= kProjectVersion) return;
    reader.fail(ErrorCode::kUnsupported,
                "the project has version " + std::to_string(version) + ", this lissom reads versions up to " +
                    std::to_string(kProjectVersion),
                "update lissom");
  }
  JsonValue write(int version) const { return JsonValue::integer(version); }
  JsonValue schema(Schema&) const { return JsonValue::object().set("const", JsonValue::integer(kProjectVersion)); }
};

struct ProjectEntry {
  int version = kProjectVersion;
  RodMeshProject project;
};

void describe(Fields& fields, ProjectEntry& entry);
constexpr ObjectOf<ProjectEntry> kProject{"project"};

}  // namespace

// Found by argument-dependent lookup, hence in the namespace of the structs.
void describe(Fields& fields, SurfaceBrief& surface) {
  fields.field("file", surface.file, TextOf{false}, kRequired, "OBJ, PLY, STL or OFF file, beside the project.")
      .field("unit", surface.unit, LengthUnitOf(), kOptional, "What the numbers of the file are in.")
      .field("size", surface.size, kLength, kOptional, "Largest extent along an axis, instead of a unit.")
      .field("fill_holes", surface.fill_holes, FlagOf(), kOptional, "Whether small holes are closed.")
      .field("keep_largest", surface.keep_largest, FlagOf(), kOptional,
             "Whether the largest of several pieces is taken.");
}

void describe(Fields& fields, CellTopology& cells) {
  fields.field("count", cells.cells, IntegerOf{4, 100'000}, kRequired, "How many.")
      .field("contrast", cells.contrast, NumberOf{Measure::kRatio, between(1, 100)}, kOptional,
             "Width of cells on white over their width on black.")
      .field("seed", cells.seed, IntegerOf{0, 1'000'000}, kOptional, "Another number, another arrangement.");
}

void describe(Fields& fields, DualTopology& dual) {
  fields.field("triangles", dual.triangles, IntegerOf{4, 100'000}, kRequired, "How many: a joint in each.");
}

void describe(Fields& fields, PatternTopology& pattern) {
  fields.field("shape", pattern.shape, ChoiceOf<PatternTopology::Shape>{kPatterns}, kRequired, "What is repeated.")
      .field("width", pattern.width, kLength, kRequired, "Length of a cell's edges.");
}

void describe(Fields& fields, DrawnTopology& lines) {
  fields.field("file", lines.file, TextOf{false}, kRequired, "OBJ file with line elements, beside the project.")
      .field("unit", lines.unit, LengthUnitOf(), kOptional, "What its numbers are in; mm when absent.");
}

void describe(Fields& fields, MeshRods& rods) {
  fields.field("material", rods.material, TextOf{false}, kOptional, "Name in the library.")
      .field("edges", rods.edges, IntegerOf{2, 1000}, kOptional, "Edges of each rod.")
      .field("r_n", rods.r_n, kLength, kOptional, "Radius across the surface, to start with.")
      .field("r_b", rods.r_b, kLength, kOptional, "Radius in the surface, to start with.")
      .field("shortest", rods.shortest, NumberOf{Measure::kRatio, between(0, 0.9)}, kOptional,
             "Lines shorter than this share of the mean are merged into a joint.")
      .field("valence", rods.valence, IntegerOf{3, 100}, kOptional, "Most rods that merging may bring to a joint.");
}

void describe(Fields& fields, DeformerRegion& region) {
  const NumberOf factor{Measure::kRatio, kPositive};
  fields.field("low", region.low, VectorOf{Measure::kLength}, kOptional, "Lower corner of a box; with `high`.")
      .field("high", region.high, VectorOf{Measure::kLength}, kOptional, "Upper corner of the box.")
      .field("dark", region.dark, NumberOf{Measure::kRatio, between(0, 1)}, kOptional,
             "Only where the surface is painted at least so dark.")
      .field("depth", region.depth, NumberOf{Measure::kLength, kNotNegative}, kOptional,
             "Only so far below the surface, in bodies: a core inside of a skin.")
      .field("blend", region.blend, NumberOf{Measure::kLength, kNotNegative}, kOptional,
             "Width over which box and depth fade outwards.")
      .field("stiffness", region.stiffness, factor, kOptional, "Factor of the stiffness.")
      .field("density", region.density, factor, kOptional, "Factor of the density.");
}

void describe(Fields& fields, DeformerBrief& deformer) {
  fields
      .field("kind", deformer.kind, ChoiceOf<DeformerBrief::Kind>{kDeformers}, kRequired,
             "A shell, or a body that fills the surface.")
      .field("youngs_modulus", deformer.modulus, NumberOf{Measure::kStress, kPositive}, kOptional, "Young's modulus.")
      .field("poisson_ratio", deformer.poisson_ratio, NumberOf{Measure::kRatio, between(0, 0.49)}, kOptional,
             "Poisson's ratio.")
      .field("density", deformer.density, NumberOf{Measure::kDensity, kPositive}, kOptional, "Density.")
      .field("thickness", deformer.thickness, kLength, kOptional, "Of shells.")
      .field("cell", deformer.cell, kLength, kOptional,
             "Size of the tetrahedra of bodies; a twelfth of the size when absent.")
      .field("regions", deformer.regions, ListOf<ObjectOf<DeformerRegion>>{{"deformer region"}}, kOptional,
             "Parts that differ; factors of regions that overlap multiply.");
}

void describe(Fields& fields, MeshPose& pose) {
  fields.field("pose", pose.pose, PoseOf(), kRequired, "What holds and loads it: name, supports, forces, gravity.")
      .field("deformer", pose.deformer, TextOf(), kOptional, "Name of the deformer that takes the shape.")
      .field("mesh", pose.mesh, TextOf(), kOptional, "File with the posed surface, same vertices in the same order.")
      .field("warp", pose.warp, ListOf<MovedPointOf>{}, kOptional,
             "Pairs of a place and where it goes; smooth in between.")
      .field("weight", pose.weight, NumberOf{Measure::kRatio, kPositive}, kOptional, "Against the other poses.")
      .field("held_back", pose.held_back, FlagOf(), kOptional,
             "Whether it only tests how the design does where it was not asked.");
}

void describe(Fields& fields, MeshDesign& design) {
  fields
      .field(
          "method", design.method, TextOf(), kOptional,
          "How second derivatives are had, as in a structure's design; the fastest for so many parameters when absent.")
      .field("radii", design.radii, PairOf{Measure::kLength, Measure::kLength}, kOptional,
             "Smallest and largest radius.")
      .field("reach", design.reach, NumberOf{Measure::kLength, kNotNegative}, kOptional,
             "How far the rest shape may move along each axis; 0: not at all.")
      .field("clearance", design.clearance, NumberOf{Measure::kLength, kNotNegative}, kOptional,
             "Gap that rods should keep where they share no joint; what printers need is 0.5 mm. 0: none.")
      .field("iterations", design.iterations, StageIterationsOf(), kOptional,
             "At most, with radii at 2, 3 and 4 places of each rod, then together with the rest shape.")
      .field("smoothness", design.smoothness, NumberOf{Measure::kRatio, kNotNegative}, kOptional,
             "Weight of neighbouring controls being alike.")
      .field("pin_stiffness", design.pin_stiffness, NumberOf{Measure::kForcePerLength, kPositive}, kOptional,
             "Of what holds the rods, at each node, to start with.");
}

void describe(Fields& fields, MeshPrint& print) {
  fields.field("process", print.process, TextOf{false}, kOptional, "sls, fdm or sla.")
      .field("tolerance", print.tolerance, kLength, kOptional, "Of the surface of the print.")
      .field("bed", print.bed, VectorOf{Measure::kLength}, kOptional, "Size of the printer's bed, height last.");
}

namespace {

void describe(Fields& fields, ProjectEntry& entry) {
  RodMeshProject& p = entry.project;
  fields.field("lissom_project", entry.version, ProjectVersionOf(), kRequired, "Version of the format.")
      .field("title", p.title, TextOf(), kOptional, "What this is.")
      .field("source", p.source, TextOf(), kOptional, "Where the description comes from.")
      .field("surface", p.surface, ObjectOf<SurfaceBrief>{"surface"}, kRequired, "The shape of the object.")
      .field("topology", p.topology, TopologyOf(), kRequired, "How rods lie on it.")
      .field("materials", p.materials, TableOf<ObjectOf<Material>, Material>{{"material"}, &Material::name}, kOptional,
             "Materials besides the library, by name.")
      .field("rods", p.rods, ObjectOf<MeshRods>{"mesh rods"}, kOptional, "The rods to start with.")
      .field("deformers", p.deformers,
             TableOf<ObjectOf<DeformerBrief>, DeformerBrief>{{"deformer"}, &DeformerBrief::name}, kOptional,
             "What the object is made of while poses are found, by name.")
      .field("poses", p.poses, ListOf<ObjectOf<MeshPose>>{{"mesh pose"}, 1}, kRequired, "The shapes it should take.")
      .field("design", p.design, ObjectOf<MeshDesign>{"mesh design"}, kOptional, "What of the rods may change.")
      .field("print", p.print, ObjectOf<MeshPrint>{"print settings"}, kOptional, "How it is to be printed.");
}

}  // namespace

bool is_project(std::string_view text) {
  const Result<JsonValue> json = parse_json(text, kDeepestDocument);
  return json.ok() && json.value().is(JsonValue::Kind::kObject) && json.value().find("lissom_project") != nullptr;
}

Result<RodMeshProject> read_project(std::string_view text) {
  if (text.size() > kLargestDocument) {
    return Error{ErrorCode::kFile, {}, "the project is too large", "is it the right file?"};
  }
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  const Result<JsonValue> json = parse_json(text, kDeepestDocument);
  if (!json) return json.error();
  Reader reader{{}};
  ProjectEntry entry;
  kProject.read(reader, json.value(), entry);
  if (reader.failed()) return reader.error();
  if (Status status = entry.project.validate(); !status) return status.error();
  return std::move(entry.project);
}

std::string write_project(const RodMeshProject& project) {
  return print_json(kProject.write(ProjectEntry{kProjectVersion, project}));
}

std::string project_schema() {
  Schema schema;
  const JsonValue root = kProject.schema(schema);
  JsonValue json = JsonValue::object();
  json.set("$schema", JsonValue::string("https://json-schema.org/draft/2020-12/schema"));
  json.set("title", JsonValue::string("lissom project, version " + std::to_string(kProjectVersion)));
  json.set("$ref", *root.find("$ref"));
  json.set("$defs", schema.definitions());
  return print_json(json);
}

}  // namespace lissom
