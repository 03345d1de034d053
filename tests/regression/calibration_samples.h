#pragma once
/// Structures that are pulled and bent, and what would be measured on them.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <string>
#include <utility>
#include <vector>

#include "lissom/design/calibration_fit.h"
#include "lissom/model/document.h"

namespace lissom::samples {

inline Design base_of(const std::string& text) {
  Result<Model> model = read_document(text);
  EXPECT_TRUE(model) << (model ? "" : model.error().text());
  if (!model) return {};
  Result<System> system = make_system(model.value());
  EXPECT_TRUE(system) << (system ? "" : system.error().text());
  return {std::move(model).value(), std::move(system).value()};
}

/// Pairs for the first measurement of the design, as a file would have them.
inline ForceLengthData pairs_of(const Design& base, const std::vector<std::pair<double, double>>& force_length,
                                int entry = 0) {
  ForceLengthData data;
  data.brief = std::get<ForceLengthBrief>(base.model.calibration->measurements[static_cast<std::size_t>(entry)]);
  data.where = fmt::format("/calibration/measurements/{}", entry);
  for (const auto& [force, length] : force_length) {
    data.pairs.push_back({force, length, {}, fmt::format("{}:{}", data.brief.file, data.pairs.size() + 2)});
  }
  return data;
}

inline CalibrationFit fitted(const Design& base, const std::vector<MeasurementData>& data) {
  Result<CalibrationFit> fit = fit_calibration(base, data, {});
  EXPECT_TRUE(fit) << (fit ? "" : fit.error().text());
  return fit ? std::move(fit).value() : CalibrationFit();
}

inline std::string error_of(const Design& base, const std::vector<MeasurementData>& data) {
  const Result<CalibrationFit> fit = fit_calibration(base, data, {});
  return fit ? "no error" : fit.error().text();
}

/// What the design as it is described would show where `data` was measured, SI.
inline VecX shown(const Design& base, const std::vector<MeasurementData>& data) {
  return fitted(base, data).fitted_at_start;
}

/// `data` with these numbers as the measured ones.
inline ForceLengthData measured(ForceLengthData data, const VecX& numbers) {
  for (std::size_t i = 0; i < data.pairs.size(); ++i) {
    const bool by_force = data.brief.prescribed == ForceLengthBrief::Prescribed::kForce;
    (by_force ? data.pairs[i].length : data.pairs[i].force) = numbers[static_cast<Eigen::Index>(i)];
  }
  return data;
}

/// A rod of radius 1 mm, 100 mm long, clamped at its start; what is measured at its end.
inline std::string rod_document(double modulus, const std::string& pose, const std::string& measurement,
                                int edges = 1) {
  return fmt::format(R"({{"lissom": 1, "units": {{"stress": "Pa"}},
    "materials": {{"print": {{"youngs_modulus": {}, "poisson_ratio": 0.4}}}},
    "rods": [{{"name": "beam", "line": [[0, 0, 0], [100, 0, 0]], "edges": {}, "material": "print",
               "section": {{"radius": "1 mm"}}}}],
    "sets": {{"foot": {{"rod": "beam", "at": "start"}}, "tip": {{"rod": "beam", "at": "end"}}}},
    "poses": [{{"name": "loaded", {}}}],
    "calibration": {{"parameters": [{{"youngs_modulus": {{"range": ["1 MPa", "100 GPa"]}}}}],
                     "measurements": [{}]}}}})",
                     modulus, edges, pose, measurement);
}

inline Design pulled_by_force(double modulus, const std::string& more = "") {
  return base_of(rod_document(modulus,
                              R"("supports": [{"at": "foot", "hold": "clamp"}],
                                 "forces": [{"at": "tip", "force": [1, 0, 0]}])",
                              R"({"force_length": {"file": "pull.csv", "from": "foot", "to": "tip")" + more + "}}"));
}

inline Design pulled_by_length(double modulus) {
  return base_of(
      rod_document(modulus, R"("supports": [{"at": "foot", "hold": "clamp"}, {"at": "tip", "hold": ["x"]}])",
                   R"({"force_length": {"file": "pull.csv", "from": "foot", "to": "tip", "prescribed": "length"}})"));
}

inline Design bent(double modulus, int edges = 8) {
  return base_of(rod_document(modulus,
                              R"("supports": [{"at": "foot", "hold": "clamp"}],
                                 "forces": [{"at": "tip", "force": [0, 0, -1]}])",
                              R"({"force_length": {"file": "tip.csv", "to": "tip", "axis": "-z"}})", edges));
}

}  // namespace lissom::samples
