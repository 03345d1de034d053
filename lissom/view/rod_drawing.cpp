#include "lissom/view/rod_drawing.h"

#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <utility>

#include "lissom/model/structure.h"
#include "lissom/view/solid_surface.h"

namespace lissom {
namespace {

Error bad(ErrorCode code, const std::string& where, std::string message, std::string hint = {}) {
  return {code, where, std::move(message), std::move(hint)};
}

Status check_strip(const RodStrip& rod, int index) {
  const std::string where = rod.name.empty() ? fmt::format("rod {}", index) : fmt::format("rod \"{}\"", rod.name);
  const int edges = rod.edge_count();
  const int points = static_cast<int>(rod.points.size());
  if (edges < 1 || points != edges + (rod.closed ? 0 : 1) || (rod.closed && edges < 3)) {
    return bad(ErrorCode::kGeometry, where, fmt::format("{} points do not fit {} edges", points, edges),
               "an open rod has one point more than edges, a closed one at least three of each");
  }
  const size_t count = rod.b.size();
  if (rod.n.size() != count || rod.r_n.size() != count || rod.r_b.size() != count ||
      (!rod.wall.empty() && rod.wall.size() != count)) {
    return bad(ErrorCode::kType, where, "frames and radii are not given once per edge");
  }
  for (int i = 0; i < points; ++i) {
    if (!rod.points[i].allFinite()) {
      return bad(ErrorCode::kRange, where, fmt::format("point {} has a coordinate that is not a finite number", i),
                 "the state is not a valid shape; nothing was drawn");
    }
  }
  for (int e = 0; e < edges; ++e) {
    if (!rod.b[e].allFinite() || !rod.n[e].allFinite()) {
      return bad(ErrorCode::kRange, where, fmt::format("the frame of edge {} is not finite", e));
    }
    const double wall = rod.wall.empty() ? 0 : rod.wall[e];
    if (!(rod.r_n[e] > 0 && rod.r_b[e] > 0 && wall >= 0 && std::isfinite(rod.r_n[e] + rod.r_b[e] + wall))) {
      return bad(ErrorCode::kRange, where, fmt::format("the section of edge {} has no positive finite size", e));
    }
  }
  return {};
}

Status check_sheet(const MembraneSheet& sheet, int index) {
  const std::string where =
      sheet.name.empty() ? fmt::format("membrane {}", index) : fmt::format("membrane \"{}\"", sheet.name);
  const size_t triangles = sheet.triangles.size();
  if (triangles == 0) return bad(ErrorCode::kGeometry, where, "there are no triangles to draw");
  for (size_t i = 0; i < sheet.points.size(); ++i) {
    if (sheet.points[i].allFinite()) continue;
    return bad(ErrorCode::kRange, where, fmt::format("point {} has a coordinate that is not a finite number", i),
               "the state is not a valid shape; nothing was drawn");
  }
  for (const std::array<int, 3>& triangle : sheet.triangles) {
    for (int i : triangle) {
      if (i >= 0 && i < static_cast<int>(sheet.points.size())) continue;
      return bad(ErrorCode::kRange, where, fmt::format("a triangle names point {}, which does not exist", i));
    }
  }
  if ((!sheet.smallest_stretch.empty() && sheet.smallest_stretch.size() != triangles) ||
      (!sheet.tension.empty() && sheet.tension.size() != triangles)) {
    return bad(ErrorCode::kType, where, "stretches and tensions are not given once per triangle");
  }
  for (const Vec3& tension : sheet.tension) {
    if (!tension.allFinite()) return bad(ErrorCode::kRange, where, "a tension is not a finite number");
  }
  return {};
}

int value_count(const Drawing& drawing, Field::Place place) {
  switch (place) {
    case Field::Place::kNode:
      return drawing.point_count();
    case Field::Place::kEdge:
      return drawing.edge_count();
    case Field::Place::kTriangle:
      return drawing.triangle_count();
  }
  return 0;
}

}  // namespace

const Field* Drawing::field(std::string_view name) const {
  for (const Field& f : fields) {
    if (f.name == name) return &f;
  }
  return nullptr;
}

int Drawing::rod_point_count() const {
  int count = 0;
  for (const RodStrip& rod : rods) count += static_cast<int>(rod.points.size());
  return count;
}

int Drawing::point_count() const {
  int count = rod_point_count();
  for (const MembraneSheet& sheet : membranes) count += static_cast<int>(sheet.points.size());
  return count;
}

int Drawing::triangle_count() const {
  int count = 0;
  for (const MembraneSheet& sheet : membranes) count += static_cast<int>(sheet.triangles.size());
  return count;
}

int Drawing::edge_count() const {
  int count = 0;
  for (const RodStrip& rod : rods) count += rod.edge_count();
  return count;
}

namespace {

/// Nodes of a membrane without repeats, in the order in which they are named first.
std::vector<int> sheet_nodes(const Structure& structure, const StructureMembrane& membrane) {
  std::vector<char> known(structure.nodes.size(), 0);
  std::vector<int> nodes;
  for (const int node : membrane.nodes) {
    if (!std::exchange(known[node], 1)) nodes.push_back(node);
  }
  return nodes;
}

}  // namespace

Drawing make_drawing(const Structure& structure, std::span<const Vec3> positions, std::span<const Frame> frames) {
  LISSOM_ASSERT(positions.size() == structure.nodes.size() && frames.size() == structure.edges.size());
  Drawing drawing;
  drawing.rods.reserve(structure.rods.size());
  for (const StructureRod& rod : structure.rods) {
    RodStrip strip;
    strip.name = rod.name;
    strip.closed = rod.closed;
    for (int node : rod.nodes) strip.points.push_back(positions[node]);
    for (int edge : rod.edges) {
      const Section& section = structure.edges[edge].section;
      strip.shape = section.shape;
      strip.b.push_back(frames[edge].b);
      strip.n.push_back(frames[edge].n);
      strip.r_n.push_back(section.r_n);
      strip.r_b.push_back(section.r_b);
      if (section.shape == SectionShape::kTube) strip.wall.push_back(section.wall);
    }
    drawing.rods.push_back(std::move(strip));
  }
  for (const StructureMembrane& membrane : structure.membranes) {
    MembraneSheet sheet;
    sheet.name = membrane.name;
    std::vector<int> vertex(structure.nodes.size(), -1);  // of each node
    for (const int node : sheet_nodes(structure, membrane)) {
      vertex[node] = static_cast<int>(sheet.points.size());
      sheet.points.push_back(positions[node]);
    }
    for (int t = 0; t < membrane.triangles; ++t) {
      const std::array<int, 3>& node = structure.triangles[membrane.first_triangle + t].node;
      sheet.triangles.push_back({vertex[node[0]], vertex[node[1]], vertex[node[2]]});
    }
    drawing.membranes.push_back(std::move(sheet));
  }
  for (const StructureSolid& solid : structure.solids) {
    const SolidSurface surface = surface_of(structure, solid);
    MembraneSheet sheet;
    sheet.name = solid.name;
    for (const int node : surface.nodes) sheet.points.push_back(positions[node]);
    sheet.triangles = surface.triangles;
    drawing.membranes.push_back(std::move(sheet));
  }
  return drawing;
}

std::vector<double> field_values(const Structure& structure, Field::Place place, std::span<const double> values) {
  std::vector<double> arranged;
  if (place == Field::Place::kTriangle) {
    LISSOM_ASSERT(values.size() == structure.triangles.size());
    for (const StructureMembrane& membrane : structure.membranes) {
      const auto first = values.begin() + membrane.first_triangle;
      arranged.insert(arranged.end(), first, first + membrane.triangles);
    }
    for (const StructureSolid& solid : structure.solids) {
      arranged.resize(arranged.size() + surface_of(structure, solid).triangles.size(),
                      std::numeric_limits<double>::quiet_NaN());
    }
    return arranged;
  }
  LISSOM_ASSERT(values.size() == (place == Field::Place::kNode ? structure.nodes.size() : structure.edges.size()));
  for (const StructureRod& rod : structure.rods) {
    for (int i : place == Field::Place::kNode ? rod.nodes : rod.edges) arranged.push_back(values[i]);
  }
  if (place == Field::Place::kEdge) return arranged;
  for (const StructureMembrane& membrane : structure.membranes) {
    for (int i : sheet_nodes(structure, membrane)) arranged.push_back(values[i]);
  }
  for (const StructureSolid& solid : structure.solids) {
    for (const int i : surface_of(structure, solid).nodes) arranged.push_back(values[i]);
  }
  return arranged;
}

Status check_drawing(const Drawing& drawing) {
  if (drawing.rods.empty() && drawing.membranes.empty()) {
    return bad(ErrorCode::kGeometry, "drawing", "there are no rods to draw", "add at least one rod to the structure");
  }
  for (size_t i = 0; i < drawing.rods.size(); ++i) {
    if (Status status = check_strip(drawing.rods[i], static_cast<int>(i)); !status) return status;
  }
  for (size_t i = 0; i < drawing.membranes.size(); ++i) {
    if (Status status = check_sheet(drawing.membranes[i], static_cast<int>(i)); !status) return status;
  }
  for (const Field& field : drawing.fields) {
    const int expected = value_count(drawing, field.place);
    if (static_cast<int>(field.values.size()) != expected) {
      return bad(ErrorCode::kType, fmt::format("field \"{}\"", field.name),
                 fmt::format("has {} values where the drawing has {}", field.values.size(), expected));
    }
    for (double v : field.values) {
      if (std::isinf(v))
        return bad(ErrorCode::kRange, fmt::format("field \"{}\"", field.name), "has an infinite value");
    }
  }
  for (const Marker& marker : drawing.markers) {
    if (!marker.at.allFinite() || !marker.vector.allFinite()) {
      return bad(ErrorCode::kRange, "markers", "a support or force has a coordinate that is not a finite number");
    }
  }
  return {};
}

std::vector<double> edge_values_at_points(const Drawing& drawing, std::span<const double> values) {
  std::vector<double> result;
  result.reserve(drawing.rod_point_count());
  size_t first = 0;
  for (const RodStrip& rod : drawing.rods) {
    const int edges = rod.edge_count();
    for (int i = 0; i < static_cast<int>(rod.points.size()); ++i) {
      double sum = 0;
      int count = 0;
      for (int e : {i - 1, i}) {
        if (e < 0 && rod.closed) e = edges - 1;
        if (e < 0 || e >= edges || std::isnan(values[first + e])) continue;
        sum += values[first + e];
        ++count;
      }
      result.push_back(count > 0 ? sum / count : std::numeric_limits<double>::quiet_NaN());
    }
    first += edges;
  }
  return result;
}

Vec3 triangle_cross(const MembraneSheet& sheet, int triangle) {
  const std::array<int, 3>& corner = sheet.triangles[triangle];
  const Vec3& origin = sheet.points[corner[0]];
  return (sheet.points[corner[1]] - origin).cross(sheet.points[corner[2]] - origin);
}

std::vector<double> values_at_points(const Drawing& drawing, const Field& field) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const size_t points = static_cast<size_t>(drawing.point_count());
  if (field.place == Field::Place::kNode) return field.values;
  std::vector<double> result(static_cast<size_t>(drawing.rod_point_count()), kNone);
  if (field.place == Field::Place::kEdge) {
    result = edge_values_at_points(drawing, field.values);
    result.resize(points, kNone);
    return result;
  }
  const std::vector<double>& values = field.values;
  size_t first = 0;
  for (const MembraneSheet& sheet : drawing.membranes) {
    std::vector<double> sum(sheet.points.size(), 0), weight(sheet.points.size(), 0);
    for (size_t t = 0; t < sheet.triangles.size(); ++t) {
      const double value = values[first + t], area = triangle_cross(sheet, static_cast<int>(t)).norm();
      if (std::isnan(value)) continue;
      for (int i : sheet.triangles[t]) {
        sum[i] += area * value;
        weight[i] += area;
      }
    }
    for (size_t i = 0; i < sum.size(); ++i) {
      result.push_back(weight[i] > 0 ? sum[i] / weight[i] : kNone);
    }
    first += sheet.triangles.size();
  }
  return result;
}

}  // namespace lissom
