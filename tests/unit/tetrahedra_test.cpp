/// Tetrahedra in closed surfaces, and points that they carry along.

#include "lissom/geometry/tetrahedra.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

#include "lissom/core/file_io.h"
#include "lissom/geometry/frame.h"
#include "lissom/geometry/surface_file.h"
#include "lissom/geometry/surface_topology.h"
#include "lissom/geometry/tetrahedra_embedding.h"
#include "lissom/geometry/tetrahedron_faces.h"

namespace lissom {
namespace {

/// A ring of radius `ring` around the z axis, whose tube has the radius `tube` (m).
Surface torus(double ring, double tube, int around, int across) {
  Surface surface;
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * j / across;
      const double r = ring + tube * std::cos(v);
      surface.vertices.emplace_back(r * std::cos(u), r * std::sin(u), tube * std::sin(v));
    }
  }
  const auto at = [&](int i, int j) { return i % around * across + j % across; };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      surface.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      surface.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return surface;
}

/// Six times the square root of two times the volume over the cubed root-mean-square side: 1 for a regular tetrahedron.
std::vector<double> qualities(const TetrahedralMesh& mesh) {
  std::vector<double> all;
  for (const auto& t : mesh.tetrahedra) {
    double squares = 0;
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < i; ++j) squares += (mesh.points[t[i]] - mesh.points[t[j]]).squaredNorm() / 6;
    }
    const Vec3& a = mesh.points[t[0]];
    const double six_volumes = (mesh.points[t[1]] - a).cross(mesh.points[t[2]] - a).dot(mesh.points[t[3]] - a);
    all.push_back(std::numbers::sqrt2 * six_volumes / std::pow(squares, 1.5));
  }
  std::sort(all.begin(), all.end());
  return all;
}

Surface outside_of(const TetrahedralMesh& mesh) { return {mesh.points, outer_faces(mesh.tetrahedra), {}}; }

TetrahedralMesh filled(const Surface& surface, const TetrahedralOptions& options) {
  Result<TetrahedralMesh> mesh = fill_surface(surface, options);
  EXPECT_TRUE(mesh) << (mesh ? "" : mesh.error().text());
  return mesh ? std::move(mesh).value() : TetrahedralMesh();
}

TEST(Tetrahedra, FillATorus) {
  const double ring = 0.06, tube = 0.02;
  const Surface surface = torus(ring, tube, 60, 24);
  TetrahedralOptions options;
  options.cell_size = 0.008;
  options.facet_distance = 0.0005;
  const TetrahedralMesh mesh = filled(surface, options);
  ASSERT_GT(mesh.tetrahedra.size(), 1000u);
  ASSERT_LT(mesh.tetrahedra.size(), 10000u);
  EXPECT_GT(qualities(mesh).front(), 0.1);
  const Surface outside = outside_of(mesh);
  EXPECT_NEAR(enclosed_volume(outside) / enclosed_volume(surface), 1, 0.03);
  std::vector<char> used(mesh.points.size(), 0);
  for (const auto& t : mesh.tetrahedra) {
    for (const int i : t) used[static_cast<size_t>(i)] = 1;
  }
  EXPECT_EQ(std::count(used.begin(), used.end(), 0), 0);
  // A closed ring as before: every edge of the outer faces has two of them, and corners - edges + faces = 0.
  const std::vector<int> mates = side_mates(outside.triangles);
  EXPECT_GE(*std::min_element(mates.begin(), mates.end()), 0);
  std::vector<char> outer(mesh.points.size(), 0);
  for (const auto& t : outside.triangles) {
    for (const int i : t) outer[static_cast<size_t>(i)] = 1;
  }
  const auto corners = std::count(outer.begin(), outer.end(), 1), faces = static_cast<long>(outside.triangles.size());
  EXPECT_EQ(corners - 3 * faces / 2 + faces, 0);
  for (size_t i = 0; i < mesh.points.size(); ++i) {
    if (!outer[i]) continue;
    const Vec3& p = mesh.points[i];
    EXPECT_NEAR(std::hypot(std::hypot(p.x(), p.y()) - ring, p.z()), tube, 0.0005);
  }
}

TEST(Tetrahedra, SameSurfaceSameBytes) {
  const Surface surface = torus(0.05, 0.02, 30, 15);
  TetrahedralOptions options;
  options.cell_size = 0.01;
  const TetrahedralMesh first = filled(surface, options);
  TetrahedralOptions finer = options;
  finer.cell_size = 0.008;
  const TetrahedralMesh other = filled(surface, finer);
  EXPECT_GT(other.tetrahedra.size(), first.tetrahedra.size());
  const TetrahedralMesh again = filled(surface, options);
  EXPECT_EQ(again.tetrahedra, first.tetrahedra);
  EXPECT_EQ(again.points, first.points);
}

TEST(Tetrahedra, CarryPointsAlong) {
  const Surface surface = torus(0.06, 0.02, 48, 20);
  TetrahedralOptions options;
  options.cell_size = 0.01;
  options.facet_distance = 0.001;
  const TetrahedralMesh mesh = filled(surface, options);
  const SolidEmbedding embedding(mesh, surface.vertices);
  ASSERT_EQ(embedding.points().size(), surface.vertices.size());
  EXPECT_LT(embedding.farthest_outside(), 0.002);
  EXPECT_GT(embedding.farthest_outside(), 0);
  for (const EmbeddedPoint& point : embedding.points()) {
    EXPECT_NEAR(point.weights[0] + point.weights[1] + point.weights[2] + point.weights[3], 1, 1e-12);
    EXPECT_GT(*std::min_element(point.weights.begin(), point.weights.end()), -0.6);
  }
  Mat3 map = rotation_from_vector(Vec3(0.3, 1, -0.4));
  map.col(1) *= 1.7;
  const Vec3 shift(0.1, -0.2, 0.05);
  std::vector<Vec3> moved;
  for (const Vec3& p : mesh.points) moved.push_back(map * p + shift);
  const std::vector<Vec3> carried = embedding.carried(moved);
  for (size_t i = 0; i < carried.size(); ++i) {
    EXPECT_LT((carried[i] - (map * surface.vertices[i] + shift)).norm(), 1e-13);
  }
}

/// Against a look at all tetrahedra, for points inside, near, and far away.
TEST(Tetrahedra, EmbeddingFindsTheTetrahedronThatHoldsAPoint) {
  TetrahedralOptions options;
  options.cell_size = 0.012;
  const TetrahedralMesh mesh = filled(torus(0.05, 0.02, 30, 15), options);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> uniform(-0.08, 0.08);
  std::vector<Vec3> points;
  for (int i = 0; i < 400; ++i) points.emplace_back(uniform(random), uniform(random), 0.5 * uniform(random));
  points.emplace_back(1, 2, -3);
  const SolidEmbedding embedding(mesh, points);
  int inside = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    const EmbeddedPoint& found = embedding.points()[i];
    const double least = *std::min_element(found.weights.begin(), found.weights.end());
    bool held = false;
    for (const auto& t : mesh.tetrahedra) {
      bool all = true;
      for (int skipped = 0; skipped < 4; ++skipped) {
        std::array<Vec3, 4> x;
        for (int k = 0; k < 4; ++k) x[k] = k == skipped ? points[i] : mesh.points[t[k]];
        all = all && (x[1] - x[0]).cross(x[2] - x[0]).dot(x[3] - x[0]) >= 0;
      }
      held = held || all;
    }
    EXPECT_EQ(held, least >= -1e-12) << points[i].transpose();
    inside += held;
  }
  EXPECT_GT(inside, 50);
  EXPECT_LT(inside, 300);
  EXPECT_NEAR(embedding.farthest_outside(), Vec3(1, 2, -3).norm(), 0.08);
}

TEST(Tetrahedra, WhatHoldsNoVolumeIsRefusedWithItsPlace) {
  const Surface closed = torus(0.05, 0.02, 30, 15);
  TetrahedralOptions options;
  options.cell_size = 0.01;
  const auto message = [&](const Surface& surface, const TetrahedralOptions& with) {
    const Result<TetrahedralMesh> mesh = fill_surface(surface, with);
    EXPECT_FALSE(mesh);
    if (mesh) return std::string();
    EXPECT_FALSE(mesh.error().hint.empty());
    return mesh.error().where + ": " + mesh.error().message;
  };
  Surface open = closed;
  open.triangles.erase(open.triangles.begin());
  EXPECT_NE(message(open, options).find("the surface is open"), std::string::npos);
  EXPECT_EQ(message(open, options).find("near (68.39, 7.097, 4.067) mm"), 0u) << message(open, options);
  Surface turned = closed;
  std::swap(turned.triangles[7][0], turned.triangles[7][1]);
  EXPECT_NE(message(turned, options).find("run the same way"), std::string::npos);
  Surface crowded = closed;
  crowded.triangles.push_back(crowded.triangles[3]);
  EXPECT_NE(message(crowded, options).find("more than two triangles"), std::string::npos);
  Surface inwards = closed;
  for (auto& t : inwards.triangles) std::swap(t[0], t[1]);
  EXPECT_NE(message(inwards, options).find("the surface holds -"), std::string::npos);
  Surface missing = closed;
  missing.triangles[5][1] = 10000;
  EXPECT_EQ(message(missing, options), "triangle 5: there is no vertex 10000");
  Surface endless = closed;
  endless.vertices[4].x() = std::nan("");
  EXPECT_EQ(message(endless, options).find("vertex 4"), 0u);
  EXPECT_EQ(message({}, options), "surface: the surface has no triangles");
  TetrahedralOptions tiny = options;
  tiny.cell_size = 1e-5;
  EXPECT_EQ(message(closed, tiny).find("cell_size: about "), 0u);
  EXPECT_EQ(message(closed, {}).find("cell_size: "), 0u);
  tiny = options;
  tiny.facet_angle = 1;
  EXPECT_EQ(message(closed, tiny).find("facet_angle: "), 0u);
}

/// A cow by others, 0.21 m long; time and quality are printed.
TEST(Tetrahedra, FillACow) {
  constexpr const char* kFile = "../shared/data/spot.obj";
  if (!std::filesystem::exists(kFile)) {
    GTEST_SKIP() << kFile << " is not here: a model by others, which the repository does not carry";
  }
  const Result<RawSurface> raw = read_surface(read_file(kFile).value(), "spot.obj");
  ASSERT_TRUE(raw) << raw.error().text();
  Surface surface{raw.value().points, raw.value().triangles, {}};
  Vec3 low = surface.vertices[0], high = low;
  for (const Vec3& p : surface.vertices) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  for (Vec3& p : surface.vertices) p *= 0.21 / (high - low).maxCoeff();
  TetrahedralOptions options;
  options.cell_size = 0.0085;
  options.facet_distance = 0.001;
  const auto begin = std::chrono::steady_clock::now();
  const TetrahedralMesh mesh = filled(surface, options);
  const std::chrono::duration<double> filling = std::chrono::steady_clock::now() - begin;
  const SolidEmbedding embedding(mesh, surface.vertices);
  const std::chrono::duration<double> both = std::chrono::steady_clock::now() - begin;
  const std::vector<double> quality = qualities(mesh);
  const double volume = enclosed_volume(outside_of(mesh)) / enclosed_volume(surface);
  std::printf(
      "%zu tetrahedra in %.1f s, %zu points embedded in %.2f s; quality at least %.2f, median %.2f; %.1f %% of "
      "the volume; vertices at most %.2f mm outside\n",
      mesh.tetrahedra.size(), filling.count(), surface.vertices.size(), (both - filling).count(), quality.front(),
      quality[quality.size() / 2], 100 * volume, 1e3 * embedding.farthest_outside());
  EXPECT_GT(mesh.tetrahedra.size(), 5000u);
  EXPECT_LT(mesh.tetrahedra.size(), 15000u);
  EXPECT_GT(quality.front(), 0.1);
  EXPECT_NEAR(volume, 1, 0.02);
  EXPECT_LT(embedding.farthest_outside(), 0.003);
}

}  // namespace
}  // namespace lissom
