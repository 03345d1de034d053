/// All rod, joint and load energies: derivatives, invariance, and that a wrong one is caught.

#include <gtest/gtest.h>
#include <utility>

#include "lissom/geometry/frame.h"
#include "lissom/mechanics/energies.h"
#include "lissom/mechanics/rod_stretch.h"
#include "tests/derivatives/derivative_checks.h"

namespace lissom {
namespace {

/// Five rods in space: a naturally curved and twisted one, an elliptic taper, a helix; joints of two, three and four ends.
Model test_model(JointKind joints) {
  Model model;
  model.joint_kind = joints;
  model.torsion = TorsionModel::kPolar;
  const auto rod = [&](const char* name, Curve curve, std::vector<double> r_n, std::vector<double> r_b) {
    Rod r;
    r.name = name;
    r.curve = std::move(curve);
    r.material = "TPU 92A";
    r.section.r_n = std::move(r_n);
    r.section.r_b = std::move(r_b);
    r.edges = 7;
    model.rods.push_back(r);
  };
  const Vec3 o(0, 0, 0), a(0.05, 0, 0.01), b(-0.04, 0.03, 0), c(-0.01, -0.05, -0.01), d(0.06, 0.05, 0.02);
  rod("taper", Polyline{{o, a}}, {0.001, 0.002}, {0.002, 0.001});
  rod("spline", Spline{{o, Vec3(-0.02, 0.03, 0.01), b}}, {0.001}, {0.0015});
  rod("curved", Polyline{{c, o}}, {0.0012}, {0.0012});
  rod("across", Polyline{{o, d}}, {0.001}, {0.003});
  rod("closing", Polyline{{a, d}}, {0.001}, {0.001});
  model.rods[2].natural.kind = Natural::Kind::kCurved;
  model.rods[2].natural.curvature_b = 20;
  model.rods[2].natural.curvature_n = -7;
  model.rods[2].natural.twist = 11;
  Pose pose;
  pose.name = "loaded";
  Support clamp;
  clamp.at.kind = Selector::Kind::kRod;
  clamp.at.name = "curved";
  clamp.at.fraction = 0;
  clamp.kind = SupportKind::kClamp;
  pose.supports.push_back(clamp);
  pose.gravity = Gravity{};
  PointForce force;
  force.at = clamp.at;
  force.at.name = "spline";
  force.at.fraction = 1;
  force.force = Vec3(0.01, -0.02, 0.03);
  pose.forces.push_back(force);
  PointMoment moment;
  moment.at = clamp.at;
  moment.moment = Vec3(0.001, 0.002, -0.003);
  pose.moments.push_back(moment);
  LineLoad line;
  line.force_per_length = Vec3(0.1, 0.2, -0.1);
  pose.line_loads.push_back(line);
  SoftPin pin;
  pin.at = force.at;
  pin.stiffness = 12;
  pin.target = Vec3(0, 0, 0.02);
  pose.soft_pins.push_back(pin);
  model.poses.push_back(pose);
  return model;
}

class Energies : public testing::TestWithParam<JointKind> {
 protected:
  void SetUp() override {
    model_ = test_model(GetParam());
    Result<System> system = make_system(model_);
    ASSERT_TRUE(system.ok()) << system.error().text();
    system_ = std::move(system).value();
    auto terms = make_terms(model_, system_, &model_.poses[0], "/poses/0");
    ASSERT_TRUE(terms.ok()) << terms.error().text();
    potential_.emplace(system_.layout.size(), std::move(terms).value());
    // Far from rest, over many transported steps.
    std::mt19937 random(17);
    state_ = drawn_state(system_);
    state_.load_factor = 0.7;
    State next;
    for (int k = 0; k < 40; ++k) {
      ASSERT_TRUE(advance(system_, state_, checks::random_increment(system_, random, 0.06), next));
      std::swap(state_, next);
    }
  }

  Model model_;
  System system_;
  std::optional<Potential> potential_;
  State state_;
};

TEST_P(Energies, DerivativesOfEveryTermAgree) {
  int terms = 0;
  for (int t = 0; t < static_cast<int>(potential_->terms().size()); ++t) {
    EnergyTerm& term = potential_->term(t);
    SCOPED_TRACE(std::string(term.name()));
    const checks::TermReport report = checks::check_term(term, system_.layout, state_, system_.rest.mean_edge_length);
    EXPECT_GT(report.hessian.compared, 0);
    EXPECT_LT(report.energy.worst, 1e-9);
    EXPECT_LT(report.gradient.worst, 1e-9);
    EXPECT_LT(report.hessian.worst, 1e-9);
    EXPECT_LT(report.gradient_by_differences.worst, 1e-6);
    EXPECT_LT(report.hessian_by_differences.worst, 1e-6);
    EXPECT_LT(report.mixed_by_differences.worst, 1e-6);
    EXPECT_LT(report.mixed.worst, 1e-9);
    EXPECT_GT(report.mixed.compared, 0);
    ++terms;
  }
  EXPECT_EQ(terms, GetParam() == JointKind::kExplicit ? 8 : 10);
}

TEST_P(Energies, TaylorRemaindersHaveFullOrder) {
  std::mt19937 random(5);
  for (int k = 0; k < 5; ++k) {
    const VecX direction = checks::random_increment(system_, random, 1);
    const checks::TaylorSlopes slopes = checks::taylor_slopes(system_, *potential_, state_, direction, 2e-2);
    EXPECT_GT(slopes.gradient, 1.95);
    EXPECT_GT(slopes.hessian, 2.95);
  }
}

TEST_P(Energies, RigidMotionChangesNothing) {
  auto elastic = make_terms(model_, system_, nullptr, "");
  ASSERT_TRUE(elastic.ok());
  const Potential potential(system_.layout.size(), std::move(elastic).value());
  AssemblyBuffers buffers;
  const double v = potential.value(state_, buffers);
  const Mat3 rotation = rotation_from_vector(Vec3(1.1, -2.0, 0.6));
  const State moved = rigidly_moved(system_, state_, rotation, Vec3(0.01, 0.02, 0.03), Vec3(0.2, -0.1, 0.3));
  EXPECT_NEAR(potential.value(moved, buffers) / v, 1, 1e-12);
  VecX g, g_moved;
  potential.gradient(state_, g, buffers);
  potential.gradient(moved, g_moved, buffers);
  const double scale = g.cwiseAbs().maxCoeff();
  for (int i = 0; i < system_.layout.nodes(); ++i) {
    EXPECT_LT((rotation * g.segment<3>(3 * i) - g_moved.segment<3>(3 * i)).norm(), 1e-9 * scale);
  }
}

TEST_P(Energies, ThreadsChangeNoByte) {
  AssemblyBuffers buffers;
  VecX g1, g2;
  std::vector<double> h1, h2;
  potential_->hessian(state_, g1, h1, buffers);
  const double v1 = potential_->value(state_, buffers);
  for (const int threads : {2, 8}) {
    ThreadPool pool(threads);
    AssemblyBuffers other;
    potential_->hessian(state_, g2, h2, other, &pool);
    EXPECT_EQ(g1, g2);
    EXPECT_EQ(h1, h2);
    EXPECT_EQ(v1, potential_->value(state_, other, &pool));
  }
}

INSTANTIATE_TEST_SUITE_P(Joints, Energies, testing::Values(JointKind::kExplicit, JointKind::kCorotational),
                         [](const auto& test) {
                           return test.param == JointKind::kExplicit ? "Explicit" : "Corotational";
                         });

/// Stretch with a factor missing in one block of its Hessian.
struct BrokenStretch : RodStretch {
  template <class T>
  static void derivatives(const Local<T>& a, T* gradient, T* hessian) {
    RodStretch::derivatives(a, gradient, hessian);
    if (hessian != nullptr) hessian[9] *= T(1.001);
  }
};

TEST(BrokenEnergy, IsCaught) {
  const Model model = test_model(JointKind::kExplicit);
  Result<System> system = make_system(model);
  ASSERT_TRUE(system.ok());
  BrokenStretch broken;
  for (int e = 0; e < system.value().edge_count(); ++e) {
    const StructureEdge& edge = system.value().structure.edges[e];
    const int a = 3 * edge.node0, b = 3 * edge.node1;
    const EdgeRest& rest = system.value().rest.edges[e];
    broken.stencils.push_back({{a, a + 1, a + 2, b, b + 1, b + 2}, {rest.length * 1.01, rest.stretch}, e});
  }
  StencilTerm<BrokenStretch> term(broken);
  const State state = drawn_state(system.value());
  const checks::TermReport report =
      checks::check_term(term, system.value().layout, state, system.value().rest.mean_edge_length);
  EXPECT_GT(report.hessian.worst, 1e-5);
  EXPECT_LT(report.gradient.worst, 1e-9);
}

}  // namespace
}  // namespace lissom
