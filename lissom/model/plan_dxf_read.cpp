#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "lissom/geometry/b_spline.h"
#include "lissom/model/plan_dxf.h"

namespace lissom {

namespace {

constexpr double kDegree = std::numbers::pi / 180;

struct Group {
  int code = 0;
  std::string_view text;
};

double number(std::string_view text) {
  double value = 0;
  while (!text.empty() && (text.front() == ' ' || text.front() == '+')) text.remove_prefix(1);
  std::from_chars(text.data(), text.data() + text.size(), value);
  return std::isfinite(value) ? value : 0;
}

/// The groups of one entity, from its name to the next.
class Entity {
 public:
  explicit Entity(std::vector<Group> groups) : groups_(std::move(groups)) {}

  std::string_view name() const { return groups_.front().text; }
  std::string_view text(int code) const {
    for (const Group& group : groups_) {
      if (group.code == code) return group.text;
    }
    return {};
  }
  double value(int code, double absent = 0) const {
    const std::string_view found = text(code);
    return found.empty() ? absent : number(found);
  }
  int flags() const { return static_cast<int>(value(70)); }
  Vec2 point(int code) const { return {value(code), value(code + 10)}; }
  std::vector<double> all(int code) const {
    std::vector<double> values;
    for (const Group& group : groups_) {
      if (group.code == code) values.push_back(number(group.text));
    }
    return values;
  }
  const std::vector<Group>& groups() const { return groups_; }

 private:
  std::vector<Group> groups_;
};

/// The turn from one angle to another, anticlockwise, above 0 and at most a full one.
double turn_to(double start, double end) {
  const double turn = std::fmod(end - start, 2 * std::numbers::pi);
  return turn > 1e-12 ? turn : turn + 2 * std::numbers::pi;
}

/// A vertex of a polyline; bulge: tangent of a quarter of the turn of the arc to the next.
struct Vertex {
  Vec2 at = Vec2::Zero();
  double bulge = 0;
};

PlanarPath bulged(const std::vector<Vertex>& vertices, bool closed) {
  PlanarPath path;
  const std::size_t n = vertices.size();
  for (std::size_t i = 0; i + (closed ? 0 : 1) < n; ++i) {
    const Vec2 &from = vertices[i].at, &to = vertices[(i + 1) % n].at;
    const double bulge = vertices[i].bulge;
    if (bulge == 0) {
      path.push_back(PathPiece::line(from, to));
      continue;
    }
    const Vec2 chord = to - from, right(chord.y(), -chord.x());
    path.push_back(PathPiece::arc(from, (from + to) / 2 + bulge / 2 * right, to));
  }
  return path;
}

class DxfReader {
 public:
  DxfReader(std::string_view text, std::string where) : where_(std::move(where)), rest_(text) {}

  Result<PlanDrawing> read() {
    std::string_view section, variable;
    std::vector<Group> entity;
    Group group;
    bool ended = false;
    while (!ended && next(group)) {
      if (group.code == 0 || group.code == 9) {
        if (section == "ENTITIES" && !entity.empty()) take(Entity(std::move(entity)));
        entity.clear();
        ended = group.code == 0 && group.text == "EOF";
        if (group.code == 0 && group.text == "ENDSEC") section = {};
        if (group.code == 9) variable = group.text;
      }
      if (group.code == 2 && !entity.empty() && entity.front().text == "SECTION") section = group.text;
      if (section == "HEADER" && variable == "$INSUNITS" && group.code == 70)
        set_unit(static_cast<int>(number(group.text)));
      entity.push_back(group);
    }
    if (bad_line_ > 0 || !ended) {
      return Error{ErrorCode::kSyntax, fmt::format("{}:{}", where_, bad_line_ > 0 ? bad_line_ : line_),
                   ended || bad_line_ > 0 ? "this is not a text DXF drawing" : "the drawing is cut off: EOF is missing",
                   "save it as ASCII DXF"};
    }
    for (DrawnLine& line : drawing_.lines) scale(line);
    return std::move(drawing_);
  }

 private:
  std::string_view next_line() {
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++line_;
    while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
    return line;
  }

  bool next(Group& group) {
    if (rest_.empty()) return false;
    std::string_view code = next_line();
    while (!code.empty() && code.front() == ' ') code.remove_prefix(1);
    const auto [end, error] = std::from_chars(code.data(), code.data() + code.size(), group.code);
    if (error != std::errc() || end != code.data() + code.size() || rest_.empty()) {
      if (!code.empty() || !rest_.empty()) bad_line_ = line_;
      return false;
    }
    group.text = next_line();
    return true;
  }

  void set_unit(int unit) {
    constexpr std::pair<int, double> kUnits[] = {{1, 0.0254}, {2, 0.3048}, {4, 1e-3}, {5, 1e-2}, {6, 1}, {14, 0.1}};
    for (const auto& [code, metres] : kUnits) {
      if (code == unit) unit_ = metres;
    }
  }

  void take(const Entity& entity) {
    if (entity.name() == "VERTEX" && in_polyline_) {
      vertices_.push_back({entity.point(10), entity.value(42)});
      return;
    }
    if (entity.name() == "SEQEND" && in_polyline_) {
      in_polyline_ = false;
      polyline_.path = bulged(vertices_, polyline_.closed);
      add(std::move(polyline_), polyline_layer_);
      return;
    }
    DrawnLine line = labelled(entity);
    const std::string_view layer = entity.text(8);
    if (entity.name() == "POLYLINE") {
      in_polyline_ = true;
      vertices_.clear();
      line.closed = (entity.flags() & 1) != 0;
      polyline_ = std::move(line);
      polyline_layer_ = layer;
    } else if (shape(entity, line)) {
      add(std::move(line), layer);
    }
  }

  /// What an entity says besides its shape.
  static DrawnLine labelled(const Entity& entity) {
    DrawnLine line;
    bool own = false;
    std::vector<double> radii;
    for (const Group& group : entity.groups()) {
      if (group.code == 1001) own = group.text == "LISSOM";
      if (own && group.code == 1000) line.name = group.text;
      if (own && group.code == 1040) radii.push_back(number(group.text));
    }
    if (radii.size() == 2 && radii[0] > 0 && radii[1] > 0) {
      line.r_n = radii[0];
      line.r_b = radii[1];
    }
    return line;
  }

  /// The path of an entity in the unit of the drawing; false when it is no line.
  static bool shape(const Entity& entity, DrawnLine& line) {
    const std::string_view name = entity.name();
    if (name == "LINE") {
      line.path = {PathPiece::line(entity.point(10), entity.point(11))};
    } else if (name == "LWPOLYLINE") {
      std::vector<Vertex> vertices;
      for (const Group& group : entity.groups()) {
        if (group.code == 10) vertices.push_back({{number(group.text), 0}, 0});
        if (group.code == 20 && !vertices.empty()) vertices.back().at.y() = number(group.text);
        if (group.code == 42 && !vertices.empty()) vertices.back().bulge = number(group.text);
      }
      line.closed = (entity.flags() & 1) != 0;
      line.path = bulged(vertices, line.closed);
      const double width = entity.value(43);
      if (width > 0 && !line.r_b) line.r_b = width / 2;
    } else if (name == "CIRCLE" || name == "ARC") {
      const bool whole = name == "CIRCLE";
      const double radius = entity.value(40), start = whole ? 0 : kDegree * entity.value(50);
      const double sweep = whole ? 2 * std::numbers::pi : turn_to(start, kDegree * entity.value(51));
      if (!(radius > 0)) return false;
      line.path = ellipse_path(entity.point(10), radius, radius, 0, start, sweep);
      line.closed = whole;
    } else if (name == "ELLIPSE") {
      const Vec2 major = entity.point(11);
      const double start = entity.value(41);
      const double sweep = turn_to(start, entity.value(42, 2 * std::numbers::pi));
      if (!(major.norm() > 0) || !(entity.value(40) > 0)) return false;
      line.path = ellipse_path(entity.point(10), major.norm(), entity.value(40) * major.norm(),
                               std::atan2(major.y(), major.x()), start, sweep);
      line.closed = sweep > 2 * std::numbers::pi - 1e-6;
    } else if (name == "SPLINE") {
      BSpline spline{static_cast<int>(entity.value(71, 3)), entity.all(40), {}, entity.all(41)};
      const std::vector<double> x = entity.all(10), y = entity.all(20);
      for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) spline.points.emplace_back(x[i], y[i]);
      line.path = bezier_pieces(spline);
      line.closed = (entity.flags() & 1) != 0;
    } else {
      return false;
    }
    if (line.closed && !line.path.empty() && line.path.front().kind != PathPiece::Kind::kLine) {
      // Rounding must not leave a gap; what is really open is closed by a straight piece later.
      Vec2& last = line.path.back().to;
      if ((last - line.path.front().from).norm() < 1e-6 * (1 + last.norm())) last = line.path.front().from;
    }
    if (entity.value(230, 1) < 0 && name != "LINE" && name != "ELLIPSE" && name != "SPLINE") {
      for (PathPiece& piece : line.path) {
        for (Vec2* p : {&piece.from, &piece.to, &piece.a, &piece.b}) p->x() = -p->x();
      }
    }
    return !line.path.empty();
  }

  void add(DrawnLine line, std::string_view layer) {
    const std::optional<PlanRole> role = role_of_layer(layer);
    if (!role) {
      ++drawing_.left_out;
      return;
    }
    line.role = *role;
    drawing_.lines.push_back(std::move(line));
  }

  void scale(DrawnLine& line) const {
    for (PathPiece& piece : line.path) {
      for (Vec2* p : {&piece.from, &piece.to, &piece.a, &piece.b}) *p *= unit_;
    }
    if (line.r_b) *line.r_b *= unit_;
    if (line.r_n) *line.r_n *= unit_;
  }

  std::string where_;
  std::string_view rest_;
  int line_ = 0, bad_line_ = 0;
  double unit_ = 1e-3;
  PlanDrawing drawing_;
  bool in_polyline_ = false;
  DrawnLine polyline_;
  std::string_view polyline_layer_;
  std::vector<Vertex> vertices_;
};

}  // namespace

Result<PlanDrawing> read_dxf_drawing(std::string_view text, const std::string& where) {
  return DxfReader(text, where).read();
}

}  // namespace lissom
