#pragma once
/// Dense types used everywhere. All quantities are SI (m, N, Pa, kg, s, rad) unless a name says otherwise.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/SparseCore>

namespace lissom {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using VecX = Eigen::VectorXd;
using MatX = Eigen::MatrixXd;
using SparseMatrix = Eigen::SparseMatrix<double>;

/// How many stencils are computed at once.
inline constexpr int kLanes = 4;

}  // namespace lissom
