/// Cells on surfaces, and the networks between them.

#include "lissom/geometry/surface_cells.h"

#include <gtest/gtest.h>
#include <numeric>

#include "lissom/geometry/cell_network.h"
#include "lissom/geometry/surface_boundary.h"
#include "lissom/geometry/surface_topology.h"
#include "tests/unit/surface_samples.h"

namespace lissom {
namespace {

Surface flat(int cells, double size) {
  Surface sheet = samples::sheet(cells, cells, size);
  for (Vec3& x : sheet.vertices) x[2] = 0;
  return sheet;
}

std::vector<double> areas(const SurfaceCells& cells) {
  std::vector<double> area(cells.site.size(), 0);
  for (int t = 0; t < static_cast<int>(cells.fine.surface.triangles.size()); ++t) {
    const double whole = 0.5 * area_vector(cells.fine.surface, t).norm();
    for (const CellPiece& piece : cell_pieces(cells, t)) {
      for (std::size_t k = 2; k < piece.corners.size(); ++k) {
        const Mat3 w = (Mat3() << piece.corners[0], piece.corners[k - 1], piece.corners[k]).finished();
        area[static_cast<std::size_t>(piece.cell)] += whole * w.determinant();
      }
    }
  }
  return area;
}

TEST(Refinement, KeepsTheSurface) {
  const Surface sphere = samples::icosphere(2, 0.1);
  const RefinedSurface fine = refine_surface(sphere, [](double) { return 0.01; });
  double area = 0, before = 0, longest = 0;
  for (int t = 0; t < static_cast<int>(sphere.triangles.size()); ++t) before += area_vector(sphere, t).norm();
  for (int t = 0; t < static_cast<int>(fine.surface.triangles.size()); ++t) {
    area += area_vector(fine.surface, t).norm();
    for (int i = 0; i < 3; ++i) {
      const std::array<int, 3>& corner = fine.surface.triangles[static_cast<std::size_t>(t)];
      const Vec3 own = fine.surface.vertices[static_cast<std::size_t>(corner[static_cast<std::size_t>(i)])];
      const Vec3 next = fine.surface.vertices[static_cast<std::size_t>(corner[static_cast<std::size_t>((i + 1) % 3)])];
      longest = std::max(longest, (own - next).norm());
      // The same point, on the triangle that it came from.
      EXPECT_LT((position(sphere, fine.on_given({t, Vec3::Unit(i)})) - own).norm(), 1e-15);
    }
  }
  EXPECT_NEAR(area, before, 1e-12);
  EXPECT_LE(longest, 0.01);
  for (const int mate : side_mates(fine.surface.triangles)) EXPECT_GE(mate, 0);
}

TEST(Cells, AreAlikeOnASphere) {
  const Surface sphere = samples::icosphere(3, 0.1);
  const Result<SurfaceCells> made = tessellate(sphere, {.cells = 50}, "surface", {});
  ASSERT_TRUE(made.ok());
  const SurfaceCells& cells = made.value();
  EXPECT_EQ(cells.site.size(), 50u);
  EXPECT_LE(cells.movement, 2e-3);
  const std::vector<double> area = areas(cells);
  const double mean = std::accumulate(area.begin(), area.end(), 0.0) / 50;
  double whole = 0;
  for (int t = 0; t < static_cast<int>(sphere.triangles.size()); ++t) whole += 0.5 * area_vector(sphere, t).norm();
  EXPECT_NEAR(50 * mean, whole, 1e-9);
  for (const double a : area) {
    EXPECT_GT(a, 0.75 * mean);
    EXPECT_LT(a, 1.25 * mean);
  }
}

TEST(Cells, AreNarrowWhereItIsDark) {
  Surface sheet = flat(40, 0.2);
  for (const Vec3& x : sheet.vertices) sheet.darkness.push_back(x[0] > 0.1 ? 1 : 0);
  const Result<SurfaceCells> made = tessellate(sheet, {.cells = 100, .contrast = 2}, "surface", {});
  ASSERT_TRUE(made.ok());
  // Half as wide is a quarter of the area: four fifths of the cells are on the dark half.
  int dark = 0;
  for (const Vec3& x : made.value().site) dark += x[0] > 0.1 ? 1 : 0;
  EXPECT_NEAR(dark, 80, 6);
}

TEST(Cells, OfOneSeedAreTheSame) {
  const Surface torus = samples::torus(40, 20, 0.08, 0.03);
  const Result<SurfaceCells> a = tessellate(torus, {.cells = 40, .seed = 3}, "surface", {});
  const Result<SurfaceCells> b = tessellate(torus, {.cells = 40, .seed = 3}, "surface", {});
  const Result<SurfaceCells> c = tessellate(torus, {.cells = 40, .seed = 4}, "surface", {});
  ASSERT_TRUE(a.ok() && b.ok() && c.ok());
  EXPECT_EQ(a.value().site, b.value().site);
  EXPECT_EQ(a.value().cell, b.value().cell);
  EXPECT_NE(a.value().site, c.value().site);
}

TEST(Cells, AreAddedWhereOneWouldGoAllAround) {
  // A long thin ring: four cells would each be a piece of pipe.
  const Surface ring = samples::torus(120, 12, 0.1, 0.01);
  const Result<SurfaceCells> made = tessellate(ring, {.cells = 4}, "surface", {});
  ASSERT_TRUE(made.ok());
  EXPECT_GT(made.value().site.size(), 4u);
  EXPECT_FALSE(made.value().notes.empty());
}

TEST(Cells, RefuseWhatMakesNoMesh) {
  const Surface sphere = samples::icosphere(1, 0.1);
  const Result<SurfaceCells> few = tessellate(sphere, {.cells = 3}, "surface", {});
  ASSERT_FALSE(few.ok());
  EXPECT_EQ(few.error().where, "surface/cells");
  const Result<SurfaceCells> pale = tessellate(sphere, {.contrast = 0.5}, "surface", {});
  ASSERT_FALSE(pale.ok());
  EXPECT_EQ(pale.error().where, "surface/contrast");
  const Surface two = samples::together(sphere, sphere, Vec3(1, 0, 0));
  const Result<SurfaceCells> apart = tessellate(two, {}, "surface", {});
  ASSERT_FALSE(apart.ok());
  EXPECT_EQ(apart.error().code, ErrorCode::kGeometry);
}

/// Joints minus lines plus cells is Euler's number of the surface.
void expect_network(const Surface& surface, int cells, int euler) {
  const Result<SurfaceCells> made = tessellate(surface, {.cells = cells}, "surface", {});
  ASSERT_TRUE(made.ok());
  Result<SurfaceNetwork> network = cell_network(surface, made.value(), "surface");
  ASSERT_TRUE(network.ok());
  ASSERT_TRUE(find_paths(surface, network.value(), "surface").ok());
  ASSERT_TRUE(check_network(surface, network.value(), "surface").ok());
  const int joints = static_cast<int>(network.value().joints.size());
  const int lines = static_cast<int>(network.value().lines.size());
  EXPECT_EQ(joints - lines + static_cast<int>(made.value().site.size()), euler);
  int ends = 0;
  const std::vector<int> valences = network.value().valences();
  for (std::size_t j = 0; j < valences.size(); ++j) {
    ends += valences[j];
    EXPECT_EQ(valences[j], network.value().joints[j].kind == SurfaceJoint::Kind::kCorner ? 2 : 3);
  }
  EXPECT_EQ(ends, 2 * lines);
}

TEST(CellNetwork, HasEulersNumber) {
  expect_network(samples::icosphere(3, 0.1), 40, 2);
  expect_network(samples::torus(40, 20, 0.08, 0.03), 60, 0);
  expect_network(samples::sheet(20, 20, 0.2), 30, 1);
}

TEST(CellNetwork, RunsAlongTheBoundary) {
  const Surface sheet = flat(20, 0.2);
  const Result<SurfaceCells> made = tessellate(sheet, {.cells = 30}, "surface", {});
  ASSERT_TRUE(made.ok());
  const Result<SurfaceNetwork> network = cell_network(sheet, made.value(), "surface");
  ASSERT_TRUE(network.ok());
  double along = 0;
  int corners = 0;
  for (const SurfaceLine& line : network.value().lines) along += line.on_boundary ? path_length(sheet, line.path) : 0;
  for (const SurfaceJoint& joint : network.value().joints) corners += joint.kind == SurfaceJoint::Kind::kCorner ? 1 : 0;
  EXPECT_NEAR(along, 0.8, 1e-12);
  EXPECT_EQ(corners, 4);
}

}  // namespace
}  // namespace lissom
