/// Uses the installed headers and the library with the compiler's default flags, which differ from lissom's own: builds a
/// cantilever, loads it and compares its tip with the elastica. Vectors are made on one side and freed on the other.

#include <cmath>
#include <cstdio>
#include <utility>

#include "lissom/equilibrium/solve.h"
#include "lissom/model/model.h"

int main() {
  using namespace lissom;
  Model model;
  Rod rod;
  rod.name = "beam";
  rod.curve = Polyline{{Vec3::Zero(), Vec3(0.2, 0, 0)}, false};
  rod.material = "TPU 92A";
  rod.section.r_n = rod.section.r_b = {0.001};
  rod.edges = 100;
  model.rods.push_back(rod);

  Selector start, end;
  start.kind = end.kind = Selector::Kind::kRod;
  start.name = end.name = "beam";
  start.fraction = 0;
  end.fraction = 1;
  Pose pose;
  pose.name = "loaded";
  Support clamp;
  clamp.at = start;
  clamp.kind = SupportKind::kClamp;
  pose.supports.push_back(clamp);
  PointForce pull;
  pull.at = end;
  model.poses.push_back(pose);

  const Result<System> system = make_system(model);
  if (!system) return std::printf("%s\n", system.error().text().c_str()), 1;
  // The load F L^2 / B = 1 of the elastica: the tip falls by 0.30172 L and comes nearer by 0.05643 L.
  const double load = system.value().rest.pairs[0].bend_1 / (0.2 * 0.2);
  pull.force = Vec3(0, 0, -load);
  model.poses[0].forces.push_back(pull);
  const Result<StaticProblem> problem = make_static_problem(model, system.value(), model.poses[0], "/poses/0");
  if (!problem) return std::printf("%s\n", problem.error().text().c_str()), 1;
  for (int repetition = 0; repetition < 3; ++repetition) {
    State begin = start_state(problem.value(), model.poses[0]), moved;
    const VecX turned = VecX::Zero(begin.q.size());
    if (!advance(system.value(), begin, 0.5 * turned, moved)) return 1;
    std::swap(begin, moved);
    Equilibrium e = solve(problem.value(), begin, 1, {});
    e.state.q *= 1.0;
    const Vec3 tip = e.state.position(100);
    std::printf("consumer: %s tip at %.4f L, %.4f L\n", e.message.c_str(), tip.x() / 0.2, tip.z() / 0.2);
    if (e.verdict != Verdict::kStable || std::abs(tip.z() / 0.2 + 0.30172) > 1e-3 ||
        std::abs(1 - tip.x() / 0.2 - 0.05643) > 1e-3) {
      return 1;
    }
  }
  return 0;
}
