#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "lissom/geometry/frame.h"
#include "lissom/view/picture_parts.h"

namespace lissom {
namespace {

/// Apex at the point, standing on the ground side.
void add_pyramid(Scene& scene, const Vec3& apex, double height, const Color& color) {
  const double half = 0.55 * height;
  std::array<Vec3, 4> base;
  for (int k = 0; k < 4; ++k) {
    base[k] = apex + Vec3(k == 0 || k == 3 ? half : -half, k < 2 ? half : -half, -height);
  }
  for (int k = 0; k < 4; ++k) scene.add_face(std::array{apex, base[k], base[(k + 1) % 4]}, color);
  scene.add_face(std::array{base[3], base[2], base[1], base[0]}, color);
}

void add_block(Scene& scene, const Vec3& centre, double half, const Color& color) {
  for (int axis = 0; axis < 3; ++axis) {
    for (double side : {-1.0, 1.0}) {
      const Vec3 out = Vec3::Unit(axis) * side * half;
      const Vec3 u = Vec3::Unit((axis + 1) % 3) * half, v = Vec3::Unit((axis + 2) % 3) * half * side;
      scene.add_face(
          std::array<Vec3, 4>{centre + out - u - v, centre + out + u - v, centre + out + u + v, centre + out - u + v},
          color);
    }
  }
}

void add_cone(Scene& scene, const Vec3& base, const Vec3& tip, double base_radius, double tip_radius,
              const Color& color) {
  const Frame frame = frame_from_normal(tip - base, Vec3(0.3, 0.2, 0.9));
  constexpr int kSides = 12;
  std::array<Vec3, kSides> lower, upper;
  for (int k = 0; k < kSides; ++k) {
    const double angle = 2 * std::numbers::pi * k / kSides;
    const Vec3 out = frame.b * std::cos(angle) + frame.n * std::sin(angle);
    lower[k] = base + out * base_radius;
    upper[k] = tip + out * tip_radius;
  }
  for (int k = 0; k < kSides; ++k) {
    const int next = (k + 1) % kSides;
    scene.add_face(std::array{lower[k], lower[next], upper[next], upper[k]}, color);
  }
  std::reverse(lower.begin(), lower.end());
  scene.add_face(lower, color);
}

}  // namespace

Arrow force_arrow(const Marker& marker, const MarkerScale& scale) {
  const double size = marker.vector.norm();
  if (size == 0 || scale.largest_force == 0) return {marker.at, marker.at};
  const double length = scale.arrow * (0.3 + 0.7 * size / scale.largest_force);
  const Vec3 d = marker.vector / size;
  const Vec3 gap = d * (0.02 * scale.arrow);
  // Arrows stay outside the structure: a push ends at the point, a pull starts there.
  const bool pull = d.dot(marker.at - scale.middle) > 1e-9 * scale.arrow;
  if (pull) return {marker.at + gap, marker.at + gap + d * length};
  return {marker.at - gap - d * length, marker.at - gap};
}

void add_marker(Scene& scene, const Marker& marker, const MarkerScale& scale, const ThemeColors& colors) {
  switch (marker.kind) {
    case Marker::Kind::kPin:
      add_pyramid(scene, marker.at, scale.support, colors.support);
      return;
    case Marker::Kind::kClamp:
      add_block(scene, marker.at, 0.42 * scale.support, colors.support);
      return;
    case Marker::Kind::kForce: {
      const Arrow arrow = force_arrow(marker, scale);
      const Vec3 d = arrow.tip - arrow.tail;
      const double length = d.norm();
      if (length == 0) return;
      const double head = std::min(0.4 * length, 0.24 * scale.arrow);
      const Vec3 neck = arrow.tip - d * (head / length);
      constexpr int kShaftPieces = 6;
      for (int k = 0; k < kShaftPieces; ++k) {
        const Vec3 from = arrow.tail + (neck - arrow.tail) * (static_cast<double>(k) / kShaftPieces);
        const Vec3 to = arrow.tail + (neck - arrow.tail) * (static_cast<double>(k + 1) / kShaftPieces);
        add_cone(scene, from, to, 0.028 * scale.arrow, 0.028 * scale.arrow, colors.force);
      }
      add_cone(scene, neck, arrow.tip, 0.33 * head, 0, colors.force);
      return;
    }
  }
}

}  // namespace lissom
