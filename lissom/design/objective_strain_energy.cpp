#include "lissom/design/objective_strain_energy.h"

#include <algorithm>

#include "lissom/mechanics/elastic_energy.h"
#include "lissom/mechanics/rest_numbers.h"

namespace lissom {

namespace {

constexpr double kFelt = 0.01;         // of the energy
constexpr double kLeastLoaded = 1e-3;  // of what the largest load does over the size of the structure, for slack shapes

class StrainEnergy final : public Objective {
 public:
  std::string_view name() const override { return "strain energy"; }
  std::string_view unit() const override { return "J"; }
  int size() const override { return 1; }
  double scale(const PoseShape& shape) const override {
    const double least = kLeastLoaded * shape.problem.scales.force * shape.problem.scales.length;
    return kFelt * std::max(least, elastic_energy(shape.problem.potential, shape.state));
  }

  void values(const PoseShape& shape, VecX& c) const override {
    c = VecX::Constant(1, elastic_energy(shape.problem.potential, shape.state));
  }

  void jacobian(const PoseShape& shape, SparseRows& by_q, SparseRows& by_numbers) const override {
    VecX q(shape.design.system.layout.size()), numbers(RestNumbers(shape.design.system.structure).size());
    elastic_gradient(shape.problem.potential, shape.state, q, numbers);
    by_q = MatX(q.transpose()).sparseView();
    by_numbers = MatX(numbers.transpose()).sparseView();
  }

  void curvature(const PoseShape& shape, const VecX& y, const VecX& dq, const VecX& dn, VecX& by_q,
                 VecX& by_numbers) const override {
    add_elastic_curvature(shape.problem.potential, shape.state, y[0], dq, dn, by_q, by_numbers);
  }
};

}  // namespace

std::shared_ptr<const Objective> make_strain_energy() { return std::make_shared<StrainEnergy>(); }

}  // namespace lissom
