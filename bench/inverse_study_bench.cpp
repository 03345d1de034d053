/// Six inverse problems by every method: iterations, equilibria, time, where they end, what failed. docs/guide/inverse.md has
/// the tables and what follows from them.

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstring>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "bench/inverse_problems.h"
#include "bench/timing.h"
#include "bench/yardsticks/alglib_yardstick.h"
#include "bench/yardsticks/ipopt_yardstick.h"
#include "lissom/core/parallel.h"
#include "lissom/design/optimizer.h"
#include "lissom/design/projected_problem.h"
#include "lissom/design/total_methods.h"

namespace lissom {
namespace {

constexpr int kMostIterations = 100;
constexpr double kMostSeconds = 15;  // of one method on one problem
constexpr double kGradient = 1e-7, kDecrease = 1e-9;

struct Line {
  std::string method;
  int iterations = 0, failed = 0;
  DesignEffort effort = {};
  double seconds = 0, value = 0, left = 0;  // left: of the first promise
  std::string ending = {};
};

void print(const char* problem, const Line& line) {
  std::printf("%-20s %-34s %5d %7d %7d %7d %8.2f %12.5e %8.1e %6d  %s\n", problem, line.method.c_str(), line.iterations,
              line.effort.solves, line.effort.factorizations, line.effort.back_solves, line.seconds, line.value,
              line.left, line.failed, line.ending.c_str());
  const std::string name = std::string(problem) + ", " + line.method;
  row(name, "iterations", line.iterations, "");
  row(name, "time", line.seconds, "s");
  row(name, "h", line.value, "");
}

OptimizeOptions of_method(DesignMethod method) {
  return {.method = method,
          .max_iterations = kMostIterations,
          .gradient_tolerance = kGradient,
          .decrease_tolerance = kDecrease};
}

Line by(ReducedProblem& problem, const OptimizeOptions& options, std::string name, const Context& context) {
  Line line{.method = std::move(name)};
  const double begin = now_ms();
  Optimizer optimizer(problem, options);
  while (optimizer.step(context)) {
    if (now_ms() - begin < 1e3 * kMostSeconds) continue;
    line.ending = "out of time";
    break;
  }
  line.seconds = 1e-3 * (now_ms() - begin);
  const OptimizerState& state = optimizer.state();
  line.iterations = state.iteration;
  line.effort = problem.effort();
  line.value = problem.value();
  for (const DesignRecord& r : state.records) line.failed += r.attempts.total() - r.attempts[Outcome::kSettled];
  if (!state.records.empty()) line.left = state.records.back().gradient / state.first_gradient;
  if (state.verdict) line.ending = design_verdict_info(*state.verdict).name;
  return line;
}

template <class Run>
Line by_library(StructureProblem& problem, const char* name, Run run) {
  Line line{.method = name};
  const double begin = now_ms();
  const YardstickReport report =
      run(problem, YardstickOptions{.tolerance = 1e-6, .max_iterations = kMostIterations, .cancelled = [begin] {
                                      return now_ms() - begin > 1e3 * kMostSeconds;
                                    }});
  line.seconds = 1e-3 * (now_ms() - begin);
  line.iterations = report.iterations;
  line.failed = report.failed;
  line.effort = problem.effort();
  line.value = report.value;
  line.ending = report.ending;
  return line;
}

Line in_total_space(StructureProblem& problem, const TotalOptions& options, std::string name, const Context& context) {
  Line line{.method = std::move(name)};
  const double begin = now_ms();
  std::atomic<bool> late = false;
  // It looks at the context only, so the limit of time is set from the side.
  Context limited = context;
  limited.cancel = &late;
  std::condition_variable ended;
  std::mutex mutex;
  bool done = false;
  std::thread clock([&] {
    std::unique_lock lock(mutex);
    late = !ended.wait_for(lock, std::chrono::duration<double>(kMostSeconds), [&] { return done; });
  });
  const Result<TotalResult> result = minimize_in_total_space(problem, options, limited);
  {
    const std::lock_guard lock(mutex);
    done = true;
  }
  ended.notify_one();
  clock.join();
  line.seconds = 1e-3 * (now_ms() - begin);
  if (!result) {
    line.ending = result.error().message;
    line.value = problem.value();
    return line;
  }
  const TotalResult& r = result.value();
  line.iterations = r.iterations;
  line.effort.factorizations = r.effort.factorizations + r.settled_factorizations;
  line.effort.back_solves = r.effort.back_solves;
  line.effort.solves = 1;
  line.value = r.settled == Outcome::kSettled ? r.settled_value : r.value;
  line.failed = r.settled == Outcome::kSettled ? 0 : 1;
  line.ending = std::string(late ? "out of time" : total_verdict_info(r.verdict).name);
  if (r.settled != Outcome::kSettled) line.ending += ", not settled: " + r.settled_reason;
  return line;
}

Line on_projection(StructureProblem& problem, ProjectionRule rule, std::string name, const Context& context) {
  Result<std::unique_ptr<ProjectedProblem>> projected = ProjectedProblem::make(problem, {.rule = rule}, context);
  if (!projected) return {.method = std::move(name), .value = problem.value(), .ending = projected.error().message};
  return by(*projected.value(), of_method(DesignMethod::kStructuredBfgs), std::move(name), context);
}

struct Method {
  std::string name;
  OptimizeOptions options;
};

std::vector<Method> methods() {
  std::vector<Method> all;
  for (const DesignMethodInfo& info : design_methods()) {
    OptimizeOptions options = of_method(info.method);
    if (secant_rule(info.method)) {
      all.push_back({std::string(info.name) + ", line search", options});
      options.control = StepControl::kTrustRegion;
      all.push_back({std::string(info.name) + ", trust region", options});
    } else if (info.method == DesignMethod::kNewton) {
      all.push_back({"newton, by J'J", options});
      options.preconditioner = NewtonPreconditioner::kNone;
      all.push_back({"newton, plain", options});
    } else {
      all.push_back({std::string(info.name), options});
    }
  }
  return all;
}

bool study(const inverse::Case& c, const char* only, const Context& context) {
  const Result<Model> model = c.make();
  if (!model) {
    std::fprintf(stderr, "%s: %s\n", c.name, model.error().text().c_str());
    return false;
  }
  const auto with = [&](const std::string& name, auto run) {
    if (only != nullptr && name.find(only) == std::string::npos) return true;
    Result<std::unique_ptr<StructureProblem>> problem = inverse::released(model.value(), context);
    if (!problem) {
      std::fprintf(stderr, "%s: %s\n", c.name, problem.error().text().c_str());
      return false;
    }
    print(c.name, run(*problem.value()));
    return true;
  };
  bool good = true;
  for (const Method& method : methods()) {
    good = with(method.name, [&](StructureProblem& p) { return by(p, method.options, method.name, context); }) && good;
  }
  using Rule = ProjectionRule;
  for (const auto& [rule, name] : {std::pair(Rule::kNormalFlow, "structured_bfgs on normal flow"),
                                   std::pair(Rule::kTargetWeighted, "structured_bfgs on target-weighted")}) {
    good = with(name, [&, r = rule, n = name](StructureProblem& p) { return on_projection(p, r, n, context); }) && good;
  }
  for (const TotalMethod method : {TotalMethod::kLagrangeNewton, TotalMethod::kLagrangeGaussNewton,
                                   TotalMethod::kPenalty, TotalMethod::kAugmentedLagrangian}) {
    const std::string name = "total space: " + std::string(total_method_name(method));
    const TotalOptions options{.method = method, .max_iterations = kMostIterations, .gradient_tolerance = kGradient};
    good = with(name, [&](StructureProblem& p) { return in_total_space(p, options, name, context); }) && good;
  }
  good = with("Ipopt", [](StructureProblem& p) { return by_library(p, "Ipopt", run_ipopt); }) && good;
  good = with("ALGLIB", [](StructureProblem& p) { return by_library(p, "ALGLIB minbc", run_alglib); }) && good;
  return good;
}

}  // namespace
}  // namespace lissom

/// Arguments of its own: parts of the names of a problem and of a method, to run fewer.
int main(int count, char** arguments) {
  const char* problem = count > 1 && arguments[1][0] != '-' ? arguments[1] : nullptr;
  const char* method = problem != nullptr && count > 2 && arguments[2][0] != '-' ? arguments[2] : nullptr;
  lissom::ThreadPool threads(2);
  lissom::Context context;
  context.threads = &threads;
  std::printf("%-20s %-34s %5s %7s %7s %7s %8s %12s %8s %6s\n", "problem", "method", "iter.", "solves", "factor.",
              "backs.", "s", "h", "left", "failed");
  bool good = true;
  for (const lissom::inverse::Case& c : lissom::inverse::kCases) {
    if (problem != nullptr && std::strstr(c.name, problem) == nullptr) continue;
    good = lissom::study(c, method, context) && good;
  }
  return good ? 0 : 1;
}
