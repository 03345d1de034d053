#include "lissom/design/objective_enclosed_volume.h"

#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "lissom/design/part_of_structure.h"
#include "lissom/mechanics/rest_numbers.h"

namespace lissom {

namespace {

constexpr double kFelt = 0.01;  // of the volume over which the fabric would make a half cube

using Places = std::vector<Vec3>;

/// A closed surface: corners are nodes, then tips of caps.
struct ClosedSurface {
  std::vector<int> nodes;                     // of the structure, per corner that is one
  std::vector<std::vector<int>> rims;         // corners of each rim; its tip is their mean
  std::optional<Vec3> apex;                   // or the one tip of all caps
  std::vector<std::array<int, 3>> triangles;  // corners, anticlockwise seen from outside

  std::size_t corners() const { return nodes.size() + (apex ? 1 : rims.size()); }
};

class EnclosedVolume final : public Objective {
 public:
  EnclosedVolume(ClosedSurface surface, std::vector<int> triangles)
      : surface_(std::move(surface)), triangles_(std::move(triangles)) {}

  std::string_view name() const override { return "enclosed volume"; }
  std::string_view unit() const override { return "m^3"; }
  int size() const override { return 1; }
  double scale(const PoseShape& shape) const override {
    double area = 0;
    for (const int t : triangles_) area += shape.design.system.rest.triangles[t].area;
    return kFelt * std::pow(area / 3, 1.5) / 2;
  }

  void values(const PoseShape& shape, VecX& c) const override {
    const Places x = places(shape);
    double six = 0;
    for (const auto& [i, j, k] : surface_.triangles) six += x[i].dot(x[j].cross(x[k]));
    c = VecX::Constant(1, six / 6);
  }

  void jacobian(const PoseShape& shape, SparseRows& by_q, SparseRows& by_numbers) const override {
    const Places x = places(shape);
    Places gradient(x.size(), Vec3::Zero());
    for (const auto& [i, j, k] : surface_.triangles) {
      gradient[i] += x[j].cross(x[k]) / 6;
      gradient[j] += x[k].cross(x[i]) / 6;
      gradient[k] += x[i].cross(x[j]) / 6;
    }
    VecX row = VecX::Zero(shape.design.system.layout.size());
    scatter(gradient, row);
    by_q.resize(1, row.size());
    for (int i = 0; i < row.size(); ++i) {
      if (row[i] != 0) by_q.insert(0, i) = row[i];
    }
    by_numbers.resize(1, RestNumbers(shape.design.system.structure).size());
  }

  void curvature(const PoseShape& shape, const VecX& y, const VecX& dq, const VecX&, VecX& by_q, VecX&) const override {
    const Places x = places(shape);
    Places d(x.size(), Vec3::Zero()), change(x.size(), Vec3::Zero());
    for (std::size_t i = 0; i < surface_.nodes.size(); ++i) d[i] = dq.segment<3>(3 * surface_.nodes[i]);
    set_tips(d);
    if (surface_.apex) d.back().setZero();
    const double sixth = y[0] / 6;
    for (const auto& [i, j, k] : surface_.triangles) {
      change[i] += sixth * (d[j].cross(x[k]) + x[j].cross(d[k]));
      change[j] += sixth * (d[k].cross(x[i]) + x[k].cross(d[i]));
      change[k] += sixth * (d[i].cross(x[j]) + x[i].cross(d[j]));
    }
    scatter(change, by_q);
  }

 private:
  /// Means of rims; an apex stays as it is.
  void set_tips(Places& x) const {
    if (surface_.apex) return;
    for (std::size_t r = 0; r < surface_.rims.size(); ++r) {
      Vec3 sum = Vec3::Zero();
      for (const int i : surface_.rims[r]) sum += x[i];
      x[surface_.nodes.size() + r] = sum / static_cast<double>(surface_.rims[r].size());
    }
  }

  /// Corners, from the first node: the volume does not hang on the origin, its rounding does.
  Places places(const PoseShape& shape) const {
    Places x(surface_.corners());
    const Vec3 origin = shape.state.position(surface_.nodes[0]);
    for (std::size_t i = 0; i < surface_.nodes.size(); ++i) x[i] = shape.state.position(surface_.nodes[i]) - origin;
    if (surface_.apex) x.back() = *surface_.apex - origin;
    set_tips(x);
    return x;
  }

  void scatter(const Places& by_corner, VecX& by_q) const {
    for (std::size_t i = 0; i < surface_.nodes.size(); ++i) by_q.segment<3>(3 * surface_.nodes[i]) += by_corner[i];
    if (surface_.apex) return;
    for (std::size_t r = 0; r < surface_.rims.size(); ++r) {
      const Vec3 share = by_corner[surface_.nodes.size() + r] / static_cast<double>(surface_.rims[r].size());
      for (const int i : surface_.rims[r]) by_q.segment<3>(3 * surface_.nodes[i]) += share;
    }
  }

  ClosedSurface surface_;
  std::vector<int> triangles_;  // of the structure
};

Error refuse(std::string message, std::string hint) {
  return {ErrorCode::kUnsupported, "enclosed volume", std::move(message), std::move(hint)};
}

using Edge = std::array<int, 2>;

/// Edges, in the direction of their triangle, that no other triangle has the other way round.
Result<std::vector<Edge>> rim_of(const std::vector<std::array<int, 3>>& triangles) {
  std::map<Edge, int> directed;
  for (const auto& t : triangles) {
    for (int i = 0; i < 3; ++i) {
      if (++directed[{t[i], t[(i + 1) % 3]}] > 1) {
        return refuse("triangles that share an edge are turned against each other, or more than two share it",
                      "name membranes that make up one surface with one outside");
      }
    }
  }
  std::vector<Edge> rim;
  for (const auto& [edge, count] : directed) {
    if (!directed.contains({edge[1], edge[0]})) rim.push_back(edge);
  }
  return rim;
}

/// Puts caps on the rim: one for each of its connected parts, or all from the apex.
void close_up(const std::vector<Edge>& rim, ClosedSurface& surface) {
  const int corners = static_cast<int>(surface.nodes.size());
  std::vector<int> parent(corners), rim_of_part(corners, -1);
  std::iota(parent.begin(), parent.end(), 0);
  const auto part = [&](int i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  for (const auto& [a, b] : rim) parent[part(a)] = part(b);
  std::vector<bool> on_rim(corners, false);
  for (const auto& [a, b] : rim) on_rim[a] = on_rim[b] = true;
  if (!surface.apex) {
    for (int i = 0; i < corners; ++i) {
      if (!on_rim[i]) continue;
      int& number = rim_of_part[part(i)];
      if (number < 0) {
        number = static_cast<int>(surface.rims.size());
        surface.rims.emplace_back();
      }
      surface.rims[number].push_back(i);
    }
  }
  for (const auto& [a, b] : rim) {
    surface.triangles.push_back({b, a, corners + (surface.apex ? 0 : rim_of_part[part(a)])});
  }
}

}  // namespace

Result<std::shared_ptr<const Objective>> make_enclosed_volume(const Structure& structure,
                                                              const std::vector<int>& membranes,
                                                              const std::optional<Vec3>& apex) {
  std::vector<int> triangles = triangles_of(structure, membranes);
  if (triangles.empty()) return refuse("there are no membranes to enclose a volume", "add a membrane");
  if (apex && !apex->allFinite()) {
    return Error{ErrorCode::kRange, "enclosed volume", "the apex is not finite", "give three coordinates"};
  }
  ClosedSurface surface;
  surface.apex = apex;
  std::vector<int> corner(structure.nodes.size(), -1);
  for (const int t : triangles) {
    std::array<int, 3> own;
    for (int i = 0; i < 3; ++i) {
      int& number = corner[structure.triangles[t].node[i]];
      if (number < 0) {
        number = static_cast<int>(surface.nodes.size());
        surface.nodes.push_back(structure.triangles[t].node[i]);
      }
      own[i] = number;
    }
    surface.triangles.push_back(own);
  }
  const Result<std::vector<Edge>> rim = rim_of(surface.triangles);
  if (!rim) return rim.error();
  close_up(rim.value(), surface);
  return std::shared_ptr<const Objective>(std::make_shared<EnclosedVolume>(std::move(surface), std::move(triangles)));
}

}  // namespace lissom
