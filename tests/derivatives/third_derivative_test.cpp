/// Third derivatives of all energies: stencil by stencil against differences at a fixed anchor, and assembled against
/// differences of energies and of assembled second derivatives.

#include "lissom/mechanics/third_derivative.h"

#include "lissom/core/traced_dual.h"
#include "lissom/mechanics/gradient_by_rest.h"
#include "lissom/mechanics/rest_numbers.h"
#include "tests/derivatives/third_problems.h"

namespace lissom {
namespace {

constexpr double kTolerance = 1e-8;

class ThirdDerivative : public testing::TestWithParam<third::Case> {
 protected:
  ThirdDerivative() : deformed_(GetParam().make()) {}

  VecX random_increment(double amplitude) { return checks::random_increment(deformed_.system, random_, amplitude); }
  /// Of all rest numbers, and of as many other numbers behind them that nothing hangs on.
  VecX random_numbers() {
    VecX dn = third::random_vector(random_, numbers_size() + 3);
    const VecX numbers = rest_number_values(deformed_.system);
    for (int i = 0; i < numbers.size(); ++i) dn[i] *= third::size_of(numbers[i]);
    return dn;
  }
  int numbers_size() const { return RestNumbers(deformed_.system.structure).size(); }
  double unit(int dof) const {
    const bool position = deformed_.system.layout.dof_class(dof) == DofClass::kPosition;
    return position ? deformed_.system.rest.mean_edge_length : 1;
  }
  void check_stencil(EnergyTerm& term, int stencil);

  third::Deformed deformed_;
  std::mt19937 random_{29};
};

void ThirdDerivative::check_stencil(EnergyTerm& term, int stencil) {
  const int dofs = term.dofs(), rests = term.rests();
  const VecX lambda = random_increment(0.3), dq = random_increment(0.3), rest = term.rest(stencil);
  VecX own_lambda(dofs), own_dq(dofs), dn = third::random_vector(random_, rests);
  VecX size(dofs + rests);
  for (int i = 0; i < dofs; ++i) {
    const int dof = term.indices()[stencil * dofs + i];
    own_lambda[i] = lambda[dof];
    own_dq[i] = dq[dof];
    size[i] = unit(dof);
  }
  for (int i = 0; i < rests; ++i) {
    size[dofs + i] = third::size_of(rest[i]);
    dn[i] *= size[dofs + i];
  }
  // Hessian and mixed block times lambda, in units of the unknowns and rest quantities.
  const auto products = [&](double step) -> VecX {
    term.set_rest(stencil, rest + step * dn);
    const StencilDerivatives d = term.automatic(deformed_.state, step * dq, stencil);
    VecX all(dofs + rests);
    all << d.hessian * own_lambda, d.mixed.transpose() * own_lambda;
    return all.cwiseProduct(size);
  };
  const VecX expected = third::slope(products), at_state = products(0);
  VecX got(dofs + rests);
  Tape tape;
  term.third(deformed_.state, stencil, {own_lambda.data(), own_dq.data(), dn.data()}, tape, got.data(),
             got.data() + dofs);
  got = got.cwiseProduct(size);
  const double by_q = expected.head(dofs).cwiseAbs().maxCoeff(), by_rest = expected.tail(rests).cwiseAbs().maxCoeff();
  const double least = 1e-3 * at_state.cwiseAbs().maxCoeff();
  ASSERT_GT(least, 0);
  EXPECT_LT((got - expected).head(dofs).cwiseAbs().maxCoeff(), kTolerance * std::max(by_q, least));
  EXPECT_LT((got - expected).tail(rests).cwiseAbs().maxCoeff(), kTolerance * std::max(by_rest, least));
  if (term.has_hessian()) {
    EXPECT_GT(by_q, 0);
  }
}

TEST_P(ThirdDerivative, StencilsMatchDifferences) {
  Potential potential = deformed_.potential();
  ASSERT_EQ(static_cast<int>(potential.terms().size()), GetParam().terms);
  for (int t = 0; t < GetParam().terms; ++t) {
    EnergyTerm& term = potential.term(t);
    SCOPED_TRACE(std::string(term.name()) + ", " + std::to_string(term.dofs()) + " unknowns");
    const int most = term.name() == "joint_corotational" ? 2 : 12;
    for (int s = 0; s < term.stencils(); s += std::max(1, term.stencils() / most)) {
      SCOPED_TRACE("stencil " + std::to_string(s));
      check_stencil(term, s);
    }
  }
}

/// d^3 V(q + t dq) / dt^3 from energies alone.
TEST_P(ThirdDerivative, AssembledMatchesDifferencesOfTheEnergy) {
  const Potential potential = deformed_.potential();
  const VecX dq = random_increment(0.3), dn = VecX::Zero(numbers_size());
  VecX by_q, by_numbers;
  third_derivative(potential, deformed_.state, dq, dq, dn, by_q, by_numbers);
  AssemblyBuffers buffers;
  State moved;
  const auto value = [&](double t) {
    EXPECT_TRUE(advance(deformed_.system, deformed_.state, t * dq, moved));
    return potential.value(moved, buffers);
  };
  // Central third differences at four steps, extrapolated: error h^8.
  std::array<double, 4> d;
  double h = 0.04;
  for (double& entry : d) {
    entry = (value(2 * h) - 2 * value(h) + 2 * value(-h) - value(-2 * h)) / (2 * h * h * h);
    h /= 1.5;
  }
  for (int level = 1; level < 4; ++level) {
    const double ratio = std::pow(1.5, 2 * level);
    for (int k = 0; k + level < 4; ++k) d[k] = (ratio * d[k + 1] - d[k]) / (ratio - 1);
  }
  EXPECT_NEAR(by_q.dot(dq), d[0], 2e-6 * std::abs(d[0]));
  EXPECT_GT(std::abs(d[0]), 1e-3 * std::abs(value(0)));
}

/// Along numbers alone the anchor stays, so that assembled second derivatives can be differenced.
TEST_P(ThirdDerivative, AssembledMatchesDifferencesAlongNumbers) {
  const Potential original = deformed_.potential();
  Potential moved = deformed_.potential();
  const VecX lambda = random_increment(0.3), zero = VecX::Zero(lambda.size());
  VecX dn = random_numbers();
  // Hand-written Hessians hold for rest frames that are not turned, and for rotations of joints that match their weights.
  const RestNumbers layout(deformed_.system.structure);
  const int fixed = deformed_.model.joint_kind == JointKind::kCorotational ? +kBend1 : +kRestTurn;
  for (int k = 0; k < static_cast<int>(deformed_.system.connections.size()); ++k) {
    for (int i = fixed; i < kConnectionRestCount; ++i) dn[layout.connection(k, i)] = 0;
  }
  VecX by_q, by_numbers;
  third_derivative(original, deformed_.state, lambda, zero, dn, by_q, by_numbers);
  ASSERT_EQ(by_numbers.size(), dn.size());
  AssemblyBuffers buffers;
  const VecX expected_q = third::slope([&](double step) {
    third::move_rests(moved, original, step * dn);
    VecX gradient, product;
    std::vector<double> values;
    moved.hessian(deformed_.state, gradient, values, buffers);
    multiply(moved.pattern(), values, lambda, product);
    return product;
  });
  const VecX numbers = rest_number_values(deformed_.system);
  VecX size = VecX::Ones(dn.size());
  for (int i = 0; i < numbers.size(); ++i) size[i] = third::size_of(numbers[i]);
  const VecX expected_n = third::slope([&](double step) -> VecX {
    third::move_rests(moved, original, step * dn);
    const SparseMatrix mixed = gradient_by_rest(moved, deformed_.state, static_cast<int>(dn.size()));
    return (mixed.transpose() * lambda).cwiseProduct(size);
  });
  VecX units(lambda.size());
  for (int i = 0; i < units.size(); ++i) units[i] = unit(i);
  EXPECT_LT((by_q - expected_q).cwiseProduct(units).cwiseAbs().maxCoeff(),
            kTolerance * expected_q.cwiseProduct(units).cwiseAbs().maxCoeff());
  EXPECT_LT((by_numbers.cwiseProduct(size) - expected_n).cwiseAbs().maxCoeff(),
            kTolerance * expected_n.cwiseAbs().maxCoeff());
}

/// All directions may change places: T(lambda, dq, w) is symmetric, and T(lambda, w, dn) is the same by unknowns and by
/// numbers.
TEST_P(ThirdDerivative, IsSymmetric) {
  const Potential potential = deformed_.potential();
  const VecX a = random_increment(0.3), b = random_increment(0.3), c = random_increment(0.3), dn = random_numbers();
  const VecX none = VecX::Zero(dn.size()), still = VecX::Zero(a.size());
  const auto by_q = [&](const VecX& lambda, const VecX& dq, const VecX& numbers) {
    VecX q, n;
    third_derivative(potential, deformed_.state, lambda, dq, numbers, q, n);
    return q;
  };
  const VecX ab = by_q(a, b, none), ba = by_q(b, a, none);
  VecX size(a.size());
  for (int i = 0; i < size.size(); ++i) size[i] = unit(i);
  const double scale = ab.cwiseProduct(size).cwiseAbs().maxCoeff();
  ASSERT_GT(scale, 0);
  EXPECT_LT((ab - ba).cwiseProduct(size).cwiseAbs().maxCoeff(), 1e-12 * scale);
  EXPECT_NEAR(by_q(b, c, none).dot(a), ab.dot(c), 1e-11 * scale);
  VecX q, n;
  third_derivative(potential, deformed_.state, a, c, none, q, n);
  const double across = by_q(a, still, dn).dot(c);
  EXPECT_NEAR(n.dot(dn), across, 1e-10 * std::abs(across));
}

/// Axes of supports are none of its business, nor is the number of threads.
TEST_P(ThirdDerivative, LocalAxesAndThreadsChangeNoByte) {
  const Potential potential = deformed_.potential();
  const Mat3 oblique = rotation_from_vector(Vec3(0.3, -0.8, 0.5));
  const Potential turned = deformed_.potential({{3, oblique}});
  const VecX lambda = random_increment(0.3), dq = random_increment(0.3), dn = random_numbers();
  VecX q, n, other_q, other_n;
  third_derivative(potential, deformed_.state, lambda, dq, dn, q, n);
  third_derivative(turned, deformed_.state, lambda, dq, dn, other_q, other_n);
  EXPECT_EQ(q, other_q);
  EXPECT_EQ(n, other_n);
  for (const int threads : {2, 8}) {
    ThreadPool pool(threads);
    third_derivative(potential, deformed_.state, lambda, dq, dn, other_q, other_n, &pool);
    EXPECT_EQ(q, other_q);
    EXPECT_EQ(n, other_n);
  }
}

INSTANTIATE_TEST_SUITE_P(Problems, ThirdDerivative, testing::ValuesIn(third::kCases),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace lissom
