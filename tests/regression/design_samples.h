#pragma once
/// What all tests of design spaces ask: that a design is what its description says, and that its equilibria answer to
/// parameters as those solved again do.

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <memory>
#include <utility>
#include <vector>

#include "lissom/design/design_space.h"
#include "lissom/design/sensitivity.h"
#include "lissom/equilibrium/newton_workspace.h"
#include "lissom/equilibrium/solve.h"
#include "lissom/mechanics/rest_jacobian.h"

namespace lissom::samples {

inline std::shared_ptr<const Design> base_of(const Model& model) {
  const Status valid = model.validate();
  EXPECT_TRUE(valid) << valid.error().text();
  Result<System> system = make_system(model);
  EXPECT_TRUE(system) << system.error().text();
  return std::make_shared<const Design>(Design{model, std::move(system).value()});
}

template <class Space>
Space made(Result<Space> space) {
  EXPECT_TRUE(space) << (space ? "" : space.error().text());
  return std::move(space).value();
}

inline Design design_at(const DesignSpace& space, const VecX& p) {
  Result<Design> design = space.at(p);
  EXPECT_TRUE(design) << (design ? "" : design.error().text());
  return std::move(design).value();
}

/// Parameters that differ from each other, within their bounds, `share` of the range away from the start at most.
inline VecX uneven(const DesignSpace& space, double share = 0.1) {
  VecX p = space.start();
  for (int i = 0; i < p.size(); ++i) {
    const Parameter& parameter = space.parameters()[static_cast<std::size_t>(i)];
    p[i] += share * (parameter.upper - parameter.lower) * std::sin(1.0 + 2.3 * i);
    p[i] = std::clamp(p[i], parameter.lower, parameter.upper);
  }
  return p;
}

/// Which rest numbers are angles, or coordinates that may be zero: their rounding does not shrink with them.
inline std::vector<bool> absolute_numbers(const Structure& structure) {
  const RestNumbers layout(structure);
  std::vector<bool> absolute(static_cast<std::size_t>(layout.size()), false);
  const auto mark = [&](int number) { absolute[static_cast<std::size_t>(number)] = true; };
  for (int p = 0; p < static_cast<int>(structure.pairs.size()); ++p) {
    for (const int strain : {kKappa1, kKappa2, kRestTwist}) mark(layout.pair(p, strain));
  }
  int connection = 0;
  for (const StructureJoint& joint : structure.joints) {
    for (std::size_t k = 0; k < joint.connections.size(); ++k, ++connection) {
      for (int i = 0; i < 3; ++i) mark(layout.connection(connection, kRestTurn + i));
    }
  }
  for (int t = 0; t < static_cast<int>(structure.triangles.size()); ++t) {
    for (int i = 0; i < 6; ++i) mark(layout.triangle(t, kCorner + i));
  }
  for (int h = 0; h < static_cast<int>(structure.hinges.size()); ++h) mark(layout.hinge(h, kHingeAngle));
  return absolute;
}

inline void expect_same_numbers(const Structure& structure, const VecX& got, const VecX& expected, double tolerance) {
  ASSERT_EQ(got.size(), expected.size());
  const std::vector<bool> absolute = absolute_numbers(structure);
  for (int i = 0; i < got.size(); ++i) {
    const double size =
        absolute[static_cast<std::size_t>(i)] ? std::max(1.0, std::abs(expected[i])) : std::abs(expected[i]);
    EXPECT_NEAR(got[i], expected[i], tolerance * size) << i;
  }
}

/// Places within `tolerance` of the size of the structure, all others of themselves.
inline void expect_same_inputs(const Structure& structure, const VecX& got, const VecX& expected, double tolerance) {
  ASSERT_EQ(got.size(), expected.size());
  const int places = 3 * static_cast<int>(structure.nodes.size());
  for (int i = 0; i < got.size(); ++i) {
    EXPECT_NEAR(got[i], expected[i], tolerance * (i < places ? structure.size : std::abs(expected[i]))) << i;
  }
}

/// The description, discretised anew, and the formulas that are differentiated both give the rest numbers of the design;
/// inputs follow the parameters as the space says.
inline void expect_consistent(const DesignSpace& space, const VecX& p, double tolerance = 1e-12) {
  const Design design = design_at(space, p);
  const Status valid = design.model.validate();
  EXPECT_TRUE(valid) << valid.error().text();
  const VecX numbers = rest_number_values(design.system);
  const VecX inputs = rest_input_values(design.model, design.system);
  {
    SCOPED_TRACE("by the formulas");
    expect_same_numbers(design.system.structure, rest_numbers_of(design.model, design.system, inputs), numbers,
                        tolerance);
  }
  const Result<System> again = make_system(design.model);
  ASSERT_TRUE(again) << again.error().text();
  {
    SCOPED_TRACE("discretised anew");
    expect_same_numbers(design.system.structure, rest_number_values(again.value()), numbers, tolerance);
    expect_same_inputs(design.system.structure, rest_input_values(design.model, again.value()), inputs, tolerance);
  }
  ASSERT_EQ(again.value().connections.size(), design.system.connections.size());
  for (std::size_t k = 0; k < design.system.connections.size(); ++k) {
    const Frame &a = again.value().connections[k].rest, &b = design.system.connections[k].rest;
    EXPECT_LT((a.t - b.t).norm() + (a.b - b.b).norm() + (a.n - b.n).norm(), 10 * tolerance) << k;
  }
  for (std::size_t e = 0; e < design.system.structure.edges.size(); ++e) {
    const Frame &a = again.value().structure.edges[e].drawn, &b = design.system.structure.edges[e].drawn;
    EXPECT_LT((a.t - b.t).norm() + (a.b - b.b).norm(), 10 * tolerance) << e;
    const Frame &c = again.value().structure.edges[e].rest, &d = design.system.structure.edges[e].rest;
    EXPECT_LT((c.t - d.t).norm() + (c.b - d.b).norm(), 10 * tolerance) << e;
  }
}

/// d inputs / d p against central differences, extrapolated once; exact for linear spaces whatever the step.
inline void expect_input_jacobian(const DesignSpace& space, const VecX& p, double tolerance = 1e-9) {
  const Design design = design_at(space, p);
  const DesignJacobian jacobian = space.jacobian(design, p);
  const VecX sizes = rest_input_values(design.model, design.system);
  for (int i = 0; i < p.size(); ++i) {
    const Parameter& parameter = space.parameters()[static_cast<std::size_t>(i)];
    VecX field[2];
    for (int level = 0; level < 2; ++level) {
      const double step = 1e-2 * parameter.scale / (level + 1);
      VecX low = p, high = p;
      low[i] = std::max(p[i] - step, parameter.lower);
      high[i] = std::min(p[i] + step, parameter.upper);
      const Design a = design_at(space, low), b = design_at(space, high);
      field[level] = (rest_input_values(b.model, b.system) - rest_input_values(a.model, a.system)) / (high[i] - low[i]);
    }
    const VecX expected = (4 * field[1] - field[0]) / 3;
    const VecX exact = jacobian.inputs.cols() > 0 ? VecX(jacobian.inputs.col(i)) : VecX(VecX::Zero(expected.size()));
    for (int k = 0; k < expected.size(); ++k) {
      const double rounding = 1e-13 * std::abs(sizes[k]) / (1e-2 * parameter.scale);
      EXPECT_NEAR(exact[k], expected[k], tolerance * std::abs(expected[k]) + rounding)
          << parameter.name << ", input " << k;
    }
  }
}

struct Solved {
  Design design;
  std::unique_ptr<StaticProblem> problem;
  State state;
};

/// The equilibrium of a pose, from `start`, of any design of the space, or else from the drawn shape, polished beyond what a
/// solve asks for.
inline std::unique_ptr<Solved> solved(const DesignSpace& space, const VecX& p, int pose, const State* start) {
  auto out = std::make_unique<Solved>(Solved{design_at(space, p), nullptr, {}});
  const Model& model = out->design.model;
  Result<StaticProblem> problem =
      make_static_problem(model, out->design.system, model.poses[static_cast<std::size_t>(pose)], "/poses/0");
  EXPECT_TRUE(problem) << (problem ? "" : problem.error().text());
  out->problem = std::make_unique<StaticProblem>(std::move(problem).value());
  SolveOptions options;
  options.modes = 0;
  State from;
  if (start == nullptr) {
    from = start_state(*out->problem, model.poses[static_cast<std::size_t>(pose)]);
  } else {
    // Twists against joints, and rotations that follow the rods, are those of this design.
    EXPECT_TRUE(advance(out->design.system, *start, VecX::Zero(start->q.size()), from));
  }
  const Equilibrium e = solve(*out->problem, from, 1, options);
  EXPECT_EQ(e.verdict, Verdict::kStable) << e.message;
  out->state = e.state;
  const Context context;
  NewtonWorkspace workspace(*out->problem, context);
  VecX free, increment;
  State moved;
  for (int k = 0; k < 3; ++k) {
    workspace.assemble(out->state);
    EXPECT_TRUE(workspace.factorize(0).positive_definite);
    workspace.factor().solve(-workspace.free_gradient(), free);
    workspace.to_increment(free, increment);
    EXPECT_TRUE(advance(out->design.system, out->state, increment, moved));
    std::swap(out->state, moved);
  }
  return out;
}

/// dq/dp of positions against equilibria solved again, for the parameters numbered. `step`: over the scale of a parameter.
inline void expect_sensitivities(const DesignSpace& space, const VecX& p, int pose, const std::vector<int>& parameters,
                                 double step = 1e-2, double tolerance = 1e-7) {
  const std::unique_ptr<Solved> at = solved(space, p, pose, nullptr);
  const Context context;
  NewtonWorkspace workspace(*at->problem, context);
  workspace.assemble(at->state);
  ASSERT_TRUE(workspace.factorize(0).positive_definite);
  const Result<Sensitivity> sensitivity = Sensitivity::make(at->design.model, pose, *at->problem, at->state,
                                                            workspace.factor(), space.jacobian(at->design, p));
  ASSERT_TRUE(sensitivity) << sensitivity.error().text();
  const int positions = 3 * at->design.system.layout.nodes();
  const MatX dense = sensitivity.value().dense();
  for (const int parameter : parameters) {
    SCOPED_TRACE(space.parameters()[static_cast<std::size_t>(parameter)].name);
    VecX field[2];
    for (int level = 0; level < 2; ++level) {
      const double h = step * space.parameters()[static_cast<std::size_t>(parameter)].scale / (level + 1);
      VecX sides[2];
      for (int side = 0; side < 2; ++side) {
        VecX moved = p;
        moved[parameter] += side == 0 ? -h : h;
        sides[side] = solved(space, moved, pose, &at->state)->state.q.head(positions);
      }
      field[level] = (sides[1] - sides[0]) / (2 * h);
    }
    const VecX again = (4 * field[1] - field[0]) / 3;
    const VecX exact = sensitivity.value().forward(VecX::Unit(space.size(), parameter)).head(positions);
    ASSERT_GT(again.norm(), 0);
    EXPECT_LT((exact - again).norm(), tolerance * again.norm());
    EXPECT_LT((dense.col(parameter).head(positions) - exact).norm(), 1e-9 * exact.norm());
    VecX weights = VecX::Zero(at->design.system.layout.size());
    weights.head(positions) = again / again.norm();
    EXPECT_NEAR(sensitivity.value().adjoint(weights)[parameter], exact.dot(weights.head(positions)),
                1e-9 * exact.norm());
  }
}

}  // namespace lissom::samples
