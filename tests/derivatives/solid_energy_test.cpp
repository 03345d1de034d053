/// Strain of solids: derivatives, invariance, moduli, inversion, and that a wrong derivative is caught.

#include <gtest/gtest.h>
#include <utility>

#include "lissom/geometry/frame.h"
#include "lissom/mechanics/solid_stretch.h"
#include "tests/derivatives/derivative_checks.h"
#include "tests/derivatives/potential_checks.h"
#include "tests/derivatives/solid_block.h"

namespace lissom {
namespace {

/// An uneven block with moduli that differ from tetrahedron to tetrahedron.
struct Body {
  System system;
  SolidStretch stretch;

  Body() {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const double h = 0.02;
    Solid solid = block({3, 2, 2}, h * Vec3(3, 2, 2));
    for (Vec3& p : solid.points) p += 0.15 * h * Vec3(uniform(random), uniform(random), uniform(random));
    system.structure.nodes = solid.points;
    system.layout = DofLayout(system.structure);
    system.rest.mean_edge_length = h;
    for (const std::array<int, 4>& corner : solid.tetrahedra) {
      SolidStretch::Stencil s;
      for (int i = 0; i < 4; ++i) {
        for (int k = 0; k < 3; ++k) {
          s.dofs[3 * i + k] = 3 * corner[i] + k;
          s.rest[3 * i + k] = solid.points[corner[i]][k];
        }
      }
      s.rest[12] = 2e5 * (2 + uniform(random));
      s.rest[13] = 1e5 * (2 + uniform(random));
      stretch.stencils.push_back(s);
    }
  }

  Potential potential() const {
    std::vector<std::unique_ptr<EnergyTerm>> terms;
    terms.push_back(make_term(stretch));
    return Potential(system.layout.size(), std::move(terms));
  }

  /// Drawn shape with every corner moved by up to `amplitude` of an edge length.
  State moved(unsigned seed, double amplitude) const {
    std::mt19937 random(seed);
    State state = drawn_state(system);
    state.q += checks::random_increment(system, random, amplitude);
    return state;
  }
};

int inverted(const Body& body, const State& state) {
  int count = 0;
  for (const SolidStretch::Stencil& s : body.stretch.stencils) {
    const auto at = [&](int i) { return Vec3(state.q.segment<3>(s.dofs[3 * i])); };
    count += (at(1) - at(0)).cross(at(2) - at(0)).dot(at(3) - at(0)) <= 0;
  }
  return count;
}

TEST(SolidEnergy, DerivativesAgree) {
  const Body body;
  StencilTerm<SolidStretch> stretch(body.stretch);
  for (const double amplitude : {0.0, 0.02, 0.3, 2.0}) {
    SCOPED_TRACE(amplitude);
    const State state = body.moved(9, amplitude);
    // The last one turns tetrahedra inside out, where all is as smooth as elsewhere.
    EXPECT_EQ(inverted(body, state) > 0, amplitude > 1);
    const checks::TermReport report = checks::check_term(stretch, body.system.layout, state, 0.02, 100);
    EXPECT_EQ(report.energy.compared, stretch.stencils());
    EXPECT_EQ(report.hessian.compared, static_cast<long>(stretch.stencils()) * 144);
    EXPECT_LT(report.energy.worst, 1e-9);
    EXPECT_LT(report.gradient.worst, 1e-9);
    EXPECT_LT(report.hessian.worst, 1e-9);
    EXPECT_LT(report.gradient_by_differences.worst, 1e-6);
    EXPECT_LT(report.hessian_by_differences.worst, 1e-6);
    // At rest nothing hangs on the moduli, and differences by them are rounding.
    if (amplitude > 0) EXPECT_LT(report.mixed_by_differences.worst, 1e-6);
    EXPECT_LT(report.mixed.worst, 1e-9);
    EXPECT_GT(report.mixed.compared, 0);
  }
}

TEST(SolidEnergy, TaylorRemaindersHaveFullOrder) {
  const Body body;
  checks::expect_full_order(body.system, body.potential(), body.moved(21, 0.3));
}

TEST(SolidEnergy, RigidMotionChangesNothing) {
  const Body body;
  checks::expect_rigid_motion_neutral(body.system, body.potential(), body.moved(33, 0.3));
}

TEST(SolidEnergy, NothingIsStressedAtRest) {
  const Body body;
  const Potential potential = body.potential();
  const State state = drawn_state(body.system);
  AssemblyBuffers buffers;
  VecX gradient;
  potential.gradient(state, gradient, buffers);
  // Against the forces of a strain of 1.
  EXPECT_LT(gradient.cwiseAbs().maxCoeff(), 1e-13 * 2e5 * 0.02 * 0.02);
  EXPECT_NEAR(potential.value(state, buffers), 0, 1e-13 * 2e5 * std::pow(0.06, 3));
}

constexpr double kYoung = 3e6, kPoisson = 0.35;

/// Energy per volume under a deformation gradient.
double density(const Mat3& f) {
  const double lambda = kYoung * kPoisson / ((1 + kPoisson) * (1 - 2 * kPoisson));
  std::array<double, 14> rest{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, lambda, kYoung / (2 * (1 + kPoisson))};
  std::array<double, 12> x{};
  for (int i = 0; i < 3; ++i) Eigen::Map<Vec3>(x.data() + 3 + 3 * i) = f.col(i);
  return 6 * SolidStretch::value<double>(x, rest, {});
}

TEST(SolidEnergy, SmallStrainsReturnTheModuli) {
  const double e = 1e-5;
  const auto pulled = [&](double narrowing) {
    return density(Vec3(1 + e, 1 - narrowing * e, 1 - narrowing * e).asDiagonal());
  };
  EXPECT_NEAR(pulled(kPoisson) / (0.5 * kYoung * e * e), 1, 1e-4);
  EXPECT_LT(pulled(kPoisson), pulled(1.05 * kPoisson));
  EXPECT_LT(pulled(kPoisson), pulled(0.95 * kPoisson));
  Mat3 shear = Mat3::Identity();
  shear(0, 1) = e;
  EXPECT_NEAR(density(shear) / (0.5 * kYoung / (2 * (1 + kPoisson)) * e * e), 1, 1e-4);
}

TEST(SolidEnergy, CrushingAndInversionAreResistedMoreAndMore) {
  double last = 0;
  for (double stretch = 0.9; stretch > -1.5; stretch -= 0.1) {
    const double h = 1e-5;
    const double force =
        (density(Vec3(stretch - h, 1, 1).asDiagonal()) - density(Vec3(stretch + h, 1, 1).asDiagonal())) / (2 * h);
    EXPECT_GT(force, last);
    last = force;
  }
}

struct Broken : SolidStretch {
  template <class T>
  static void derivatives(const Local<T>& a, T* gradient, T* hessian) {
    SolidStretch::derivatives(a, gradient, hessian);
    if (hessian != nullptr) hessian[40] *= T(1.001);
    gradient[5] *= T(1.001);
  }
};

TEST(BrokenSolidEnergy, IsCaught) {
  const Body body;
  StencilTerm<Broken> stretch(Broken{body.stretch});
  const checks::TermReport report = checks::check_term(stretch, body.system.layout, body.moved(9, 0.4), 0.02);
  EXPECT_GT(report.hessian.worst, 1e-5);
  EXPECT_GT(report.gradient.worst, 1e-5);
}

}  // namespace
}  // namespace lissom
