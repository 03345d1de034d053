#include "scenes/parts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "lissom/core/assert.h"
#include "lissom/model/import_network.h"

namespace lissom::scene_models {

namespace {

/// Collects lines between points given by coordinates; points closer than a micrometre are one.
class Drawing {
 public:
  void line(double x0, double y0, double x1, double y1) {
    const int a = point(x0, y0), b = point(x1, y1);
    const std::pair<int, int> key = std::minmax(a, b);
    if (a != b && lines_.emplace(key, true).second) drawn_.segments.push_back({a, b});
  }
  ObjLines centred() {
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const Vec3& p : drawn_.points) {
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    for (Vec3& p : drawn_.points) p -= 0.5 * (low + high);
    return drawn_;
  }

 private:
  int point(double x, double y) {
    const std::pair<long, long> key{std::lround(x * 1e6), std::lround(y * 1e6)};
    const auto [found, fresh] = numbers_.emplace(key, static_cast<int>(drawn_.points.size()));
    if (fresh) drawn_.points.push_back(Vec3(x, y, 0));
    return found->second;
  }

  ObjLines drawn_;
  std::map<std::pair<long, long>, int> numbers_;
  std::map<std::pair<int, int>, bool> lines_;
};

}  // namespace

Rod round_rod(std::string name, Curve curve, double radius, std::string material, int edges) {
  Rod rod;
  rod.name = std::move(name);
  rod.curve = std::move(curve);
  rod.material = std::move(material);
  rod.section.r_n = {radius};
  rod.section.r_b = {radius};
  rod.edges = edges;
  return rod;
}

Selector rod_place(std::string rod, double fraction) {
  Selector at;
  at.kind = Selector::Kind::kRod;
  at.name = std::move(rod);
  at.fraction = fraction;
  return at;
}

Selector box(const Vec3& low, const Vec3& high) {
  Selector at;
  at.kind = Selector::Kind::kBox;
  at.low = low;
  at.high = high;
  return at;
}

Support hold(Selector at, SupportKind kind) {
  Support support;
  support.at = std::move(at);
  support.kind = kind;
  return support;
}

ObjLines hexagons(double edge, int columns, int rows) {
  Drawing drawing;
  const double width = std::sqrt(3.0) * edge;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const double x = width * (column + 0.5 * (row % 2)), y = 1.5 * edge * row;
      for (int k = 0; k < 6; ++k) {
        const double a = std::numbers::pi / 6 + k * std::numbers::pi / 3, b = a + std::numbers::pi / 3;
        drawing.line(x + edge * std::cos(a), y + edge * std::sin(a), x + edge * std::cos(b), y + edge * std::sin(b));
      }
    }
  }
  return drawing.centred();
}

ObjLines squares(double edge, int columns, int rows) {
  Drawing drawing;
  for (int i = 0; i <= columns; ++i) {
    for (int j = 0; j <= rows; ++j) {
      if (i < columns) drawing.line(i * edge, j * edge, (i + 1) * edge, j * edge);
      if (j < rows) drawing.line(i * edge, j * edge, i * edge, (j + 1) * edge);
    }
  }
  return drawing.centred();
}

ObjLines triangles(double edge, int columns, int rows) {
  Drawing drawing;
  const double height = std::sqrt(0.75) * edge;
  const auto x = [&](int i, int j) { return edge * (i + 0.5 * (j % 2)); };
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      if (i < columns) drawing.line(x(i, j), j * height, x(i + 1, j), j * height);
      if (j == rows) continue;
      drawing.line(x(i, j), j * height, x(i, j + 1), (j + 1) * height);
      const int other = j % 2 == 0 ? i - 1 : i + 1;
      if (other >= 0 && other <= columns) drawing.line(x(i, j), j * height, x(other, j + 1), (j + 1) * height);
    }
  }
  return drawing.centred();
}

Model sheet(const std::string& title, const ObjLines& lines, double radius, const std::string& material, int edges) {
  NetworkOptions options;
  options.material = material;
  options.section.r_n = {radius};
  options.section.r_b = {radius};
  options.edges_per_segment = edges;
  options.rods = NetworkRods::kSegments;
  Result<ImportedNetwork> network = import_network(lines, options);
  LISSOM_ASSERT(network.ok());
  network.value().model.title = title;
  return std::move(network.value().model);
}

Pose hanging_pose(const ObjLines& lines, double margin) {
  double reach = 0;
  for (const Vec3& p : lines.points) reach = std::max(reach, p.x());
  Pose pose;
  pose.name = "hanging";
  for (const double side : {-1.0, 1.0}) {
    const double inner = side * (reach - margin), outer = side * (reach + margin);
    pose.supports.push_back(
        hold(box(Vec3(std::min(inner, outer), -10, -10), Vec3(std::max(inner, outer), 10, 10)), SupportKind::kPin));
  }
  pose.gravity = Gravity{};
  return pose;
}

}  // namespace lissom::scene_models
