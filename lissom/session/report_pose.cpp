#include "lissom/session/report_pose.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "lissom/geometry/frame.h"
#include "lissom/session/fields.h"

namespace lissom {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kDegree = std::numbers::pi / 180;

Drawing shape_of(const System& system, const State& state) {
  std::vector<Vec3> positions;
  for (int i = 0; i < system.layout.nodes(); ++i) positions.push_back(state.position(i));
  std::vector<Frame> frames;
  for (const EdgeState& edge : state.edges) frames.push_back(edge.material());
  return make_drawing(system.structure, positions, frames);
}

/// Adds the edge from `a` to `b` to the open strip, which has the section of the edge.
void extend(RodStrip& strip, const Vec3& a, const Vec3& b, const Vec3& normal, const Section& section) {
  const Frame frame = frame_from_normal(b - a, normal);
  if (strip.points.empty()) strip.points.push_back(a);
  strip.points.push_back(b);
  strip.b.push_back(frame.b);
  strip.n.push_back(frame.n);
  strip.r_n.push_back(section.r_n);
  strip.r_b.push_back(section.r_b);
}

/// Pieces of rods whose nodes have targets, with the sections and about the normals of the rods as they came out.
void draw_targets(const System& system, const State& state, std::span<const Vec3> wanted, DesignReport::Pose& pose) {
  const Structure& structure = system.structure;
  std::vector<char> drawn(wanted.size(), 0);
  for (const StructureRod& rod : structure.rods) {
    RodStrip strip;
    const auto flush = [&] {
      if (!strip.b.empty()) pose.target.rods.push_back(std::move(strip));
      strip = {};
    };
    for (size_t e = 0; e < rod.edges.size(); ++e) {
      const int a = rod.nodes[e], b = rod.nodes[(e + 1) % rod.nodes.size()];
      const bool known = wanted[a].allFinite() && wanted[b].allFinite() && (wanted[b] - wanted[a]).norm() > 0;
      if (!known) {
        flush();
        continue;
      }
      strip.name = rod.name;
      strip.shape = structure.edges[rod.edges[e]].section.shape;
      extend(strip, wanted[a], wanted[b], state.edges[rod.edges[e]].material().n,
             structure.edges[rod.edges[e]].section);
      drawn[a] = drawn[b] = 1;
    }
    flush();
  }
  for (size_t i = 0; i < wanted.size(); ++i) {
    if (wanted[i].allFinite() && drawn[i] == 0) pose.dots.push_back(wanted[i]);
  }
}

/// Shorter over longer half-axis of a shape as it is seen: small where it is seen edge-on.
double roundness(const DesignReport::Pose& pose, Vec3 DesignReport::Target::*shape, const Camera& camera) {
  Vec2 mean = Vec2::Zero();
  for (const DesignReport::Target& t : pose.targets) mean += camera.project(t.*shape);
  mean /= static_cast<double>(pose.targets.size());
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const DesignReport::Target& t : pose.targets) {
    const Vec2 d = camera.project(t.*shape) - mean;
    spread += d * d.transpose();
  }
  const double half = spread.trace() / 2;
  const double root = std::sqrt(std::max(0.0, half * half - spread.determinant()));
  return half + root > 0 ? std::sqrt(std::max(0.0, half - root) / (half + root)) : 0;
}

}  // namespace

DesignReport::Pose report_pose(const std::string& name, const System& start, const State& before, const System& found,
                               const State& after, std::span<const Vec3> wanted) {
  LISSOM_ASSERT(wanted.size() == found.structure.nodes.size() && wanted.size() == start.structure.nodes.size());
  DesignReport::Pose pose;
  pose.name = name;
  pose.before = shape_of(start, before);
  pose.after = shape_of(found, after);
  std::vector<double> deviation(wanted.size(), kNone);
  for (size_t i = 0; i < wanted.size(); ++i) {
    if (!wanted[i].allFinite()) continue;
    const int node = static_cast<int>(i);
    pose.targets.push_back({wanted[i], before.position(node), after.position(node)});
    deviation[i] = (after.position(node) - wanted[i]).norm();
  }
  if (pose.targets.empty()) return pose;
  draw_targets(found, after, wanted, pose);
  pose.after.fields.push_back({.name = kDeviation,
                               .unit = "m",
                               .display_unit = "mm",
                               .display_scale = 1000,
                               .place = Field::Place::kNode,
                               .colors = Field::Colors::kSequential,
                               .values = field_values(found.structure, Field::Place::kNode, deviation)});
  return pose;
}

Viewpoint view_of_deviations(const DesignReport::Pose& pose) {
  Viewpoint best = Viewpoint::iso();
  double most = -1;
  double whole = 0;
  for (const DesignReport::Target& t : pose.targets) whole += (t.before - t.wanted).squaredNorm();
  if (whole == 0) return best;
  for (const double elevation : {20.0, 35.0, 55.0}) {
    for (double azimuth = -60; azimuth < 300; azimuth += 30) {
      const Viewpoint view{.azimuth = azimuth * kDegree, .elevation = elevation * kDegree};
      const Camera camera(view, std::vector<Vec3>{Vec3::Zero()}, std::vector<double>{1}, Vec2::Zero(), Vec2(1, 1));
      double seen = 0;
      for (const DesignReport::Target& t : pose.targets) {
        const Vec3 d = t.before - t.wanted;
        seen += d.squaredNorm() - std::pow(d.dot(camera.towards()), 2);
      }
      const double round = std::min(roundness(pose, &DesignReport::Target::wanted, camera),
                                    roundness(pose, &DesignReport::Target::before, camera));
      // Deviations that are seen whole are of no use where a shape is seen edge-on. Nearly equal: the first is kept.
      const double score = std::sqrt(seen / whole) * (0.4 + 0.6 * std::min(1.0, 2 * round));
      if (score > most * 1.01) most = score, best = view;
    }
  }
  return best;
}

}  // namespace lissom
