// Stretches, tensions and areas of membranes.

#include <algorithm>
#include <cmath>
#include <limits>

#include "lissom/session/cloth.h"
#include "lissom/session/quantity_families.h"

namespace lissom {

namespace {

/// Mean over the triangles; `value` gets a triangle's sides, `weight` says how much they count.
template <class Value, class Weight>
Result<double> mean(const Measurement& m, const Value& value, const Weight& weight) {
  const Result<Cloth> cloth = cloth_at(m);
  if (!cloth) return cloth.error();
  double sum = 0, total = 0;
  for (const int t : cloth.value().triangles) {
    const Sides sides = sides_of(*cloth.value().in, t);
    sum += weight(sides) * value(sides);
    total += weight(sides);
  }
  return sum / total;
}

double by_rest_area(const Sides& sides) { return sides.stretch.rest_area; }
double by_area(const Sides& sides) { return sides.stretch.area; }

Result<const StructureMembrane*> membrane_of(const Measurement& m, const System& system) {
  for (const StructureMembrane& membrane : system.structure.membranes) {
    if (membrane.name == m.expectation.membrane) return &membrane;
  }
  return Error{ErrorCode::kUnknown, m.where + "/membrane", "there is no membrane \"" + m.expectation.membrane + "\"",
               "name one of the membranes"};
}

}  // namespace

Result<double> membrane_line_stretch(const Measurement& m) {
  return mean(
      m,
      [&](const Sides& sides) {
        const Vec2 parts = sides.parts(*m.expectation.axis);
        return (sides.now * parts).norm() / (sides.stretch.rest_sides * parts).norm();
      },
      by_rest_area);
}

Result<double> membrane_angle(const Measurement& m) {
  return mean(
      m,
      [&](const Sides& sides) {
        const Vec3 along = sides.now * sides.parts(*m.expectation.axis);
        const Vec3 across = sides.now * sides.parts_across(*m.expectation.axis);
        return std::atan2(along.cross(across).norm(), along.dot(across));
      },
      by_rest_area);
}

Result<double> membrane_largest_stretch(const Measurement& m) {
  const Result<Cloth> cloth = cloth_at(m);
  if (!cloth) return cloth.error();
  double largest = 0;
  for (const int t : cloth.value().triangles) {
    largest = std::max(largest, sides_of(*cloth.value().in, t).stretch.largest);
  }
  return largest;
}

Result<double> membrane_smallest_stretch(const Measurement& m) {
  const Result<Cloth> cloth = cloth_at(m);
  if (!cloth) return cloth.error();
  double smallest = std::numeric_limits<double>::infinity();
  for (const int t : cloth.value().triangles) {
    smallest = std::min(smallest, sides_of(*cloth.value().in, t).stretch.smallest);
  }
  return smallest;
}

Result<double> membrane_tension(const Measurement& m) {
  return mean(
      m,
      [&](const Sides& sides) {
        const Mat3 now = cauchy_tension(*sides.moduli, sides.stretch);
        if (!m.expectation.axis) return 0.5 * now.trace();
        const Vec3 along = (sides.now * sides.parts(*m.expectation.axis)).normalized();
        return along.dot(now * along);
      },
      by_area);
}

Result<double> membrane_area(const Measurement& m) {
  const Result<Cloth> cloth = cloth_at(m);
  if (!cloth) return cloth.error();
  double sum = 0;
  for (const int t : cloth.value().triangles) sum += sides_of(*cloth.value().in, t).stretch.area;
  return sum;
}

Result<double> membrane_rest_area(const Measurement& m) {
  const Result<Cloth> cloth = cloth_at(m);
  if (!cloth) return cloth.error();
  double sum = 0;
  for (const int t : cloth.value().triangles) sum += sides_of(*cloth.value().in, t).stretch.rest_area;
  return sum;
}

Result<double> membrane_pre_stretch(const Measurement& m) {
  const Result<const Situation*> found = m.study.situation(m.pose(), m.refine);
  if (!found) return found.error();
  const Result<const StructureMembrane*> membrane = membrane_of(m, *found.value()->system);
  if (!membrane) return membrane.error();
  return present_pre_stretch(*found.value(), *membrane.value())[0];
}

Result<double> membrane_bending_stiffness(const Measurement& m) {
  const Result<const System*> system = m.study.system(m.refine);
  if (!system) return system.error();
  const Result<const StructureMembrane*> membrane = membrane_of(m, *system.value());
  if (!membrane) return membrane.error();
  return membrane.value()->bending * m.study.model().membrane_material(membrane.value()->material)->bend();
}

Result<double> membrane_height(const Measurement& m) {
  const Result<const Situation*> found = m.study.situation(m.pose(), m.refine);
  if (!found) return found.error();
  if (m.at.kind != Selector::Kind::kPoint) {
    return Error{ErrorCode::kConflict, m.where + "/at", "\"surface_height\" is measured through a point in space",
                 "write \"at\": {\"point\": [x, y, z]}"};
  }
  const Situation& s = *found.value();
  const Vec3 axis = m.expectation.axis->normalized();
  double height = 0, best = std::numeric_limits<double>::infinity();
  for (const StructureTriangle& triangle : s.system->structure.triangles) {
    const Vec3 a = s.state.position(triangle.node[0]), b = s.state.position(triangle.node[1]),
               c = s.state.position(triangle.node[2]);
    // point + h axis = a + u (b - a) + v (c - a)
    Mat3 system;
    system << b - a, c - a, -axis;
    if (std::abs(system.determinant()) <= 1e-12 * (b - a).norm() * (c - a).norm()) continue;
    const Vec3 x = system.partialPivLu().solve(m.at.point - a);
    const double outside = std::max({-x[0], -x[1], x[0] + x[1] - 1, 0.0});
    if (outside > 1e-9 || outside >= best) continue;
    best = outside;
    height = (m.at.point + x[2] * axis).dot(axis);
  }
  if (std::isfinite(best)) return height;
  return Error{ErrorCode::kGeometry, m.where + "/at", "no membrane is met along the axis through this point",
               "move the point over or under a membrane"};
}

}  // namespace lissom
