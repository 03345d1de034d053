#pragma once
/// Surfaces made in code, and the bytes of files that hold them, for the tests of what users bring.

#include <bit>
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "lissom/geometry/surface.h"

namespace lissom::samples {

/// Triangles of a sphere about the origin (radius in m), `levels` times refined from an icosahedron: closed.
inline Surface icosphere(int levels, double radius) {
  const double g = (1 + std::sqrt(5.0)) / 2;
  Surface s;
  s.vertices = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  s.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                 {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                 {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [found, added] =
          middles.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<int>(s.vertices.size()));
      if (added) s.vertices.emplace_back(0.5 * (s.vertices[a] + s.vertices[b]));
      return found->second;
    };
    std::vector<std::array<int, 3>> finer;
    for (const auto& [a, b, c] : s.triangles) {
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    s.triangles = finer;
  }
  for (Vec3& v : s.vertices) v *= radius / v.norm();
  return s;
}

/// A torus about z: closed, genus 1.
inline Surface torus(int around, int across, double large, double small) {
  Surface s;
  constexpr double kTurn = 6.283185307179586;
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double u = kTurn * i / around, v = kTurn * j / across, r = large + small * std::cos(v);
      s.vertices.emplace_back(r * std::cos(u), r * std::sin(u), small * std::sin(v));
    }
  }
  const auto at = [&](int i, int j) { return i % around * across + j % across; };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      s.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      s.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return s;
}

/// A gently curved sheet over a rectangle: open, one boundary.
inline Surface sheet(int cells_x, int cells_y, double size) {
  Surface s;
  for (int i = 0; i <= cells_x; ++i) {
    for (int j = 0; j <= cells_y; ++j) {
      const double x = size * i / cells_x, y = size * j / cells_x;
      s.vertices.emplace_back(x, y, 0.1 * size * std::sin(3 * x / size) * std::cos(2 * y / size));
    }
  }
  const auto at = [&](int i, int j) { return i * (cells_y + 1) + j; };
  for (int i = 0; i < cells_x; ++i) {
    for (int j = 0; j < cells_y; ++j) {
      s.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      s.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return s;
}

/// Both, with the second moved.
inline Surface together(Surface a, const Surface& b, const Vec3& by) {
  const int shift = static_cast<int>(a.vertices.size());
  for (const Vec3& v : b.vertices) a.vertices.emplace_back(v + by);
  for (const auto& t : b.triangles) a.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  return a;
}

template <class Number>
void append(std::string& bytes, Number value, bool big = false) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  for (std::size_t i = 0; i < sizeof value; ++i) bytes += raw[big ? sizeof value - 1 - i : i];
}

inline std::string numbers(const Vec3& p) {
  char text[100];
  std::snprintf(text, sizeof text, "%.17g %.17g %.17g", p.x(), p.y(), p.z());
  return text;
}

/// Files of the kinds below, coordinates as they are in the surface.
inline std::string obj_file(const Surface& s) {
  std::string text = "# made by a test\no thing\n";
  for (const Vec3& v : s.vertices) text += "v " + numbers(v) + "\n";
  text += "vn 0 0 1\ns off\n";
  for (const auto& [a, b, c] : s.triangles) {
    text += "f " + std::to_string(a + 1) + "//1 " + std::to_string(b + 1) + "//1 " + std::to_string(c + 1) + "//1\n";
  }
  return text;
}

inline std::string off_file(const Surface& s) {
  std::string text = "OFF\n" + std::to_string(s.vertices.size()) + " " + std::to_string(s.triangles.size()) + " 0\n";
  for (const Vec3& v : s.vertices) text += numbers(v) + "\n";
  for (const auto& [a, b, c] : s.triangles) {
    text += "3 " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
  }
  return text;
}

inline std::string stl_text_file(const Surface& s) {
  std::string text = "solid thing\n";
  for (const auto& t : s.triangles) {
    text += "facet normal 0 0 0\n outer loop\n";
    for (const int v : t) text += "  vertex " + numbers(s.vertices[v]) + "\n";
    text += " endloop\nendfacet\n";
  }
  return text + "endsolid thing\n";
}

inline std::string stl_binary_file(const Surface& s) {
  std::string bytes(80, 'x');
  append(bytes, static_cast<std::uint32_t>(s.triangles.size()));
  for (const auto& t : s.triangles) {
    bytes.append(12, '\0');
    for (const int v : t) {
      for (int i = 0; i < 3; ++i) append(bytes, static_cast<float>(s.vertices[v][i]));
    }
    bytes.append(2, '\0');
  }
  return bytes;
}

enum class Ply { kText, kLittle, kBig };
inline std::string ply_file(const Surface& s, Ply kind) {
  const char* const kNames[] = {"ascii", "binary_little_endian", "binary_big_endian"};
  std::string bytes = std::string("ply\nformat ") + kNames[static_cast<int>(kind)] + " 1.0\nelement vertex " +
                      std::to_string(s.vertices.size()) +
                      "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
                      std::to_string(s.triangles.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Vec3& v : s.vertices) {
    if (kind == Ply::kText) bytes += numbers(v) + "\n";
    for (int i = 0; i < 3 && kind != Ply::kText; ++i) append(bytes, v[i], kind == Ply::kBig);
  }
  for (const auto& t : s.triangles) {
    bytes += kind == Ply::kText ? "3" : std::string("\3");
    for (const int v : t) {
      if (kind == Ply::kText) bytes += " " + std::to_string(v);
      if (kind != Ply::kText) append(bytes, static_cast<std::int32_t>(v), kind == Ply::kBig);
    }
    if (kind == Ply::kText) bytes += "\n";
  }
  return bytes;
}

struct Kind {
  const char* file;
  std::string (*bytes)(const Surface&);
};
inline constexpr Kind kKinds[] = {{"thing.obj", obj_file},
                                  {"thing.off", off_file},
                                  {"text.stl", stl_text_file},
                                  {"binary.stl", stl_binary_file},
                                  {"text.ply", [](const Surface& s) { return ply_file(s, Ply::kText); }},
                                  {"little.ply", [](const Surface& s) { return ply_file(s, Ply::kLittle); }},
                                  {"big.ply", [](const Surface& s) { return ply_file(s, Ply::kBig); }}};

}  // namespace lissom::samples
