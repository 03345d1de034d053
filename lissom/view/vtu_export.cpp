#include <fmt/format.h>

#include "lissom/view/vtk_export.h"
#include "lissom/view/vtk_names.h"
#include "lissom/view/vtk_writer.h"

namespace lissom {

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
  constexpr uint8_t kLineCell = 3;  // VTK_LINE
  const std::vector<uint8_t> types(offsets.size(), kLineCell);

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
  vtk.array("rod", point_rod);
  vtk.array("radius (m)", edge_values_at_points(drawing, equal_area_radius(drawing)));
  for (const Field& field : drawing.fields) {
    if (field.place == Field::Place::kNode) vtk.array(array_name(field), field.values);
  }
  vtk.close("PointData");
  vtk.open("CellData");
  vtk.array("rod", edge_rod);
  vtk.array("r_n (m)", half_extent_n(drawing));
  vtk.array("r_b (m)", half_extent_b(drawing));
  vtk.array("t", t);
  vtk.array("b", b);
  vtk.array("n", n);
  for (const Field& field : drawing.fields) {
    if (field.place == Field::Place::kEdge) vtk.array(array_name(field), field.values);
  }
  vtk.close("CellData");
  vtk.close("Piece");
  return vtk.finish();
}

}  // namespace lissom
