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

  VtkWriter vtk("PolyData", time);
  vtk.open("Piece", fmt::format("NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"{}\" NumberOfStrips=\"0\" "
                                "NumberOfPolys=\"0\"",
                                points.size(), offsets.size()));
  vtk.open("PointData");
  vtk.array("rod", point_rod);
  vtk.array("radius (m)", edge_values_at_points(drawing, equal_area_radius(drawing)));
  vtk.array("r_n (m)", edge_values_at_points(drawing, half_extent_n(drawing)));
  vtk.array("r_b (m)", edge_values_at_points(drawing, half_extent_b(drawing)));
  vtk.array("b", b);
  vtk.array("n", n);
  for (const Field& field : drawing.fields) {
    const bool on_edges = field.place == Field::Place::kEdge;
    vtk.array(array_name(field), on_edges ? edge_values_at_points(drawing, field.values) : field.values);
  }
  vtk.close("PointData");
  vtk.open("CellData");
  vtk.array("rod", line_rod);
  vtk.close("CellData");
  vtk.open("Points");
  vtk.array("Points", points);
  vtk.close("Points");
  vtk.open("Lines");
  vtk.array("connectivity", connectivity);
  vtk.array("offsets", offsets);
  vtk.close("Lines");
  vtk.close("Piece");
  return vtk.finish();
}

}  // namespace lissom
