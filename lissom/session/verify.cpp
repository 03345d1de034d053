#include "lissom/session/verify.h"

#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "lissom/model/units.h"
#include "lissom/session/quantities.h"
#include "lissom/session/study.h"

namespace lissom {

namespace {

/// So tight that what is compared is the theory and not the solver.
constexpr double kTolerance = 1e-9;

/// SI value of one of the unit of an entry, which the document reader has checked.
double unit_scale(const std::string& unit) {
  if (unit.empty()) return 1;
  const Result<Unit> parsed = parse_unit(unit);
  return parsed ? parsed.value().factor * std::pow(10.0, parsed.value().exponent) : 1;
}

std::string pose_name(const Model& model, const Expectation& e, size_t i) {
  if (i < e.poses.size()) return e.poses[i];
  return i < model.poses.size() ? model.poses[i].name : std::string();
}

Check failed(std::string label, std::string reason) {
  Check check;
  check.label = std::move(label);
  check.failure = std::move(reason);
  return check;
}

Check compare(const Expectation& e, double measured, double claimed, std::string label) {
  const double unit = unit_scale(e.unit);
  const double got = (measured - e.offset) / e.scale;
  Check check;
  check.label = std::move(label);
  check.unit = e.unit == "1" ? "" : e.unit;
  check.source = e.source;
  check.got = got / unit;
  check.expected = claimed / unit;
  check.deviation = (got - claimed) / unit;
  check.relative = claimed != 0 ? (got - claimed) / std::abs(claimed) : std::numeric_limits<double>::quiet_NaN();
  check.relative_tolerance = e.tolerance_relative > 0;
  check.tolerance = check.relative_tolerance ? e.tolerance_relative : e.tolerance_absolute / unit;
  const double allowed = check.relative_tolerance ? e.tolerance_relative * std::abs(claimed) : e.tolerance_absolute;
  if (!std::isfinite(got)) check.failure = "the measured value is not a finite number";
  check.passed = check.failure.empty() && std::abs(got - claimed) <= allowed;
  return check;
}

void run_entry(Study& study, const Expectation& e, const std::string& where, std::vector<Check>& checks) {
  const std::string label = e.label.empty() ? e.quantity : e.label;
  const Result<std::vector<double>> measured = measure(study, e, where);
  if (!measured) {
    checks.push_back(failed(label, measured.error().text()));
    return;
  }
  const size_t count = measured.value().size();
  if (e.value.size() != 1 && e.value.size() != count) {
    checks.push_back(failed(
        label, fmt::format("{}: {} values are claimed for {} measurements", where + "/value", e.value.size(), count)));
    return;
  }
  for (size_t i = 0; i < count; ++i) {
    const std::string pose = count > 1 ? " [" + pose_name(study.model(), e, i) + "]" : "";
    checks.push_back(compare(e, measured.value()[i], e.value.size() == 1 ? e.value[0] : e.value[i], label + pose));
  }
}

}  // namespace

std::vector<Check> verify(const Model& model, const Context& context) {
  std::vector<Check> checks;
  SolveOptions options;
  options.tolerance = kTolerance;
  Study study(model, options, context);
  for (size_t i = 0; i < model.expectations.size(); ++i) {
    const Expectation& e = model.expectations[i];
    context.report({.task = "verify",
                    .fraction = static_cast<double>(i) / static_cast<double>(model.expectations.size()),
                    .iteration = static_cast<int>(i) + 1,
                    .residual = 0,
                    .detail = e.label.empty() ? e.quantity : e.label});
    if (context.cancelled()) {
      checks.push_back(failed(e.label.empty() ? e.quantity : e.label, "stopped by you"));
      continue;
    }
    run_entry(study, e, "/expect/" + std::to_string(i), checks);
  }
  if (checks.empty())
    checks.push_back(failed("expectations", "the document expects nothing: it has no \"expect\" entry"));
  return checks;
}

std::string check_line(const Check& check, const std::string& document) {
  std::string line = check.passed ? "PASS  " : "FAIL  ";
  line += document + ": " + check.label + ": ";
  if (!check.failure.empty()) return line + check.failure;
  const std::string unit = check.unit.empty() ? "" : " " + check.unit;
  line += fmt::format("got {:.7g}{}, expected {:.7g}{}, deviation ", check.got, unit, check.expected, unit);
  line += std::isnan(check.relative) || !check.relative_tolerance ? fmt::format("{:+.2g}{}", check.deviation, unit)
                                                                  : fmt::format("{:+.2g} %", 100 * check.relative);
  line += check.relative_tolerance ? fmt::format(", tolerance {:.4g} %", 100 * check.tolerance)
                                   : fmt::format(", tolerance {:.4g}{}", check.tolerance, unit);
  if (!check.source.empty()) line += " (" + check.source + ")";
  return line;
}

}  // namespace lissom
