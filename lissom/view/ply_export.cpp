#include <fmt/format.h>

#include "lissom/view/mesh_export.h"
#include "lissom/view/surface_mesh.h"
#include "lissom/view/text.h"

namespace lissom {

Result<std::string> ply_surfaces(const Drawing& drawing, const PlyOptions& options) {
  if (Status status = check_sides(options.sides); !status) return status.error();
  if (Status status = check_drawing(drawing); !status) return status.error();
  const Field* field = options.field.empty() ? nullptr : drawing.field(options.field);
  if (field == nullptr && !options.field.empty()) {
    return Error{ErrorCode::kUnknown, "field", fmt::format("there is no field \"{}\"", printable(options.field)), ""};
  }
  std::vector<double> values;
  ColorRange range;
  if (field != nullptr) {
    values = values_at_points(drawing, *field);
    range = options.range ? *options.range : ColorRange::fitting(field->colors, field->values);
  }
  const SurfaceMesh mesh = all_surfaces(drawing, options.sides);
  std::string text = "ply\nformat ascii 1.0\ncomment surfaces of rods";
  text += drawing.membranes.empty() ? ", millimetres\n" : ", and membranes, millimetres\n";
  if (field != nullptr) text += "comment colours: " + printable(field->name) + "\n";
  text +=
      fmt::format("element vertex {}\nproperty float x\nproperty float y\nproperty float z\n", mesh.vertices.size());
  if (field != nullptr) text += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  text += fmt::format("element face {}\nproperty list uchar int vertex_indices\nend_header\n", mesh.triangles.size());
  for (size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Eigen::Vector3f mm = (1000 * mesh.vertices[i]).cast<float>();
    for (int k = 0; k < 3; ++k) {
      if (k > 0) text += ' ';
      append_number(text, mm[k]);
    }
    if (field != nullptr) {
      for (uint8_t channel : to_bytes(range.color(field->colors, values[mesh.source[i]]))) {
        text += ' ';
        append_number(text, static_cast<int>(channel));
      }
    }
    text += '\n';
  }
  for (const std::array<int, 3>& triangle : mesh.triangles) {
    text += '3';
    for (int vertex : triangle) {
      text += ' ';
      append_number(text, vertex);
    }
    text += '\n';
  }
  return text;
}

}  // namespace lissom
