#include "lissom/view/rod_drawing.h"

#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "lissom/model/structure.h"

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

}  // namespace

const Field* Drawing::field(std::string_view name) const {
  for (const Field& f : fields) {
    if (f.name == name) return &f;
  }
  return nullptr;
}

int Drawing::point_count() const {
  int count = 0;
  for (const RodStrip& rod : rods) count += static_cast<int>(rod.points.size());
  return count;
}

int Drawing::edge_count() const {
  int count = 0;
  for (const RodStrip& rod : rods) count += rod.edge_count();
  return count;
}

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
  return drawing;
}

std::vector<double> field_values(const Structure& structure, Field::Place place, std::span<const double> values) {
  LISSOM_ASSERT(values.size() == (place == Field::Place::kNode ? structure.nodes.size() : structure.edges.size()));
  std::vector<double> arranged;
  for (const StructureRod& rod : structure.rods) {
    for (int i : place == Field::Place::kNode ? rod.nodes : rod.edges) arranged.push_back(values[i]);
  }
  return arranged;
}

Status check_drawing(const Drawing& drawing) {
  if (drawing.rods.empty()) {
    return bad(ErrorCode::kGeometry, "drawing", "there are no rods to draw", "add at least one rod to the structure");
  }
  for (size_t i = 0; i < drawing.rods.size(); ++i) {
    if (Status status = check_strip(drawing.rods[i], static_cast<int>(i)); !status) return status;
  }
  for (const Field& field : drawing.fields) {
    const int expected = field.place == Field::Place::kNode ? drawing.point_count() : drawing.edge_count();
    if (static_cast<int>(field.values.size()) != expected) {
      return bad(ErrorCode::kType, fmt::format("field \"{}\"", field.name),
                 fmt::format("has {} values where the rods have {}", field.values.size(), expected));
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
  result.reserve(drawing.point_count());
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

}  // namespace lissom
