#pragma once
/// Drawings for the tests of lissom/view.

#include <cmath>
#include <string>
#include <vector>

#include "lissom/geometry/frame.h"
#include "lissom/view/rod_drawing.h"

namespace lissom::samples {

/// Strip through points with n as close as possible to +z and constant half-extents (m).
inline RodStrip strip(std::string name, std::vector<Vec3> points, double r_n, double r_b,
                      SectionShape shape = SectionShape::kEllipse, bool closed = false) {
  RodStrip rod;
  rod.name = std::move(name);
  rod.points = std::move(points);
  rod.closed = closed;
  rod.shape = shape;
  const size_t count = rod.points.size();
  for (size_t e = 0; e + (closed ? 0 : 1) < count; ++e) {
    const Frame frame = frame_from_normal(rod.points[(e + 1) % count] - rod.points[e], Vec3::UnitZ());
    rod.b.push_back(frame.b);
    rod.n.push_back(frame.n);
    rod.r_n.push_back(r_n);
    rod.r_b.push_back(r_b);
  }
  return rod;
}

/// Straight along x, from 0 to `length` (m).
inline RodStrip straight(double length, int edges, double r_n, double r_b,
                         SectionShape shape = SectionShape::kEllipse) {
  std::vector<Vec3> points;
  for (int i = 0; i <= edges; ++i) points.push_back({length * i / edges, 0, 0});
  return strip("beam", points, r_n, r_b, shape);
}

/// Circle in the xy plane.
inline RodStrip circle(double radius, int edges, double r, SectionShape shape = SectionShape::kEllipse) {
  std::vector<Vec3> points;
  for (int i = 0; i < edges; ++i) {
    const double angle = 2 * 3.14159265358979323846 * i / edges;
    points.push_back({radius * std::cos(angle), radius * std::sin(angle), 0});
  }
  return strip("ring", points, r, r, shape, true);
}

inline Field edge_field(std::string name, std::vector<double> values) {
  return {.name = std::move(name),
          .unit = "N",
          .display_unit = "N",
          .display_scale = 1,
          .place = Field::Place::kEdge,
          .colors = Field::Colors::kDiverging,
          .values = std::move(values)};
}

/// A beam with awkward numbers and a ring, one field per edge (with a missing value) and one per node.
inline Drawing beam_and_ring() {
  Drawing drawing;
  drawing.rods = {straight(0.1, 3, 0.001, 0.002), circle(0.03, 5, 0.0015)};
  drawing.fields = {edge_field("axial force", {1.0 / 3, -2e-300, std::nan(""), 4.25, -0.0, 1e10, 7, -8.125}),
                    {.name = "bending <moment>",
                     .unit = "N m",
                     .display_unit = "N mm",
                     .display_scale = 1000,
                     .place = Field::Place::kNode,
                     .colors = Field::Colors::kSequential,
                     .values = {0.1, 0.2, 0.3, 0.4, 1.1, 1.2, 1.3, 1.4, 1.5}}};
  return drawing;
}

/// Square sheet of side 0.1 m in cells x cells squares of two triangles, bent into a saddle z = bend (x^2 - y^2), on a
/// rod along its edge that shares its points. bend in 1/m.
inline Drawing saddle(int cells, double bend, double r = 0.001) {
  MembraneSheet sheet;
  sheet.name = "sail";
  const auto at = [&](int i, int j) {
    const double x = 0.1 * i / cells - 0.05, y = 0.1 * j / cells - 0.05;
    return Vec3(x, y, bend * (x * x - y * y));
  };
  const auto index = [&](int i, int j) { return j * (cells + 1) + i; };
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) sheet.points.push_back(at(i, j));
  }
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      sheet.triangles.push_back({index(i, j), index(i + 1, j), index(i + 1, j + 1)});
      sheet.triangles.push_back({index(i, j), index(i + 1, j + 1), index(i, j + 1)});
    }
  }
  std::vector<Vec3> edge;
  for (int k = 0; k < cells; ++k) edge.push_back(at(k, 0));
  for (int k = 0; k < cells; ++k) edge.push_back(at(cells, k));
  for (int k = cells; k > 0; --k) edge.push_back(at(k, cells));
  for (int k = cells; k > 0; --k) edge.push_back(at(0, k));
  Drawing drawing;
  drawing.rods = {strip("frame", edge, r, r, SectionShape::kEllipse, true)};
  drawing.membranes = {sheet};
  return drawing;
}

/// One value per triangle.
inline Field triangle_field(std::string name, std::vector<double> values) {
  return {.name = std::move(name),
          .unit = "N/m",
          .display_unit = "N/m",
          .display_scale = 1,
          .place = Field::Place::kTriangle,
          .colors = Field::Colors::kSequential,
          .values = std::move(values)};
}

}  // namespace lissom::samples
