/// Surfaces out of files of all kinds, and what is said of files that hold none.

#include "lissom/geometry/surface_file.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "lissom/geometry/surface_scale.h"
#include "tests/unit/surface_samples.h"

namespace lissom {
namespace {

using samples::append;

/// The corners of all triangles, so that surfaces with vertices in another order compare.
std::vector<double> corners(const std::vector<Vec3>& points, const std::vector<std::array<int, 3>>& triangles) {
  std::vector<double> list;
  for (const auto& t : triangles) {
    for (const int v : t) list.insert(list.end(), points[v].data(), points[v].data() + 3);
  }
  return list;
}

RawSurface read(const std::string& bytes, const std::string& file) {
  const Result<RawSurface> raw = read_surface(bytes, file);
  EXPECT_TRUE(raw) << raw.error().text();
  return raw ? raw.value() : RawSurface();
}

void expect_refused(const std::string& bytes, const std::string& file, const std::string& where,
                    const std::string& message) {
  const Result<RawSurface> raw = read_surface(bytes, file);
  ASSERT_FALSE(raw) << file << ": " << message;
  EXPECT_EQ(raw.error().where, where) << raw.error().text();
  EXPECT_NE(raw.error().message.find(message), std::string::npos) << raw.error().text();
  EXPECT_FALSE(raw.error().hint.empty());
}

TEST(SurfaceFile, EveryKindHoldsTheSameSurface) {
  Surface sphere = samples::icosphere(2, 1);
  for (Vec3& v : sphere.vertices) {
    for (int i = 0; i < 3; ++i) v[i] = std::ldexp(std::round(std::ldexp(v[i], 20)), -20);  // what floats can hold
  }
  const std::vector<double> expected = corners(sphere.vertices, sphere.triangles);
  for (const samples::Kind& kind : samples::kKinds) {
    const RawSurface raw = read(kind.bytes(sphere), kind.file);
    EXPECT_EQ(corners(raw.points, raw.triangles), expected) << kind.file;
    EXPECT_EQ(raw.points.size(), sphere.vertices.size()) << kind.file;
    EXPECT_TRUE(raw.notes.empty()) << kind.file;
    EXPECT_TRUE(raw.darkness.empty()) << kind.file;
  }
}

TEST(SurfaceFile, ObjTakesWhatProgramsWrite) {
  const RawSurface raw = read(
      "\xEF\xBB\xBF# comment\r\nmtllib a.mtl\r\nv 0 0 0\r\nv 1 0 0 1.0\r\nv 1 1 0\r\nv 0 1 0\r\nvt 0 0\r\n"
      "f 1/1 2/1 \\\r\n 3/1 4/1\r\nf -4 -2 5\r\nv 0 0 +2e0\r\nl 1 2\r\nf 1 2\r\n",
      "a.OBJ");
  EXPECT_EQ(raw.points.size(), 5U);
  EXPECT_EQ(raw.points[4], Vec3(0, 0, 2));
  ASSERT_EQ(raw.triangles.size(), 3U);
  EXPECT_EQ(raw.triangles[2], (std::array<int, 3>{0, 2, 4}));
  ASSERT_EQ(raw.notes.size(), 2U);
  EXPECT_EQ(raw.notes[0].text(), "1 polygons with fewer than 3 corners: left out (line 13)");
  EXPECT_EQ(raw.notes[1].text(), "1 polygons with more than 3 corners: split into triangles");
}

TEST(SurfaceFile, ColoursBecomeDarkness) {
  const std::vector<double> expected = {0, 1, 1 - 0.2126, 1 - 0.7152};
  const auto check = [&](const std::string& bytes, const std::string& file) {
    const RawSurface raw = read(bytes, file);
    ASSERT_EQ(raw.darkness.size(), 4U) << file;
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(raw.darkness[i], expected[i], 1e-12) << file;
  };
  const std::string bytes255[] = {"255 255 255", "0 0 0", "255 0 0", "0 255 0"};
  const std::string units[] = {"1 1 1", "0 0 0", "1 0 0", "0 1 0"};
  const std::string places[] = {"0 0 0", "1 0 0", "0 1 0", "0 0 1"};
  std::string obj, obj255, off = "OFF 4 1 0\n", coff = "COFF\n# colours\n4 1 0\n", noff = "STCNOFF\n4 1 0\n";
  std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n"
      "element face 1\nproperty list uchar int vertex_index\nend_header\n";
  for (int i = 0; i < 4; ++i) {
    obj += "v " + places[i] + " " + units[i] + "\n";
    obj255 += "v " + places[i] + " " + bytes255[i] + "\n";
    off += places[i] + " " + bytes255[i] + "\n";
    coff += places[i] + " " + units[i] + " 1\n";
    noff += places[i] + " 0 0 1 " + units[i] + " 1 0.5 0.5\n";
    ply += places[i] + " " + bytes255[i] + " 255\n";
  }
  check(obj + "f 1 2 3\n", "a.obj");
  check(obj255 + "f 1 2 3\n", "b.obj");
  check(off + "3 0 1 2\n", "a.off");
  check(coff + "3 0 1 2 0.5 0.5 0.5\n", "b.off");
  check(noff + "3 0 1 2\n", "c.off");
  check(ply + "3 0 1 2\n", "a.ply");
}

TEST(SurfaceFile, PlyReadsOverOtherElementsAndTypes) {
  std::string bytes =
      "ply\r\nformat binary_big_endian 1.0\r\ncomment x\r\nelement nothing 1000000000\r\nelement vertex 3\r\n"
      "property list uchar short tags\r\nproperty short x\r\nproperty float y\r\nproperty double z\r\n"
      "element camera 1\r\nproperty float fov\r\nelement face 1\r\nproperty uchar flags\r\n"
      "property list uint uchar vertex_indices\r\nend_header\r\n";
  for (int i = 0; i < 3; ++i) {
    bytes += '\2';
    append(bytes, std::int16_t{7}, true);
    append(bytes, std::int16_t{8}, true);
    append(bytes, static_cast<std::int16_t>(i == 1 ? -300 : 0), true);
    append(bytes, i == 2 ? 0.5F : 0.0F, true);
    append(bytes, 0.25, true);
  }
  append(bytes, 1.0F, true);
  bytes += '\0';
  append(bytes, std::uint32_t{3}, true);
  bytes += std::string("\0\1\2", 3);
  const RawSurface raw = read(bytes, "a.ply");
  ASSERT_EQ(raw.points.size(), 3U);
  EXPECT_EQ(raw.points[1], Vec3(-300, 0, 0.25));
  EXPECT_EQ(raw.points[2], Vec3(0, 0.5, 0.25));
  EXPECT_EQ(raw.triangles, (std::vector<std::array<int, 3>>{{0, 1, 2}}));
}

TEST(SurfaceFile, BinaryStlMayCallItselfSolid) {
  std::string bytes = samples::stl_binary_file(samples::icosphere(1, 1));
  bytes.replace(0, 5, "solid");
  EXPECT_EQ(read(bytes, "a.stl").triangles.size(), 80U);
  EXPECT_EQ(read(bytes + "abc", "a.stl").notes.size(), 1U) << "bytes behind the last face are noted";
}

TEST(SurfaceFile, ConcavePolygonsAreSplitInside) {
  // An L of area 3, and an arrow whose only good diagonal is the longer one.
  const RawSurface raw = read("v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4 5 6\n", "l.obj");
  ASSERT_EQ(raw.triangles.size(), 4U);
  const RawSurface arrow = read("v 0 0 0\nv 5 1 0\nv 10 0 0\nv 5 9 0\nf 1 2 3 4\n", "arrow.obj");
  ASSERT_EQ(arrow.triangles.size(), 2U);
  for (const auto& [surface, area] : {std::pair(&raw, 3.0), std::pair(&arrow, 40.0)}) {
    double sum = 0;
    for (const auto& t : surface->triangles) {
      const double own =
          0.5 *
          (surface->points[t[1]] - surface->points[t[0]]).cross(surface->points[t[2]] - surface->points[t[0]]).z();
      EXPECT_GT(own, 0) << "folded back";
      sum += own;
    }
    EXPECT_NEAR(sum, area, 1e-12);
  }
}

TEST(SurfaceFile, ErrorsNameTheLine) {
  expect_refused("v 0 0 0\nv 1 0 0\nv 0 1\nf 1 2 3\n", "a.obj", "a.obj:3", "2 coordinates");
  expect_refused("v 0 0 0\nv 1 0 0\nv 0 one 0\nf 1 2 3\n", "a.obj", "a.obj:3", "\"one\" is not a number");
  expect_refused("v 0 0 1e999\n", "a.obj", "a.obj:1", "not a number");
  expect_refused("v 0 0 0\nv 1 0 0\nv 0 1 0\n\nf 1 2 4\n", "a.obj", "a.obj:5", "no vertex 4");
  expect_refused("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 0 2\n", "a.obj", "a.obj:4", "\"0\" is not the number");
  expect_refused("v 0 0 0\nv 1 0 0\nl 1 2\n", "a.obj", "a.obj", "no faces");
  expect_refused("", "a.obj", "a.obj", "no faces");
  expect_refused("OFF\n3 1 0\n0 0 0\n1 0 0\n", "a.off", "a.off:2", "do not fit");
  expect_refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n", "a.off", "a.off:6", "2 of 3 corners");
  expect_refused("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "a.off", "a.off:6", "no vertex 3");
  expect_refused("OFF\n999999999999 1 0\n0 0 0\n", "a.off", "a.off:2", "do not fit");
  expect_refused("OFF BINARY\n", "a.off", "a.off:1", "not read");
  expect_refused("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 x 0\n", "a.stl", "a.stl:5", "\"x\"");
  expect_refused("solid a\nfacet normal 0 0 1\nvertex 0 0 0\n", "a.stl", "a.stl:3", "where \"outer loop\" is expected");
  expect_refused("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n", "a.stl", "a.stl:4", "without \"endsolid\"");
  expect_refused("anything", "a.stl", "a.stl", "no STL file");
  expect_refused("anything", "a.step", "a.step", "\".step\"");
}

TEST(SurfaceFile, HeadersThatAnnounceTooMuchAreRefusedAtOnce) {
  const Surface sphere = samples::icosphere(1, 1);
  std::string stl = samples::stl_binary_file(sphere);
  stl[83] = '\x7F';
  expect_refused(stl, "a.stl", "a.stl, face 80", "announces 2130706512 faces");
  for (const samples::Ply kind : {samples::Ply::kText, samples::Ply::kLittle}) {
    std::string ply = samples::ply_file(sphere, kind);
    ply.replace(ply.find("element face 80"), 15, "element face 800000000");
    const Result<RawSurface> raw = read_surface(ply, "a.ply");
    ASSERT_FALSE(raw);
    EXPECT_NE(raw.error().message.find("do not fit into"), std::string::npos) << raw.error().text();
  }
}

TEST(SurfaceFile, EveryCutIsRefusedOrLeavesWholeFaces) {
  const Surface sphere = samples::icosphere(1, 1);
  for (const samples::Kind& kind : samples::kKinds) {
    const std::string bytes = kind.bytes(sphere);
    int refused = 0, tried = 0;
    for (std::size_t cut = 0; cut + 20 < bytes.size(); cut += 37, ++tried) {
      const Result<RawSurface> raw = read_surface(bytes.substr(0, cut), kind.file);
      if (raw) {
        EXPECT_EQ(kind.file, std::string("thing.obj")) << "only OBJ files do not say how long they are";
        EXPECT_LT(raw.value().triangles.size(), 80U);
        continue;
      }
      ++refused;
      EXPECT_FALSE(raw.error().where.empty() || raw.error().message.empty() || raw.error().hint.empty());
    }
    EXPECT_GT(2 * refused, tried) << kind.file;
  }
}

TEST(SurfaceFile, WrittenFilesReadBackToTheSameNumbers) {
  Surface sphere = samples::icosphere(2, 0.1);
  for (std::size_t v = 0; v < sphere.vertices.size(); ++v)
    sphere.darkness.push_back(static_cast<double>(v % 256) / 255);
  for (const auto& [file, bytes] : {std::pair<std::string, std::string>{"a.ply", write_surface_ply(sphere)},
                                    {"a.obj", write_surface_obj(sphere)}}) {
    const RawSurface raw = read(bytes, file);
    ASSERT_EQ(raw.points.size(), sphere.vertices.size());
    EXPECT_EQ(raw.triangles, sphere.triangles);
    ASSERT_EQ(raw.darkness.size(), sphere.darkness.size());
    for (std::size_t v = 0; v < raw.points.size(); ++v) {
      EXPECT_EQ(raw.points[v], Vec3(1000 * sphere.vertices[v]));
      EXPECT_NEAR(raw.darkness[v], sphere.darkness[v], 1e-6);
    }
  }
}

TEST(SurfaceScale, TheUnitIsAskedForWithSizes) {
  const RawSurface raw = read(samples::obj_file(samples::icosphere(3, 115)), "ball.obj");
  const Result<Surface> none = surface_in_metres(raw, {});
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().code, ErrorCode::kUnit);
  EXPECT_EQ(
      none.error().text(),
      "ball.obj: the file does not say its unit; the surface would be 230 mm in mm, 2.3 m in cm, 230 m in m, 5.842 m "
      "in "
      "in across (say what the numbers are in, likely --unit mm or --unit cm, or how large it is: --size \"230 mm\")");
  const Result<Surface> metres = surface_in_metres(raw, {.unit = 1});
  ASSERT_FALSE(metres);
  EXPECT_NE(metres.error().message.find("230 m across"), std::string::npos) << metres.error().text();
  EXPECT_NE(metres.error().hint.find("--unit mm"), std::string::npos);
  EXPECT_FALSE(surface_in_metres(raw, {.unit = 0.001, .size = 1}));
  const Result<Surface> mm = surface_in_metres(raw, {.unit = 0.001}), sized = surface_in_metres(raw, {.size = 30});
  ASSERT_TRUE(mm && sized);
  EXPECT_NEAR(mm.value().vertices[0].norm(), 0.115, 1e-15);
  EXPECT_NEAR(sized.value().vertices[0].norm(), 15, 1e-12) << "a size that is said is believed";
}

}  // namespace
}  // namespace lissom
