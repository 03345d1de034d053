/// Thin triangles, holes and crossings of surfaces, and how long large ones take.

#include <algorithm>
#include <ctime>
#include <gtest/gtest.h>

#include "lissom/geometry/surface_repair.h"
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
using Outcome = SurfaceNote::Outcome;

TEST(SurfaceMending, NeedlesAndCapsGo) {
  // A needle: an edge of the ball is split by a vertex next to its end. A cap: a vertex right on an edge, and the
  // triangle between it and the edge.
  const Surface whole = icosphere(2, 0.1);
  const auto split_edge = [&](double at, bool both_sides) {
    Surface s = whole;
    const auto [a, b, c] = whole.triangles[50];
    const int m = static_cast<int>(s.vertices.size());
    s.vertices.emplace_back((1 - at) * s.vertices[a] + at * s.vertices[b]);
    s.triangles[50] = {m, b, c};
    s.triangles.push_back({a, m, c});
    for (std::size_t t = 0; t < whole.triangles.size(); ++t) {
      for (int i = 0; i < 3; ++i) {
        if (whole.triangles[t][i] != b || whole.triangles[t][(i + 1) % 3] != a) continue;
        const int d = whole.triangles[t][(i + 2) % 3];
        if (both_sides) {
          s.triangles[t] = {b, m, d};
          s.triangles.push_back({m, a, d});
        } else {
          s.triangles.push_back({a, b, m});
        }
      }
    }
    return s;
  };
  const Mended needles = mend(split_edge(1e-7, true));
  EXPECT_EQ(needles.surface.triangles.size(), 320U);
  EXPECT_NE(texts(needles.notes).find("needles"), std::string::npos) << texts(needles.notes);
  const Mended caps = mend(split_edge(0.4, false));
  EXPECT_EQ(caps.surface.triangles.size(), 322U);
  EXPECT_NE(texts(caps.notes).find("1 caps"), std::string::npos) << texts(caps.notes);
  EXPECT_EQ(surface_facts(caps.surface).loops, 0);
  EXPECT_NEAR(surface_facts(caps.surface).volume, surface_facts(whole).volume, 1e-15);
}

TEST(SurfaceMending, CapsAtARimGo) {
  Surface s = sheet(5, 5, 0.1);
  const int m = static_cast<int>(s.vertices.size());
  s.vertices.emplace_back(0.5 * (s.vertices[0] + s.vertices[6]) + Vec3(0, 1e-9, 0));
  ASSERT_EQ(s.triangles[0], (std::array<int, 3>{0, 6, 7}));
  s.triangles[0] = {m, 6, 7};
  s.triangles.push_back({0, m, 7});
  s.triangles.push_back({0, 6, m});
  const Mended mended = mend(s);
  EXPECT_EQ(mended.surface.triangles.size(), 51U) << texts(mended.notes);
  EXPECT_EQ(surface_facts(mended.surface).loops, 1);
}

TEST(SurfaceMending, SmallHolesAreFilledWhenAllowedAndLargeOnesStay) {
  Surface s = icosphere(4, 0.1);
  const double volume = surface_facts(s).volume;
  std::erase_if(s.triangles, [](const auto& t) { return t[0] == 0 || t[1] == 0 || t[2] == 0; });
  const Options fill{.holes = Options::Holes::kFill, .small_hole = 0.1};
  const Mended kept = mend(s, {.small_hole = 0.1});
  EXPECT_EQ(surface_facts(kept.surface).loops, 1);
  ASSERT_EQ(kept.notes.size(), 2U) << texts(kept.notes);
  EXPECT_EQ(kept.notes[1].outcome, Outcome::kKept);
  EXPECT_NE(kept.notes[1].text().find("--fill-holes"), std::string::npos);
  const Mended filled = mend(s, fill);
  EXPECT_EQ(surface_facts(filled.surface).loops, 0);
  EXPECT_NEAR(surface_facts(filled.surface).volume, volume, 1e-3 * volume);
  EXPECT_NE(texts(filled.notes).find("1 small holes: closed (a hole of 5 sides"), std::string::npos)
      << texts(filled.notes);
  std::erase_if(s.triangles, [&](const auto& t) { return s.vertices[t[0]].z() > 0.05; });
  EXPECT_EQ(surface_facts(mend(s, fill).surface).loops, 1) << "the rim of an open surface";
}

TEST(SurfaceMending, HolesThatMeetInAVertexAreClosedEach) {
  const Surface whole = icosphere(4, 0.1);
  // Two triangles at vertex 0 that share no edge.
  std::vector<std::size_t> around;
  for (std::size_t t = 0; t < whole.triangles.size(); ++t) {
    const auto& own = whole.triangles[t];
    if (std::find(own.begin(), own.end(), 0) == own.end()) continue;
    const bool apart = std::all_of(around.begin(), around.end(), [&](std::size_t other) {
      return std::count_if(own.begin(), own.end(), [&](int v) {
               const auto& o = whole.triangles[other];
               return std::find(o.begin(), o.end(), v) != o.end();
             }) == 1;
    });
    if (apart) around.push_back(t);
  }
  ASSERT_EQ(around.size(), 2U);
  Surface s = whole;
  for (auto t = around.rbegin(); t != around.rend(); ++t) {
    s.triangles.erase(s.triangles.begin() + static_cast<std::ptrdiff_t>(*t));
  }
  const Mended filled = mend(s, {.holes = Options::Holes::kFill});
  EXPECT_EQ(surface_facts(filled.surface).loops, 0);
  EXPECT_EQ(filled.surface.vertices, whole.vertices);
  EXPECT_EQ(filled.surface.triangles.size(), whole.triangles.size());
  ASSERT_EQ(filled.notes.size(), 1U) << texts(filled.notes);
  EXPECT_EQ(filled.notes[0].count, 2);
}

TEST(SurfaceMending, CrossingsAreNamedAndKeptOrRefused) {
  Surface s = icosphere(2, 0.1);
  s.vertices[0] *= -1.5;  // a spike through the other side
  const Mended mended = mend(s);
  ASSERT_EQ(mended.notes.size(), 1U) << texts(mended.notes);
  EXPECT_EQ(mended.notes[0].outcome, Outcome::kKept);
  EXPECT_NE(texts(mended.notes).find("pairs of triangles that cross"), std::string::npos) << texts(mended.notes);
  const Error error = refuse(s, {.crossings = Options::Crossings::kRefuse});
  EXPECT_NE(error.message.find("crosses or touches itself in"), std::string::npos);
  EXPECT_NE(error.where.find("thing/triangles/"), std::string::npos);
}

/// A disc of ever so many triangles around one vertex, all too thin: nothing may be tried at the cost of its valence.
TEST(SurfaceMending, WheelsOfThinTrianglesAreRefusedAtOnce) {
  Surface s;
  constexpr int kSpokes = 400'000;
  s.vertices.emplace_back(0, 0, 0.1);
  for (int i = 0; i < kSpokes; ++i) {
    const double a = 2 * kPi * i / kSpokes;
    s.vertices.emplace_back(std::cos(a), std::sin(a), 0);
    s.triangles.push_back({0, 1 + i, 1 + (i + 1) % kSpokes});
  }
  const std::clock_t start = std::clock();
  EXPECT_NE(refuse(s, {.thin = 1e-4}).message.find("cannot be mended"), std::string::npos);
  EXPECT_LT(double(std::clock() - start) / CLOCKS_PER_SEC, 20);
}

TEST(SurfaceMending, LargeSurfacesTakeSeconds) {
  const Surface s = icosphere(7, 0.1);  // 327,680 triangles
  const std::clock_t start = std::clock();
  EXPECT_TRUE(repair_surface(s, {}, "thing"));
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  constexpr double kLongest = 60;
#else
  constexpr double kLongest = 6;
#endif
  EXPECT_LT(double(std::clock() - start) / CLOCKS_PER_SEC, kLongest);
}

}  // namespace
}  // namespace lissom
