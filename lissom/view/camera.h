#pragma once
/// From space to the page.

#include <span>

#include "lissom/core/result.h"
#include "lissom/core/types.h"

namespace lissom {

enum class Projection { kOrthographic, kPerspective };

/// Where to look from. z is up.
struct Viewpoint {
  double azimuth = 0;    ///< rad, direction from the content to the eye, counter-clockwise from +x about z
  double elevation = 0;  ///< rad, -pi/2 to pi/2
  Projection projection = Projection::kOrthographic;
  double opening = 0.5;  ///< rad, angle that the content fills in perspective

  static Viewpoint iso();    ///< from front right above
  static Viewpoint top();    ///< along -z, x to the right
  static Viewpoint front();  ///< along +y, x to the right
  static Viewpoint right();  ///< along -x, y to the right

  Status validate() const;
};

/// Page coordinates (px, y down) and depth (m, larger is nearer to the eye) of points.
class Camera {
 public:
  /// Fits spheres (`points`, `radii` in m) into the rectangle.
  Camera(const Viewpoint& view, std::span<const Vec3> points, std::span<const double> radii, const Vec2& corner,
         const Vec2& size);

  Vec2 project(const Vec3& point) const;
  double depth(const Vec3& point) const { return (point - centre_).dot(towards_); }
  double scale(const Vec3& point) const;        ///< px per m at a point
  double scale() const { return zoom_; }        ///< px per m at the centre of the content
  Vec3 towards_eye(const Vec3& point) const;    ///< unit
  const Vec3& right() const { return right_; }  ///< unit, page directions in space
  const Vec3& up() const { return up_; }
  const Vec3& towards() const { return towards_; }

 private:
  double magnification(const Vec3& point) const;

  Vec3 right_, up_, towards_;
  Vec3 centre_ = Vec3::Zero();  // m
  double distance_ = 0;         // m from eye to centre; 0: orthographic
  double zoom_ = 1;             // px per m at the centre
  Vec2 middle_ = Vec2::Zero();  // px, where the centre lands
};

}  // namespace lissom
