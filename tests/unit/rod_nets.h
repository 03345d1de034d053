#pragma once
/// Structures of straight rods for tests of what is printed, and their volume counted point by point, by another way than
/// the one that makes surfaces.

#include <cmath>
#include <string>
#include <vector>

#include "lissom/model/structure.h"

namespace lissom::testing {

/// Rods with elliptic (or other) sections between places; rods that have a place in common meet there.
struct RodNet {
  Structure structure;

  int node(const Vec3& place) {
    for (std::size_t i = 0; i < structure.nodes.size(); ++i) {
      if ((structure.nodes[i] - place).norm() < 1e-9) return static_cast<int>(i);
    }
    structure.nodes.push_back(place);
    return static_cast<int>(structure.nodes.size()) - 1;
  }

  /// Half-extents along b and n go from those of `first` to those of `last`, in the middles of the edges.
  void add(const std::vector<Vec3>& points, Section first, Section last, bool closed = false,
           const Vec3& up = Vec3::UnitZ()) {
    StructureRod rod;
    const int number = static_cast<int>(structure.rods.size());
    rod.name = "rod-" + std::to_string(number);
    rod.material = "TPU 92A";
    rod.closed = closed;
    for (const Vec3& p : points) rod.nodes.push_back(node(p));
    const int edges = static_cast<int>(points.size()) - (closed ? 0 : 1);
    for (int e = 0; e < edges; ++e) {
      StructureEdge edge;
      edge.node0 = rod.nodes[e];
      edge.node1 = rod.nodes[(e + 1) % rod.nodes.size()];
      edge.rod = number;
      const double share = (e + 0.5) / edges;
      edge.section = first;
      edge.section.r_n += share * (last.r_n - first.r_n);
      edge.section.r_b += share * (last.r_b - first.r_b);
      const Vec3 side = structure.nodes[edge.node1] - structure.nodes[edge.node0];
      edge.rest_length = side.norm();
      edge.drawn = edge.rest = frame_from_normal(side.normalized(), up);
      rod.edges.push_back(static_cast<int>(structure.edges.size()));
      structure.edges.push_back(edge);
    }
    structure.rods.push_back(rod);
  }

  void line(const Vec3& from, const Vec3& to, const Section& section, int edges = 4) {
    std::vector<Vec3> points;
    for (int i = 0; i <= edges; ++i) points.push_back(i == edges ? to : Vec3(from + (to - from) * (double(i) / edges)));
    const Vec3 t = (to - from).normalized();
    add(points, section, section, false, std::abs(t.z()) > 0.9 ? Vec3::UnitX() : Vec3::UnitZ());
  }
};

/// m^3 of the union of straight rods of elliptic sections, each with an ellipsoid at ends that it shares with others: points of
/// a lattice that lie inside, times the volume of a cell.
inline double counted_volume(const Structure& structure, double step) {
  Vec3 low = Vec3::Constant(INFINITY), high = -low;
  double reach = 0;
  for (const Vec3& x : structure.nodes) low = low.cwiseMin(x), high = high.cwiseMax(x);
  for (const StructureEdge& e : structure.edges) reach = std::max({reach, e.section.r_n, e.section.r_b});
  low.array() -= reach + 0.37 * step;
  std::vector<int> uses(structure.nodes.size(), 0);
  for (const StructureRod& rod : structure.rods) {
    for (const int node : rod.nodes) ++uses[node];
  }
  const Eigen::Array3i count =
      ((high - low).array() + reach).unaryExpr([&](double x) { return std::ceil(x / step) + 1; }).cast<int>();
  std::vector<bool> inside(static_cast<std::size_t>(count.x()) * count.y() * count.z(), false);
  for (const StructureRod& rod : structure.rods) {
    const StructureEdge& edge = structure.edges[rod.edges.front()];
    const Vec3 &from = structure.nodes[rod.nodes.front()], &to = structure.nodes[rod.nodes.back()];
    const double length = (to - from).norm(), r_b = edge.section.r_b, r_n = edge.section.r_n;
    const bool round0 = uses[rod.nodes.front()] > 1, round1 = uses[rod.nodes.back()] > 1;
    const Eigen::Array3i first = ((from.cwiseMin(to) - low).array() - reach)
                                     .unaryExpr([&](double x) { return std::max(0.0, std::floor(x / step)); })
                                     .cast<int>();
    const Eigen::Array3i last = ((from.cwiseMax(to) - low).array() + reach)
                                    .unaryExpr([&](double x) { return std::ceil(x / step); })
                                    .cast<int>();
    for (int x = first.x(); x <= std::min(last.x(), count.x() - 1); ++x) {
      for (int y = first.y(); y <= std::min(last.y(), count.y() - 1); ++y) {
        for (int z = first.z(); z <= std::min(last.z(), count.z() - 1); ++z) {
          const Vec3 offset = low + step * Vec3(x, y, z) - from;
          const double s = offset.dot(edge.drawn.t), u = offset.dot(edge.drawn.b) / r_b,
                       v = offset.dot(edge.drawn.n) / r_n;
          const double beyond = s < 0 ? -s : s > length ? s - length : 0;
          if (beyond > 0 && !(s < 0 ? round0 : round1)) continue;
          if (u * u + v * v + beyond * beyond / (r_b * r_b) > 1) continue;
          inside[(static_cast<std::size_t>(x) * count.y() + y) * count.z() + z] = true;
        }
      }
    }
  }
  return static_cast<double>(std::count(inside.begin(), inside.end(), true)) * step * step * step;
}

}  // namespace lissom::testing
