/// Stretch and bending of sheets: derivatives, invariance, moduli, and that a wrong derivative is caught.

#include <gtest/gtest.h>
#include <utility>

#include "lissom/geometry/frame.h"
#include "lissom/mechanics/membrane_bend.h"
#include "lissom/mechanics/membrane_stretch.h"
#include "tests/derivatives/derivative_checks.h"
#include "tests/derivatives/potential_checks.h"

namespace lissom {
namespace {

constexpr int kSide = 5;  // vertices per side

std::array<int, 3> dofs_of(int node) { return {3 * node, 3 * node + 1, 3 * node + 2}; }

template <size_t N>
std::array<int, 3 * N> dofs_of(const std::array<int, N>& nodes) {
  std::array<int, 3 * N> dofs;
  for (size_t k = 0; k < N; ++k) std::copy_n(dofs_of(nodes[k]).begin(), 3, dofs.begin() + 3 * k);
  return dofs;
}

/// An uneven square sheet with a warp direction of its own, pre-stretched unequally, and its triangles and inner edges.
struct Sheet {
  System system;
  MembraneStretch stretch;
  MembraneBend bend;

  Sheet() {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const double h = 0.02;
    for (int j = 0; j < kSide; ++j) {
      for (int i = 0; i < kSide; ++i) {
        system.structure.nodes.emplace_back(h * (i + 0.2 * uniform(random)), h * (j + 0.2 * uniform(random)), 0);
      }
    }
    system.layout = DofLayout(system.structure);
    system.rest.mean_edge_length = h;
    const double c = std::cos(0.4), s = std::sin(0.4);
    const auto triangle = [&](int a, int b, int d) {
      std::array<double, 9> rest{0, 0, 0, 0, 0, 0, 50, 18, 0.25};
      for (int k = 0; const int node : {a, b, d}) {
        const Vec3& x = system.structure.nodes[node];
        rest[k++] = (c * x.x() + s * x.y()) / 1.3;
        rest[k++] = (c * x.y() - s * x.x()) / 1.2;
      }
      stretch.stencils.push_back({dofs_of(std::array{a, b, d}), rest});
    };
    const auto hinge = [&](int a, int b, int left, int right) {
      bend.stencils.push_back(
          {dofs_of(std::array{a, b, left, right}), {2e-4 * (2 + uniform(random)), uniform(random)}});
    };
    for (int j = 0; j + 1 < kSide; ++j) {
      for (int i = 0; i + 1 < kSide; ++i) {
        const int a = j * kSide + i, b = a + 1, d = a + kSide, e = d + 1;
        triangle(a, b, e);
        triangle(a, e, d);
        hinge(a, e, d, b);
        if (j > 0) hinge(a, b, e, a - kSide);
        if (i > 0) hinge(d, a, e, a - 1);
      }
    }
  }

  Potential potential() const {
    std::vector<std::unique_ptr<EnergyTerm>> terms;
    terms.push_back(make_term(stretch));
    terms.push_back(make_term(bend));
    return Potential(system.layout.size(), std::move(terms));
  }

  /// Drawn shape with every vertex moved by up to `amplitude` of an edge length.
  State moved(unsigned seed, double amplitude) const {
    std::mt19937 random(seed);
    State state = drawn_state(system);
    state.q += checks::random_increment(system, random, amplitude);
    return state;
  }
};

void expect_exact(EnergyTerm& term, const Sheet& sheet, const State& state) {
  SCOPED_TRACE(std::string(term.name()));
  const checks::TermReport report =
      checks::check_term(term, sheet.system.layout, state, sheet.system.rest.mean_edge_length, 100);
  EXPECT_EQ(report.energy.compared, term.stencils());
  EXPECT_EQ(report.hessian.compared, static_cast<long>(term.stencils()) * term.dofs() * term.dofs());
  EXPECT_LT(report.energy.worst, 1e-9);
  EXPECT_LT(report.gradient.worst, 1e-9);
  EXPECT_LT(report.hessian.worst, 1e-9);
  EXPECT_LT(report.gradient_by_differences.worst, 1e-6);
  EXPECT_LT(report.hessian_by_differences.worst, 1e-6);
  EXPECT_LT(report.mixed_by_differences.worst, 1e-6);
  EXPECT_LT(report.mixed.worst, 1e-9);
  EXPECT_GT(report.mixed.compared, 0);
}

TEST(MembraneEnergies, DerivativesAgree) {
  const Sheet sheet;
  for (const double amplitude : {0.02, 0.4}) {
    const State state = sheet.moved(9, amplitude);
    StencilTerm<MembraneStretch> stretch(sheet.stretch);
    StencilTerm<MembraneBend> bend(sheet.bend);
    expect_exact(stretch, sheet, state);
    expect_exact(bend, sheet, state);
  }
}

TEST(MembraneEnergies, FlatSheetHasExactDerivatives) {
  const Sheet sheet;
  const State state = drawn_state(sheet.system);
  StencilTerm<MembraneStretch> stretch(sheet.stretch);
  StencilTerm<MembraneBend> bend(sheet.bend);
  expect_exact(stretch, sheet, state);
  expect_exact(bend, sheet, state);
}

/// Pressed together along x until triangles resist being crushed, some of a pack more than others, some not at all.
TEST(MembraneEnergies, CrushedSheetHasExactDerivatives) {
  const Sheet sheet;
  StencilTerm<MembraneStretch> stretch(sheet.stretch);
  for (const double squeeze : {0.05, 0.2, 0.3}) {
    State state = sheet.moved(9, 0.1);
    for (int i = 0; i < sheet.system.layout.nodes(); ++i) {
      state.q[3 * i] *= squeeze;
      state.q[3 * i + 2] += 0.3 * state.q[3 * i + 1];
    }
    expect_exact(stretch, sheet, state);
  }
}

TEST(MembraneEnergies, TaylorRemaindersHaveFullOrder) {
  const Sheet sheet;
  checks::expect_full_order(sheet.system, sheet.potential(), sheet.moved(21, 0.3));
}

TEST(MembraneEnergies, RigidMotionChangesNothing) {
  const Sheet sheet;
  checks::expect_rigid_motion_neutral(sheet.system, sheet.potential(), sheet.moved(33, 0.3));
}

/// Energy of one right triangle of area 1/2 m^2 with moduli (50, 18, 0.25) under a displacement gradient.
double energy_of(double g11, double g12, double g22) {
  const std::array<double, 9> x{0, 0, 0, 1 + g11, 0, 0, g12, 1 + g22, 0};
  const std::array<double, 9> rest{0, 0, 1, 0, 0, 1, 50, 18, 0.25};
  return MembraneStretch::value<double>(x, rest, {Vec2::Ones()});
}

TEST(MembraneEnergies, SmallStrainsReturnTheModuli) {
  // A small pull along 1 that leaves 2 free: slope Y1, narrowing mu sqrt(Y1 / Y2).
  const double e = 1e-5, narrowing = 0.25 * std::sqrt(50.0 / 18.0);
  const double at_rest_2 = energy_of(e, 0, -narrowing * e);
  EXPECT_NEAR(at_rest_2 / (0.5 * 0.5 * 50 * e * e), 1, 1e-4);
  EXPECT_LT(at_rest_2, energy_of(e, 0, -1.05 * narrowing * e));
  EXPECT_LT(at_rest_2, energy_of(e, 0, -0.95 * narrowing * e));
  // Simple shear gamma: G gamma^2 / 2 with G = sqrt(Y1 Y2) / (2 (1 + mu)) = 12.
  EXPECT_NEAR(energy_of(0, e, 0) / (0.5 * 0.5 * 12 * e * e), 1, 1e-4);
}

TEST(MembraneEnergies, CrushingIsResistedMoreAndMore) {
  // Across nothing moves. The sheet alone would need less and less force.
  const auto force = [](double stretch) {
    const double h = 1e-6;
    return (energy_of(stretch - 1 - h, 0, 0) - energy_of(stretch - 1 + h, 0, 0)) / (2 * h);
  };
  const double begin = SheetCrush<double>::kCrushedArea;
  EXPECT_LT(force(begin), force(1 / std::sqrt(3.0)));
  double last = force(begin);
  for (double stretch = begin - 0.02; stretch > 0.01; stretch -= 0.02) {
    EXPECT_GT(force(stretch), stretch < begin - 0.05 ? last : 0);
    last = force(stretch);
  }
  EXPECT_GT(energy_of(1e-3 - 1, 0, 0), 1e3 * energy_of(begin - 1, 0, 0));
}

TEST(MembraneEnergies, FoldAngleHasTheStatedSign) {
  const std::array<double, 2> rest{2, 0};
  // Wings below the edge, normals up: they fold away from the normals.
  const auto energy = [&](double z, double rest_angle) {
    const std::array<double, 12> x{0, 0, 0, 1, 0, 0, 0.3, 1, z, 0.6, -1, z};
    return MembraneBend::value<double>(x, std::array<double, 2>{rest[0], rest_angle}, {});
  };
  const double angle = 2 * std::atan(0.5);
  EXPECT_NEAR(energy(-0.5, 0), angle * angle, 1e-12);
  EXPECT_NEAR(energy(-0.5, angle), 0, 1e-24);
  EXPECT_NEAR(energy(0.5, -angle), 0, 1e-24);
}

/// Stretch with a factor missing in one entry of its Hessian; bending with a sign lost in its gradient.
struct BrokenStretch : MembraneStretch {
  template <class T>
  static void derivatives(const Local<T>& a, T* gradient, T* hessian) {
    MembraneStretch::derivatives(a, gradient, hessian);
    if (hessian != nullptr) hessian[9] *= T(1.001);
  }
};
struct BrokenBend : MembraneBend {
  template <class T>
  static void derivatives(const Local<T>& a, T* gradient, T* hessian) {
    MembraneBend::derivatives(a, gradient, hessian);
    gradient[4] = -gradient[4];
  }
};

TEST(BrokenMembraneEnergies, AreCaught) {
  const Sheet sheet;
  const State state = sheet.moved(9, 0.4);
  StencilTerm<BrokenStretch> stretch(BrokenStretch{sheet.stretch});
  const checks::TermReport stretched = checks::check_term(stretch, sheet.system.layout, state, 0.02);
  EXPECT_GT(stretched.hessian.worst, 1e-5);
  EXPECT_LT(stretched.gradient.worst, 1e-9);
  StencilTerm<BrokenBend> bend(BrokenBend{sheet.bend});
  const checks::TermReport bent = checks::check_term(bend, sheet.system.layout, state, 0.02);
  EXPECT_GT(bent.gradient.worst, 1e-3);
  EXPECT_LT(bent.hessian.worst, 1e-9);
}

}  // namespace
}  // namespace lissom
