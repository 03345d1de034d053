#include "lissom/design/objective_angle.h"

#include <cmath>
#include <numbers>

#include "lissom/core/assert.h"
#include "lissom/design/objective_stencils.h"
#include "lissom/geometry/frame_strain.h"

namespace lissom {

namespace {

constexpr double kFelt = std::numbers::pi / 180;
constexpr double kParallel = 1e-9;  // sine of the angle below which directions count as parallel

class Angle final : public StencilObjective<Angle> {
 public:
  struct Stencil : ObjectiveStencil {
    std::optional<Vec3> axis;  // unit
  };

  Angle(const std::array<int, 4>& nodes, const std::optional<Vec3>& axis) {
    for (const int node : nodes) stencil_.add_node(node);
    if (axis) stencil_.axis = axis->normalized();
  }

  std::string_view name() const override { return "angle"; }
  std::string_view unit() const override { return "rad"; }
  int size() const override { return 1; }
  double scale(const PoseShape&) const override { return kFelt; }

  std::vector<Stencil> stencils(const PoseShape&) const { return {stencil_}; }

  template <class T>
  static T value(const T* x, const T*, const Stencil& s) {
    using std::atan2;
    using std::sqrt;
    const Vec3T<T> u(x[3] - x[0], x[4] - x[1], x[5] - x[2]), v(x[9] - x[6], x[10] - x[7], x[11] - x[8]);
    const Vec3T<T> across = u.cross(v);
    if (s.axis) {
      const Vec3T<T> axis = s.axis->cast<T>();
      return atan2(T(axis.dot(across)), T(u.dot(v) - axis.dot(u) * axis.dot(v)));
    }
    const T along = u.dot(v), square = across.dot(across);
    const double cosine = primal(along);
    if (primal(square) <= kParallel * kParallel * cosine * cosine) return T(cosine > 0 ? 0 : std::numbers::pi);
    return atan2(T(sqrt(square)), along);
  }

 private:
  Stencil stencil_;
};

}  // namespace

std::shared_ptr<const Objective> make_angle(const std::array<int, 4>& nodes, const std::optional<Vec3>& axis) {
  LISSOM_ASSERT(!axis || axis->norm() > 0);
  return std::make_shared<Angle>(nodes, axis);
}

}  // namespace lissom
