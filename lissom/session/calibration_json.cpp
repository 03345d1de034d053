#include "lissom/session/calibration_json.h"

#include <cmath>

namespace lissom {

namespace {

using Json = nlohmann::ordered_json;
using Certainty = ParameterCertainty::State;

/// null for what is no number.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json parameter_json(const CalibrationFit& fit, std::size_t i) {
  const Parameter& parameter = fit.parameters[i];
  const ParameterCertainty& own = fit.statistics.parameters[i];
  const double value = fit.values[static_cast<Eigen::Index>(i)];
  const bool has_value = own.state != Certainty::kUndetermined && own.state != Certainty::kUncertain;
  const bool has_interval = own.state == Certainty::kDetermined && std::isfinite(own.half_width);
  return {{"name", parameter.name},
          {"unit", si_unit(parameter.kind)},
          {"state", certainty_name(own.state)},
          {"value", has_value ? Json(value) : Json()},
          {"standard_error", has_interval ? Json(own.standard_error) : Json()},
          {"interval", has_interval ? Json({value - own.half_width, value + own.half_width}) : Json()},
          {"start", fit.start[static_cast<Eigen::Index>(i)]},
          {"lower", parameter.lower},
          {"upper", parameter.upper}};
}

Json correlation_json(const MatX& correlation) {
  Json rows = Json::array();
  for (Eigen::Index i = 0; i < correlation.rows(); ++i) {
    Json row = Json::array();
    for (Eigen::Index j = 0; j < correlation.cols(); ++j) row.push_back(number(correlation(i, j)));
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

Json calibration_summary_json(const CalibrationFit& fit, double confidence) {
  const FitStatistics& s = fit.statistics;
  Json json;
  json["verdict"] = design_verdict_info(fit.verdict).name;
  json["message"] = fit.message;
  json["iterations"] = fit.iterations;
  json["measured_numbers"] = s.residuals;
  json["degrees_of_freedom"] = s.freedom;
  json["confidence"] = confidence;
  json["student_t"] = number(s.quantile);
  json["sigma_known"] = fit.steps.sigma_known;
  const double nominal = fit.steps.sigma_known ? 1 : fit.steps.numbers.front().sigma;
  json["residual_standard_deviation"] = number(nominal * s.deviation);
  json["parameters"] = Json::array();
  for (std::size_t i = 0; i < fit.parameters.size(); ++i) json["parameters"].push_back(parameter_json(fit, i));
  json["correlation"] = correlation_json(s.correlation);
  json["undetermined_combinations"] = s.combinations;
  return json;
}

Json measured_sets_json(const CalibrationFit& fit, const std::vector<MeasuredSet>& sets) {
  Json list = Json::array();
  for (const MeasuredSet& set : sets) {
    Json rows = Json::array();
    for (const int i : set.numbers) {
      const MeasuredNumber& n = fit.steps.numbers[static_cast<std::size_t>(i)];
      Json row = {{"place", n.where}};
      if (set.shapes) {
        row["node"] =
            fit.steps.steps[static_cast<std::size_t>(n.step)].nodes[static_cast<std::size_t>(n.component / 3)];
        row["axis"] = std::string(1, "xyz"[n.component % 3]);
      } else {
        row[set.by_force ? "force" : set.length_word] = n.prescribed;
      }
      row["measured"] = n.measured - n.shift;
      row["fitted"] = fit.fitted[i] - n.shift;
      row["fitted_at_start"] = fit.fitted_at_start[i] - n.shift;
      if (fit.steps.sigma_known) row["sigma"] = n.sigma;
      rows.push_back(std::move(row));
    }
    const bool force = !set.shapes && !set.by_force;
    list.push_back({{"file", set.file},
                    {"measured", set.shapes ? "place"
                                 : force    ? "force"
                                            : set.length_word.c_str()},
                    {"unit", force ? "N" : "m"},
                    {"rms", set.rms},
                    {"largest", set.largest},
                    {"rows", std::move(rows)}});
  }
  return list;
}

}  // namespace lissom
