#include "lissom/design/objective_surface_distance.h"

#include <utility>

#include "lissom/core/assert.h"
#include "lissom/mechanics/rest_numbers.h"

namespace lissom {

namespace {

constexpr double kFelt = 0.01;      // of the size of the structure
constexpr double kTouching = 1e-9;  // of that size: nearer than this, a node lies on the surface

class SurfaceDistance final : public Objective {
 public:
  SurfaceDistance(std::shared_ptr<const TriangleSurface> surface, std::vector<int> nodes, DistanceKind kind)
      : surface_(std::move(surface)), nodes_(std::move(nodes)), kind_(kind) {}

  std::string_view name() const override { return "distance to a surface"; }
  std::string_view unit() const override { return "m"; }
  int size() const override { return (kind_ == DistanceKind::kVector ? 3 : 1) * static_cast<int>(nodes_.size()); }
  double scale(const PoseShape& shape) const override { return kFelt * shape.design.system.structure.size; }

  void values(const PoseShape& shape, VecX& c) const override {
    c.resize(size());
    for (int k = 0; k < static_cast<int>(nodes_.size()); ++k) {
      const Vec3 p = shape.state.position(nodes_[k]);
      const NearestPoint near = surface_->nearest(p);
      const Vec3 away = p - near.point;
      if (kind_ == DistanceKind::kVector) {
        c.segment<3>(3 * k) = away;
      } else {
        c[k] = away.dot(near.normal) < 0 ? -away.norm() : away.norm();
      }
    }
  }

  void jacobian(const PoseShape& shape, SparseRows& by_q, SparseRows& by_numbers) const override {
    std::vector<Eigen::Triplet<double>> entries;
    for (int k = 0; k < static_cast<int>(nodes_.size()); ++k) {
      const NearestPoint near = surface_->nearest(shape.state.position(nodes_[k]));
      if (kind_ == DistanceKind::kVector) {
        for (int i = 0; i < 9; ++i)
          entries.emplace_back(3 * k + i / 3, 3 * nodes_[k] + i % 3, near.across(i / 3, i % 3));
      } else {
        const Vec3 direction = outwards(shape, k, near).direction;
        for (int i = 0; i < 3; ++i) entries.emplace_back(k, 3 * nodes_[k] + i, direction[i]);
      }
    }
    by_q.resize(size(), shape.design.system.layout.size());
    by_q.setFromTriplets(entries.begin(), entries.end());
    by_numbers.resize(size(), RestNumbers(shape.design.system.structure).size());
  }

  void curvature(const PoseShape& shape, const VecX& y, const VecX& dq, const VecX&, VecX& by_q, VecX&) const override {
    if (kind_ == DistanceKind::kVector) return;
    for (int k = 0; k < static_cast<int>(nodes_.size()); ++k) {
      const NearestPoint near = surface_->nearest(shape.state.position(nodes_[k]));
      const Outwards out = outwards(shape, k, near);
      if (out.distance == 0) continue;
      const Vec3 d = dq.segment<3>(3 * nodes_[k]);
      // Over the inside of a triangle both cancel.
      const Vec3 change = near.across * d - out.direction * out.direction.dot(d);
      by_q.segment<3>(3 * nodes_[k]) += y[k] / out.distance * change;
    }
  }

 private:
  /// Direction in which the signed distance grows; the distance is 0 where that direction is a matter of choice.
  struct Outwards {
    Vec3 direction;
    double distance = 0;
  };
  Outwards outwards(const PoseShape& shape, int k, const NearestPoint& near) const {
    const Vec3 away = shape.state.position(nodes_[k]) - near.point;
    const double length = away.norm();
    if (length <= kTouching * shape.design.system.structure.size) return {near.normal, 0};
    const double distance = away.dot(near.normal) < 0 ? -length : length;
    return {away / distance, distance};
  }

  std::shared_ptr<const TriangleSurface> surface_;
  std::vector<int> nodes_;
  DistanceKind kind_;
};

}  // namespace

std::shared_ptr<const Objective> make_surface_distance(std::shared_ptr<const TriangleSurface> surface,
                                                       std::vector<int> nodes, DistanceKind kind) {
  LISSOM_ASSERT(surface != nullptr);
  return std::make_shared<SurfaceDistance>(std::move(surface), std::move(nodes), kind);
}

}  // namespace lissom
