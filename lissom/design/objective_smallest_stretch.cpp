#include "lissom/design/objective_smallest_stretch.h"

#include <cmath>
#include <utility>

#include "lissom/design/objective_stencils.h"
#include "lissom/design/part_of_structure.h"
#include "lissom/mechanics/membrane_strain.h"

namespace lissom {

namespace {

constexpr double kFelt = 0.01;
constexpr double kRounding = 1e-8;  // added to the discriminant

class SmallestStretch final : public StencilObjective<SmallestStretch> {
 public:
  struct Stencil : ObjectiveStencil {
    Vec2 growth = Vec2::Ones();  // of the rest corners while the pre-stretch is not all there
  };

  explicit SmallestStretch(std::vector<int> triangles) : triangles_(std::move(triangles)) {}

  std::string_view name() const override { return "smallest stretch"; }
  std::string_view unit() const override { return ""; }
  int size() const override { return static_cast<int>(triangles_.size()); }
  double scale(const PoseShape&) const override { return kFelt; }

  std::vector<Stencil> stencils(const PoseShape& shape) const {
    const System& system = shape.design.system;
    const RestNumbers numbers(system.structure);
    const double share = stretch_share(shape.pose, shape.state.load_factor);
    std::vector<Stencil> stencils(triangles_.size());
    for (int k = 0; k < size(); ++k) {
      const int t = triangles_[k];
      const StructureTriangle& triangle = system.structure.triangles[t];
      const Vec2& full = system.structure.membranes[triangle.membrane].pre_stretch;
      Stencil& s = stencils[k];
      s.component = k;
      s.growth = full.cwiseQuotient(Vec2::Ones() + share * (full - Vec2::Ones()));
      for (const int node : triangle.node) s.add_node(node);
      for (int i = 0; i < 6; ++i) {
        s.add_number(numbers.triangle(t, kCorner + i), system.rest.triangles[t].corner[i / 2][i % 2]);
      }
    }
    return stencils;
  }

  template <class T>
  static T value(const T* x, const T* rest, const Stencil& s) {
    using std::sqrt;
    const T a1 = (rest[2] - rest[0]) * T(s.growth[0]), a2 = (rest[3] - rest[1]) * T(s.growth[1]);
    const T b1 = (rest[4] - rest[0]) * T(s.growth[0]), b2 = (rest[5] - rest[1]) * T(s.growth[1]);
    const T per = T(1) / (a1 * b2 - a2 * b1);
    T c11 = T(0), c22 = T(0), c12 = T(0);
    for (int i = 0; i < 3; ++i) {
      const T d = x[3 + i] - x[i], e = x[6 + i] - x[i];
      const T f1 = (d * b2 - e * a2) * per, f2 = (e * a1 - d * b1) * per;
      c11 += f1 * f1;
      c22 += f2 * f2;
      c12 += f1 * f2;
    }
    const T difference = c11 - c22;
    const T root = sqrt(T(difference * difference + T(4) * c12 * c12 + T(kRounding)));
    // The smaller eigenvalue from the determinant: a difference of nearly equal numbers would lose it in folded triangles.
    const T product = c11 * c22 - c12 * c12 - T(kRounding / 4);
    const T square = T(2) * product / (c11 + c22 + root);
    return primal(square) > 0 ? T(sqrt(square)) : T(0);
  }

 private:
  std::vector<int> triangles_;
};

}  // namespace

std::shared_ptr<const Objective> make_smallest_stretch(const Structure& structure, std::vector<int> membranes) {
  return std::make_shared<SmallestStretch>(triangles_of(structure, membranes));
}

}  // namespace lissom
