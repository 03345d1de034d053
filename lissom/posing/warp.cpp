#include "lissom/posing/warp.h"

#include <Eigen/QR>
#include <fmt/format.h>

namespace lissom {

namespace {

constexpr double kSamePlace = 1e-9;  // m

}  // namespace

Result<Warp> Warp::make(std::vector<std::array<Vec3, 2>> pairs, const std::string& where) {
  const auto n = static_cast<Eigen::Index>(pairs.size());
  Warp warp;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const std::string place = fmt::format("{}/{}", where, i);
    if (!pairs[i][0].allFinite() || !pairs[i][1].allFinite()) {
      return Error{ErrorCode::kRange, place, "a place is not a number", "write coordinates"};
    }
    for (std::size_t j = 0; j < i; ++j) {
      if ((pairs[i][0] - pairs[j][0]).norm() > kSamePlace) continue;
      return Error{ErrorCode::kGeometry, place, fmt::format("this place and that of pair {} are the same", j),
                   "move each place once"};
    }
    warp.from_.push_back(pairs[i][0]);
  }
  MatX system = MatX::Zero(n + 4, n + 4), wanted = MatX::Zero(n + 4, 3);
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::array<Vec3, 2>& pair = pairs[static_cast<std::size_t>(i)];
    for (Eigen::Index j = 0; j < n; ++j) system(i, j) = (pair[0] - warp.from_[static_cast<std::size_t>(j)]).norm();
    system(i, n) = system(n, i) = 1;
    for (int k = 0; k < 3; ++k) system(i, n + 1 + k) = system(n + 1 + k, i) = pair[0][k];
    wanted.row(i) = (pair[1] - pair[0]).transpose();
  }
  // Places in a plane leave the part of A across it open: the least one is taken, which is none.
  const MatX solved = system.completeOrthogonalDecomposition().solve(wanted);
  warp.weight_ = solved.topRows(n);
  warp.affine_ = solved.bottomRows(4);
  return warp;
}

Vec3 Warp::operator()(const Vec3& x) const {
  Vec3 moved = x + affine_.row(0).transpose();
  for (int k = 0; k < 3; ++k) moved += x[k] * affine_.row(1 + k).transpose();
  for (std::size_t i = 0; i < from_.size(); ++i) {
    moved += (x - from_[i]).norm() * weight_.row(static_cast<Eigen::Index>(i)).transpose();
  }
  return moved;
}

}  // namespace lissom
