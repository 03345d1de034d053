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
      {{-0.030, 0, 0.060}, {0.026, 0, 0.062}, 0.027, 0.026},   // body
      {{-0.030, 0, 0.060}, {-0.066, 0, 0.052}, 0.025, 0.015},  // root of the tail
      {{-0.066, 0, 0.052}, {-0.098, 0, 0.050}, 0.015, 0.007},  // tail
      {{0.026, 0, 0.064}, {0.062, 0, 0.098}, 0.022, 0.012},    // neck
      {{0.062, 0, 0.098}, {0.074, 0, 0.116}, 0.012, 0.011},    // throat
      {{0.074, 0, 0.118}, {0.094, 0, 0.114}, 0.014, 0.010},    // head
      {{-0.030, 0.016, 0.050}, {-0.032, 0.020, 0.010}, 0.014, 0.010},
      {{-0.030, -0.016, 0.050}, {-0.032, -0.020, 0.010}, 0.014, 0.010},
      {{0.026, 0.016, 0.050}, {0.028, 0.020, 0.010}, 0.014, 0.010},
      {{0.026, -0.016, 0.050}, {0.028, -0.020, 0.010}, 0.014, 0.010},
      {{-0.012, 0, 0.078}, {0.012, 0, 0.079}, 0.014, 0.014},  // hump
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
