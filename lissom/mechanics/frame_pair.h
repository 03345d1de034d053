#pragma once
/// Derivatives of the strains of a frame pair by rotations of the two frames [mathematics 1.5], and the chain from
/// rotations to the unknowns of an edge [mathematics 1.6]. The kernel of both joints.

#include <Eigen/Core>

#include "lissom/mechanics/strain.h"

namespace lissom {

using Mat36 = Eigen::Matrix<double, 3, 6>;
using Mat6 = Eigen::Matrix<double, 6, 6>;
using Mat4 = Eigen::Matrix<double, 4, 4>;
using Vec4 = Eigen::Matrix<double, 4, 1>;
using Vec6 = Eigen::Matrix<double, 6, 1>;

/// Energy of one bending-twist spring as a function of rotation vectors (w1, w2) of its frames.
struct FramePairDerivatives {
  Vec6 gradient;  ///< N m
  Mat6 hessian;   ///< N m, in exponential coordinates at w = 0: symmetric
};

/// `rest` in PairRestIndex order; `twist` is the present twist, rad. The Hessian is left untouched unless asked for.
FramePairDerivatives frame_pair_derivatives(const FrameT<double>& first, const FrameT<double>& second, double twist,
                                            const double* rest, bool with_hessian);

/// dw/d(e, theta) of an edge at its anchor, 3 x 4.
Eigen::Matrix<double, 3, 4> edge_rotation_jacobian(const Vec3& t, double length);

/// Second-order part g . d2w/d(e, theta)2, 4 x 4, for the gradient g by the rotation vector.
Mat4 edge_rotation_curvature(const Vec3& g, const Vec3& t, double length);

}  // namespace lissom
