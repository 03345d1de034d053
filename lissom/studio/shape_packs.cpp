#include "lissom/studio/shape_packs.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <utility>

#include "lissom/model/membrane_rim.h"
#include "lissom/studio/pack_writer.h"
#include "lissom/studio/shown_units.h"

namespace lissom {

namespace {

using Json = nlohmann::json;
using Floats = std::vector<float>;
using Numbers = std::vector<std::uint32_t>;

constexpr std::uint32_t kNone = 0xffffffff;

std::uint32_t number(int value) { return value < 0 ? kNone : static_cast<std::uint32_t>(value); }

Floats millimetres(const VecX& places) {
  Floats numbers(static_cast<std::size_t>(places.size()));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    numbers[i] = static_cast<float>(kMillimetres * places[static_cast<Eigen::Index>(i)]);
  }
  return numbers;
}

Floats places_of(const State& state, int nodes) { return millimetres(state.q.head(3 * nodes)); }

/// Edges in the order of packs: rod by rod.
template <class Use>
void each_edge(const Structure& structure, const Use& use) {
  for (const StructureRod& rod : structure.rods) {
    for (const int e : rod.edges) use(e);
  }
}

Floats normals_of(const System& system, const State& state) {
  Floats normals;
  normals.reserve(3 * state.edges.size());
  each_edge(system.structure, [&](int e) {
    const Vec3 n = state.edges[static_cast<std::size_t>(e)].material().n;
    for (int k = 0; k < 3; ++k) normals.push_back(static_cast<float>(n[k]));
  });
  return normals;
}

Floats radii_of(const Structure& structure) {
  Floats radii;
  each_edge(structure, [&](int e) {
    const Section& section = structure.edges[static_cast<std::size_t>(e)].section;
    radii.push_back(static_cast<float>(kMillimetres * section.r_n));
    radii.push_back(static_cast<float>(kMillimetres * section.r_b));
  });
  return radii;
}

const FieldInfo* find_field(const std::string& name) {
  for (const FieldInfo& field : field_list()) {
    if (field.name == name) return &field;
  }
  return nullptr;
}

/// Values in the unit that people see, and what the legend needs to know.
Json scaled(const FieldInfo& field, const std::vector<double>& values, Floats& shown) {
  double low = INFINITY, high = -INFINITY;
  for (const double value : values) {
    const double scaled = value * field.display_scale;
    shown.push_back(static_cast<float>(scaled));
    if (!std::isfinite(scaled)) continue;
    low = std::min(low, scaled);
    high = std::max(high, scaled);
  }
  if (!(low <= high)) low = high = 0;
  const bool diverging = field.colors == Field::Colors::kDiverging;
  if (diverging) {
    high = std::max(std::abs(low), std::abs(high));
    low = -high;
  }
  return {{"name", field.name}, {"unit", field.display_unit}, {"low", low}, {"high", high}, {"diverging", diverging}};
}

Json rod_values(const FieldSource& source, const FieldInfo& field, Floats& shown) {
  const std::vector<double> values = field.values(source);
  std::vector<double> ordered;
  ordered.reserve(values.size());
  each_edge(source.system.structure, [&](int e) { ordered.push_back(values[static_cast<std::size_t>(e)]); });
  return scaled(field, ordered, shown);
}

Numbers rim_of(const Structure& structure) {
  Numbers rim;
  for (int m = 0; m < static_cast<int>(structure.membranes.size()); ++m) {
    for (const RimLoop& loop : rim_loops(structure, m)) {
      for (const RimEdge& edge : loop) {
        rim.push_back(number(edge.node0));
        rim.push_back(number(edge.node1));
      }
    }
  }
  return rim;
}

/// Lists of different lengths as their starts and all their entries in a row.
void append(const std::vector<int>& list, Numbers& starts, Numbers& entries) {
  for (const int entry : list) entries.push_back(number(entry));
  starts.push_back(static_cast<std::uint32_t>(entries.size()));
}

}  // namespace

PlanParts plan_parts(const Plan& plan, const ExpandedPlan& expanded, const System& system) {
  PlanParts parts = no_plan_parts(system);
  const std::vector<StructureMembrane>& membranes = system.structure.membranes;
  const auto fabric = std::find_if(membranes.begin(), membranes.end(),
                                   [](const StructureMembrane& m) { return m.name == kFabricName; });
  LISSOM_ASSERT(fabric != membranes.end());
  const auto node_of = [&](int sample) { return fabric->nodes[static_cast<std::size_t>(sample)]; };
  for (std::size_t r = 0; r < plan.rods.size(); ++r) {
    if (plan.rods[r].role != PlanRole::kGhost) continue;
    std::vector<int> line;
    for (const int sample : expanded.samples.rods[r]) line.push_back(node_of(sample));
    if (plan.rods[r].closed) line.push_back(line.front());
    parts.ghosts.push_back(std::move(line));
  }
  for (int i = 0; i < static_cast<int>(plan.points.size()); ++i) parts.point_nodes.push_back(node_of(i));
  // A rod of the plan may have become several, NAME-0, NAME-1, ...: every one has its first edge on a piece of it.
  std::map<std::pair<int, int>, int> rod_of_edge;
  for (std::size_t r = 0; r < plan.rods.size(); ++r) {
    if (plan.rods[r].role == PlanRole::kGhost) continue;
    const std::vector<int>& line = expanded.samples.rods[r];
    for (std::size_t i = 0; i < line.size(); ++i) {
      const std::size_t next = (i + 1) % line.size();
      if (next == 0 && !plan.rods[r].closed) break;
      rod_of_edge[{node_of(line[i]), node_of(line[next])}] = static_cast<int>(r);
    }
  }
  for (std::size_t r = 0; r < system.structure.rods.size(); ++r) {
    const StructureEdge& edge =
        system.structure.edges[static_cast<std::size_t>(system.structure.rods[r].edges.front())];
    const auto found = rod_of_edge.find({edge.node0, edge.node1});
    if (found != rod_of_edge.end()) parts.plan_rods[r] = found->second;
  }
  return parts;
}

PlanParts no_plan_parts(const System& system) { return {{}, {}, std::vector<int>(system.structure.rods.size(), -1)}; }

Status check_fields(const ShownFields& fields) {
  const auto check = [](const std::string& name, Field::Place place, const char* where) -> Status {
    const FieldInfo* field = find_field(name);
    if (name.empty() || (field != nullptr && field->place == place)) return {};
    return Error{ErrorCode::kUnknown, where, fmt::format("there is no field \"{}\" here", name),
                 "choose one of those that `hello` lists"};
  };
  if (Status s = check(fields.rods, Field::Place::kEdge, "/rods"); !s) return s;
  return check(fields.fabric, Field::Place::kTriangle, "/fabric");
}

Pack topology_pack(Json header, const System& system, const PlanParts& parts) {
  const Structure& structure = system.structure;
  header["pack"] = "topology";
  header["rods"] = Json::array();
  Floats places;
  for (const Vec3& node : structure.nodes) {
    places.push_back(static_cast<float>(kMillimetres * node.x()));
    places.push_back(static_cast<float>(kMillimetres * node.y()));
  }
  Numbers triangles;
  for (const StructureTriangle& triangle : structure.triangles) {
    for (const int node : triangle.node) triangles.push_back(number(node));
  }
  Numbers rod_starts{0}, rod_nodes, ghost_starts{0}, ghost_nodes, point_nodes;
  for (std::size_t r = 0; r < structure.rods.size(); ++r) {
    const StructureRod& rod = structure.rods[r];
    header["rods"].push_back({{"name", rod.name}, {"plan_rod", parts.plan_rods[r]}, {"closed", rod.closed}});
    append(rod.nodes, rod_starts, rod_nodes);
  }
  for (const std::vector<int>& ghost : parts.ghosts) append(ghost, ghost_starts, ghost_nodes);
  for (const int node : parts.point_nodes) point_nodes.push_back(number(node));
  PackWriter pack(std::move(header));
  return pack.add("plan_places", places, 2)
      .add("triangles", triangles, 3)
      .add("rod_starts", rod_starts, 1)
      .add("rod_nodes", rod_nodes, 1)
      .add("edge_radii", radii_of(structure), 2)
      .add("ghost_starts", ghost_starts, 1)
      .add("ghost_nodes", ghost_nodes, 1)
      .add("point_nodes", point_nodes, 1)
      .add("rim", rim_of(structure), 2)
      .finish();
}

Pack shape_pack(Json header, const FieldSource& source, const ShownFields& fields) {
  Floats edge_values, triangle_values;
  if (const FieldInfo* field = find_field(fields.rods); field != nullptr) {
    header["field_rods"] = rod_values(source, *field, edge_values);
  }
  const bool fabric = !source.system.structure.triangles.empty();
  if (const FieldInfo* field = find_field(fields.fabric); field != nullptr && fabric) {
    header["field_fabric"] = scaled(*field, field->values(source), triangle_values);
  }
  if (!header.contains("pack")) header["pack"] = "shape";
  PackWriter pack(std::move(header));
  return pack.add("positions", places_of(source.state, source.system.layout.nodes()), 3)
      .add("normals", normals_of(source.system, source.state), 3)
      .add("edge_radii", radii_of(source.system.structure), 2)
      .add("edge_values", edge_values, 1)
      .add("triangle_values", triangle_values, 1)
      .finish();
}

Pack places_pack(Json header, const System& system, const State& state, std::span<const float> target) {
  PackWriter pack(std::move(header));
  pack.add("positions", places_of(state, system.layout.nodes()), 3).add("normals", normals_of(system, state), 3);
  if (!target.empty()) pack.add("target", target, 4);
  return pack.finish();
}

Pack shapes_pack(Json header, const char* name, std::span<const VecX> shapes) {
  Floats numbers;
  for (const VecX& shape : shapes) {
    const Floats one = millimetres(shape);
    numbers.insert(numbers.end(), one.begin(), one.end());
  }
  return PackWriter(std::move(header)).add(name, numbers, 3).finish();
}

}  // namespace lissom
