#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <utility>

#include "lissom/geometry/point_grid.h"
#include "lissom/model/discretize_parts.h"

namespace lissom {

namespace {

constexpr double kDefaultMerge = 1e-6;  // of the size of the structure

/// Bounding box (m), number and shortest distance (m) of all points before they are merged.
class Extent {
 public:
  explicit Extent(const Draft& draft) {
    for (const RodShape& rod : draft.drawn) {
      add(rod.points);
      for (const double length : rod.lengths) shortest_ = std::min(shortest_, length);
    }
    for (const MembraneMesh& membrane : draft.membranes) {
      add(membrane.points);
      for (const std::array<int, 3>& t : membrane.triangles) add_side(membrane.points[t[0]], membrane.points[t[1]]);
    }
    for (const Solid& solid : draft.model.solids) {
      add(solid.points);
      for (const std::array<int, 4>& t : solid.tetrahedra) add_side(solid.points[t[0]], solid.points[t[1]]);
    }
  }

  double size() const { return (high_ - low_).norm(); }
  double shortest() const { return shortest_; }
  size_t count() const { return count_; }

 private:
  void add(const std::vector<Vec3>& points) {
    for (const Vec3& p : points) {
      low_ = count_ == 0 ? p : Vec3(low_.cwiseMin(p));
      high_ = count_ == 0 ? p : Vec3(high_.cwiseMax(p));
      ++count_;
    }
  }
  void add_side(const Vec3& a, const Vec3& b) {
    const double side = (b - a).norm();
    if (side > 0) shortest_ = std::min(shortest_, side);
  }

  Vec3 low_ = Vec3::Zero(), high_ = Vec3::Zero();
  double shortest_ = std::numeric_limits<double>::infinity();
  size_t count_ = 0;
};

/// Gives numbers to places; those within the merge distance of an earlier one get its number.
class Numbering {
 public:
  Numbering(std::vector<Vec3>& nodes, bool merges, PointGrid grid)
      : nodes_(nodes), merges_(merges), grid_(std::move(grid)) {}

  int number(const Vec3& p) {
    const int fresh = static_cast<int>(nodes_.size());
    const int node = merges_ ? grid_.insert(p) : fresh;
    if (node == fresh) nodes_.push_back(p);
    return node;
  }
  std::vector<int> numbers(const std::vector<Vec3>& points) {
    std::vector<int> all;
    all.reserve(points.size());
    for (const Vec3& p : points) all.push_back(number(p));
    return all;
  }

 private:
  std::vector<Vec3>& nodes_;
  bool merges_;
  PointGrid grid_;
};

Status number_rods(Draft& draft, Numbering& numbering) {
  Structure& s = draft.structure;
  for (size_t r = 0; r < draft.drawn.size(); ++r) {
    RodShape& rod = draft.drawn[r];
    StructureRod out;
    out.name = draft.model.rods[r].name;
    out.material = draft.model.rods[r].material;
    out.closed = rod.closed;
    out.nodes = numbering.numbers(rod.points);
    bool moved = false;
    for (size_t i = 0; i < rod.points.size(); ++i) {
      const Vec3& merged = s.nodes[static_cast<size_t>(out.nodes[i])];
      moved = moved || merged != rod.points[i];
      rod.points[i] = merged;
    }
    if (moved) {
      if (Status status = measure_edges(rod, rod_place(r), rod_label(draft.model, r)); !status) return status;
    }
    s.rods.push_back(std::move(out));
  }
  return {};
}

}  // namespace

Status merge_nodes(Draft& draft) {
  Structure& s = draft.structure;
  const Extent extent(draft);
  s.size = extent.size();
  const double asked = draft.model.merge_distance;
  if (!std::isfinite(asked) || asked > s.size) {
    return Error{ErrorCode::kRange, "/merge_distance", fmt::format("the merge distance is {:g} m", asked),
                 fmt::format("the whole structure measures {:g} m: use less", s.size)};
  }
  const double distance = asked > 0 ? asked : kDefaultMerge * s.size;
  Numbering numbering(
      s.nodes, asked >= 0,
      PointGrid(distance, std::max(extent.shortest() / 2, 1e-9 * s.size), asked < 0 ? 0 : extent.count()));
  if (Status status = number_rods(draft, numbering); !status) return status;
  for (size_t m = 0; m < draft.membranes.size(); ++m) {
    const Membrane& membrane = draft.model.membranes[m];
    StructureMembrane out;
    out.name = membrane.name;
    out.material = membrane.material;
    out.pre_stretch = membrane.pre_stretch;
    out.warp_angle = membrane.warp_angle;
    out.bending = membrane.bending;
    out.rest_folds = membrane.rest_folds;
    out.nodes = numbering.numbers(draft.membranes[m].points);
    s.membranes.push_back(std::move(out));
  }
  for (const Solid& solid : draft.model.solids) {
    s.solids.push_back({solid.name, solid.material, numbering.numbers(solid.points)});
  }
  draft.passages.assign(s.nodes.size(), 0);
  for (const StructureRod& rod : s.rods) {
    for (int node : rod.nodes) ++draft.passages[static_cast<size_t>(node)];
  }
  return {};
}

}  // namespace lissom
