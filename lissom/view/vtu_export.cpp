#include <algorithm>
#include <fmt/format.h>

#include "lissom/view/vtk_export.h"
#include "lissom/view/vtk_names.h"
#include "lissom/view/vtk_writer.h"

namespace lissom {

namespace {

std::vector<double> after_nan(size_t count, const std::vector<double>& values) {
  std::vector<double> all = padded(std::vector<double>(), count);
  all.insert(all.end(), values.begin(), values.end());
  return all;
}

/// Whether every membrane knows its tensions.
bool has_tension(const Drawing& drawing) {
  return !drawing.membranes.empty() && std::none_of(drawing.membranes.begin(), drawing.membranes.end(),
                                                    [](const MembraneSheet& sheet) { return sheet.tension.empty(); });
}

std::vector<Vec3> tension_vectors(const Drawing& drawing, size_t before) {
  std::vector<Vec3> vectors(before, Vec3::Zero());
  for (const MembraneSheet& sheet : drawing.membranes) {
    vectors.insert(vectors.end(), sheet.tension.begin(), sheet.tension.end());
  }
  return vectors;
}

}  // namespace

Result<std::string> vtu_bytes(const Drawing& drawing, std::optional<double> time) {
  if (Status status = check_drawing(drawing); !status) return status.error();
  std::vector<Vec3> points, t, b, n;
  std::vector<int64_t> connectivity, offsets, point_rod, edge_rod;
  for (size_t r = 0; r < drawing.rods.size(); ++r) {
    const RodStrip& rod = drawing.rods[r];
    const int64_t first = static_cast<int64_t>(points.size());
    points.insert(points.end(), rod.points.begin(), rod.points.end());
    point_rod.insert(point_rod.end(), rod.points.size(), static_cast<int64_t>(r));
    edge_rod.insert(edge_rod.end(), rod.b.size(), static_cast<int64_t>(r));
    for (int e = 0; e < rod.edge_count(); ++e) {
      connectivity.push_back(first + e);
      connectivity.push_back(first + rod.end_point(e));
      offsets.push_back(static_cast<int64_t>(connectivity.size()));
      t.push_back(rod.b[e].cross(rod.n[e]));
      b.push_back(rod.b[e]);
      n.push_back(rod.n[e]);
    }
  }
  constexpr uint8_t kLineCell = 3, kTriangleCell = 5;  // VTK_LINE, VTK_TRIANGLE
  std::vector<uint8_t> types(offsets.size(), kLineCell);
  const size_t rod_points = points.size(), lines = offsets.size();
  for (const MembraneSheet& sheet : drawing.membranes) {
    const int64_t first = static_cast<int64_t>(points.size());
    points.insert(points.end(), sheet.points.begin(), sheet.points.end());
    for (const std::array<int, 3>& triangle : sheet.triangles) {
      for (int i : triangle) connectivity.push_back(first + i);
      offsets.push_back(static_cast<int64_t>(connectivity.size()));
      types.push_back(kTriangleCell);
    }
  }
  const size_t cells = offsets.size();
  t.resize(cells, Vec3::Zero());
  b.resize(cells, Vec3::Zero());
  n.resize(cells, Vec3::Zero());

  VtkWriter vtk("UnstructuredGrid", time);
  vtk.open("Piece", fmt::format("NumberOfPoints=\"{}\" NumberOfCells=\"{}\"", points.size(), offsets.size()));
  vtk.open("Points");
  vtk.array("Points", points);
  vtk.close("Points");
  vtk.open("Cells");
  vtk.array("connectivity", connectivity);
  vtk.array("offsets", offsets);
  vtk.array("types", types);
  vtk.close("Cells");
  vtk.open("PointData");
  vtk.array("rod", padded(point_rod, points.size()));
  vtk.array("radius (m)", padded(edge_values_at_points(drawing, equal_area_radius(drawing)), points.size()));
  if (cells > lines) vtk.array("membrane", membrane_numbers(drawing, rod_points, &MembraneSheet::points));
  for (const Field& field : drawing.fields) {
    if (field.place == Field::Place::kNode) vtk.array(array_name(field), field.values);
  }
  vtk.close("PointData");
  vtk.open("CellData");
  vtk.array("rod", padded(edge_rod, cells));
  if (cells > lines) vtk.array("membrane", membrane_numbers(drawing, lines, &MembraneSheet::triangles));
  vtk.array("r_n (m)", padded(half_extent_n(drawing), cells));
  vtk.array("r_b (m)", padded(half_extent_b(drawing), cells));
  vtk.array("t", t);
  vtk.array("b", b);
  vtk.array("n", n);
  for (const Field& field : drawing.fields) {
    if (field.place == Field::Place::kEdge) vtk.array(array_name(field), padded(field.values, cells));
    if (field.place == Field::Place::kTriangle) vtk.array(array_name(field), after_nan(lines, field.values));
  }
  if (has_tension(drawing)) vtk.array("largest tension vector (N/m)", tension_vectors(drawing, lines));
  vtk.close("CellData");
  vtk.close("Piece");
  return vtk.finish();
}

}  // namespace lissom
