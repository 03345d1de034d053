/// Every defect of a surface: found, named, and mended or refused.

#include "lissom/geometry/surface_repair.h"

#include <algorithm>
#include <gtest/gtest.h>

#include "lissom/geometry/surface_topology.h"
#include "tests/unit/surface_mended.h"
#include "tests/unit/surface_samples.h"

namespace lissom {
namespace {

using samples::icosphere;
using samples::mend;
using samples::Mended;
using samples::refuse;
using samples::sheet;
using samples::texts;
using Options = SurfaceRepairOptions;

constexpr double kPi = 3.141592653589793;

void expect_same(const Surface& a, const Surface& b) {
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.triangles, b.triangles);
}

TEST(SurfaceRepair, SoundSurfacesStayAsTheyAre) {
  for (const Surface& s : {icosphere(2, 0.1), samples::torus(20, 12, 0.1, 0.03), sheet(10, 7, 0.2)}) {
    const Mended mended = mend(s);
    EXPECT_TRUE(mended.notes.empty()) << texts(mended.notes);
    expect_same(mended.surface, s);
  }
}

TEST(SurfaceRepair, FactsAreThoseOfTheShapes) {
  const SurfaceFacts ball = surface_facts(icosphere(4, 0.1));
  EXPECT_EQ(std::tuple(ball.pieces, ball.loops, ball.genus), std::tuple(1, 0, 0));
  EXPECT_NEAR(ball.area, 4 * kPi * 0.01, 2e-3 * ball.area);
  EXPECT_NEAR(ball.volume, 4.0 / 3 * kPi * 0.001, 4e-3 * ball.volume);
  EXPECT_LT(ball.volume, 4.0 / 3 * kPi * 0.001);
  const SurfaceFacts ring = surface_facts(samples::torus(40, 30, 0.1, 0.03));
  EXPECT_EQ(std::tuple(ring.pieces, ring.loops, ring.genus), std::tuple(1, 0, 1));
  const SurfaceFacts open = surface_facts(sheet(10, 10, 0.2));
  EXPECT_EQ(std::tuple(open.pieces, open.loops, open.genus), std::tuple(1, 1, 0));
  EXPECT_EQ(open.volume, 0);
  EXPECT_NEAR(open.longest_loop, 0.8, 0.05);
  EXPECT_NEAR(open.high.x() - open.low.x(), 0.2, 1e-15);
}

TEST(SurfaceRepair, NumbersThatDoNotExistAreRefused) {
  Surface s = icosphere(1, 0.1);
  s.triangles[7][1] = 42;
  EXPECT_EQ(refuse(s).text(), "thing/triangles/7: there is no vertex 42 (vertices are numbered from 0 to 41)");
  s = icosphere(1, 0.1);
  s.vertices[3].y() = NAN;
  EXPECT_EQ(refuse(s).where, "thing/vertices/3");
  EXPECT_EQ(refuse(Surface{}).message, "the surface has no triangles");
  s = icosphere(1, 0.1);
  for (Vec3& v : s.vertices) v.x() += 2e6;
  EXPECT_EQ(refuse(s).code, ErrorCode::kRange);
  s = icosphere(1, 1e-3);
  for (Vec3& v : s.vertices) v.x() += 2e5;
  EXPECT_NE(refuse(s).message.find("few digits"), std::string::npos);
  s = icosphere(1, 0);
  EXPECT_EQ(refuse(s).code, ErrorCode::kRange);
  s = icosphere(1, 1);
  s.darkness = {0.5};
  EXPECT_EQ(refuse(s).where, "thing/darkness");
  EXPECT_EQ(refuse(icosphere(1, 1), {.merge = 2}).where, "options");
}

TEST(SurfaceRepair, UnusedVerticesGo) {
  Surface s = icosphere(1, 0.1);
  s.darkness.assign(s.vertices.size(), 0.25);
  s.vertices.insert(s.vertices.begin() + 5, {NAN, 0, 0});
  s.darkness.insert(s.darkness.begin() + 5, 0.75);
  for (auto& t : s.triangles) {
    for (int& v : t) v += v >= 5;
  }
  const Mended mended = mend(s);
  EXPECT_EQ(texts(mended.notes), "1 vertices that no triangle uses: left out (vertex 5)\n");
  EXPECT_EQ(mended.surface.darkness, std::vector<double>(42, 0.25));
}

TEST(SurfaceRepair, SoupIsSewn) {
  const Surface whole = samples::torus(20, 12, 0.1, 0.03);
  Surface soup;
  for (const auto& t : whole.triangles) {
    const int n = static_cast<int>(soup.vertices.size());
    soup.triangles.push_back({n, n + 1, n + 2});
    for (const int v : t) soup.vertices.emplace_back(whole.vertices[v] + Vec3::Constant(1e-8 * (n % 5)));
  }
  const Mended mended = mend(soup);
  EXPECT_EQ(mended.surface.vertices.size(), whole.vertices.size());
  EXPECT_EQ(mended.surface.triangles.size(), whole.triangles.size());
  EXPECT_EQ(surface_facts(mended.surface).genus, 1);
  ASSERT_EQ(mended.notes.size(), 1U);
  EXPECT_EQ(mended.notes[0].count, 1200);
  EXPECT_EQ(mended.notes[0].done, "merged with it");
}

TEST(SurfaceRepair, ClosedPartsThatOnlyTouchAreNotFused) {
  // Two tetrahedra with an edge in the same place, but vertices of their own: merging would crowd the edge.
  const Surface one{
      {{0, 0, 0}, {0, 0, 1}, {1, 0.3, 0.5}, {1, -0.3, 0.5}}, {{0, 1, 3}, {0, 3, 2}, {1, 2, 3}, {0, 2, 1}}, {}};
  Surface mirrored = one;
  for (Vec3& v : mirrored.vertices) v.x() = -v.x();
  for (auto& t : mirrored.triangles) std::swap(t[0], t[1]);
  const Surface both = samples::together(one, mirrored, Vec3::Zero());
  EXPECT_NE(refuse(both).message.find("2 separate pieces"), std::string::npos) << refuse(both).text();
  EXPECT_EQ(mend(both, {.pieces = Options::Pieces::kKeepLargest}).surface.triangles.size(), 4U);
}

TEST(SurfaceRepair, DuplicatesAndRepeatedCornersGo) {
  const Surface whole = icosphere(2, 0.1);
  Surface s = whole;
  s.triangles.push_back({whole.triangles[9][1], whole.triangles[9][0], whole.triangles[9][2]});
  s.triangles.push_back(whole.triangles[30]);
  s.triangles.push_back({4, 4, 7});
  const Mended mended = mend(s);
  expect_same(mended.surface, whole);
  EXPECT_EQ(mended.notes.size(), 2U) << texts(mended.notes);
  EXPECT_EQ(mended.notes[0].count, 1);
  EXPECT_EQ(mended.notes[1].count, 2);
  EXPECT_EQ(mended.notes[1].places[0].element, "triangle 320");
  // A whole copy with vertices of its own, turned inside out.
  Surface copy = whole;
  for (auto& t : copy.triangles) std::swap(t[0], t[1]);
  expect_same(mend(samples::together(whole, copy, Vec3::Zero())).surface, whole);
}

TEST(SurfaceRepair, TrianglesAreTurnedAlikeAndOutward) {
  const Surface whole = icosphere(2, 0.1);
  Surface s = whole;
  for (std::size_t t = 0; t < s.triangles.size(); t += 3) std::swap(s.triangles[t][1], s.triangles[t][2]);
  const Mended mended = mend(s);
  EXPECT_EQ(mended.notes.at(0).count, 107);
  EXPECT_GT(samples::six_volumes(mended.surface), 0);
  for (auto& t : s.triangles = whole.triangles) std::swap(t[1], t[2]);
  EXPECT_EQ(mend(s).notes.at(0).count, 320) << "the whole surface inside out";
  EXPECT_GT(samples::six_volumes(mend(s).surface), 0);
  // An open one follows the majority.
  Surface open = sheet(6, 6, 0.1);
  for (int t = 0; t < 50; ++t) std::swap(open.triangles[t][1], open.triangles[t][2]);
  EXPECT_EQ(mend(open).notes.at(0).count, 22);
}

TEST(SurfaceRepair, MoebiusStripIsRefused) {
  Surface s;
  for (int i = 0; i < 20; ++i) {
    const double u = 2 * kPi * i / 20;
    for (const double w : {-0.3, 0.3}) {
      const double r = 1 + w * std::cos(u / 2);
      s.vertices.emplace_back(r * std::cos(u), r * std::sin(u), w * std::sin(u / 2));
    }
  }
  for (int i = 0; i < 20; ++i) {
    const int a = 2 * i, b = 2 * i + 1;
    const int c = i < 19 ? 2 * i + 2 : 1, d = i < 19 ? 2 * i + 3 : 0;
    s.triangles.push_back({a, c, b});
    s.triangles.push_back({b, c, d});
  }
  EXPECT_NE(refuse(s).message.find("Moebius"), std::string::npos);
}

TEST(SurfaceRepair, CrowdedEdgesAreMendedWhenScrapsHangThereAndRefusedElse) {
  const Surface whole = icosphere(4, 0.1);
  Surface s = whole;
  s.vertices.emplace_back(1.05 * whole.vertices[whole.triangles[100][0]]);
  s.triangles.push_back({whole.triangles[100][0], whole.triangles[100][1], static_cast<int>(s.vertices.size()) - 1});
  const Mended mended = mend(s);
  expect_same(mended.surface, whole);
  EXPECT_NE(texts(mended.notes).find("1 scraps that hang on an edge"), std::string::npos) << texts(mended.notes);

  Surface wall = sheet(8, 8, 0.2);  // a second sheet stands on the first one's middle line
  const int middle = 4 * 9;
  for (int j = 0; j < 9; ++j) wall.vertices.emplace_back(wall.vertices[middle + j] + Vec3(0, 0, 0.1));
  for (int j = 0; j < 8; ++j) {
    wall.triangles.push_back({middle + j, middle + j + 1, 81 + j});
    wall.triangles.push_back({middle + j + 1, 82 + j, 81 + j});
  }
  const Error error = refuse(wall);
  EXPECT_NE(error.message.find("3 triangles meet in the edge"), std::string::npos) << error.text();
  EXPECT_NE(error.message.find("7 other edges"), std::string::npos) << error.text();
}

TEST(SurfaceRepair, PiecesAreKeptLeftOutOrRefusedBySize) {
  const Surface ball = icosphere(3, 0.1);
  const Mended mended = mend(samples::together(ball, icosphere(0, 0.001), {0.2, 0, 0}));
  expect_same(mended.surface, ball);
  EXPECT_NE(texts(mended.notes).find("1 loose pieces"), std::string::npos) << texts(mended.notes);
  const Surface two = samples::together(icosphere(1, 0.05), ball, {0.3, 0, 0});
  const Error error = refuse(two);
  EXPECT_NE(error.message.find("2 separate pieces: 200 x 200 x 200 mm at (300, 0, 0) mm"), std::string::npos)
      << error.text();
  EXPECT_EQ(mend(two, {.pieces = Options::Pieces::kKeepLargest}).surface.triangles, ball.triangles);
}

TEST(SurfaceRepair, VerticesOfSeveralFansAreSplit) {
  Surface s = sheet(6, 6, 0.1);
  // Two holes that meet in the middle vertex.
  std::erase_if(s.triangles, [](const auto& t) {
    const auto has = [&](int v) { return std::find(t.begin(), t.end(), v) != t.end(); };
    return has(24) && (has(16) || has(32)) && !has(31) && !has(17);
  });
  const std::size_t before = s.vertices.size();
  const Mended mended = mend(s);
  EXPECT_GE(mended.surface.vertices.size(), before);
  EXPECT_NE(texts(mended.notes).find("only touch: made one for each part (vertex 24"), std::string::npos)
      << texts(mended.notes);
}

}  // namespace
}  // namespace lissom
