#include "lissom/design/rod_controls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "lissom/core/assert.h"
#include "lissom/geometry/hermite_curve.h"

namespace lissom {

namespace {

Error unsupported(const StructureRod& rod, const std::string& what, const std::string& hint) {
  return {ErrorCode::kUnsupported, "/rods", fmt::format("rod \"{}\" {}", rod.name, what), hint};
}

/// Of a rod with `count` controls.
double place_of(int control, int count) { return static_cast<double>(control) / (count - 1); }

SparseMatrix matrix(int rows, int columns, const std::vector<Eigen::Triplet<double>>& entries) {
  SparseMatrix m(rows, columns);
  m.setFromTriplets(entries.begin(), entries.end());
  return m;
}

}  // namespace

Result<RodControls> RodControls::make(const Structure& structure, ControlStage stage) {
  RodControls out;
  out.stage_ = stage;
  std::vector<int> control_of(structure.nodes.size(), -1);
  for (const StructureRod& rod : structure.rods) {
    if (rod.closed) return unsupported(rod, "is closed and has no ends", "cut it into rods that end at joints");
    if (rod.edges.size() < 2) return unsupported(rod, "has a single edge", "give it two edges or more");
    std::array<int, 2> ends{};
    for (int side = 0; side < 2; ++side) {
      const int node = side == 0 ? rod.nodes.front() : rod.nodes.back();
      if (control_of[node] < 0) {
        control_of[node] = out.size();
        out.controls_.push_back({node, -1, 0});
      }
      ends[side] = control_of[node];
    }
    out.rod_ends_.push_back(ends);
  }
  out.ends_ = out.size();
  std::vector<int> passing(structure.nodes.size(), -1);  // rod that has this node between its ends
  const int count = static_cast<int>(stage);
  for (int r = 0; r < static_cast<int>(structure.rods.size()); ++r) {
    const StructureRod& rod = structure.rods[r];
    for (size_t k = 1; k + 1 < rod.nodes.size(); ++k) {
      if (control_of[rod.nodes[k]] >= 0 || passing[rod.nodes[k]] >= 0) {
        return unsupported(rod, "is met by another rod between its ends",
                           "cut it there, so that all rods end at the joint");
      }
      passing[rod.nodes[k]] = r;
    }
    for (int c = 1; c + 1 < count; ++c) out.controls_.push_back({-1, r, place_of(c, count)});
  }
  return out;
}

std::string RodControls::name(int control, const Structure& structure) const {
  const Control& c = controls_[control];
  if (c.node >= 0) return fmt::format("end at node {}", c.node);
  const int pieces = static_cast<int>(stage_) - 1;
  return fmt::format("rod \"{}\" at {}/{}", structure.rods[c.rod].name, std::lround(c.at * pieces), pieces);
}

Vec3 RodControls::place(int control, const Structure& structure) const {
  const Control& c = controls_[control];
  if (c.node >= 0) return structure.nodes[c.node];
  const std::vector<int>& nodes = structure.rods[c.rod].nodes;
  const double u = c.at * (static_cast<double>(nodes.size()) - 1);
  const std::size_t k = std::min(static_cast<std::size_t>(u), nodes.size() - 2);
  const double s = u - static_cast<double>(k);
  return (1 - s) * structure.nodes[nodes[k]] + s * structure.nodes[nodes[k + 1]];
}

std::vector<int> RodControls::along(int rod) const {
  const int between = static_cast<int>(stage_) - 2;
  std::vector<int> numbers{rod_ends_[rod][0]};
  for (int c = 0; c < between; ++c) numbers.push_back(ends_ + between * rod + c);
  numbers.push_back(rod_ends_[rod][1]);
  return numbers;
}

void RodControls::add_value(int row, int rod, double u, std::vector<Eigen::Triplet<double>>& out) const {
  std::vector<PointWeights> points;
  for (const int number : along(rod)) points.emplace_back(number);
  const HermiteCurve<PointWeights> curve(points, false);
  const int piece = std::clamp(static_cast<int>(u * curve.pieces()), 0, curve.pieces() - 1);
  const PointWeights value = curve.point(piece, u * curve.pieces() - piece);
  for (int k = 0; k < value.count; ++k) {
    if (value.weight[k] != 0) out.emplace_back(row, value.point[k], value.weight[k]);
  }
}

SparseMatrix RodControls::edge_weights(const Structure& structure) const {
  LISSOM_ASSERT(structure.rods.size() == rod_ends_.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (int r = 0; r < static_cast<int>(structure.rods.size()); ++r) {
    const std::vector<int>& edges = structure.rods[r].edges;
    for (size_t k = 0; k < edges.size(); ++k) {
      add_value(edges[k], r, (static_cast<double>(k) + 0.5) / static_cast<double>(edges.size()), entries);
    }
  }
  return matrix(static_cast<int>(structure.edges.size()), size(), entries);
}

SparseMatrix RodControls::node_weights(const Structure& structure) const {
  LISSOM_ASSERT(structure.rods.size() == rod_ends_.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (int c = 0; c < ends_; ++c) entries.emplace_back(controls_[c].node, c, 1.0);
  for (int r = 0; r < static_cast<int>(structure.rods.size()); ++r) {
    const std::vector<int>& nodes = structure.rods[r].nodes;
    const double last = static_cast<double>(nodes.size()) - 1;
    for (size_t k = 1; k + 1 < nodes.size(); ++k) add_value(nodes[k], r, static_cast<double>(k) / last, entries);
  }
  return matrix(static_cast<int>(structure.nodes.size()), size(), entries);
}

SparseMatrix RodControls::prolongation(const RodControls& finer) const {
  LISSOM_ASSERT(finer.stage_ >= stage_ && finer.ends_ == ends_ && finer.rod_ends_ == rod_ends_);
  std::vector<Eigen::Triplet<double>> entries;
  for (int c = 0; c < finer.size(); ++c) {
    const Control& control = finer.controls_[c];
    if (control.node >= 0) {
      entries.emplace_back(c, c, 1.0);
    } else {
      add_value(c, control.rod, control.at, entries);
    }
  }
  return matrix(finer.size(), size(), entries);
}

}  // namespace lissom
