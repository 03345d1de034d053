// Stretches, tensions, energies and areas of membranes.

#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

#include "lissom/mechanics/membrane_bend.h"
#include "lissom/mechanics/membrane_stretch.h"
#include "lissom/session/quantity_families.h"

namespace lissom {

namespace {

using Mat32 = Eigen::Matrix<double, 3, 2>;
using Mat2 = Eigen::Matrix2d;

/// A triangle of the situation: its two sides from the first corner, drawn, at rest and now.
struct Sides {
  Mat32 drawn, now;  ///< m, columns in space
  Mat2 rest;         ///< m, columns along the material axes
  const TriangleRest* moduli = nullptr;

  double rest_area() const { return 0.5 * rest.determinant(); }
  double area() const { return 0.5 * now.col(0).cross(now.col(1)).norm(); }
  Mat32 gradient() const { return now * rest.inverse(); }

  /// How much of each side makes up a direction of the drawing, laid into the drawn triangle.
  Vec2 parts(const Vec3& direction) const { return drawn.colPivHouseholderQr().solve(direction); }
  /// The same for the direction at right angles to it, anticlockwise in the drawn triangle.
  Vec2 parts_across(const Vec3& direction) const {
    const Vec3 normal = drawn.col(0).cross(drawn.col(1)).normalized();
    return parts(normal.cross(direction));
  }
};

/// Factors by which the rest corners are larger than RestState says, because the pre-stretch grows with the load.
Vec2 rest_growth(const Situation& s, const StructureMembrane& membrane) {
  if (!s.problem->stretches_with_load) return Vec2::Ones();
  return membrane.pre_stretch.cwiseQuotient(present_pre_stretch(s, membrane));
}

Sides sides_of(const Situation& s, int t) {
  const StructureTriangle& triangle = s.system->structure.triangles[t];
  const TriangleRest& rest = s.system->rest.triangles[t];
  const Vec2 growth = rest_growth(s, s.system->structure.membranes[triangle.membrane]);
  Sides sides;
  sides.moduli = &rest;
  for (int i = 0; i < 2; ++i) {
    const int from = triangle.node[0], to = triangle.node[i + 1];
    sides.drawn.col(i) = s.system->structure.nodes[to] - s.system->structure.nodes[from];
    sides.now.col(i) = s.state.position(to) - s.state.position(from);
    sides.rest.col(i) = (rest.corner[i + 1] - rest.corner[0]).cwiseProduct(growth);
  }
  return sides;
}

/// The situation with the triangles whose corners are all selected.
struct Cloth {
  const Situation* in = nullptr;
  std::vector<int> triangles;
};

Result<Cloth> cloth_at(const Measurement& m) {
  const Result<const Situation*> found = m.study.situation(m.pose(), m.refine);
  if (!found) return found.error();
  const System& system = *found.value()->system;
  const Result<std::vector<int>> nodes = selected_nodes(m, m.at, system);
  if (!nodes) return nodes.error();
  std::vector<bool> selected(system.structure.nodes.size(), false);
  for (const int node : nodes.value()) selected[node] = true;
  Cloth cloth{found.value(), {}};
  for (int t = 0; t < static_cast<int>(system.structure.triangles.size()); ++t) {
    const std::array<int, 3>& node = system.structure.triangles[t].node;
    if (selected[node[0]] && selected[node[1]] && selected[node[2]]) cloth.triangles.push_back(t);
  }
  if (!cloth.triangles.empty()) return cloth;
  return Error{ErrorCode::kGeometry, m.where + "/at", "no triangle of a membrane has all its corners in this selection",
               "select more of a membrane"};
}

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

double by_rest_area(const Sides& sides) { return sides.rest_area(); }
double by_area(const Sides& sides) { return sides.area(); }

/// Principal stretches, the larger first.
Vec2 principal_stretches(const Sides& sides) {
  const Mat2 c = sides.gradient().transpose() * sides.gradient();
  const double middle = 0.5 * c.trace();
  const double half = std::hypot(0.5 * (c(0, 0) - c(1, 1)), c(0, 1));
  // The smaller from the determinant: their difference would lose digits.
  const double larger = middle + half;
  return Vec2(std::sqrt(larger), std::sqrt(std::max(0.0, c.determinant()) / larger));
}

/// Second Piola-Kirchhoff tension, N/m.
Mat2 piola_tension(const Sides& sides) {
  const auto c =
      SheetModuli<double>::of(sides.moduli->stiffness_1, sides.moduli->stiffness_2, sides.moduli->poisson_ratio);
  const Mat2 strain = 0.5 * (sides.gradient().transpose() * sides.gradient() - Mat2::Identity());
  Mat2 s;
  s(0, 0) = c.c11 * strain(0, 0) + c.c12 * strain(1, 1);
  s(1, 1) = c.c22 * strain(1, 1) + c.c12 * strain(0, 0);
  s(0, 1) = s(1, 0) = 2 * c.shear * strain(0, 1);
  return s;
}

/// Cauchy tension in the plane of the triangle, as a matrix in space, N/m.
Mat3 tension(const Sides& sides) {
  const Mat32 f = sides.gradient();
  return f * piola_tension(sides) * f.transpose() * (sides.rest_area() / sides.area());
}

/// Energies of the stencils of a term, J; empty when the pose has no such term.
std::vector<double> term_energies(const Situation& s, std::string_view name) {
  for (const auto& term : s.problem->potential.terms()) {
    if (term->name() != name) continue;
    std::vector<double> energy(static_cast<size_t>(term->groups()) * kLanes);
    term->energies(s.state, 0, term->groups(), energy.data());
    return energy;
  }
  return {};
}

/// Per triangle: stretch, and half of the bending at each of its sides, J.
struct ClothEnergies {
  std::vector<double> stretch, bending;
};

ClothEnergies energies_by_triangle(const Situation& s) {
  const Structure& structure = s.system->structure;
  ClothEnergies energies{term_energies(s, MembraneStretch::kName), std::vector<double>(structure.triangles.size(), 0)};
  energies.stretch.resize(structure.triangles.size(), 0);
  const std::vector<double> hinges = term_energies(s, MembraneBend::kName);
  size_t stencil = 0;  // hinges without stiffness have none
  for (size_t h = 0; h < structure.hinges.size() && stencil < hinges.size(); ++h) {
    if (s.system->rest.hinges[h].stiffness == 0) continue;
    for (const int t : structure.hinges[h].triangle) energies.bending[t] += 0.5 * hinges[stencil];
    ++stencil;
  }
  return energies;
}

Result<const StructureMembrane*> membrane_of(const Measurement& m, const System& system) {
  for (const StructureMembrane& membrane : system.structure.membranes) {
    if (membrane.name == m.expectation.membrane) return &membrane;
  }
  return Error{ErrorCode::kUnknown, m.where + "/membrane", "there is no membrane \"" + m.expectation.membrane + "\"",
               "name one of the membranes"};
}

}  // namespace

Vec2 present_pre_stretch(const Situation& s, const StructureMembrane& membrane) {
  if (!s.problem->stretches_with_load) return membrane.pre_stretch;
  return Vec2::Ones() + s.state.load_factor * (membrane.pre_stretch - Vec2::Ones());
}

Result<double> membrane_line_stretch(const Measurement& m) {
  return mean(
      m,
      [&](const Sides& sides) {
        const Vec2 parts = sides.parts(*m.expectation.axis);
        return (sides.now * parts).norm() / (sides.rest * parts).norm();
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
    largest = std::max(largest, principal_stretches(sides_of(*cloth.value().in, t))[0]);
  }
  return largest;
}

Result<double> membrane_smallest_stretch(const Measurement& m) {
  const Result<Cloth> cloth = cloth_at(m);
  if (!cloth) return cloth.error();
  double smallest = std::numeric_limits<double>::infinity();
  for (const int t : cloth.value().triangles) {
    smallest = std::min(smallest, principal_stretches(sides_of(*cloth.value().in, t))[1]);
  }
  return smallest;
}

Result<double> membrane_tension(const Measurement& m) {
  return mean(
      m,
      [&](const Sides& sides) {
        const Mat3 now = tension(sides);
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
  for (const int t : cloth.value().triangles) sum += sides_of(*cloth.value().in, t).area();
  return sum;
}

Result<double> membrane_rest_area(const Measurement& m) {
  const Result<Cloth> cloth = cloth_at(m);
  if (!cloth) return cloth.error();
  double sum = 0;
  for (const int t : cloth.value().triangles) sum += sides_of(*cloth.value().in, t).rest_area();
  return sum;
}

double cloth_energy(const Situation& s, const std::vector<bool>& selected) {
  const Structure& structure = s.system->structure;
  const auto inside = [&](const auto& nodes) {
    return std::all_of(nodes.begin(), nodes.end(), [&](int node) { return selected[node]; });
  };
  double sum = 0;
  const std::vector<double> stretch = term_energies(s, MembraneStretch::kName);
  for (size_t t = 0; t < structure.triangles.size() && t < stretch.size(); ++t) {
    if (inside(structure.triangles[t].node)) sum += stretch[t];
  }
  const std::vector<double> bend = term_energies(s, MembraneBend::kName);
  size_t stencil = 0;
  for (size_t h = 0; h < structure.hinges.size() && stencil < bend.size(); ++h) {
    if (s.system->rest.hinges[h].stiffness == 0) continue;
    if (inside(structure.hinges[h].node)) sum += bend[stencil];
    ++stencil;
  }
  return sum;
}

Result<double> membrane_energy(const Measurement& m) {
  const Result<const Situation*> found = m.study.situation(m.pose(), m.refine);
  if (!found) return found.error();
  const Result<std::vector<int>> nodes = selected_nodes(m, m.at, *found.value()->system);
  if (!nodes) return nodes.error();
  std::vector<bool> selected(found.value()->system->structure.nodes.size(), false);
  for (const int node : nodes.value()) selected[node] = true;
  return cloth_energy(*found.value(), selected);
}

namespace {

Result<double> energy_density(const Measurement& m, bool stretch, bool bending) {
  const Result<Cloth> cloth = cloth_at(m);
  if (!cloth) return cloth.error();
  const Situation& s = *cloth.value().in;
  const ClothEnergies energies = energies_by_triangle(s);
  double sum = 0, area = 0;
  for (const int t : cloth.value().triangles) {
    if (stretch) sum += energies.stretch[t];
    if (bending) sum += energies.bending[t];
    area += sides_of(s, t).rest_area();
  }
  return sum / area;
}

}  // namespace

Result<double> membrane_energy_density(const Measurement& m) { return energy_density(m, true, true); }
Result<double> membrane_bending_density(const Measurement& m) { return energy_density(m, false, true); }

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
