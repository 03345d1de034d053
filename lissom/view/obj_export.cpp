#include <array>
#include <fmt/format.h>
#include <map>

#include "lissom/view/mesh_export.h"
#include "lissom/view/surface_mesh.h"
#include "lissom/view/text.h"

namespace lissom {
namespace {

/// OBJ names end at white space.
std::string object_name(const RodStrip& rod, size_t index) {
  if (rod.name.empty()) return fmt::format("rod_{}", index);
  std::string name = printable(rod.name);
  for (char& c : name) {
    if (c == ' ') c = '_';
  }
  return name;
}

template <class Number>
void append_vertex(std::string& text, Number x, Number y, Number z) {
  text += "v ";
  append_number(text, x);
  text += ' ';
  append_number(text, y);
  text += ' ';
  append_number(text, z);
  text += '\n';
}

}  // namespace

Result<std::string> obj_centrelines(const Drawing& drawing) {
  if (Status status = check_drawing(drawing); !status) return status.error();
  std::string text = "# centrelines, millimetres\n";
  std::map<std::array<double, 3>, int> known;
  for (size_t r = 0; r < drawing.rods.size(); ++r) {
    const RodStrip& rod = drawing.rods[r];
    std::string line = "l";
    int first = 0;
    text += "o " + object_name(rod, r) + "\n";
    for (size_t i = 0; i < rod.points.size(); ++i) {
      const Vec3& p = rod.points[i];
      const auto [place, is_new] = known.try_emplace({p.x(), p.y(), p.z()}, static_cast<int>(known.size()) + 1);
      if (is_new) append_vertex(text, 1000 * p.x(), 1000 * p.y(), 1000 * p.z());
      if (i == 0) first = place->second;
      line += ' ';
      append_number(line, place->second);
    }
    if (rod.closed) {
      line += ' ';
      append_number(line, first);
    }
    text += line + "\n";
  }
  return text;
}

Result<std::string> obj_surfaces(const Drawing& drawing, int sides) {
  if (Status status = check_sides(sides); !status) return status.error();
  if (Status status = check_drawing(drawing); !status) return status.error();
  const SurfaceMesh mesh = rod_surfaces(drawing, sides);
  std::string text = "# surfaces of rods, millimetres\n";
  for (const Vec3& v : mesh.vertices) {
    const Eigen::Vector3f mm = (1000 * v).cast<float>();
    append_vertex(text, mm.x(), mm.y(), mm.z());
  }
  for (size_t r = 0; r < drawing.rods.size(); ++r) {
    text += "o " + object_name(drawing.rods[r], r) + "\n";
    const size_t end = r + 1 < drawing.rods.size() ? mesh.first_triangle[r + 1] : mesh.triangles.size();
    for (size_t i = mesh.first_triangle[r]; i < end; ++i) {
      text += 'f';
      for (int vertex : mesh.triangles[i]) {
        text += ' ';
        append_number(text, vertex + 1);
      }
      text += '\n';
    }
  }
  return text;
}

}  // namespace lissom
