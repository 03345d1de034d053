#include "lissom/design/objective_reaction_force.h"

#include <algorithm>
#include <utility>

#include "lissom/core/assert.h"
#include "lissom/mechanics/gradient_by_rest.h"
#include "lissom/mechanics/rest_numbers.h"
#include "lissom/mechanics/third_derivative.h"

namespace lissom {

namespace {

constexpr double kFelt = 0.01;  // of the force, or of the largest load

class ReactionForce final : public Objective {
 public:
  ReactionForce(std::vector<int> nodes, std::vector<Vec3> axes) : nodes_(std::move(nodes)), axes_(std::move(axes)) {}

  std::string_view name() const override { return "reaction force"; }
  std::string_view unit() const override { return "N"; }
  int size() const override { return static_cast<int>(axes_.size()); }
  double scale(const PoseShape& shape) const override {
    VecX c;
    values(shape, c);
    return kFelt * std::max(c.norm(), shape.problem.scales.force);
  }

  void values(const PoseShape& shape, VecX& c) const override {
    VecX gradient;
    AssemblyBuffers buffers;
    shape.problem.potential.gradient(shape.state, gradient, buffers);
    c = weights(shape) * gradient;
  }

  void jacobian(const PoseShape& shape, SparseRows& by_q, SparseRows& by_numbers) const override {
    const Potential& potential = shape.problem.potential;
    VecX gradient, product;
    std::vector<double> hessian;
    AssemblyBuffers buffers;
    potential.hessian(shape.state, gradient, hessian, buffers);
    const MatX local = weights(shape);
    MatX rows(size(), potential.dofs());
    for (int k = 0; k < size(); ++k) {
      multiply(potential.pattern(), hessian, local.row(k).transpose(), product);
      potential.to_global(product);
      rows.row(k) = product;
    }
    by_q = rows.sparseView();
    const SparseMatrix by_rest =
        gradient_by_rest(potential, shape.state, RestNumbers(shape.design.system.structure).size());
    by_numbers = MatX(local * by_rest).sparseView();
  }

  void curvature(const PoseShape& shape, const VecX& y, const VecX& dq, const VecX& dn, VecX& by_q,
                 VecX& by_numbers) const override {
    VecX lambda = weights(shape).transpose() * y, q, numbers;
    shape.problem.potential.to_global(lambda);
    third_derivative(shape.problem.potential, shape.state, lambda, dq, dn, q, numbers);
    by_q += q;
    by_numbers += numbers;
  }

 private:
  /// Components as sums of entries of the gradient in local axes, (size x unknowns): the supports push with as much as the
  /// energy grows.
  MatX weights(const PoseShape& shape) const {
    MatX w = MatX::Zero(size(), shape.problem.potential.dofs());
    for (int k = 0; k < size(); ++k) {
      VecX row = VecX::Zero(w.cols());
      for (const int node : nodes_) row.segment<3>(3 * node) = axes_[k];
      shape.problem.potential.to_local(row);
      for (const int node : nodes_) {
        for (int i = 3 * node; i < 3 * node + 3; ++i) {
          if (shape.problem.supports.held_by_pose(i)) w(k, i) = row[i];
        }
      }
    }
    return w;
  }

  std::vector<int> nodes_;
  std::vector<Vec3> axes_;  // unit
};

}  // namespace

std::shared_ptr<const Objective> make_reaction_force(std::vector<int> nodes, std::vector<Vec3> axes) {
  for (Vec3& axis : axes) {
    LISSOM_ASSERT(axis.norm() > 0);
    axis.normalize();
  }
  return std::make_shared<ReactionForce>(std::move(nodes), std::move(axes));
}

}  // namespace lissom
