// What is said against printing, and the files that are written.

#include "lissom/fabrication/print_checks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <gtest/gtest.h>
#include <numbers>
#include <set>

#include "lissom/fabrication/cube_cuts.h"
#include "lissom/fabrication/exporters.h"
#include "lissom/fabrication/near_rods.h"
#include "lissom/fabrication/solid_check.h"
#include "tests/unit/rod_nets.h"

namespace lissom {
namespace {

using testing::RodNet;

constexpr double kMm = 1e-3;

Section round(double r) { return {SectionShape::kEllipse, r * kMm, r * kMm, 0}; }

std::vector<NearRods> near_of(const RodNet& net, double gap = 0.5 * kMm) {
  return near_rods(rod_pieces(net.structure, 1e-4), gap);
}

TEST(NearRods, NamesRodsThatCrossWithoutAJoint) {
  RodNet net;
  net.line({-20 * kMm, 0, 0}, {20 * kMm, 0, 0}, round(1.5));
  net.line({0, -20 * kMm, 2 * kMm}, {0, 20 * kMm, 2 * kMm}, round(1.5));
  const std::vector<NearRods> near = near_of(net);
  ASSERT_EQ(near.size(), 1U);
  EXPECT_EQ(near[0].rod0, 0);
  EXPECT_EQ(near[0].rod1, 1);
  EXPECT_NEAR(near[0].gap, -1 * kMm, 0.1 * kMm);
  EXPECT_LT((near[0].place - Vec3(0, 0, 1 * kMm)).norm(), 0.6 * kMm);
}

TEST(NearRods, MeasuresGaps) {
  RodNet net;
  net.line({0, 0, 0}, {40 * kMm, 0, 0}, round(1.5));
  net.line({0, 3.3 * kMm, 0}, {40 * kMm, 3.3 * kMm, 0}, round(1.5));
  ASSERT_EQ(near_of(net).size(), 1U);
  EXPECT_NEAR(near_of(net)[0].gap, 0.3 * kMm, 1e-6);
  EXPECT_TRUE(near_of(net, 0.25 * kMm).empty());
}

/// Thick rods at both ends of a short one make one joint, also where the short one has a kink and is two pieces.
TEST(NearRods, ShortRodsMakeOneJointAlsoWithKinks) {
  for (const double kink : {0.0, 1.5}) {
    RodNet net;
    net.add({{0, 0, 0}, {2.5 * kMm, kink * kMm, 0}, {5 * kMm, 0, 0}}, round(1), round(1));
    net.line({0, 0, 0}, {-5 * kMm, 20 * kMm, 0}, round(2.6));
    net.line({5 * kMm, 0, 0}, {10 * kMm, 20 * kMm, 0}, round(2.6));
    EXPECT_TRUE(near_of(net).empty()) << kink;
  }
}

TEST(NearRods, JointsAreNoFault) {
  RodNet star;
  for (int k = 0; k < 5; ++k)
    star.line({0, 0, 0}, Vec3(std::cos(1.2566 * k), std::sin(1.2566 * k), 0) * 0.02, round(2));
  EXPECT_TRUE(near_of(star).empty());
  RodNet wedge;  // long together, since their joint
  wedge.line({0, 0, 0}, {30 * kMm, 0, 0}, round(1.5));
  wedge.line({0, 0, 0}, Vec3(std::cos(0.08), std::sin(0.08), 0) * 0.03, round(1.5));
  EXPECT_TRUE(near_of(wedge).empty());
  RodNet bridge;  // thick joints, with a rod between them that is shorter than these
  bridge.line({0, 0, 0}, {2 * kMm, 0, 0}, round(3));
  bridge.line({0, 0, 0}, {-12 * kMm, 15 * kMm, 0}, round(3));
  bridge.line({2 * kMm, 0, 0}, {14 * kMm, 15 * kMm, 0}, round(3));
  EXPECT_TRUE(near_of(bridge).empty());
}

TEST(NearRods, FindsRodsThatMeetAgain) {
  RodNet net;  // two arcs from one joint that cross once more
  std::vector<Vec3> left, right;
  for (int i = 0; i <= 20; ++i) {
    const double s = i / 20.0, x = 40 * kMm * s, y = 8 * kMm * std::sin(1.5 * std::numbers::pi * s);
    left.emplace_back(x, y, 0);
    right.emplace_back(x, -y, 0);
  }
  net.add(left, round(1), round(1));
  net.add(right, round(1), round(1));
  const std::vector<NearRods> near = near_of(net);
  ASSERT_EQ(near.size(), 1U);
  EXPECT_LT(near[0].gap, -1 * kMm);
  EXPECT_NEAR(near[0].place.x(), 40 * kMm * 2 / 3, 1 * kMm);
}

TEST(NearRods, FindsARodThatComesBackToItself) {
  RodNet net;
  std::vector<Vec3> points;
  for (int i = 0; i <= 24; ++i) {
    const double angle = (2 * std::numbers::pi - 0.02) * i / 24;
    points.emplace_back(Vec3(std::cos(angle), std::sin(angle), 0) * 15 * kMm);
  }
  net.add(points, round(1), round(1));
  const std::vector<NearRods> near = near_of(net);
  ASSERT_EQ(near.size(), 1U);
  EXPECT_EQ(near[0].rod0, near[0].rod1);
}

std::vector<PrintFinding> findings_of(const RodNet& net, const char* process) {
  const Result<std::vector<RodSolid>> solids = rod_solids(net.structure, {}, {});
  EXPECT_TRUE(solids.ok());
  return print_checks(net.structure, solids.value(), *find_process(process), 1e-4);
}

TEST(PrintChecks, ThinRodsDependOnTheProcess) {
  RodNet net;
  net.line({0, 0, 0}, {40 * kMm, 0, 0}, round(0.35));
  const std::vector<PrintFinding> findings = findings_of(net, "fdm");
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].what, "thin rod");
  EXPECT_NEAR(findings[0].value, 0.7 * kMm, 1e-9);
  EXPECT_NE(findings[0].where.find("rod-0 at ("), std::string::npos);
  EXPECT_TRUE(findings_of(net, "sla").empty());
}

TEST(PrintChecks, SaysByHowMuchTheBedIsTooSmall) {
  RodNet net;
  net.line({0, 0, 0}, {0, 230 * kMm, 0}, round(2));
  EXPECT_TRUE(findings_of(net, "fdm").empty()) << "turned by a quarter, it fits";
  const std::vector<PrintFinding> findings = findings_of(net, "sla");
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].what, "too large");
  EXPECT_NEAR(findings[0].value, 85 * kMm, 0.1 * kMm);
  EXPECT_NE(findings[0].remedy.find("85.0 mm too long"), std::string::npos);
}

TEST(PrintChecks, SaysWhatFitsOnlyStanding) {
  RodNet net;
  net.line({0, 0, 0}, {0, 280 * kMm, 0}, round(2));
  const std::vector<PrintFinding> findings = findings_of(net, "sls");
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].weight, PrintFinding::Weight::kWarning);
  EXPECT_EQ(findings[0].what, "fits only on another side");
  EXPECT_NE(findings[0].where.find("280.0 mm on a bed of"), std::string::npos);
}

TEST(PrintChecks, TubesArePrintedFull) {
  RodNet net;
  net.line({0, 0, 0}, {40 * kMm, 0, 0}, {SectionShape::kTube, 3 * kMm, 3 * kMm, 0.5 * kMm});
  const std::vector<PrintFinding> findings = findings_of(net, "fdm");
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].weight, PrintFinding::Weight::kWarning);
}

TEST(PrintProcesses, HaveNumbersAndSources) {
  for (const PrintProcess& process : print_processes()) {
    EXPECT_GT(process.diameter, 0);
    EXPECT_GT(process.gap, 0);
    EXPECT_GT(process.bed.minCoeff(), 0);
    EXPECT_GT(process.source.size(), 40U);
    EXPECT_EQ(find_process(process.name), &process);
  }
  EXPECT_EQ(find_process("cnc"), nullptr);
}

/// A tetrahedron with its corner at `place`.
Surface tetrahedron(const Vec3& place) {
  Surface s;
  s.vertices = {place, place + Vec3::UnitX(), place + Vec3::UnitY(), place + Vec3::UnitZ()};
  s.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return s;
}

Surface with(Surface a, const Surface& b) {
  const int offset = static_cast<int>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& t : b.triangles) a.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  return a;
}

TEST(SolidCheck, SeesWhatIsWrong) {
  const Surface good = tetrahedron(Vec3::Zero());
  EXPECT_TRUE(check_solid(good, {}).ok());
  EXPECT_NEAR(check_solid(good, {}).volume, 1.0 / 6, 1e-12);
  Surface open = good;
  open.triangles.pop_back();
  EXPECT_EQ(check_solid(open, {}).problem, "an edge has only one triangle");
  Surface turned = good;
  for (auto& t : turned.triangles) std::swap(t[0], t[1]);
  EXPECT_EQ(check_solid(turned, {}).problem, "a part of it is inside out");
  Surface doubled = good;
  doubled.triangles.push_back(doubled.triangles.front());
  EXPECT_EQ(check_solid(doubled, {}).problem, "an edge has more than two triangles");
  EXPECT_EQ(check_solid(with(good, tetrahedron(Vec3(0.2, 0.2, 0.1))), {}).problem, "two of its triangles intersect");
  EXPECT_TRUE(check_solid(with(good, tetrahedron(Vec3(2, 0, 0))), {}).ok());
  Surface pinched = with(good, tetrahedron(Vec3(2, 0, 0)));
  for (Vec3& x : pinched.vertices) x = x.x() >= 2 ? Vec3(Vec3(2, 0, 0) - x) : x;  // mirrored: inside out
  for (std::size_t t = 4; t < 8; ++t) {
    std::swap(pinched.triangles[t][0], pinched.triangles[t][1]);
    for (int& v : pinched.triangles[t]) v = v == 4 ? 0 : v;  // both corners in one vertex
  }
  EXPECT_EQ(check_solid(pinched, {}).problem, "parts of it touch in a single vertex");
}

TEST(SolidCheck, FillsCavities) {
  Surface hollow = tetrahedron(Vec3::Zero());
  Surface inner = tetrahedron(Vec3(0.1, 0.1, 0.1));
  for (Vec3& x : inner.vertices) x = Vec3(0.1, 0.1, 0.1) + 0.2 * (x - Vec3(0.1, 0.1, 0.1));
  for (auto& t : inner.triangles) std::swap(t[0], t[1]);
  hollow = with(hollow, inner);
  EXPECT_EQ(fill_cavities(hollow), 1);
  EXPECT_NEAR(check_solid(hollow, {}).volume, 1.0 / 6, 1e-12);
}

TEST(SolidCheck, DropsFlakes) {
  Surface flake = tetrahedron(Vec3::Zero());
  for (Vec3& x : flake.vertices) x = 1e-3 * x + Vec3(2, 0, 0);
  Surface both = with(tetrahedron(Vec3::Zero()), flake);
  EXPECT_EQ(drop_flakes(both, 1e-10), 0);
  EXPECT_EQ(drop_flakes(both, 1e-9), 1);
  EXPECT_EQ(both.triangles.size(), 4u);
  EXPECT_EQ(check_solid(both, {}).parts, 1);
}

/// Directed segments of a case on a side of the cube, as pairs of cut edges named by their two corners.
std::multiset<std::array<int, 4>> segments_on(int which, int axis, int level) {
  const auto corners = [](int edge) {
    const CubeEdge& e = cube_edges()[edge];
    return std::array<int, 2>{e.from, e.from | 1 << e.axis};
  };
  const auto on_side = [&](int edge) {
    if (edge >= kCubeEdges) return false;
    const auto [a, b] = corners(edge);
    return (a >> axis & 1) == level && (b >> axis & 1) == level;
  };
  std::multiset<std::array<int, 4>> found;
  for (const auto& t : cube_cuts()[which].triangles) {
    for (int k = 0; k < 3; ++k) {
      const int from = t[k], to = t[(k + 1) % 3];
      if (!on_side(from) || !on_side(to)) continue;
      const int mask = ~(1 << axis);
      found.insert({corners(from)[0] & mask, corners(from)[1] & mask, corners(to)[0] & mask, corners(to)[1] & mask});
    }
  }
  return found;
}

TEST(CubeCuts, NeighboursAgreeOnTheirSide) {
  int compared = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (int a = 0; a < 256; ++a) {
      for (int b = 0; b < 256; ++b) {
        bool same = true;
        for (int c = 0; c < 8; ++c) {
          if ((c >> axis & 1) == 1) same = same && (a >> c & 1) == (b >> (c & ~(1 << axis)) & 1);
        }
        if (!same) continue;
        std::multiset<std::array<int, 4>> reversed;
        for (const auto& s : segments_on(b, axis, 0)) reversed.insert({s[2], s[3], s[0], s[1]});
        ASSERT_EQ(segments_on(a, axis, 1), reversed) << a << " and " << b << " along " << axis;
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 3 * 256 * 16);
}

PrintObjects two_objects() {
  Surface surface = tetrahedron(Vec3::Zero());
  for (Vec3& x : surface.vertices) x *= 0.01;
  return {"Two <objects> & \"more\"", {{"TPU 92A", surface}, {"PLA", surface}}};
}

TEST(Exporters, AreChosenByTheEnding) {
  EXPECT_EQ(exporter_for("a/b.3mf").value()->ending, ".3mf");
  EXPECT_EQ(exporter_for("B.STL").value()->ending, ".stl");
  EXPECT_EQ(exporter_for("b.obj").error().code, ErrorCode::kUnsupported);
  EXPECT_NE(exporter_for("b").error().message.find(".3mf, .stl"), std::string::npos);
}

TEST(Exporters, StlIsBinaryInMillimetres) {
  PrintObjects objects = two_objects();
  EXPECT_EQ(export_stl(objects).error().code, ErrorCode::kConflict);
  objects.objects.pop_back();
  const std::string bytes = export_stl(objects).value();
  ASSERT_EQ(bytes.size(), 84U + 4 * 50);
  EXPECT_NE(bytes.substr(0, 5), "solid");
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, 4);
  EXPECT_EQ(count, 4U);
  float corner[12];
  std::memcpy(corner, bytes.data() + 84 + 3 * 50, sizeof corner);  // the slanted side
  EXPECT_NEAR(corner[0], 1 / std::sqrt(3.0), 1e-6);
  EXPECT_EQ(corner[3], 10.0F);
}

TEST(Exporters, BytesAreTheSameTwice) {
  const std::string bytes = export_3mf(two_objects()).value();
  EXPECT_EQ(bytes, export_3mf(two_objects()).value());
  EXPECT_EQ(bytes.substr(0, 2), "PK");
}

}  // namespace
}  // namespace lissom
