#include "lissom/design/kept_lengths.h"

#include <vector>

#include "lissom/mechanics/rest_numbers.h"

namespace lissom {

namespace {

constexpr double kKept = 0.8;     // of the length as drawn
constexpr double kWeight = 0.04;  // enough to keep edges from vanishing, too little to bend a design for

}  // namespace

ParameterGoal make_kept_lengths(const Design& base, const DesignSpace& space) {
  const Structure& structure = base.system.structure;
  const VecX start = space.start();
  const Result<Design> first = space.at(start);
  const Design& begun = first ? first.value() : base;
  const DesignJacobian jacobian = space.jacobian(begun, start);
  ParameterGoal wish;
  wish.name = "lengths of edges";
  wish.kind = GoalKind::kAtLeast;
  wish.weight = kWeight;
  wish.target = start;
  if (jacobian.inputs.cols() == 0) return wish;
  const auto edges = static_cast<Eigen::Index>(structure.edges.size());
  std::vector<Eigen::Triplet<double>> entries;
  wish.level.resize(edges);
  for (Eigen::Index e = 0; e < edges; ++e) {
    const StructureEdge& edge = structure.edges[static_cast<std::size_t>(e)];
    const auto node0 = static_cast<std::size_t>(edge.node0), node1 = static_cast<std::size_t>(edge.node1);
    const Vec3 drawn = structure.nodes[node1] - structure.nodes[node0];
    const Vec3 along = drawn / (kKept * drawn.squaredNorm());
    const std::vector<Vec3>& nodes = begun.system.structure.nodes;
    wish.level[e] = 1 - along.dot(nodes[node1] - nodes[node0]);
    for (int k = 0; k < 3; ++k) {
      entries.emplace_back(e, 3 * edge.node0 + k, -along[k]);
      entries.emplace_back(e, 3 * edge.node1 + k, along[k]);
    }
  }
  SparseMatrix by_inputs(edges, RestInputs(structure).size());
  by_inputs.setFromTriplets(entries.begin(), entries.end());
  const SparseMatrix rows = by_inputs * jacobian.inputs;
  if (rows.nonZeros() > 0) wish.rows = rows;
  return wish;
}

}  // namespace lissom
