#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "lissom/geometry/implicit_surface.h"
#include "scenes/object_surfaces.h"

namespace lissom::scene_models {

namespace {

constexpr double kBlend = 0.012;  // m, over which parts grow into each other
constexpr double kEdge = 0.0035;  // m, of the triangles

/// The hull of two balls, roughly: a ball that slides from one to the other and changes its radius on the way.
struct Limb {
  Vec3 from, to;       // m
  double thick, thin;  // m, radii at both ends

  double distance(const Vec3& x) const {
    const double share = std::clamp((x - from).dot(to - from) / (to - from).squaredNorm(), 0.0, 1.0);
    return (x - from - share * (to - from)).norm() - (thick + share * (thin - thick));
  }
};

const std::array<Limb, 11>& limbs() {
  static const std::array<Limb, 11> all{{
      {{-0.028, 0, 0.066}, {0.028, 0, 0.068}, 0.030, 0.029},   // body
      {{-0.028, 0, 0.066}, {-0.068, 0, 0.060}, 0.027, 0.018},  // root of the tail
      {{-0.068, 0, 0.060}, {-0.106, 0, 0.060}, 0.018, 0.011},  // tail
      {{0.028, 0, 0.070}, {0.060, 0, 0.108}, 0.024, 0.016},    // neck
      {{0.060, 0, 0.108}, {0.068, 0, 0.124}, 0.016, 0.015},    // throat
      {{0.066, 0, 0.127}, {0.082, 0, 0.123}, 0.017, 0.012},    // head
      {{-0.030, 0.020, 0.056}, {-0.032, 0.023, 0.012}, 0.016, 0.012},
      {{-0.030, -0.020, 0.056}, {-0.032, -0.023, 0.012}, 0.016, 0.012},
      {{0.030, 0.020, 0.056}, {0.032, 0.023, 0.012}, 0.016, 0.012},
      {{0.030, -0.020, 0.056}, {0.032, -0.023, 0.012}, 0.016, 0.012},
      {{-0.012, 0, 0.084}, {0.012, 0, 0.085}, 0.015, 0.015},  // hump
  }};
  return all;
}

/// min(a, b), rounded where both are about the same [Quilez 2013].
double blended(double a, double b) {
  const double near = std::max(0.0, kBlend - std::abs(a - b)) / kBlend;
  return std::min(a, b) - 0.25 * kBlend * near * near;
}

double dinosaur(const Vec3& x) {
  double distance = std::numeric_limits<double>::infinity();
  for (const Limb& limb : limbs()) {
    distance = std::isinf(distance) ? limb.distance(x) : blended(distance, limb.distance(x));
  }
  return distance;
}

}  // namespace

Result<Surface> dinosaur_surface() { return implicit_surface(dinosaur, {Vec3(0, 0, 0.06), 0.16, kEdge, 0.1 * kEdge}); }

}  // namespace lissom::scene_models
