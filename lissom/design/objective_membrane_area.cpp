#include "lissom/design/objective_membrane_area.h"

#include <cmath>
#include <utility>

#include "lissom/design/objective_stencils.h"
#include "lissom/design/part_of_structure.h"
#include "lissom/geometry/frame_strain.h"

namespace lissom {

namespace {

constexpr double kFelt = 0.01;  // of the area at rest

class MembraneArea final : public StencilObjective<MembraneArea> {
 public:
  struct Stencil : ObjectiveStencil {};

  explicit MembraneArea(std::vector<int> membranes) : membranes_(std::move(membranes)) {}

  std::string_view name() const override { return "membrane area"; }
  std::string_view unit() const override { return "m^2"; }
  int size() const override { return 1; }
  double scale(const PoseShape& shape) const override {
    double area = 0;
    for (const int t : triangles_of(shape.design.system.structure, membranes_)) {
      area += shape.design.system.rest.triangles[t].area;
    }
    return kFelt * area;
  }

  std::vector<Stencil> stencils(const PoseShape& shape) const {
    std::vector<Stencil> stencils;
    const Structure& structure = shape.design.system.structure;
    for (const int t : triangles_of(structure, membranes_)) {
      Stencil s;
      for (const int node : structure.triangles[t].node) s.add_node(node);
      stencils.push_back(std::move(s));
    }
    return stencils;
  }

  template <class T>
  static T value(const T* x, const T*, const Stencil&) {
    using std::sqrt;
    const Vec3T<T> u(x[3] - x[0], x[4] - x[1], x[5] - x[2]), v(x[6] - x[0], x[7] - x[1], x[8] - x[2]);
    const Vec3T<T> normal = u.cross(v);
    return sqrt(T(normal.dot(normal))) * T(0.5);
  }

 private:
  std::vector<int> membranes_;
};

}  // namespace

std::shared_ptr<const Objective> make_membrane_area(std::vector<int> membranes) {
  return std::make_shared<MembraneArea>(std::move(membranes));
}

}  // namespace lissom
