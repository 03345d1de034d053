/// What derivatives cost: the gradient of an inverse problem beside one solve for an equilibrium, over the number of parameters;
/// and an iteration of four poses on one thread and on two.

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <string>
#include <vector>

#include "bench/inverse_problems.h"
#include "bench/timing.h"
#include "lissom/core/parallel.h"
#include "lissom/design/design_spaces.h"

namespace lissom {
namespace {

constexpr int kRepetitions = 5;

/// Every k-th of the parameters of a space, `count` in all.
Result<SpacePtr> some_of(const SpacePtr& space, int count) {
  std::vector<int> which;
  for (int i = 0; i < count; ++i) which.push_back(static_cast<int>(static_cast<long>(i) * space->size() / count));
  Result<MappedSpace> chosen = chosen_parameters(space, which);
  if (!chosen) return chosen.error();
  return SpacePtr(std::make_shared<const MappedSpace>(std::move(chosen).value()));
}

/// A honeycomb of 12 by 24 cells that is pulled and hangs; radii and rest shape at four places of every rod.
Model large_sheet() {
  const ObjLines lines = hexagon_pattern(0.02, 12, 24);
  Model model = scene_models::sheet("large sheet", lines, 2e-3, "TPU 92A", 10);
  model.poses.push_back(scene_models::hanging_pose(lines, 1e-6));
  inverse::Places targets;
  const Structure structure = make_system(model).value().structure;
  for (const Vec3& x : structure.nodes) targets.push_back(x + Vec3(0, 0, 0.01));
  model.design.emplace();
  model.design->parameters = {inverse::radii(4, {1e-3, 5e-3}), inverse::rest_shape(4, 0.01)};
  model.design->goals = {inverse::at_places(inverse::everything(), targets)};
  return model;
}

bool gradients(const Context& context) {
  const Model model = large_sheet();
  const Result<BriefSpace> space = make_brief_space(*model.design, model);
  if (!space) return std::fprintf(stderr, "%s\n", space.error().text().c_str()), false;
  const Result<BriefGoals> goals = make_brief_goals(*model.design, space.value());
  if (!goals) return std::fprintf(stderr, "%s\n", goals.error().text().c_str()), false;
  std::printf("%d parameters in all, %d nodes\n", space.value().space->size(),
              static_cast<int>(space.value().base->system.structure.nodes.size()));
  for (const int count : {10, 30, 100, 300, 1000, 3000, 5000}) {
    const Result<SpacePtr> some = some_of(space.value().space, count);
    if (!some) return std::fprintf(stderr, "%s\n", some.error().text().c_str()), false;
    Result<std::unique_ptr<StructureProblem>> made =
        StructureProblem::make(some.value(), goals.value().goals, {}, {}, context);
    if (!made) return std::fprintf(stderr, "%s\n", made.error().text().c_str()), false;
    StructureProblem& problem = *made.value();
    const double solve = median_ms(1, [&] { (void)problem.release(); });
    std::vector<double> times, resettled;
    VecX x = problem.x();
    for (int k = 0; k < kRepetitions; ++k) {
      x.array() += 1e-3;
      double begin = now_ms();
      const Attempt attempt = problem.attempt(x);
      resettled.push_back(now_ms() - begin);
      if (attempt.outcome != Outcome::kSettled) return std::fprintf(stderr, "%s\n", attempt.reason.c_str()), false;
      problem.accept();
      begin = now_ms();
      (void)problem.gradient();
      times.push_back(now_ms() - begin);
    }
    std::sort(times.begin(), times.end());
    std::sort(resettled.begin(), resettled.end());
    const double gradient = times[kRepetitions / 2], warm = resettled[kRepetitions / 2];
    std::printf(
        "%5d parameters: equilibrium %8.1f ms cold, %7.1f ms warm, gradient %7.2f ms: %.4f of a cold one, %.3f of a "
        "warm one\n",
        count, solve, warm, gradient, gradient / solve, gradient / warm);
    const std::string name = "gradient, " + std::to_string(count) + " parameters";
    row(name, "time", gradient, "ms");
    row(name, "over an equilibrium, cold", gradient / solve, "");
    row(name, "over an equilibrium, warm", gradient / warm, "");
  }
  return true;
}

/// ms, of an attempt, its acceptance, J'J and the gradient of the Sheet's four poses.
double iteration(const Model& model, const Context& context) {
  const Result<std::unique_ptr<StructureProblem>> made = inverse::released(model, context);
  if (!made) return -1;
  StructureProblem& problem = *made.value();
  VecX x = problem.x();
  std::vector<double> times;
  for (int k = 0; k < kRepetitions; ++k) {
    x.array() += 0.02;
    const double begin = now_ms();
    if (problem.attempt(x).outcome != Outcome::kSettled) return -1;
    problem.accept();
    (void)problem.gram();
    (void)problem.gradient();
    times.push_back(now_ms() - begin);
  }
  std::sort(times.begin(), times.end());
  return times[kRepetitions / 2];
}

bool poses(const Context& two) {
  Result<Model> model = scene_models::sheet_with_brief(scene_models::SheetTargets::kOtherRadii, two);
  if (!model) return std::fprintf(stderr, "%s\n", model.error().text().c_str()), false;
  for (const std::size_t stage : {0, 2, 3}) {
    Model one = model.value();
    if (stage < one.design->stages.size()) one.design->parameters = one.design->stages[stage].parameters;
    one.design->stages.clear();
    const double alone = iteration(one, {}), both = iteration(one, two);
    if (alone < 0 || both < 0) return std::fprintf(stderr, "the Sheet did not settle\n"), false;
    const std::string name = "iteration of four poses, stage " + std::to_string(stage + 1);
    std::printf("%s: %.1f ms on one thread, %.1f ms on two: %.2f times faster\n", name.c_str(), alone, both,
                alone / both);
    row(name, "one thread over two", alone / both, "");
  }
  return true;
}

}  // namespace
}  // namespace lissom

int main() {
  lissom::ThreadPool threads(2);
  lissom::Context two;
  two.threads = &threads;
  const bool first = lissom::gradients(two), second = lissom::poses(two);
  return first && second ? 0 : 1;
}
