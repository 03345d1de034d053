#include "lissom/geometry/obj_lines.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include "lissom/model/import_network.h"
#include "lissom/model/structure.h"

namespace lissom {
namespace {

ObjLines read(std::string_view text) {
  const Result<ObjLines> r = read_obj_lines(text, "net.obj");
  EXPECT_TRUE(r.ok()) << (r.ok() ? "" : r.error().text());
  return r.ok() ? r.value() : ObjLines{};
}

Error refused(std::string_view text) {
  const Result<ObjLines> r = read_obj_lines(text, "net.obj");
  EXPECT_FALSE(r.ok()) << text;
  return r.ok() ? Error{} : r.error();
}

using Segments = std::vector<std::array<int, 2>>;

TEST(ObjLines, ReadsEveryFormOfLine) {
  const ObjLines a = read(
      "# drawing\r\nv 0 0 0\r\nv 1 0 +0 1.0\r\nvt 0 0\r\nl 1/1 2/1 3\r\nv 1e0 -2.5e-1 0 # last\r\nl -1 \\\r\n  1\r\nf "
      "1 2 3\r\ng x\r\n");
  EXPECT_EQ(a.points.size(), 3u);
  EXPECT_EQ(a.points[2], Vec3(1, -0.25, 0));
  EXPECT_EQ(a.segments, (Segments{{0, 1}, {1, 2}, {2, 0}}));
  EXPECT_EQ(a.ignored, 3);
  EXPECT_EQ(read("\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nl 1 2").segments.size(), 1u);
}

TEST(ObjLines, WritesWhatItReads) {
  ObjLines a;
  a.points = {{0.1, 1.0 / 3, -2e-300}, {1e9, 0, 7}};
  a.segments = {{1, 0}};
  const ObjLines b = read(write_obj_lines(a));
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.segments, b.segments);
}

TEST(ObjLines, ErrorsNameTheLine) {
  const std::pair<const char*, const char*> wrong[] = {
      {"v 0 0\nl 1 2", "net.obj:1"},
      {"v 0 0 0\nv 0 x 0\nl 1 2", "net.obj:2"},
      {"v 0 0 nan\nl 1 2", "net.obj:1"},
      {"v 0 0 1e999\nl 1 2", "net.obj:1"},
      {"v 0 0 0\nv 1 0 0\nl 1 3", "net.obj:3"},
      {"v 0 0 0\nv 1 0 0\nl 0 1", "net.obj:3"},
      {"v 0 0 0\nv 1 0 0\n\nl 1 -3", "net.obj:4"},
      {"v 0 0 0\nv 1 0 0\nl 1 99999999999999999999", "net.obj:3"},
      {"v 0 0 0\nv 1 0 0\nl 1 999999999999", "net.obj:3"},
      {"v 0 0 0\nv 1 0 0\nl 1 2.5", "net.obj:3"},
      {"v 0 0 0\nv 1 0 0\nl 1", "net.obj:3"},
      {"v 0 0 \\\n 0\nv 1 0 0\nl \\\n 1 \\\n 7", "net.obj:4"},
      {"v 0 0 0\nf 1 1 1", "net.obj"},
      {"", "net.obj"},
  };
  for (const auto& [text, where] : wrong) {
    const Error e = refused(text);
    EXPECT_EQ(e.where, where) << text;
    EXPECT_FALSE(e.hint.empty());
  }
}

TEST(ObjLines, AnyBytesEndInAResult) {
  std::mt19937 random(7);
  const std::string good = "v 0 0 0\nv 1 0 0\nv 1 1 0\nl 1 2 3\nl -1 1\n";
  const char letters[] = "vl 0123456789-+.e/\\#\n\r\t\xff";
  int read_well = 0, refused_well = 0;
  for (int i = 0; i < 5000; ++i) {
    std::string text = good;
    for (int k = 0; k < 4; ++k) text[random() % text.size()] = letters[random() % (sizeof letters - 1)];
    const Result<ObjLines> r = read_obj_lines(text, "f");
    if (!r) {
      ++refused_well;
      continue;
    }
    ++read_well;
    for (const auto& [a, b] : r.value().segments) {
      ASSERT_TRUE(a >= 0 && b >= 0 && std::max(a, b) < static_cast<int>(r.value().points.size()));
    }
    const Result<ImportedNetwork> network = import_network(r.value(), {});
    if (network) EXPECT_FALSE(network.value().model.rods.empty());
  }
  EXPECT_GT(read_well, 100);
  EXPECT_GT(refused_well, 100);
}

NetworkOptions lath() {
  NetworkOptions options;
  options.section = {SectionShape::kRectangle, {0.005}, {0.02}, 0};
  return options;
}

TEST(ImportNetwork, ChainsRunThroughPointsOfTwoLines) {
  // A ladder rung with bent stiles: points 1-2-3 nearly straight, 3-4 a corner, 2-5 a branch.
  const ObjLines lines = read(
      "v 0 0 0\nv 1000 0 0\nv 2000 100 0\nv 3000 100 0\nv 3000 2000 0\nv 1000 -900 0\n"
      "l 2 3\nl 1 2\nl 3 4\nl 4 5\nl 2 6\n");
  NetworkOptions options = lath();
  options.scale = 1e-3;
  const ImportedNetwork network = import_network(lines, options).value();
  EXPECT_TRUE(network.notes.empty());
  ASSERT_EQ(network.model.rods.size(), 4u);  // 2-3-4 is one chain, 4-5 starts at a corner
  EXPECT_LT((network.extent - Vec3(3, 2.9, 0)).norm(), 1e-12);
  EXPECT_EQ(std::get<Polyline>(network.model.rods[0].curve).points.size(), 3u);
  EXPECT_EQ(network.model.rods[0].edges, 8);
  const Structure s = discretize(network.model).value();
  EXPECT_EQ(s.joints.size(), 2u);
  EXPECT_EQ(s.components, 1);

  options.rods = NetworkRods::kSegments;
  const ImportedNetwork pieces = import_network(lines, options).value();
  EXPECT_EQ(pieces.model.rods.size(), 5u);
  EXPECT_EQ(discretize(pieces.model).value().joints.size(), 3u);
}

TEST(ImportNetwork, RingsCloseAndUselessLinesAreSaid) {
  std::string text;
  for (int i = 0; i < 24; ++i)
    text += "v " + std::to_string(std::cos(i * 0.2617993877991494)) + " " +
            std::to_string(std::sin(i * 0.2617993877991494)) + " 0\n";
  text += "v 1 0 0\nv 5 5 5\n";  // repeats point 1; isolated
  for (int i = 0; i < 23; ++i) text += "l " + std::to_string(i + 1) + " " + std::to_string(i + 2) + "\n";
  text += "l 24 25\nl 25 1\nl 2 1\nf 1 2 3\n";
  const ImportedNetwork network = import_network(read(text), lath()).value();
  ASSERT_EQ(network.model.rods.size(), 1u);
  EXPECT_TRUE(std::get<Polyline>(network.model.rods[0].curve).closed);
  EXPECT_EQ(std::get<Polyline>(network.model.rods[0].curve).points.size(), 24u);
  EXPECT_EQ(network.notes.size(), 5u);
  EXPECT_EQ(discretize(network.model).value().edges.size(), 96u);
}

TEST(ImportNetwork, GridHasARodPerLineAndItsBoundary) {
  ObjLines lines;
  constexpr int kSide = 6;
  for (int i = 0; i <= kSide; ++i) {
    for (int j = 0; j <= kSide; ++j) lines.points.emplace_back(i, j, 0.1 * i * j);
  }
  const auto at = [](int i, int j) { return i * (kSide + 1) + j; };
  for (int i = 0; i <= kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      lines.segments.push_back({at(i, j), at(i, j + 1)});
      lines.segments.push_back({at(j, i), at(j + 1, i)});
    }
  }
  const ImportedNetwork network = import_network(lines, lath()).value();
  EXPECT_EQ(network.model.rods.size(), 84u);
  const Structure s = discretize(network.model).value();
  EXPECT_EQ(s.joints.size(), 49u);
  Selector boundary;
  boundary.kind = Selector::Kind::kBoundary;
  EXPECT_EQ(select(network.model, s, boundary, "").value().size(), 24u);
}

TEST(ImportNetwork, WrongOptionsAndEmptyDrawingsAreRefused) {
  const ObjLines lines = read("v 0 0 0\nv 1 0 0\nl 1 2\n");
  NetworkOptions options = lath();
  options.scale = 0;
  EXPECT_FALSE(import_network(lines, options).ok());
  options = lath();
  options.edges_per_segment = 0;
  EXPECT_FALSE(import_network(lines, options).ok());
  EXPECT_FALSE(import_network(read("v 1 1 1\nv 1 1 1\nl 1 2\n"), lath()).ok());
  ObjLines broken = lines;
  broken.segments.push_back({0, 7});
  EXPECT_EQ(import_network(broken, lath()).error().code, ErrorCode::kRange);
}

}  // namespace
}  // namespace lissom
