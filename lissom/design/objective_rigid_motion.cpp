#include "lissom/design/objective_rigid_motion.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <numbers>
#include <utility>

#include "lissom/core/assert.h"
#include "lissom/core/dual.h"
#include "lissom/geometry/frame.h"
#include "lissom/mechanics/joint_explicit.h"
#include "lissom/mechanics/rest_numbers.h"

namespace lissom {

namespace {

constexpr double kFelt = 0.01;  // of the size of the structure
constexpr double kFeltTurn = std::numbers::pi / 180;

class SetPosition final : public Objective {
 public:
  explicit SetPosition(std::vector<int> nodes) : nodes_(std::move(nodes)) {}

  std::string_view name() const override { return "position of a set"; }
  std::string_view unit() const override { return "m"; }
  int size() const override { return 3; }
  double scale(const PoseShape& shape) const override { return kFelt * shape.design.system.structure.size; }

  void values(const PoseShape& shape, VecX& c) const override {
    c.setZero(3);
    for (const int node : nodes_) c += shape.state.position(node);
    c /= static_cast<double>(nodes_.size());
  }

  void jacobian(const PoseShape& shape, SparseRows& by_q, SparseRows& by_numbers) const override {
    std::vector<Eigen::Triplet<double>> entries;
    for (const int node : nodes_) {
      for (int i = 0; i < 3; ++i) entries.emplace_back(i, 3 * node + i, 1 / static_cast<double>(nodes_.size()));
    }
    by_q.resize(3, shape.design.system.layout.size());
    by_q.setFromTriplets(entries.begin(), entries.end());
    by_numbers.resize(3, RestNumbers(shape.design.system.structure).size());
  }

  void curvature(const PoseShape&, const VecX&, const VecX&, const VecX&, VecX&, VecX&) const override {}

 private:
  std::vector<int> nodes_;
};

using Turn = Dual2<9>;  // by the entries of the covariance, column by column

/// Rotation vector of the nearest rotation to a matrix, with both derivatives. It makes exp([r])' N symmetric; a Newton step
/// with the Jacobian at the solution gains one order of the expansion.
Vec3T<Turn> turn_of(const Mat3& covariance) {
  const Mat3 rotation = nearest_rotation(covariance);
  const Vec3 r0 = vector_from_rotation(rotation);
  Eigen::Matrix<Turn, 3, 3> n;
  for (int k = 0; k < 9; ++k) n(k % 3, k / 3) = Turn::variable(covariance(k % 3, k / 3), k);
  const Mat3 s = covariance * rotation.transpose();
  const Mat3 resists = s.trace() * Mat3::Identity() - 0.5 * (s + s.transpose());
  const Mat3 step = (resists * left_jacobian(r0)).inverse();
  Vec3T<Turn> r = r0.cast<Turn>();
  for (int round = 0; round < 3; ++round) {
    Vec3T<Turn> moment(Turn(0), Turn(0), Turn(0));
    for (int j = 0; j < 3; ++j) {
      const Vec3T<Turn> axis = rotated_by_vector<Turn>(r, Vec3(Vec3::Unit(j)).cast<Turn>()), column = n.col(j);
      moment += axis.cross(column);
    }
    r += step.cast<Turn>() * moment;
  }
  return r;
}

class SetOrientation final : public Objective {
 public:
  SetOrientation(std::vector<int> nodes, Eigen::Matrix3Xd arms) : nodes_(std::move(nodes)), arms_(std::move(arms)) {}

  std::string_view name() const override { return "orientation of a set"; }
  std::string_view unit() const override { return "rad"; }
  int size() const override { return 3; }
  double scale(const PoseShape&) const override { return kFeltTurn; }

  void values(const PoseShape& shape, VecX& c) const override {
    c = vector_from_rotation(nearest_rotation(covariance(shape.state.q)));
  }

  void jacobian(const PoseShape& shape, SparseRows& by_q, SparseRows& by_numbers) const override {
    const Vec3T<Turn> r = turn_of(covariance(shape.state.q));
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < 3; ++i) {
      const Mat3 by_covariance = Eigen::Map<const Mat3>(r[i].g.data());
      const Eigen::Matrix3Xd rows = by_covariance * arms_;
      for (int k = 0; k < static_cast<int>(nodes_.size()); ++k) {
        for (int j = 0; j < 3; ++j) entries.emplace_back(i, 3 * nodes_[k] + j, rows(j, k));
      }
    }
    by_q.resize(3, shape.design.system.layout.size());
    by_q.setFromTriplets(entries.begin(), entries.end());
    by_numbers.resize(3, RestNumbers(shape.design.system.structure).size());
  }

  void curvature(const PoseShape& shape, const VecX& y, const VecX& dq, const VecX&, VecX& by_q, VecX&) const override {
    const Vec3T<Turn> r = turn_of(covariance(shape.state.q));
    const Mat3 along = covariance(dq);  // linear in the places
    Mat3 change = Mat3::Zero();
    for (int i = 0; i < 3; ++i) {
      for (int a = 0; a < 9; ++a) {
        for (int b = 0; b < 9; ++b) change(a % 3, a / 3) += y[i] * r[i].hessian(a, b) * along(b % 3, b / 3);
      }
    }
    const Eigen::Matrix3Xd rows = change * arms_;
    for (int k = 0; k < static_cast<int>(nodes_.size()); ++k) by_q.segment<3>(3 * nodes_[k]) += rows.col(k);
  }

 private:
  /// sum x_k arm_k'; the arms sum up to zero, so that it does not matter where x is counted from.
  Mat3 covariance(const VecX& q) const {
    Mat3 sum = Mat3::Zero();
    const Vec3 first = q.segment<3>(3 * nodes_[0]);
    for (int k = 0; k < static_cast<int>(nodes_.size()); ++k) {
      sum += (q.segment<3>(3 * nodes_[k]) - first) * arms_.col(k).transpose();
    }
    return sum;
  }

  std::vector<int> nodes_;
  Eigen::Matrix3Xd arms_;  // from the mean of the given places, m, over their mean square
};

}  // namespace

std::shared_ptr<const Objective> make_set_position(std::vector<int> nodes) {
  LISSOM_ASSERT(!nodes.empty());
  return std::make_shared<SetPosition>(std::move(nodes));
}

Result<std::shared_ptr<const Objective>> make_set_orientation(std::vector<int> nodes, const Eigen::Matrix3Xd& places) {
  LISSOM_ASSERT(places.cols() == static_cast<int>(nodes.size()));
  const auto refuse = [](const char* message) {
    return Error{ErrorCode::kGeometry, "orientation of a set", message, "take three nodes or more that span a plane"};
  };
  if (nodes.size() < 3) return refuse("fewer than three nodes have no orientation");
  if (!places.allFinite()) return refuse("a place is not finite");
  Eigen::Matrix3Xd arms = places.colwise() - places.rowwise().mean();
  const Vec3 spread = Eigen::JacobiSVD<Mat3>(arms * arms.transpose()).singularValues();
  if (!(spread[1] > 1e-8 * spread[0])) return refuse("nodes on a line have no orientation");
  arms /= spread[0];  // a rotation of the covariance as it is, whatever the unit of length
  return std::shared_ptr<const Objective>(std::make_shared<SetOrientation>(std::move(nodes), std::move(arms)));
}

}  // namespace lissom
