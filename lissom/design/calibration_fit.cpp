#include "lissom/design/calibration_fit.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "lissom/core/assert.h"
#include "lissom/design/brief_space.h"
#include "lissom/design/log_space.h"
#include "lissom/design/optimizer.h"

namespace lissom {

namespace {

/// Parameters of least squares are asked for more digits than those of designs: their last ones are compared with data.
constexpr double kGradientTolerance = 1e-8, kDecreaseTolerance = 1e-13, kLeastStep = 1e-9;

/// Errors of design spaces at the place that the document has.
Error of_calibration(Error error) {
  constexpr std::string_view kDesign = "/design/";
  if (error.where.starts_with(kDesign)) error.where = "/calibration/" + error.where.substr(kDesign.size());
  if (error.where == "/parameters") error.where = "/calibration/parameters";
  return error;
}

/// Errors of poses that stand for a row of a file.
Error of_step(Error error, const CalibrationSteps& steps) {
  for (const CalibrationStep& step : steps.steps) {
    if (error.where != fmt::format("/poses/{}", step.pose)) continue;
    error.where = step.where;
    error.hint =
        "check the numbers of this row and their units, and how the pose holds the structure, or start from other "
        "moduli";
    return error;
  }
  return of_calibration(std::move(error));
}

/// Residuals that count, and their rows of the Jacobian by parameters in SI.
struct Linearized {
  VecX residual;
  MatX jacobian;
};

/// Residual of each measured number: rows of the problem without those that weigh nothing.
std::vector<Eigen::Index> rows_of(const CalibrationSteps& steps) {
  std::vector<Eigen::Index> first(steps.goals.size(), 0), rows;
  for (std::size_t g = 1; g < first.size(); ++g) first[g] = first[g - 1] + steps.goals[g - 1].objective->size();
  for (const MeasuredNumber& n : steps.numbers) rows.push_back(first[static_cast<std::size_t>(n.step)] + n.component);
  return rows;
}

VecX picked(const VecX& all, const std::vector<Eigen::Index>& rows) {
  VecX some(static_cast<Eigen::Index>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) some[static_cast<Eigen::Index>(i)] = all[rows[i]];
  return some;
}

Linearized linearized(StructureProblem& problem, const LogSpace& space, const std::vector<Eigen::Index>& rows) {
  const VecX slope = space.slope(problem.p());
  Linearized at{picked(problem.residual(), rows), MatX(static_cast<Eigen::Index>(rows.size()), problem.size())};
  for (int i = 0; i < problem.size(); ++i) {
    const double scale = space.parameters()[static_cast<std::size_t>(i)].scale * slope[i];
    at.jacobian.col(i) = picked(problem.jacobian_times(VecX::Unit(problem.size(), i)), rows) / scale;
  }
  return at;
}

/// Deviations are over sigma: what the structure does where `measured` was seen.
VecX fitted_numbers(const std::vector<MeasuredNumber>& numbers, const VecX& residual) {
  VecX fitted(residual.size());
  for (Eigen::Index i = 0; i < fitted.size(); ++i) {
    const MeasuredNumber& n = numbers[static_cast<std::size_t>(i)];
    fitted[i] = n.measured + n.sigma * residual[i];
  }
  return fitted;
}

std::vector<FittedParameter> fitted_parameters(StructureProblem& problem, const std::vector<Parameter>& parameters,
                                               const VecX& values) {
  std::vector<FittedParameter> fitted;
  const VecX& gradient = problem.gradient();
  for (int i = 0; i < problem.size(); ++i) {
    const Parameter& p = parameters[static_cast<std::size_t>(i)];
    FittedParameter own;
    if (problem.x()[i] <= problem.lower()[i] && gradient[i] > 0) own.bound = FittedParameter::Bound::kLower;
    if (problem.x()[i] >= problem.upper()[i] && gradient[i] < 0) own.bound = FittedParameter::Bound::kUpper;
    own.reach = p.upper - p.lower;
    if (p.lower > 0) own.reach = std::min(own.reach, values[i]);  // an interval that reaches 0 says nothing
    fitted.push_back(own);
  }
  return fitted;
}

std::string files_of(const std::vector<MeasurementData>& data) {
  std::vector<std::string> files;
  for (const MeasurementData& set : data) {
    const std::string& file = std::visit([](const auto& one) -> const std::string& { return one.brief.file; }, set);
    if (std::find(files.begin(), files.end(), file) == files.end()) files.push_back(file);
  }
  std::string text;
  for (const std::string& file : files) text += (text.empty() ? "" : ", ") + file;
  return text;
}

/// The document as it was but for its materials and natural shapes.
Model calibrated(const Model& document, Model found, const std::string& source) {
  found.poses.resize(document.poses.size());
  found.design = document.design;
  for (Material& material : found.materials) {
    const Material* before = document.material(material.name);
    if (before == nullptr || before->youngs_modulus != material.youngs_modulus) material.source = source;
  }
  for (MembraneMaterial& fabric : found.membrane_materials) {
    const MembraneMaterial* before = document.membrane_material(fabric.name);
    const auto same = [&] {
      return before->stiffness_1 == fabric.stiffness_1 && before->stiffness_2 == fabric.stiffness_2 &&
             before->poisson_ratio == fabric.poisson_ratio && before->thickness == fabric.thickness;
    };
    if (before == nullptr || !same()) fabric.source = source;
  }
  return found;
}

Status check_count(const CalibrationSteps& steps, int parameters) {
  const int numbers = static_cast<int>(steps.numbers.size());
  if (numbers >= parameters) return {};
  return Error{ErrorCode::kConflict, "/calibration/measurements",
               fmt::format("{} measured {} cannot determine {} parameters", numbers,
                           numbers == 1 ? "number" : "numbers", parameters),
               "measure more, or let fewer parameters be unknown"};
}

}  // namespace

Result<CalibrationFit> fit_calibration(const Design& base, const std::vector<MeasurementData>& data,
                                       const Context& context) {
  LISSOM_ASSERT(base.model.calibration.has_value());
  const Calibration& calibration = *base.model.calibration;
  Result<CalibrationSteps> steps = make_calibration_steps(base, data);
  if (!steps) return steps.error();
  CalibrationFit fit;
  fit.steps = std::move(steps).value();
  Brief brief;
  brief.parameters = calibration.parameters;
  Result<BriefSpace> natural = make_brief_space(brief, fit.steps.model);
  if (!natural) return of_calibration(natural.error());
  Result<LogSpace> made = LogSpace::make(natural.value().space);
  if (!made) return of_calibration(made.error());
  const auto space = std::make_shared<const LogSpace>(std::move(made).value());
  if (const Status s = check_count(fit.steps, space->size()); !s) return s.error();
  fit.parameters.assign(space->inner().parameters().begin(), space->inner().parameters().end());
  StructureProblemOptions options;
  options.solve.tolerance = calibration.solve_tolerance;
  Result<std::unique_ptr<StructureProblem>> problem =
      StructureProblem::make(space, fit.steps.goals, {}, options, context);
  if (!problem) return of_step(problem.error(), fit.steps);
  fit.problem = std::move(problem).value();
  StructureProblem& p = *fit.problem;
  if (const Status s = p.release(); !s) return of_step(s.error(), fit.steps);
  const std::vector<Eigen::Index> rows = rows_of(fit.steps);
  fit.start = space->values(p.p());
  fit.first = p.design();
  fit.first_point = p.point();
  fit.fitted_at_start = fitted_numbers(fit.steps.numbers, picked(p.residual(), rows));

  OptimizeOptions how;
  how.max_iterations = calibration.iterations;
  how.gradient_tolerance = kGradientTolerance;
  how.decrease_tolerance = kDecreaseTolerance;
  how.least_step = kLeastStep;
  Optimizer optimizer(p, how);
  fit.verdict = optimizer.run(context);
  fit.message = optimizer.state().message;
  fit.iterations = optimizer.state().iteration;
  fit.values = space->values(p.p());
  const Linearized end = linearized(p, *space, rows);
  fit.fitted = fitted_numbers(fit.steps.numbers, end.residual);
  fit.statistics = fit_statistics(end.jacobian, end.residual, fitted_parameters(p, fit.parameters, fit.values),
                                  calibration.confidence);
  fit.effort = p.effort();
  fit.model = calibrated(base.model, p.design().model, "calibrated from " + files_of(data));
  return fit;
}

}  // namespace lissom
