#include "lissom/geometry/cell_network.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

#include "lissom/core/assert.h"
#include "lissom/geometry/surface_boundary.h"
#include "lissom/geometry/surface_topology.h"

namespace lissom {

namespace {

constexpr double kCorner = 0.7;  // rad, turn of a boundary that makes a joint

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Follows the borders between cells over the fine surface.
class Tracer {
 public:
  Tracer(const Surface& surface, const SurfaceCells& cells, const std::string& where)
      : surface_(surface), where_(where), cells_(cells), mates_(side_mates(cells.fine.surface.triangles)) {}

  Result<SurfaceNetwork> run() {
    const int triangles = static_cast<int>(cells_.fine.surface.triangles.size());
    joint_in_.assign(at(triangles), -1);
    for (int t = 0; t < triangles; ++t) {
      if (distinct(t) != 3) continue;
      joint_in_[at(t)] = static_cast<int>(network_.joints.size());
      network_.joints.push_back({cells_.fine.on_given({t, triple_point(cells_, t)}), SurfaceJoint::Kind::kInside});
    }
    find_patches();
    for (int t = 0; t < triangles; ++t) {
      for (int i = 0; i < 3; ++i) {
        if (mates_[at(3 * t + i)] < 0 && cell(t, i) != cell(t, i + 1)) begin_at_boundary(t, i);
      }
    }
    for (int t = 0; t < triangles; ++t) {
      for (int i = 0; i < 3 && joint_in_[at(t)] >= 0; ++i) begin_at_joint(t, i);
    }
    network_.notes = cells_.notes;
    if (Status s = add_boundary_lines(surface_, kCorner, network_, where_); !s) return s.error();
    return std::move(network_);
  }

 private:
  int vertex(int triangle, int i) const { return cells_.fine.surface.triangles[at(triangle)][at(i % 3)]; }
  int cell(int triangle, int i) const { return cells_.cell[at(vertex(triangle, i))]; }

  int distinct(int t) const { return static_cast<int>(std::set<int>{cell(t, 0), cell(t, 1), cell(t, 2)}.size()); }

  /// Given triangles that each cell touches.
  void find_patches() {
    patch_.resize(cells_.site.size());
    for (int t = 0; t < static_cast<int>(cells_.fine.surface.triangles.size()); ++t) {
      for (int i = 0; i < 3; ++i) patch_[at(cell(t, i))].push_back(cells_.fine.origin[at(t)]);
    }
    for (std::vector<int>& triangles : patch_) {
      std::sort(triangles.begin(), triangles.end());
      triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
    }
  }

  int boundary_joint(int t, int i) {
    const double along = crossing(cells_, vertex(t, i), vertex(t, i + 1));
    Vec3 weights = Vec3::Zero();
    weights[i] = 1 - along;
    weights[(i + 1) % 3] = along;
    network_.joints.push_back({cells_.fine.on_given({t, weights}), SurfaceJoint::Kind::kBoundary});
    return static_cast<int>(network_.joints.size()) - 1;
  }

  /// A line that enters triangle t through its edge i, at the boundary.
  void begin_at_boundary(int t, int i) {
    if (!passed_.insert({t, i}).second) return;
    const std::pair<int, int> cells = std::minmax(cell(t, i), cell(t, i + 1));
    const int from = boundary_joint(t, i);
    add(from, follow(t, i), cells);
  }

  /// A line that leaves the joint in triangle t through its edge i.
  void begin_at_joint(int t, int i) {
    if (passed_.count({t, i}) != 0) return;
    passed_.insert({t, i});
    const std::pair<int, int> cells = std::minmax(cell(t, i), cell(t, i + 1));
    const auto [next, edge] = across(t, i);
    LISSOM_ASSERT(next >= 0);  // lines to the boundary were begun there
    add(joint_in_[at(t)], follow(next, edge), cells);
  }

  /// The triangle beyond an edge, and which of its edges that is.
  std::pair<int, int> across(int t, int i) const {
    const int mate = mates_[at(3 * t + i)];
    return mate < 0 ? std::pair(-1, -1) : std::pair(mate / 3, mate % 3);
  }

  /// From a triangle entered through an edge to the joint at which the border ends.
  int follow(int t, int entered) {
    while (true) {
      if (joint_in_[at(t)] >= 0) {
        passed_.insert({t, entered});
        return joint_in_[at(t)];
      }
      int exit = (entered + 1) % 3;
      if (cell(t, exit) == cell(t, exit + 1)) exit = (entered + 2) % 3;
      const auto [next, edge] = across(t, exit);
      if (next < 0) {
        passed_.insert({t, exit});
        return boundary_joint(t, exit);
      }
      t = next;
      entered = edge;
    }
  }

  void add(int from, int to, std::pair<int, int> cells) {
    SurfaceLine line{{from, to}, {}, false, {}};
    const std::vector<int>&a = patch_[at(cells.first)], &b = patch_[at(cells.second)];
    std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(line.patch));
    network_.lines.push_back(std::move(line));
  }

  const Surface& surface_;
  const std::string& where_;
  const SurfaceCells& cells_;
  std::vector<int> mates_;                // per side
  std::vector<int> joint_in_;             // per fine triangle
  std::vector<std::vector<int>> patch_;   // per cell
  std::set<std::pair<int, int>> passed_;  // ends of lines: triangle and edge through which they leave it
  SurfaceNetwork network_;
};

}  // namespace

Result<SurfaceNetwork> cell_network(const Surface& surface, const SurfaceCells& cells, const std::string& where) {
  return Tracer(surface, cells, where).run();
}

}  // namespace lissom
