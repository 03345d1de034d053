#include "lissom/design/objective_rod_bending.h"

#include <utility>

#include "lissom/design/objective_stencils.h"
#include "lissom/design/part_of_structure.h"

namespace lissom {

namespace {

constexpr double kFelt = 0.1;  // rad by which a rod as long as the structure turns from end to end

/// An inner node of a rod.
struct Bend {
  int edge0 = -1, edge1 = -1;
};

class RodBending final : public StencilObjective<RodBending> {
 public:
  struct Stencil : ObjectiveStencil {};  // one coordinate of three nodes; two rest lengths

  explicit RodBending(std::vector<Bend> bends) : bends_(std::move(bends)) {}

  std::string_view name() const override { return "rod bending"; }
  std::string_view unit() const override { return "1/m"; }
  int size() const override { return 3 * static_cast<int>(bends_.size()); }
  double scale(const PoseShape& shape) const override { return kFelt / shape.design.system.structure.size; }

  std::vector<Stencil> stencils(const PoseShape& shape) const {
    const System& system = shape.design.system;
    const RestNumbers numbers(system.structure);
    std::vector<Stencil> stencils;
    for (const Bend& bend : bends_) {
      const StructureEdge &first = system.structure.edges[bend.edge0], &second = system.structure.edges[bend.edge1];
      for (int axis = 0; axis < 3; ++axis) {
        Stencil s;
        s.component = static_cast<int>(stencils.size());
        s.dofs = {3 * first.node0 + axis, 3 * first.node1 + axis, 3 * second.node1 + axis};
        for (const int e : {bend.edge0, bend.edge1}) {
          s.add_number(numbers.edge(e, kEdgeLength), system.rest.edges[e].length);
        }
        stencils.push_back(std::move(s));
      }
    }
    return stencils;
  }

  template <class T>
  static T value(const T* x, const T* rest, const Stencil&) {
    return ((x[2] - x[1]) / rest[1] - (x[1] - x[0]) / rest[0]) * T(2) / (rest[0] + rest[1]);
  }

 private:
  std::vector<Bend> bends_;
};

}  // namespace

std::shared_ptr<const Objective> make_rod_bending(const Structure& structure, std::vector<int> rods) {
  std::vector<Bend> bends;
  for (const int r : rods_or_all(structure, rods)) {
    const std::vector<int>& edges = structure.rods[r].edges;
    for (std::size_t i = 1; i < edges.size(); ++i) bends.push_back({edges[i - 1], edges[i]});
    if (structure.rods[r].closed) bends.push_back({edges.back(), edges.front()});
  }
  return std::make_shared<RodBending>(std::move(bends));
}

}  // namespace lissom
