#include "lissom/design/objective_node_positions.h"

#include <utility>

#include "lissom/mechanics/rest_numbers.h"

namespace lissom {

namespace {

constexpr double kFelt = 0.01;  // of the size of the structure

class NodePositions final : public Objective {
 public:
  explicit NodePositions(std::vector<int> nodes) : nodes_(std::move(nodes)) {}

  std::string_view name() const override { return "node positions"; }
  std::string_view unit() const override { return "m"; }
  int size() const override { return 3 * static_cast<int>(nodes_.size()); }
  double scale(const PoseShape& shape) const override { return kFelt * shape.design.system.structure.size; }

  void values(const PoseShape& shape, VecX& c) const override {
    c.resize(size());
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
      c.segment<3>(3 * static_cast<int>(k)) = shape.state.position(nodes_[k]);
    }
  }

  void jacobian(const PoseShape& shape, SparseRows& by_q, SparseRows& by_numbers) const override {
    by_q.resize(size(), shape.design.system.layout.size());
    by_q.reserve(Eigen::VectorXi::Constant(size(), 1));
    for (int i = 0; i < size(); ++i) by_q.insert(i, 3 * nodes_[static_cast<std::size_t>(i / 3)] + i % 3) = 1;
    by_numbers.resize(size(), RestNumbers(shape.design.system.structure).size());
  }

  void curvature(const PoseShape&, const VecX&, const VecX&, const VecX&, VecX&, VecX&) const override {}

 private:
  std::vector<int> nodes_;
};

}  // namespace

std::shared_ptr<const Objective> make_node_positions(std::vector<int> nodes) {
  return std::make_shared<NodePositions>(std::move(nodes));
}

}  // namespace lissom
