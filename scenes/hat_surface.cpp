#include <array>
#include <cmath>
#include <vector>

#include "lissom/geometry/curve_sampling.h"
#include "lissom/geometry/planar_patterns.h"
#include "scenes/object_surfaces.h"

namespace lissom::scene_models {

namespace {

constexpr int kRings = 30, kSectors = 90;
constexpr double kNarrow = 0.87;     // width over length
constexpr double kBrimLift = 0.010;  // m, of the brim at both sides
constexpr double kCrown = 0.074;     // m, radius at which the brim begins to turn up

/// Distance from the axis and height, from the top of the crown to the edge of the brim, m.
const std::vector<Vec3>& profile() {
  static const std::vector<Vec3> points{{0.000, 0, 0.098}, {0.026, 0, 0.097}, {0.048, 0, 0.091}, {0.061, 0, 0.077},
                                        {0.067, 0, 0.056}, {0.070, 0, 0.034}, {0.073, 0, 0.015}, {0.080, 0, 0.005},
                                        {0.093, 0, 0.001}, {0.105, 0, 0.002}, {0.115, 0, 0.004}};
  return points;
}

/// Points of the profile at even distances along it.
std::vector<Vec3> even_profile() {
  constexpr int kFine = 4000;
  const std::vector<Vec3> fine = sample_spline(profile(), false, kFine, "profile").value().points;
  std::vector<double> along{0};
  for (std::size_t i = 1; i < fine.size(); ++i) along.push_back(along.back() + (fine[i] - fine[i - 1]).norm());
  std::vector<Vec3> even;
  std::size_t i = 0;
  for (int ring = 0; ring <= kRings; ++ring) {
    const double wanted = along.back() * ring / kRings;
    while (i + 2 < along.size() && along[i + 1] < wanted) ++i;
    const double share = (wanted - along[i]) / (along[i + 1] - along[i]);
    even.push_back(fine[i] + share * (fine[i + 1] - fine[i]));
  }
  return even;
}

}  // namespace

Surface hat_surface() {
  const PlanarTriangles disc = disc_triangles(Vec2::Zero(), 0, kRings, kRings, kSectors);
  const std::vector<Vec3> ring = even_profile();
  Surface hat;
  for (const Vec2& p : disc.points) {
    const Vec3& at = ring[static_cast<std::size_t>(std::lround(p.norm()))];
    const double angle = std::atan2(p[1], p[0]), radius = at[0];
    const double brim = std::max(0.0, radius - kCrown) / (profile().back()[0] - kCrown);
    const double lift = kBrimLift * brim * brim * std::pow(std::sin(angle), 2);
    hat.vertices.emplace_back(radius * std::cos(angle), kNarrow * radius * std::sin(angle), at[2] + lift);
  }
  hat.triangles = disc.triangles;
  return hat;
}

}  // namespace lissom::scene_models
