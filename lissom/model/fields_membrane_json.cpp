#include "lissom/model/entries_json.h"
#include "lissom/model/limits.h"

namespace lissom {
namespace {

constexpr std::pair<std::string_view, RestFolds> kFolds[] = {{"as_drawn", RestFolds::kAsDrawn},
                                                             {"flat", RestFolds::kFlat}};
constexpr PairOf kPlace{Measure::kLength, Measure::kLength};
constexpr IntegerOf kCount{1, kMostNodes};

struct FabricEntry {
  std::optional<Vec2> stiffness, youngs_modulus;
  double poisson_ratio = 0, thickness = 0;
  std::optional<double> area_density, density;
  std::string source;
};

void describe(Fields& fields, FabricEntry& fabric) {
  fields
      .field("stiffness", fabric.stiffness, OneOrPairOf{Measure::kForcePerLength, kPositive}, kOptional,
             "Young's modulus times thickness; two numbers along warp and weft.")
      .field("youngs_modulus", fabric.youngs_modulus, OneOrPairOf{Measure::kStress, kPositive}, kOptional,
             "Young's modulus, along warp and weft where they differ; needs the thickness.")
      .field("poisson_ratio", fabric.poisson_ratio, NumberOf{Measure::kRatio, between(-1, 1)}, kRequired,
             "A pull along the warp narrows the weft by this, times the root of their stiffness ratio.")
      .field("thickness", fabric.thickness, NumberOf{Measure::kLength, kNotNegative}, kOptional,
             "Thickness; without it the fabric does not resist bending.")
      .field("area_density", fabric.area_density, NumberOf{Measure::kAreaDensity, kNotNegative}, kOptional,
             "Mass per area; weightless when neither it nor a density is given.")
      .field("density", fabric.density, NumberOf{Measure::kDensity, kNotNegative}, kOptional,
             "Density; needs the thickness.")
      .field("source", fabric.source, TextOf(), kOptional, "Where the numbers come from.");
}

/// Exactly one of two keys is given.
bool one_of(Reader& reader, bool first, bool second, const char* first_key, const char* second_key, const char* hint) {
  if (first != second) return true;
  const std::string one = std::string("\"") + first_key + "\"", other = std::string("\"") + second_key + "\"";
  reader.fail(
      first ? ErrorCode::kConflict : ErrorCode::kType,
      (first ? "both " : "neither ") + one + (first ? " and " : " nor ") + other + (first ? " are given" : " is given"),
      first ? "keep one of them" : hint);
  return false;
}

void to_model(Reader& reader, const FabricEntry& entry, MembraneMaterial& fabric) {
  if (!one_of(reader, entry.stiffness.has_value(), entry.youngs_modulus.has_value(), "stiffness", "youngs_modulus",
              "add for example \"stiffness\": \"23.6 N/m\"")) {
    return;
  }
  if (entry.area_density && entry.density) {
    one_of(reader, true, true, "area_density", "density", "");
    return;
  }
  if ((entry.youngs_modulus || entry.density) && !(entry.thickness > 0)) {
    return reader.fail(ErrorCode::kType,
                       std::string("the thickness is missing, which \"") +
                           (entry.youngs_modulus ? "youngs_modulus" : "density") + "\" is multiplied by",
                       entry.youngs_modulus ? "add \"thickness\", or give \"stiffness\" in N/m"
                                            : "add \"thickness\", or give \"area_density\" in g/m^2");
  }
  const Vec2 stiffness = entry.stiffness ? *entry.stiffness : Vec2(*entry.youngs_modulus * entry.thickness);
  fabric.stiffness_1 = stiffness[0];
  fabric.stiffness_2 = stiffness[1];
  fabric.poisson_ratio = entry.poisson_ratio;
  fabric.thickness = entry.thickness;
  fabric.area_density = entry.density ? *entry.density * entry.thickness : entry.area_density.value_or(0);
  fabric.source = entry.source;
}

void to_entry(const MembraneMaterial& fabric, FabricEntry& entry) {
  entry.stiffness = Vec2(fabric.stiffness_1, fabric.stiffness_2);
  entry.poisson_ratio = fabric.poisson_ratio;
  entry.thickness = fabric.thickness;
  if (fabric.area_density != 0) entry.area_density = fabric.area_density;
  entry.source = fabric.source;
}

struct GridEntry {
  Vec2 corner = Vec2::Zero(), size = Vec2::Zero();
  std::vector<int> cells;
};

void describe(Fields& fields, GridEntry& grid) {
  fields.field("corner", grid.corner, kPlace, kOptional, "Its corner with the least x and y.")
      .field("size", grid.size, kPlace, kRequired, "Lengths along x and y.")
      .field("cells", grid.cells, ListOf<IntegerOf>{kCount, 2, 2}, kRequired,
             "Number of cells along x and y, two triangles each.");
}

struct MeshEntry {
  std::vector<Vec3> points;
  std::vector<std::vector<int>> triangles;
  std::vector<double> stiffness, density;
};

void describe(Fields& fields, MeshEntry& mesh) {
  fields.field("points", mesh.points, ListOf<VectorOf>{{Measure::kLength}, 3}, kRequired, "Vertices.")
      .field("triangles", mesh.triangles, ListOf<ListOf<IntegerOf>>{{{0, kMostNodes}, 3, 3}, 1}, kRequired,
             "Three numbers of vertices each, from 0, all turning the same way seen from one side of the sheet.")
      .field("stiffness", mesh.stiffness, ListOf<NumberOf>{{Measure::kRatio, kPositive}}, kOptional,
             "By triangle, multiplies the stiffness to stretch and to bend; 1 everywhere when absent.")
      .field("density", mesh.density, ListOf<NumberOf>{{Measure::kRatio, kNotNegative}}, kOptional,
             "By triangle, multiplies the area density; 1 everywhere when absent.");
}

struct MembraneEntry {
  std::string name, material;
  std::optional<GridEntry> grid;
  std::optional<MembraneDisc> disc;
  std::optional<MembraneTriangles> triangles;
  std::optional<MeshEntry> mesh;
  Vec2 pre_stretch = Vec2::Ones();
  double warp_angle = 0, bending = 1;
  RestFolds rest_folds = RestFolds::kAsDrawn;
};

}  // namespace

// Found by argument-dependent lookup, hence in the namespace of the structs.
void describe(Fields& fields, MembraneDisc& disc) {
  fields.field("centre", disc.centre, kPlace, kOptional, "Its centre, x and y.")
      .field("radius", disc.radius, NumberOf{Measure::kLength, kPositive}, kRequired, "Outer radius.")
      .field("inner_radius", disc.inner_radius, NumberOf{Measure::kLength, kNotNegative}, kOptional,
             "Radius of the hole; a full disc when absent.")
      .field("rings", disc.rings, kCount, kRequired, "Number of rings of triangles.")
      .field("sectors", disc.sectors, IntegerOf{3, kMostNodes}, kRequired, "Number of edges along the rim.");
}

void describe(Fields& fields, MembraneTriangles& sheet) {
  fields.field("corner", sheet.corner, kPlace, kOptional, "Its first corner, x and y.")
      .field("edge", sheet.edge, NumberOf{Measure::kLength, kPositive}, kRequired, "Side of the equilateral triangles.")
      .field("columns", sheet.columns, kCount, kRequired, "Number of edges along x.")
      .field("rows", sheet.rows, kCount, kRequired, "Number of strips of triangles along y.");
}

namespace {

void describe(Fields& fields, MembraneEntry& membrane) {
  fields.field("name", membrane.name, TextOf{false}, kRequired, "Name of the membrane, used by selectors.")
      .field("grid", membrane.grid, ObjectOf<GridEntry>{"grid"}, kOptional,
             "A rectangle in the xy plane, cut into cells of two triangles.")
      .field("disc", membrane.disc, ObjectOf<MembraneDisc>{"disc"}, kOptional,
             "A disc or an annulus in the xy plane, its first spoke along x.")
      .field("triangles", membrane.triangles, ObjectOf<MembraneTriangles>{"sheet of triangles"}, kOptional,
             "Equilateral triangles in the xy plane.")
      .field("mesh", membrane.mesh, ObjectOf<MeshEntry>{"mesh"}, kOptional,
             "Triangles one by one, each at rest in its own plane.")
      .field("material", membrane.material, TextOf{false}, kRequired,
             "Name of a fabric of the document or the library.")
      .field("pre_stretch", membrane.pre_stretch, OneOrPairOf{Measure::kRatio, kPositive}, kOptional,
             "How much the fabric is stretched when it is as drawn; two numbers along warp and weft.")
      .field("warp_angle", membrane.warp_angle, NumberOf{Measure::kAngle}, kOptional,
             "Angle from x to the warp direction.")
      .field("bending", membrane.bending, NumberOf{Measure::kRatio, kNotNegative}, kOptional,
             "Multiplies the bending stiffness of the fabric; 0 switches it off.")
      .field("rest_folds", membrane.rest_folds, ChoiceOf<RestFolds>{kFolds}, kOptional,
             "Whether the angles between triangles are free of stress as drawn, or when flat.");
}

constexpr ConvertedOf<MembraneMaterial, FabricEntry> kFabric{"fabric"};
constexpr ObjectOf<MembraneEntry> kMembrane{"membrane"};

MembraneShape shape_of(const MembraneEntry& entry) {
  if (entry.grid) return MembraneGrid{entry.grid->corner, entry.grid->size, entry.grid->cells[0], entry.grid->cells[1]};
  if (entry.disc) return *entry.disc;
  if (entry.triangles) return *entry.triangles;
  MembraneMesh mesh{entry.mesh->points, {}, entry.mesh->stiffness, entry.mesh->density};
  for (const std::vector<int>& t : entry.mesh->triangles) mesh.triangles.push_back({t[0], t[1], t[2]});
  return mesh;
}

struct ShapeWriter {
  MembraneEntry& entry;
  void operator()(const MembraneGrid& grid) const {
    entry.grid = GridEntry{grid.corner, grid.size, {grid.cells_x, grid.cells_y}};
  }
  void operator()(const MembraneDisc& disc) const { entry.disc = disc; }
  void operator()(const MembraneTriangles& sheet) const { entry.triangles = sheet; }
  void operator()(const MembraneMesh& mesh) const {
    entry.mesh = MeshEntry{mesh.points, {}, mesh.stiffness, mesh.density};
    for (const std::array<int, 3>& t : mesh.triangles) entry.mesh->triangles.emplace_back(t.begin(), t.end());
  }
};

}  // namespace

void MembraneMaterialOf::read(Reader& reader, const JsonValue& json, MembraneMaterial& material) const {
  kFabric.read(reader, json, material);
}
JsonValue MembraneMaterialOf::write(const MembraneMaterial& material) const { return kFabric.write(material); }
JsonValue MembraneMaterialOf::schema(Schema& schema) const { return kFabric.schema(schema); }

void MembraneOf::read(Reader& reader, const JsonValue& json, Membrane& membrane) const {
  MembraneEntry entry;
  kMembrane.read(reader, json, entry);
  if (reader.failed()) return;
  const int shapes =
      entry.grid.has_value() + entry.disc.has_value() + entry.triangles.has_value() + entry.mesh.has_value();
  if (shapes != 1) {
    return reader.fail(shapes == 0 ? ErrorCode::kType : ErrorCode::kConflict,
                       shapes == 0 ? "the membrane has no shape" : "the membrane has more than one shape",
                       "give one of \"grid\", \"disc\", \"triangles\" and \"mesh\"");
  }
  membrane = {entry.name,       shape_of(entry), entry.material,  entry.pre_stretch,
              entry.warp_angle, entry.bending,   entry.rest_folds};
}

JsonValue MembraneOf::write(const Membrane& membrane) const {
  MembraneEntry entry{membrane.name,    membrane.material,  {}, {}, {}, {}, membrane.pre_stretch, membrane.warp_angle,
                      membrane.bending, membrane.rest_folds};
  std::visit(ShapeWriter{entry}, membrane.shape);
  return kMembrane.write(entry);
}

JsonValue MembraneOf::schema(Schema& schema) const { return kMembrane.schema(schema); }

}  // namespace lissom
