#include "lissom/view/mesh_export.h"

#include <gtest/gtest.h>
#include <map>
#include <numbers>
#include <sstream>

#include "lissom/view/surface_mesh.h"
#include "tests/unit/view_samples.h"

namespace lissom {
namespace {

using std::numbers::pi;

double volume(const SurfaceMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    sum += mesh.vertices[a].dot(mesh.vertices[b].cross(mesh.vertices[c])) / 6;
  return sum;
}

/// Every edge is used once in each direction.
bool closed(const SurfaceMesh& mesh) {
  std::map<std::pair<int, int>, int> uses;
  for (const auto& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) ++uses[{t[k], t[(k + 1) % 3]}];
  }
  for (const auto& [edge, count] : uses) {
    const auto back = uses.find({edge.second, edge.first});
    if (count != 1 || back == uses.end() || back->second != 1) return false;
  }
  return !uses.empty();
}

double polygon_factor(int sides) { return sides / 2.0 * std::sin(2 * pi / sides); }

TEST(SurfaceMesh, StraightRodsHaveTheVolumeOfTheirSection) {
  const double length = 0.1, r_n = 0.001, r_b = 0.003;
  const SurfaceMesh ellipse = rod_surfaces({.rods = {samples::straight(length, 4, r_n, r_b)}}, 32);
  EXPECT_TRUE(closed(ellipse));
  EXPECT_NEAR(volume(ellipse), polygon_factor(32) * r_n * r_b * length, 1e-15);
  const SurfaceMesh lath =
      rod_surfaces({.rods = {samples::straight(length, 4, r_n, r_b, SectionShape::kRectangle)}}, 32);
  EXPECT_TRUE(closed(lath));
  EXPECT_NEAR(volume(lath), 4 * r_n * r_b * length, 1e-15);
  RodStrip tube = samples::straight(length, 4, r_b, r_b, SectionShape::kTube);
  tube.wall.assign(4, 0.001);
  const SurfaceMesh hollow = rod_surfaces({.rods = {tube}}, 32);
  EXPECT_TRUE(closed(hollow));
  EXPECT_NEAR(volume(hollow), polygon_factor(32) * (r_b * r_b - 0.002 * 0.002) * length, 1e-15);
}

TEST(SurfaceMesh, RingFollowsPappus) {
  const SurfaceMesh mesh = rod_surfaces({.rods = {samples::circle(0.05, 200, 0.004)}}, 64);
  EXPECT_TRUE(closed(mesh));
  EXPECT_NEAR(volume(mesh), 2 * pi * 0.05 * pi * 0.004 * 0.004, 3e-3 * 2 * pi * 0.05 * pi * 0.004 * 0.004);
}

TEST(SurfaceMesh, MoebiusBandCloses) {
  RodStrip rod = samples::circle(0.05, 60, 0.001, SectionShape::kRectangle);
  for (int e = 0; e < 60; ++e) {
    rod.r_b[e] = 0.006;
    const double half_turn = pi * (e + 0.5) / 60;
    const Vec3 b = rod.b[e], n = rod.n[e];
    rod.b[e] = std::cos(half_turn) * b + std::sin(half_turn) * n;
    rod.n[e] = std::cos(half_turn) * n - std::sin(half_turn) * b;
  }
  const SurfaceMesh mesh = rod_surfaces({.rods = {rod}}, 4);
  EXPECT_TRUE(closed(mesh));
  EXPECT_NEAR(volume(mesh), 4 * 0.001 * 0.006 * 2 * pi * 0.05, 0.01 * 4 * 0.001 * 0.006 * 2 * pi * 0.05);
}

TEST(SurfaceMesh, KinkKeepsTheWidth) {
  const RodStrip rod =
      samples::strip("corner", {{0, 0, 0}, {0.1, 0, 0}, {0.1, 0.1, 0}}, 0.002, 0.002, SectionShape::kRectangle);
  const SurfaceMesh mesh = rod_surfaces({.rods = {rod}}, 4);
  EXPECT_TRUE(closed(mesh));
  EXPECT_NEAR(volume(mesh), 0.004 * 0.004 * 0.2, 1e-12);
}

TEST(MeshExport, CentrelinesReadBackExactlyAndShareJoints) {
  Drawing drawing;
  drawing.rods = {samples::strip("a b", {{0, 0, 0}, {0.1, 0.2 / 3, 0}, {0.3, 0, 1e-7}}, 0.001, 0.001),
                  samples::strip("", {{0.3, 0, 1e-7}, {0.4, 0, 0}}, 0.001, 0.001), samples::circle(0.7, 3, 0.01)};
  std::istringstream file(obj_centrelines(drawing).value());
  std::vector<Vec3> vertices;
  std::vector<std::vector<int>> lines;
  std::string row;
  while (std::getline(file, row)) {
    std::istringstream words(row);
    std::string key;
    words >> key;
    if (key == "v") {
      Vec3 v;
      words >> v.x() >> v.y() >> v.z();
      vertices.push_back(v);
    } else if (key == "l") {
      lines.emplace_back();
      for (int index; words >> index;) lines.back().push_back(index);
    }
  }
  ASSERT_EQ(vertices.size(), 7u);
  EXPECT_EQ(vertices[1].y(), 1000 * (0.2 / 3));
  EXPECT_EQ(lines, (std::vector<std::vector<int>>{{1, 2, 3}, {3, 4}, {5, 6, 7, 5}}));
}

TEST(MeshExport, PlyHasColoursOfTheField) {
  const Drawing drawing = samples::beam_and_ring();
  const std::string text = ply_surfaces(drawing, {.sides = 6, .field = "bending <moment>"}).value();
  std::istringstream file(text);
  std::string row;
  int vertices = 0, faces = 0;
  while (std::getline(file, row) && row != "end_header") {
    std::istringstream words(row);
    std::string element, kind;
    int number = 0;
    if (words >> element >> kind >> number && element == "element") (kind == "vertex" ? vertices : faces) = number;
  }
  EXPECT_EQ(vertices, 4 * 6 + 2 + 5 * 6);
  EXPECT_EQ(faces, 3 * 12 + 2 * 6 + 5 * 12);
  const ColorRange range{0.1, 1.5};
  for (int i = 0; i < vertices; ++i) {
    float x = 0, y = 0, z = 0;
    int r = 0, g = 0, b = 0;
    file >> x >> y >> z >> r >> g >> b;
    if (i >= 6) continue;  // first ring: first node of the beam
    const auto expected = to_bytes(range.color(Field::Colors::kSequential, 0.1));
    EXPECT_EQ(x, 0.0f);
    EXPECT_NEAR(y * y / 4 + z * z, 1, 1e-6);
    EXPECT_EQ(r, expected[0]);
    EXPECT_EQ(g, expected[1]);
    EXPECT_EQ(b, expected[2]);
  }
  int rows = 0;
  for (int n = 0, a = 0, b = 0, c = 0; file >> n >> a >> b >> c; ++rows) {
    ASSERT_EQ(n, 3);
    ASSERT_LT(std::max({a, b, c}), vertices);
  }
  EXPECT_EQ(rows, faces);
}

TEST(MeshExport, ObjSurfacesHaveOneObjectPerRod) {
  const std::string text = obj_surfaces(samples::beam_and_ring(), 8).value();
  EXPECT_NE(text.find("\no beam\nf "), std::string::npos);
  EXPECT_NE(text.find("\no ring\nf "), std::string::npos);
  EXPECT_EQ(text, obj_surfaces(samples::beam_and_ring(), 8).value());
}

TEST(MeshExport, MembranesFollowTheRods) {
  Drawing drawing = samples::saddle(1, 5);
  const std::string lines = obj_centrelines(drawing).value();
  EXPECT_NE(lines.find("o frame\nv "), std::string::npos);
  EXPECT_NE(lines.find("l 1 2 3 4 1\no sail\nf 1 2 3\nf 1 3 4\n"), std::string::npos) << lines;
  const std::string surfaces = obj_surfaces(drawing, 4).value();
  EXPECT_NE(surfaces.find("o sail\nf 17 18 20\nf 17 20 19\n"), std::string::npos) << surfaces;
  drawing.fields = {samples::triangle_field("tension", {1, 2})};
  const std::string ply = ply_surfaces(drawing, {.sides = 4, .field = "tension"}).value();
  EXPECT_NE(ply.find("element vertex 20\n"), std::string::npos);
  EXPECT_NE(ply.find("element face 34\n"), std::string::npos);
  // One corner has the value of one triangle only, two have the mean; rods have none.
  const auto tail = [](const Color& color) {
    const auto bytes = to_bytes(color);
    return " " + std::to_string(bytes[0]) + " " + std::to_string(bytes[1]) + " " + std::to_string(bytes[2]) + "\n";
  };
  const auto lines_with = [&](const Color& color) {
    size_t n = 0;
    const std::string end = tail(color);
    for (size_t at = ply.find(end); at != std::string::npos; at = ply.find(end, at + 1)) ++n;
    return n;
  };
  EXPECT_EQ(lines_with(map_color(Field::Colors::kSequential, 0)), 1u);
  EXPECT_EQ(lines_with(map_color(Field::Colors::kSequential, 1)), 1u);
  EXPECT_EQ(lines_with(map_color(Field::Colors::kSequential, 0.5)), 2u);
  EXPECT_EQ(lines_with(kNoValueColor), 16u);
}

TEST(MeshExport, RefusesWhatCannotBe) {
  Drawing drawing = samples::beam_and_ring();
  EXPECT_EQ(obj_surfaces(drawing, 7).error().where, "sides");
  EXPECT_EQ(ply_surfaces(drawing, {.field = "nothing"}).error().where, "field");
  drawing.rods[1].points[2].y() = std::nan("");
  for (const Result<std::string>& result : {obj_centrelines(drawing), obj_surfaces(drawing), ply_surfaces(drawing)}) {
    ASSERT_FALSE(result.ok());
    EXPECT_EQ(result.error().where, "rod \"ring\"");
  }
  EXPECT_FALSE(obj_centrelines({}).ok());
}

}  // namespace
}  // namespace lissom
