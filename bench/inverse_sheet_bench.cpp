/// The Sheet of the thesis' table 5.1, designed as `lissom optimize scene:sheet_design` does, and once more with targets that can
/// be reached: root mean squares, time, and where it goes.

#include <cmath>
#include <cstdio>
#include <string>

#include "bench/timing.h"
#include "lissom/core/parallel.h"
#include "lissom/session/design_run.h"
#include "scenes/sheet_brief.h"

namespace lissom {
namespace {

/// mm, of all poses together.
double rms(const std::vector<double>& poses) {
  double sum = 0;
  for (const double value : poses) sum += value * value;
  return 1e3 * std::sqrt(sum / static_cast<double>(poses.size()));
}

bool design(const char* name, scene_models::SheetTargets targets, const char* method, const Context& context) {
  Result<Model> model = scene_models::sheet_with_brief(targets, context);
  if (!model) return std::fprintf(stderr, "%s: %s\n", name, model.error().text().c_str()), false;
  if (method != nullptr) model.value().design->settings.method = method;
  const double begin = now_ms();
  const Result<std::unique_ptr<DesignRun>> made = DesignRun::start(model.value(), context);
  if (!made) return std::fprintf(stderr, "%s: %s\n", name, made.error().text().c_str()), false;
  DesignRun& run = *made.value();
  const double started = 1e-3 * (now_ms() - begin);
  std::vector<double> first;
  for (const GoalMeasure& m : run.first_measures()) first.push_back(m.rms);
  std::printf("%s: start %.3f mm (%.2f s)\n", name, rms(first), started);
  for (const GoalMeasure& m : run.first_measures()) std::printf("  %s: %.3f mm\n", m.name.c_str(), 1e3 * m.rms);
  row(name, "rms, start", rms(first), "mm");
  std::size_t told = 0;
  int stage = 0;
  while (run.step()) {
    for (; told < run.steps().size(); ++told) {
      const DesignStep& step = run.steps()[told];
      std::printf("  stage %d, %4d parameters, %6.2f s: %7.4f mm, %d solves, %d factorizations%s\n", step.stage + 1,
                  run.problem().size(), started + step.seconds, rms(step.rms), step.record.effort.solves,
                  step.record.effort.factorizations, step.record.accepted ? "" : " (rejected)");
      std::fflush(stdout);
    }
    if (run.stage() == stage) continue;
    stage = run.stage();
    row(name, ("rms, after stage " + std::to_string(stage)).c_str(), rms(run.steps().back().rms), "mm");
    row(name, ("time, after stage " + std::to_string(stage)).c_str(), started + run.steps().back().seconds, "s");
  }
  if (!run.status()) return std::fprintf(stderr, "%s: %s\n", name, run.status().error().text().c_str()), false;
  const double seconds = 1e-3 * (now_ms() - begin);
  std::vector<double> last;
  for (const GoalMeasure& m : run.problem().measures()) last.push_back(m.rms);
  for (const GoalMeasure& m : run.problem().measures()) std::printf("  %s: %.4f mm\n", m.name.c_str(), 1e3 * m.rms);
  std::printf("  %s\n", run.message().c_str());
  row(name, "rms, end", rms(last), "mm");
  row(name, "time", seconds, "s");
  row(name, "iterations", static_cast<double>(run.steps().size()), "");
  row(name, "factorizations", run.effort().factorizations, "");
  return true;
}

}  // namespace
}  // namespace lissom

/// An argument of its own: a method instead of the usual one.
int main(int count, char** arguments) {
  const char* method = count > 1 && arguments[1][0] != '-' ? arguments[1] : nullptr;
  lissom::ThreadPool threads(2);
  lissom::Context context;
  context.threads = &threads;
  using lissom::scene_models::SheetTargets;
  const bool only_hidden = method != nullptr && count > 2;
  const bool sheet = only_hidden || lissom::design("sheet", SheetTargets::kOtherRadii, method, context);
  const bool hidden = lissom::design("sheet, hidden design", SheetTargets::kHidden, method, context);
  return sheet && hidden ? 0 : 1;
}
