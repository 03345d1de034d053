#include "lissom/studio/fit_job.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <utility>

#include "lissom/design/optimizer.h"
#include "lissom/studio/design_edit.h"
#include "lissom/studio/desk.h"
#include "lissom/studio/shown_units.h"

namespace lissom {

namespace {

using Json = nlohmann::json;

constexpr int kMostIterations = 25;
constexpr double kNearEnough = 0.05;  // of the distance at the start
constexpr double kTooLittle = 0.02;   // of the value: gaining less, three times in a row, is arriving
constexpr int kMostIdle = 3;
constexpr double kNear = 0.1, kLittle = 0.2;  // the same where one time is enough, for somebody waits
constexpr double kNearBound = 1e-6;           // of the range
constexpr double kLeastDamped =
    2e-6;  // of the largest: less lets points run into each other, much more keeps them from moving

std::vector<std::string> at_bounds(const ShapeFit& fit) {
  std::vector<std::string> names;
  for (int i = 0; i < fit.size(); ++i) {
    const double near = kNearBound * (fit.upper()[i] - fit.lower()[i]);
    if (fit.x()[i] < fit.lower()[i] + near || fit.x()[i] > fit.upper()[i] - near)
      names.push_back(fit.parameter_name(i));
  }
  return names;
}

/// The event `fit`, but for its records.
Json result_of(const ShapeFit& fit, double before) {
  const double after = fit.distance();
  return {{"event", "fit"},
          {"before_mm", kMillimetres * before},
          {"after_mm", kMillimetres * after},
          {"at_bounds", at_bounds(fit)},
          {"constraint_mm", kMillimetres * fit.violation()},
          {"sentence", fmt::format("From {:.2f} to {:.2f} mm of where it was pulled to", kMillimetres * before,
                                   kMillimetres * after)}};
}

}  // namespace

std::optional<DesignVerdict> run_fit(ShapeFit& fit, const Context& context,
                                     const std::function<void(const FitRecord&)>& tell) {
  OptimizeOptions options;
  // Many parameters hardly matter to a shape: damped steps leave them alone, and do not ruin the mesh by them.
  options.method = DesignMethod::kLevenbergMarquardt;
  options.least_damped = kLeastDamped;
  options.max_iterations = kMostIterations;
  options.value_tolerance = kNearEnough * kNearEnough * fit.value();
  options.decrease_tolerance = 1e-4;
  options.first_cap = 20;  // the step was looked at before it was accepted
  options.max_halvings = 5;
  const double start = fit.distance();
  tell({0, start, fit.value()});
  int iteration = 0;
  if (fit.approach()) tell({++iteration, fit.distance(), fit.value()});
  Optimizer optimizer(fit, options);
  for (int idle = 0; idle < kMostIdle;) {
    const double before = fit.value();
    if (!optimizer.step(context)) return optimizer.state().verdict;
    tell({++iteration, fit.distance(), fit.value()});
    if (optimizer.state().verdict || context.cancelled()) return optimizer.state().verdict;
    if (fit.distance() < kNear * start && before - fit.value() < kLittle * before) return DesignVerdict::kGoodEnough;
    if (fit.value() < before) idle = before - fit.value() < kTooLittle * before ? idle + 1 : 0;
  }
  return DesignVerdict::kConverged;
}

void start_fit(Desk& desk, FitTask task) {
  desk.jobs().start("fit", "mm", [&desk, task = std::move(task)](const Context& context) {
    Result<std::unique_ptr<ShapeFit>> made = ShapeFit::make(task.response, task.constraints, task.target, context);
    if (!made) return Jobs::End{Jobs::End::State::kFailed, made.error().text(), {}};
    ShapeFit& fit = *made.value();
    const double before = fit.distance();
    Json records = Json::array();
    run_fit(fit, context, [&](const FitRecord& record) {
      records.push_back(
          {{"iteration", record.iteration}, {"distance_mm", kMillimetres * record.distance}, {"value", record.value}});
      Json event = result_of(fit, before);
      event["records"] = records;
      desk.pages().tell_all(event);
      context.report({.task = "fit",
                      .fraction = -1,
                      .iteration = record.iteration,
                      .residual = kMillimetres * record.distance,
                      .detail = "bringing the shape to where it was pulled"});
    });
    const bool cancelled = context.cancelled();
    const double after = fit.distance();
    if (!(after < before)) {
      return Jobs::End{cancelled ? Jobs::End::State::kCancelled : Jobs::End::State::kFailed,
                       "no design comes nearer to where it was pulled: it stays as it is",
                       {}};
    }
    const auto state = std::make_shared<const State>(fit.state());
    return Jobs::End{cancelled ? Jobs::End::State::kCancelled : Jobs::End::State::kDone,
                     result_of(fit, before)["sentence"].get<std::string>(),
                     [&desk, task, state, model = fit.design().model] {
                       if (desk.revision() != task.revision) return;
                       const ShapeSnapshot shape{task.mesh, task.mesh_of, state};
                       const std::string title = "Pull the shape";
                       desk.commit(title, design_edit(model, title).dump(), model, &shape);
                     }};
  });
}

}  // namespace lissom
