/// The gathered gradient and Hessian against the plain sum of all stencils.

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "bench/fabric_problems.h"
#include "bench/first_pose.h"
#include "lissom/core/file_io.h"
#include "lissom/mechanics/potential.h"
#include "lissom/model/document.h"

namespace lissom {
namespace {

State shaken(const System& system, double size) {
  const State drawn = drawn_state(system);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> noise(-size, size);
  VecX dq(system.layout.size());
  for (int i = 0; i < dq.size(); ++i) dq[i] = noise(random);
  State moved;
  EXPECT_TRUE(advance(system, drawn, dq, moved));
  return moved;
}

void expect_sum_of_stencils(const std::string& name, const Model& model) {
  SCOPED_TRACE(name);
  const FirstPose ready = first_pose(name, model);
  ASSERT_TRUE(ready.problem);
  const Potential& potential = ready.problem->potential;
  const State state = shaken(*ready.system, 1e-4 * ready.system->structure.size);
  VecX gradient;
  std::vector<double> values;
  AssemblyBuffers buffers;
  potential.hessian(state, gradient, values, buffers);

  const int n = potential.dofs();
  ASSERT_LT(n, 1500) << "dense";
  VecX plain = VecX::Zero(n);
  MatX dense = MatX::Zero(n, n);
  for (const auto& term : potential.terms()) {
    for (int s = 0; s < term->stencils(); ++s) {
      const StencilDerivatives d = term->automatic(state, VecX::Zero(n), s);
      const int* dof = term->indices().data() + static_cast<std::ptrdiff_t>(s) * term->dofs();
      for (int i = 0; i < term->dofs(); ++i) {
        plain[dof[i]] += d.gradient[i];
        for (int j = 0; j < term->dofs(); ++j) dense(dof[i], dof[j]) += d.hessian(i, j);
      }
    }
  }
  MatX axes = MatX::Identity(n, n);
  for (const LocalAxes& local : potential.local_axes()) {
    axes.block<3, 3>(local.first_dof, local.first_dof) = local.axes;
  }
  plain = axes.transpose() * plain;
  dense = axes.transpose() * dense * axes;

  EXPECT_LE((gradient - plain).cwiseAbs().maxCoeff(), 1e-10 * plain.cwiseAbs().maxCoeff());
  const SparsePattern& pattern = potential.pattern();
  const double largest = dense.cwiseAbs().maxCoeff();
  for (int j = 0; j < n; ++j) {
    for (int i = j; i < n; ++i) {
      const int slot = pattern.slot(i, j);
      const double value = slot < 0 ? 0 : values[slot];
      ASSERT_LE(std::abs(value - dense(i, j)), 1e-10 * largest) << i << ' ' << j;
    }
  }
}

Model document(const std::string& path) {
  const Result<std::string> text = read_file(path);
  EXPECT_TRUE(text);
  const Result<Model> model = read_document(text.value());
  EXPECT_TRUE(model) << path;
  return model.value();
}

TEST(Assembly, IsTheSumOfAllStencils) {
  expect_sum_of_stencils("frame", networks::square_frame_on_fabric({}));
  expect_sum_of_stencils("joints", document("tests/physics/N06-honeycomb.lissom"));
  Model held = networks::square_frame_on_fabric({});
  Support oblique;
  oblique.at.kind = Selector::Kind::kRod;
  oblique.at.name = held.rods[0].name;
  oblique.kind = SupportKind::kFree;
  oblique.directions = {Vec3(0.6, 0.8, 0)};
  held.poses[0].supports.push_back(oblique);
  expect_sum_of_stencils("local axes", held);
}

/// What the rods' own system is made of: rows and columns of some unknowns alone.
TEST(Assembly, LeavesOutWhatIsNotWanted) {
  const Model model = networks::square_frame_on_fabric({});
  const FirstPose ready = first_pose("frame", model);
  ASSERT_TRUE(ready.problem);
  const Potential& whole = ready.problem->potential;
  const std::vector<bool> every(whole.dofs(), true);
  std::vector<bool> wanted(whole.dofs(), false);
  for (const StructureEdge& edge : ready.system->structure.edges) {
    for (int i = 0; i < 3; ++i) wanted[3 * edge.node0 + i] = wanted[3 * edge.node1 + i] = true;
  }
  std::vector<std::unique_ptr<EnergyTerm>> terms;
  for (const auto& term : whole.terms()) terms.push_back(term->touching(every, true));
  const Potential part(whole.dofs(), std::move(terms), {}, wanted);
  const State state = shaken(*ready.system, 1e-4 * ready.system->structure.size);
  VecX whole_gradient, gradient;
  std::vector<double> whole_values, values;
  AssemblyBuffers buffers;
  whole.hessian(state, whole_gradient, whole_values, buffers);
  part.hessian(state, gradient, values, buffers);
  EXPECT_EQ(gradient, whole_gradient);
  int compared = 0;
  for (int j = 0; j < whole.dofs(); ++j) {
    for (int i = j; i < whole.dofs(); ++i) {
      const int slot = part.pattern().slot(i, j);
      const bool both = wanted[i] && wanted[j];
      if (!both) {
        if (i != j) ASSERT_EQ(slot, -1) << i << ' ' << j;
        continue;
      }
      const int whole_slot = whole.pattern().slot(i, j);
      ASSERT_EQ(slot < 0, whole_slot < 0);
      if (slot < 0) continue;
      ASSERT_EQ(values[slot], whole_values[whole_slot]) << i << ' ' << j;
      ++compared;
    }
  }
  EXPECT_GT(compared, 500);
}

}  // namespace
}  // namespace lissom
