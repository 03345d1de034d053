#pragma once
/// Orthonormal frames, parallel transport and rotations [mathematics 0, 1.1; Bergou et al. 2008].

#include "lissom/core/types.h"

namespace lissom {

/// Right-handed orthonormal frame with t x b = n: t tangent, b in plane, n out of plane.
struct Frame {
  Vec3 t = Vec3::UnitX(), b = Vec3::UnitY(), n = Vec3::UnitZ();
};

/// R applied to all three axes.
Frame rotated(const Mat3& rotation, const Frame& frame);

/// Frame with tangent t and n as close as possible to `normal`. Falls back to a fixed axis when they are parallel.
Frame frame_from_normal(const Vec3& tangent, const Vec3& normal);

/// Minimal rotation that takes unit vector a to unit vector b, applied to x. Exact at a = b; for a = -b turns by pi
/// about the coordinate axis least aligned with a (erratum E1).
Vec3 parallel_transport(const Vec3& a, const Vec3& b, const Vec3& x);

/// Signed angle about unit vector `axis` from u to v, in (-pi, pi].
double signed_angle(const Vec3& axis, const Vec3& u, const Vec3& v);

/// x shifted by a multiple of 2 pi into (-pi, pi].
double wrap_angle(double x);

Mat3 skew(const Vec3& a);

/// Rotation by |r| about r.
Mat3 rotation_from_vector(const Vec3& r);

/// The r with |r| <= pi and rotation_from_vector(r) = R.
Vec3 vector_from_rotation(const Mat3& rotation);

/// d(rotation) = skew(left_jacobian(r) dr) rotation.
Mat3 left_jacobian(const Vec3& r);

/// Nearest rotation (determinant +1) to a matrix: signed polar factor [mathematics 2.3].
Mat3 nearest_rotation(const Mat3& matrix);

}  // namespace lissom
