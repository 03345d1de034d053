#include "lissom/view/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace lissom {

using std::numbers::pi;

Viewpoint Viewpoint::iso() { return {.azimuth = -pi / 3, .elevation = std::atan(std::sqrt(0.5))}; }
Viewpoint Viewpoint::top() { return {.azimuth = -pi / 2, .elevation = pi / 2}; }
Viewpoint Viewpoint::front() { return {.azimuth = -pi / 2, .elevation = 0}; }
Viewpoint Viewpoint::right() { return {.azimuth = 0, .elevation = 0}; }

Status Viewpoint::validate() const {
  if (!std::isfinite(azimuth) || !(std::abs(elevation) <= pi / 2 + 1e-9)) {
    return Error{ErrorCode::kRange, "view", "the direction of view is not possible",
                 "azimuth must be finite, elevation between -90 and 90 degrees"};
  }
  if (!(opening > 0.01 && opening < 2.5)) {
    return Error{ErrorCode::kRange, "view", "the opening angle is not possible", "use 1 to 140 degrees"};
  }
  return {};
}

Camera::Camera(const Viewpoint& view, std::span<const Vec3> points, std::span<const double> radii, const Vec2& corner,
               const Vec2& size) {
  const double ca = std::cos(view.azimuth), sa = std::sin(view.azimuth);
  const double ce = std::cos(view.elevation), se = std::sin(view.elevation);
  towards_ = Vec3(ce * ca, ce * sa, se);
  right_ = Vec3(-sa, ca, 0);
  up_ = Vec3(-se * ca, -se * sa, ce);

  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  const auto seen = [&](const Vec3& p) { return Vec3(right_.dot(p), up_.dot(p), towards_.dot(p)); };
  for (size_t i = 0; i < points.size(); ++i) {
    low = low.cwiseMin(seen(points[i]) - Vec3::Constant(radii[i]));
    high = high.cwiseMax(seen(points[i]) + Vec3::Constant(radii[i]));
  }
  const Vec3 middle = (low + high) / 2;
  centre_ = right_ * middle.x() + up_ * middle.y() + towards_ * middle.z();
  if (view.projection == Projection::kPerspective) {
    distance_ = (high - low).norm() / 2 / std::sin(view.opening / 2);
  }
  Vec2 page_low = Vec2::Constant(std::numeric_limits<double>::infinity()), page_high = -page_low;
  for (size_t i = 0; i < points.size(); ++i) {
    const Vec2 p = project(points[i]);
    const double r = radii[i] * magnification(points[i]);
    page_low = page_low.cwiseMin(p - Vec2::Constant(r));
    page_high = page_high.cwiseMax(p + Vec2::Constant(r));
  }
  const Vec2 extent = (page_high - page_low).cwiseMax(1e-12);
  zoom_ = std::min(size.x() / extent.x(), size.y() / extent.y());
  middle_ = corner + size / 2 - zoom_ * (page_low + page_high) / 2;
}

double Camera::magnification(const Vec3& point) const {
  if (distance_ == 0) return 1;
  return distance_ / std::max(distance_ - depth(point), 1e-3 * distance_);
}

Vec2 Camera::project(const Vec3& point) const {
  const Vec3 d = point - centre_;
  return middle_ + Vec2(right_.dot(d), -up_.dot(d)) * (zoom_ * magnification(point));
}

double Camera::scale(const Vec3& point) const { return zoom_ * magnification(point); }

Vec3 Camera::towards_eye(const Vec3& point) const {
  if (distance_ == 0) return towards_;
  return (centre_ + towards_ * distance_ - point).normalized();
}

}  // namespace lissom
