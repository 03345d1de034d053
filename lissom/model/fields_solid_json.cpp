#include "lissom/model/entries_json.h"
#include "lissom/model/limits.h"

namespace lissom {
namespace {

struct SolidEntry {
  std::string name, material;
  std::vector<Vec3> points;
  std::vector<std::vector<int>> tetrahedra;
  std::vector<double> stiffness, density;
};

void describe(Fields& fields, SolidEntry& solid) {
  fields.field("name", solid.name, TextOf{false}, kRequired, "Name of the solid.")
      .field("points", solid.points, ListOf<VectorOf>{{Measure::kLength}, 4}, kRequired, "Corners of its tetrahedra.")
      .field("tetrahedra", solid.tetrahedra, ListOf<ListOf<IntegerOf>>{{{0, kMostNodes}, 4, 4}, 1}, kRequired,
             "Four numbers of points each, from 0; from the fourth the first three run clockwise.")
      .field("material", solid.material, TextOf{false}, kRequired,
             "Name of a material of the document or the library; its Poisson ratio is below 0.5.")
      .field("stiffness", solid.stiffness, ListOf<NumberOf>{{Measure::kRatio, kPositive}}, kOptional,
             "By tetrahedron, multiplies Young's modulus; 1 everywhere when absent.")
      .field("density", solid.density, ListOf<NumberOf>{{Measure::kRatio, kNotNegative}}, kOptional,
             "By tetrahedron, multiplies the density; 1 everywhere when absent.");
}

void to_model(Reader&, SolidEntry& entry, Solid& solid) {
  solid = {entry.name,     std::move(entry.points),    {},
           entry.material, std::move(entry.stiffness), std::move(entry.density)};
  solid.tetrahedra.reserve(entry.tetrahedra.size());
  for (const std::vector<int>& t : entry.tetrahedra) solid.tetrahedra.push_back({t[0], t[1], t[2], t[3]});
}

void to_entry(const Solid& solid, SolidEntry& entry) {
  entry = {solid.name, solid.material, solid.points, {}, solid.stiffness, solid.density};
  for (const std::array<int, 4>& t : solid.tetrahedra) entry.tetrahedra.emplace_back(t.begin(), t.end());
}

constexpr ConvertedOf<Solid, SolidEntry> kSolid{"solid"};

}  // namespace

void SolidOf::read(Reader& reader, const JsonValue& json, Solid& solid) const { kSolid.read(reader, json, solid); }
JsonValue SolidOf::write(const Solid& solid) const { return kSolid.write(solid); }
JsonValue SolidOf::schema(Schema& schema) const { return kSolid.schema(schema); }

}  // namespace lissom
