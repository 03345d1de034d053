#include "lissom/design/objective_distance.h"

#include <cmath>
#include <utility>

#include "lissom/core/assert.h"
#include "lissom/design/objective_stencils.h"
#include "lissom/geometry/frame_strain.h"

namespace lissom {

namespace {

constexpr double kFelt = 0.01;  // of the size of the structure

class Distance final : public StencilObjective<Distance> {
 public:
  struct Stencil : ObjectiveStencil {
    std::size_t from = 0, to = 0;  // nodes; those of `from` come first
    Vec3 start = Vec3::Zero();     // m, where there are none
    std::optional<Vec3> axis;      // unit
  };

  explicit Distance(Stencil stencil) : stencil_(std::move(stencil)) {}

  std::string_view name() const override { return "distance"; }
  std::string_view unit() const override { return "m"; }
  int size() const override { return 1; }
  double scale(const PoseShape& shape) const override { return kFelt * shape.design.system.structure.size; }

  std::vector<Stencil> stencils(const PoseShape&) const { return {stencil_}; }

  template <class T>
  static T value(const T* x, const T*, const Stencil& s) {
    using std::sqrt;
    Vec3T<T> apart = -s.start.cast<T>();
    for (std::size_t i = 0; i < s.from + s.to; ++i, x += 3) {
      const double share = i < s.from ? -1.0 / static_cast<double>(s.from) : 1.0 / static_cast<double>(s.to);
      apart += T(share) * Vec3T<T>(x[0], x[1], x[2]);
    }
    if (!s.axis) return sqrt(T(apart.dot(apart)));
    const Vec3T<T> axis = s.axis->cast<T>();
    return axis.dot(apart);
  }

 private:
  Stencil stencil_;
};

std::shared_ptr<const Objective> made(Distance::Stencil stencil, const std::vector<int>& from,
                                      const std::vector<int>& to, const std::optional<Vec3>& axis) {
  LISSOM_ASSERT(!to.empty() && (!axis || axis->norm() > 0));
  for (const int node : from) stencil.add_node(node);
  for (const int node : to) stencil.add_node(node);
  stencil.from = from.size();
  stencil.to = to.size();
  if (axis) stencil.axis = axis->normalized();
  return std::make_shared<Distance>(std::move(stencil));
}

}  // namespace

std::shared_ptr<const Objective> make_distance(const std::vector<int>& from, const std::vector<int>& to,
                                               const std::optional<Vec3>& axis) {
  LISSOM_ASSERT(!from.empty());
  return made({}, from, to, axis);
}

std::shared_ptr<const Objective> make_distance(const Vec3& from, const std::vector<int>& to,
                                               const std::optional<Vec3>& axis) {
  Distance::Stencil stencil;
  stencil.start = from;
  return made(std::move(stencil), {}, to, axis);
}

}  // namespace lissom
