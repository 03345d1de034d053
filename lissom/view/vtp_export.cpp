#include <fmt/format.h>

#include "lissom/view/tube.h"
#include "lissom/view/vtk_export.h"
#include "lissom/view/vtk_names.h"
#include "lissom/view/vtk_writer.h"

namespace lissom {

Result<std::string> vtp_bytes(const Drawing& drawing, std::optional<double> time) {
  if (Status status = check_drawing(drawing); !status) return status.error();
  std::vector<Vec3> points, b, n;
  std::vector<int64_t> connectivity, offsets, point_rod, line_rod;
  for (size_t r = 0; r < drawing.rods.size(); ++r) {
    const RodStrip& rod = drawing.rods[r];
    const int64_t first = static_cast<int64_t>(points.size());
    const std::vector<Ring> rings = tube_rings(rod, std::vector<int>(rod.b.size(), 1));
    for (size_t i = 0; i < rod.points.size(); ++i) {
      connectivity.push_back(static_cast<int64_t>(points.size()));
      points.push_back(rod.points[i]);
      b.push_back(rings[i].b);
      n.push_back(rings[i].n);
      point_rod.push_back(static_cast<int64_t>(r));
    }
    if (rod.closed) connectivity.push_back(first);
    offsets.push_back(static_cast<int64_t>(connectivity.size()));
    line_rod.push_back(static_cast<int64_t>(r));
  }

  const size_t rod_points = points.size();
  std::vector<int64_t> corners, corner_offsets;
  for (const MembraneSheet& sheet : drawing.membranes) {
    const int64_t first = static_cast<int64_t>(points.size());
    points.insert(points.end(), sheet.points.begin(), sheet.points.end());
    for (const std::array<int, 3>& triangle : sheet.triangles) {
      for (int i : triangle) corners.push_back(first + i);
      corner_offsets.push_back(static_cast<int64_t>(corners.size()));
    }
  }
  const size_t triangles = corner_offsets.size(), cells = offsets.size() + triangles;
  b.resize(points.size(), Vec3::Zero());
  n.resize(points.size(), Vec3::Zero());

  VtkWriter vtk("PolyData", time);
  vtk.open("Piece", fmt::format("NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"{}\" NumberOfStrips=\"0\" "
                                "NumberOfPolys=\"{}\"",
                                points.size(), offsets.size(), triangles));
  vtk.open("PointData");
  vtk.array("rod", padded(point_rod, points.size()));
  if (triangles > 0) vtk.array("membrane", membrane_numbers(drawing, rod_points, &MembraneSheet::points));
  vtk.array("radius (m)", padded(edge_values_at_points(drawing, equal_area_radius(drawing)), points.size()));
  vtk.array("r_n (m)", padded(edge_values_at_points(drawing, half_extent_n(drawing)), points.size()));
  vtk.array("r_b (m)", padded(edge_values_at_points(drawing, half_extent_b(drawing)), points.size()));
  vtk.array("b", b);
  vtk.array("n", n);
  for (const Field& field : drawing.fields) vtk.array(array_name(field), values_at_points(drawing, field));
  vtk.close("PointData");
  vtk.open("CellData");
  vtk.array("rod", padded(line_rod, cells));
  if (triangles > 0) vtk.array("membrane", membrane_numbers(drawing, line_rod.size(), &MembraneSheet::triangles));
  vtk.close("CellData");
  vtk.open("Points");
  vtk.array("Points", points);
  vtk.close("Points");
  vtk.open("Lines");
  vtk.array("connectivity", connectivity);
  vtk.array("offsets", offsets);
  vtk.close("Lines");
  if (triangles > 0) {
    vtk.open("Polys");
    vtk.array("connectivity", corners);
    vtk.array("offsets", corner_offsets);
    vtk.close("Polys");
  }
  vtk.close("Piece");
  return vtk.finish();
}

}  // namespace lissom
