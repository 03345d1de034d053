/// Second derivatives of rest numbers by their inputs.

#include "lissom/mechanics/rest_jacobian.h"
#include "tests/derivatives/third_problems.h"

namespace lissom {
namespace {

struct Family {
  const char* name;
  int begin, end;  // among the rest numbers
};

class RestCurvature : public testing::TestWithParam<third::Case> {
 protected:
  RestCurvature() : deformed_(GetParam().make()), numbers_(deformed_.system.structure) {
    inputs_ = rest_input_values(deformed_.model, deformed_.system);
    size_ = VecX::Constant(inputs_.size(), deformed_.system.rest.mean_edge_length);
    for (Eigen::Index i = 3 * deformed_.system.layout.nodes(); i < inputs_.size(); ++i) size_[i] = std::abs(inputs_[i]);
  }

  VecX random_direction() { return third::random_vector(random_, inputs_.size()).cwiseProduct(size_) * 0.3; }
  VecX curvature(const VecX& y, const VecX& direction) const {
    return rest_curvature(deformed_.model, deformed_.system, y, direction);
  }
  /// Rest numbers in pieces of alike size, with weights by which they all count.
  VecX weights(const Family& family) {
    VecX y = VecX::Zero(numbers_.size());
    const VecX values = rest_number_values(deformed_.system), random = third::random_vector(random_, y.size());
    for (int k = family.begin; k < family.end; ++k) y[k] = random[k] / third::size_of(values[k]);
    return y;
  }
  std::vector<Family> families() const {
    return {{"edges", 0, numbers_.pair(0, 0)},
            {"pairs", numbers_.pair(0, 0), numbers_.connection(0, 0)},
            {"connections", numbers_.connection(0, 0), numbers_.triangle(0, 0)},
            {"triangles", numbers_.triangle(0, 0), numbers_.hinge(0, 0)},
            {"hinges", numbers_.hinge(0, 0), numbers_.tetrahedron(0, 0)},
            {"tetrahedra", numbers_.tetrahedron(0, 0), numbers_.size()}};
  }

  third::Deformed deformed_;
  RestNumbers numbers_;
  VecX inputs_, size_;
  std::mt19937 random_{11};
};

TEST_P(RestCurvature, MatchesSecondDifferences) {
  int checked = 0;
  for (const Family& family : families()) {
    if (family.begin == family.end) continue;
    SCOPED_TRACE(family.name);
    const VecX y = weights(family), v = random_direction();
    const VecX exact = curvature(y, v).cwiseProduct(size_);
    const double scale = exact.cwiseAbs().maxCoeff();
    EXPECT_GT(scale, 1e-3);
    const auto sum_at = [&](const VecX& inputs) {
      return y.dot(rest_numbers_of(deformed_.model, deformed_.system, inputs));
    };
    for (Eigen::Index i = 0; i < inputs_.size(); ++i) {
      const VecX w = size_[i] * VecX::Unit(inputs_.size(), i);
      const auto both = [&](double step) {
        const VecX s = step * v, t = step * w;
        const double change =
            sum_at(inputs_ + s + t) - sum_at(inputs_ + s - t) - sum_at(inputs_ - s + t) + sum_at(inputs_ - s - t);
        return change / (4 * step * step);
      };
      const double h = 0.02, d1 = both(h), d2 = both(h / 1.5), d4 = both(h / 2.25);
      const double coarse = (2.25 * d2 - d1) / 1.25, fine = (2.25 * d4 - d2) / 1.25;
      const double expected = (5.0625 * fine - coarse) / 4.0625;
      EXPECT_NEAR(exact[i], expected, 2e-8 * scale) << "by input " << i;
    }
    ++checked;
  }
  EXPECT_GE(checked, 2);
}

/// Where models with other inputs keep their frames, the jacobian itself can be differenced.
TEST_P(RestCurvature, MatchesDifferencesOfTheJacobian) {
  const RestInputs layout(deformed_.system.structure);
  VecX direction = VecX::Zero(inputs_.size());
  for (int e = 0; e < deformed_.system.edge_count(); ++e) {
    direction[layout.extent_n(e)] = 0.3 * inputs_[layout.extent_n(e)];
    direction[layout.extent_b(e)] = 0.3 * inputs_[layout.extent_b(e)];
  }
  if (!deformed_.model.membranes.empty()) direction[layout.pre_stretch(0, 1)] = 0.2;
  const auto jacobian_at = [&](double step) {
    Model model = deformed_.model;
    for (Rod& rod : model.rods) {
      for (double& r : rod.section.r_n) r *= 1 + 0.3 * step;
      for (double& r : rod.section.r_b) r *= 1 + 0.3 * step;
    }
    for (Membrane& membrane : model.membranes) membrane.pre_stretch[1] += 0.2 * step;
    Result<System> made = make_system(model);
    EXPECT_TRUE(made.ok());
    return rest_jacobian(model, made.value());
  };
  for (const Family& family : families()) {
    // Nothing of tetrahedra hangs on sections and pre-stretches.
    if (family.begin == family.end || family.begin == numbers_.tetrahedron(0, 0)) continue;
    SCOPED_TRACE(family.name);
    const VecX y = weights(family);
    const VecX expected =
        third::slope([&](double step) -> VecX { return (jacobian_at(step).transpose() * y).cwiseProduct(size_); });
    const VecX exact = curvature(y, direction).cwiseProduct(size_);
    EXPECT_LT((exact - expected).cwiseAbs().maxCoeff(), 1e-9 * expected.cwiseAbs().maxCoeff());
  }
}

TEST_P(RestCurvature, IsSymmetricAndPassesOverOtherNumbers) {
  VecX y = third::random_vector(random_, numbers_.size());
  const VecX v = random_direction(), w = random_direction();
  const VecX along_v = curvature(y, v);
  EXPECT_NEAR(along_v.dot(w), curvature(y, w).dot(v), 1e-11 * std::abs(along_v.dot(w)));
  VecX longer(y.size() + 2);
  longer << y, 7, 8;
  EXPECT_EQ(curvature(longer, v), along_v);
}

INSTANTIATE_TEST_SUITE_P(Problems, RestCurvature,
                         testing::Values(third::kCases[0], third::kCases[3], third::kCases[4], third::kCases[5]),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace lissom
