#include <array>
#include <fmt/format.h>
#include <map>

#include "lissom/view/mesh_export.h"
#include "lissom/view/surface_mesh.h"
#include "lissom/view/text.h"

namespace lissom {
namespace {

/// OBJ names end at white space.
std::string object_name(const std::string& given, std::string_view kind, size_t index) {
  if (given.empty()) return fmt::format("{}_{}", kind, index);
  std::string name = printable(given);
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

/// Vertex numbers of OBJ files count from 1.
void append_face(std::string& text, const std::array<int, 3>& vertices) {
  text += 'f';
  for (int vertex : vertices) {
    text += ' ';
    append_number(text, vertex);
  }
  text += '\n';
}

}  // namespace

Result<std::string> obj_centrelines(const Drawing& drawing) {
  if (Status status = check_drawing(drawing); !status) return status.error();
  std::string text =
      drawing.membranes.empty() ? "# centrelines, millimetres\n" : "# centrelines and membranes, millimetres\n";
  std::map<std::array<double, 3>, int> known;
  const auto vertex = [&](const Vec3& p) {
    const auto [place, is_new] = known.try_emplace({p.x(), p.y(), p.z()}, static_cast<int>(known.size()) + 1);
    if (is_new) append_vertex(text, 1000 * p.x(), 1000 * p.y(), 1000 * p.z());
    return place->second;
  };
  for (size_t r = 0; r < drawing.rods.size(); ++r) {
    const RodStrip& rod = drawing.rods[r];
    std::string line = "l";
    int first = 0;
    text += "o " + object_name(rod.name, "rod", r) + "\n";
    for (size_t i = 0; i < rod.points.size(); ++i) {
      const int number = vertex(rod.points[i]);
      if (i == 0) first = number;
      line += ' ';
      append_number(line, number);
    }
    if (rod.closed) {
      line += ' ';
      append_number(line, first);
    }
    text += line + "\n";
  }
  for (size_t m = 0; m < drawing.membranes.size(); ++m) {
    const MembraneSheet& sheet = drawing.membranes[m];
    text += "o " + object_name(sheet.name, "membrane", m) + "\n";
    std::vector<int> number;
    for (const Vec3& p : sheet.points) number.push_back(vertex(p));
    for (const std::array<int, 3>& t : sheet.triangles) append_face(text, {number[t[0]], number[t[1]], number[t[2]]});
  }
  return text;
}

Result<std::string> obj_surfaces(const Drawing& drawing, int sides) {
  if (Status status = check_sides(sides); !status) return status.error();
  if (Status status = check_drawing(drawing); !status) return status.error();
  const SurfaceMesh mesh = all_surfaces(drawing, sides);
  std::string text = drawing.membranes.empty() ? "# surfaces of rods, millimetres\n"
                                               : "# surfaces of rods, and membranes, millimetres\n";
  for (const Vec3& v : mesh.vertices) {
    const Eigen::Vector3f mm = (1000 * v).cast<float>();
    append_vertex(text, mm.x(), mm.y(), mm.z());
  }
  const size_t rods = drawing.rods.size();
  for (size_t i = 0; i < mesh.first_triangle.size(); ++i) {
    text += "o ";
    text += i < rods ? object_name(drawing.rods[i].name, "rod", i)
                     : object_name(drawing.membranes[i - rods].name, "membrane", i - rods);
    text += "\n";
    const size_t end = i + 1 < mesh.first_triangle.size() ? mesh.first_triangle[i + 1] : mesh.triangles.size();
    for (size_t t = mesh.first_triangle[i]; t < end; ++t) {
      append_face(text, {mesh.triangles[t][0] + 1, mesh.triangles[t][1] + 1, mesh.triangles[t][2] + 1});
    }
  }
  return text;
}

}  // namespace lissom
