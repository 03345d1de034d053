#include "lissom/geometry/tetrahedra_embedding.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "lissom/core/assert.h"
#include "lissom/geometry/tetrahedra.h"
#include "lissom/geometry/triangle_point.h"

namespace lissom {

namespace {

using Index3 = std::array<std::int64_t, 3>;

constexpr double kTie = 1e-9;  // of the size of a cell: distances that are this close are alike

struct Corners {
  std::array<Vec3, 4> x;

  std::array<double, 4> weights(const Vec3& p) const {
    Mat3 sides;
    for (int i = 0; i < 3; ++i) sides.col(i) = x[static_cast<std::size_t>(i) + 1] - x[0];
    const Vec3 w = sides.inverse() * (p - x[0]);
    return {1 - w.sum(), w[0], w[1], w[2]};
  }
  /// m; 0 inside.
  double distance(const Vec3& p, const std::array<double, 4>& weights) const {
    if (*std::min_element(weights.begin(), weights.end()) >= 0) return 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t skipped = 0; skipped < 4; ++skipped) {
      const Vec3 &a = x[(skipped + 1) % 4], &b = x[(skipped + 2) % 4], &c = x[(skipped + 3) % 4];
      const Vec3 w = nearest_in_triangle(a, b, c, p);
      least = std::min(least, (w[0] * a + w[1] * b + w[2] * c - p).norm());
    }
    return least;
  }
};

/// Boxes of equal size with the tetrahedra whose bounding boxes reach into them.
class Boxes {
 public:
  explicit Boxes(const TetrahedralMesh& mesh) : mesh_(mesh) {
    Vec3 high = mesh.points[0];
    low_ = high;
    for (const Vec3& p : mesh.points) {
      low_ = low_.cwiseMin(p);
      high = high.cwiseMax(p);
    }
    // About one tetrahedron to a box.
    const Vec3 size = (high - low_).cwiseMax(1e-3 * (high - low_).maxCoeff());
    side_ = std::cbrt(size.prod() / static_cast<double>(mesh.tetrahedra.size()));
    for (int k = 0; k < 3; ++k) count_[static_cast<std::size_t>(k)] = 1 + static_cast<std::int64_t>(size[k] / side_);
    first_.assign(static_cast<std::size_t>(count_[0] * count_[1] * count_[2]) + 1, 0);
    for_each_entry([&](std::size_t box, int) { ++first_[box + 1]; });
    for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
    tetrahedra_.resize(static_cast<std::size_t>(first_.back()));
    std::vector<int> next(first_.begin(), first_.end() - 1);
    for_each_entry([&](std::size_t box, int t) { tetrahedra_[static_cast<std::size_t>(next[box]++)] = t; });
  }

  /// The tetrahedron that a point belongs to, with its distance (m).
  EmbeddedPoint find(const Vec3& p, double& distance) const {
    EmbeddedPoint best;
    distance = std::numeric_limits<double>::infinity();
    double inside = 0;  // least weight in the best
    const Index3 middle = box_at(p);
    const double gap =
        (p - p.cwiseMax(low_).cwiseMin(low_ + side_ * Vec3(double(count_[0]), double(count_[1]), double(count_[2]))))
            .norm();
    const std::int64_t most = *std::max_element(count_.begin(), count_.end());
    for (std::int64_t ring = 0; ring <= most; ++ring) {
      // Boxes of this ring are at least so far away.
      if (std::max(gap, static_cast<double>(ring - 1) * side_) > distance + kTie * side_) break;
      for_each_in_ring(middle, ring, [&](int t) {
        const Corners corners = corners_of(t);
        const std::array<double, 4> weights = corners.weights(p);
        const double own = corners.distance(p, weights), least = *std::min_element(weights.begin(), weights.end());
        const bool nearer = own < distance - kTie * side_;
        if (!nearer &&
            !(own <= distance + kTie * side_ && (least > inside || (least == inside && t < best.tetrahedron))))
          return;
        distance = std::min(distance, own);
        inside = least;
        best = {t, weights};
      });
    }
    return best;
  }

 private:
  Corners corners_of(int t) const {
    Corners corners;
    for (std::size_t i = 0; i < 4; ++i) {
      corners.x[i] = mesh_.points[static_cast<std::size_t>(mesh_.tetrahedra[static_cast<std::size_t>(t)][i])];
    }
    return corners;
  }
  Index3 box_at(const Vec3& p) const {
    Index3 box{};
    for (std::size_t k = 0; k < 3; ++k) {
      const double place = std::floor((p[static_cast<int>(k)] - low_[static_cast<int>(k)]) / side_);
      box[k] = static_cast<std::int64_t>(std::clamp(place, 0.0, static_cast<double>(count_[k] - 1)));
    }
    return box;
  }
  std::size_t number(const Index3& box) const {
    return static_cast<std::size_t>(box[0] + count_[0] * (box[1] + count_[1] * box[2]));
  }

  template <class F>
  void for_each_entry(const F& f) const {
    for (int t = 0; t < static_cast<int>(mesh_.tetrahedra.size()); ++t) {
      const Corners corners = corners_of(t);
      Vec3 low = corners.x[0], high = low;
      for (const Vec3& p : corners.x) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
      }
      const Index3 begin = box_at(low), end = box_at(high);
      for (Index3 box = begin; box[2] <= end[2]; ++box[2]) {
        for (box[1] = begin[1]; box[1] <= end[1]; ++box[1]) {
          for (box[0] = begin[0]; box[0] <= end[0]; ++box[0]) f(number(box), t);
        }
      }
    }
  }

  /// Tetrahedra in the boxes whose largest step from `middle` along an axis is `ring`.
  template <class F>
  void for_each_in_ring(const Index3& middle, std::int64_t ring, const F& f) const {
    Index3 begin{}, end{};
    for (std::size_t k = 0; k < 3; ++k) {
      begin[k] = std::max<std::int64_t>(0, middle[k] - ring);
      end[k] = std::min(count_[k] - 1, middle[k] + ring);
    }
    for (Index3 box = begin; box[2] <= end[2]; ++box[2]) {
      for (box[1] = begin[1]; box[1] <= end[1]; ++box[1]) {
        for (box[0] = begin[0]; box[0] <= end[0]; ++box[0]) {
          std::int64_t step = 0;
          for (std::size_t k = 0; k < 3; ++k) step = std::max(step, std::abs(box[k] - middle[k]));
          if (step != ring) continue;
          const std::size_t at = number(box);
          for (int i = first_[at]; i < first_[at + 1]; ++i) f(tetrahedra_[static_cast<std::size_t>(i)]);
        }
      }
    }
  }

  const TetrahedralMesh& mesh_;
  Vec3 low_;
  double side_ = 0;
  Index3 count_{};
  std::vector<int> first_, tetrahedra_;
};

}  // namespace

SolidEmbedding::SolidEmbedding(const TetrahedralMesh& mesh, std::span<const Vec3> points)
    : tetrahedra_(mesh.tetrahedra) {
  LISSOM_ASSERT(!mesh.tetrahedra.empty());
  const Boxes boxes(mesh);
  points_.reserve(points.size());
  for (const Vec3& p : points) {
    double distance = 0;
    points_.push_back(boxes.find(p, distance));
    farthest_outside_ = std::max(farthest_outside_, distance);
  }
}

std::vector<Vec3> SolidEmbedding::carried(std::span<const Vec3> positions) const {
  std::vector<Vec3> places;
  places.reserve(points_.size());
  for (const EmbeddedPoint& point : points_) {
    Vec3 x = Vec3::Zero();
    for (std::size_t i = 0; i < 4; ++i) {
      const int corner = tetrahedra_[static_cast<std::size_t>(point.tetrahedron)][i];
      x += point.weights[i] * positions[static_cast<std::size_t>(corner)];
    }
    places.push_back(x);
  }
  return places;
}

}  // namespace lissom
