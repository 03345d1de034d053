#pragma once
/// C1 curve of cubic Hermite pieces through points (Catmull-Rom): central-difference tangents, one-sided quadratic end
/// tangents, periodic when closed, parameter that grows by 1 per piece [mathematics 6.1, 6.2]. The one place that knows
/// the rule: curves, radii along rods, and the weights of control points all follow from it.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "lissom/core/assert.h"

namespace lissom {

/// T: anything with sums and multiples; double, Vec2, Vec3, PointWeights.
template <class T>
class HermiteCurve {
 public:
  /// At least two points.
  HermiteCurve(std::span<const T> points, bool closed) : points_(points.begin(), points.end()), closed_(closed) {
    const int n = static_cast<int>(points.size());
    const auto at = [&](int i) -> const T& { return points_[static_cast<std::size_t>((i + n) % n)]; };
    slopes_.reserve(points.size());
    for (int i = 0; i < n; ++i) {
      if (n == 2) {
        slopes_.push_back(at(1) - at(0));
      } else if (!closed && i == 0) {
        slopes_.push_back((-3 * at(0) + 4 * at(1) - at(2)) / 2);
      } else if (!closed && i == n - 1) {
        slopes_.push_back((3 * at(n - 1) - 4 * at(n - 2) + at(n - 3)) / 2);
      } else {
        slopes_.push_back((at(i + 1) - at(i - 1)) / 2);
      }
    }
  }

  int pieces() const { return static_cast<int>(points_.size()) - (closed_ ? 0 : 1); }

  /// s from 0 to 1.
  T point(int piece, double s) const {
    const std::size_t i = static_cast<std::size_t>(piece), j = (i + 1) % points_.size();
    const double r = 1 - s;
    return (1 + 2 * s) * r * r * points_[i] + s * r * r * slopes_[i] + s * s * (3 - 2 * s) * points_[j] +
           s * s * (s - 1) * slopes_[j];
  }

  /// Derivative with respect to s.
  T slope(int piece, double s) const {
    const std::size_t i = static_cast<std::size_t>(piece), j = (i + 1) % points_.size();
    return 6 * s * (1 - s) * (points_[j] - points_[i]) + (1 - s) * (1 - 3 * s) * slopes_[i] +
           s * (3 * s - 2) * slopes_[j];
  }

  /// Difference of the two points that bound a piece.
  T chord(int piece) const {
    const std::size_t i = static_cast<std::size_t>(piece), j = (i + 1) % points_.size();
    return points_[j] - points_[i];
  }

 private:
  std::vector<T> points_, slopes_;
  bool closed_;
};

/// A weighted sum of numbered points. Put through a HermiteCurve it says how a point of the curve hangs on them.
struct PointWeights {
  static constexpr int kMost = 6;  ///< a point of a curve hangs on four
  std::array<int, kMost> point{};
  std::array<double, kMost> weight{};
  int count = 0;

  PointWeights() = default;
  explicit PointWeights(int single) : count(1) {
    point[0] = single;
    weight[0] = 1;
  }

  PointWeights& operator+=(const PointWeights& o) {
    for (int k = 0; k < o.count; ++k) add(o.point[static_cast<std::size_t>(k)], o.weight[static_cast<std::size_t>(k)]);
    return *this;
  }
  PointWeights& operator*=(double factor) {
    for (double& w : weight) w *= factor;
    return *this;
  }
  friend PointWeights operator+(PointWeights a, const PointWeights& b) { return a += b; }
  friend PointWeights operator-(PointWeights a, const PointWeights& b) { return a += -1.0 * b; }
  friend PointWeights operator*(double factor, PointWeights a) { return a *= factor; }
  friend PointWeights operator/(PointWeights a, double divisor) { return a *= 1 / divisor; }

 private:
  void add(int which, double by) {
    for (int k = 0; k < count; ++k) {
      if (point[static_cast<std::size_t>(k)] != which) continue;
      weight[static_cast<std::size_t>(k)] += by;
      return;
    }
    LISSOM_ASSERT(count < kMost);
    point[static_cast<std::size_t>(count)] = which;
    weight[static_cast<std::size_t>(count++)] = by;
  }
};

}  // namespace lissom
