#include <fmt/format.h>

#include "lissom/model/validate_parts.h"

namespace lissom {
namespace {

struct MeasurementCheck {
  Checker& check;
  const std::string& where;  ///< of the measurement

  void operator()(const ForceLengthBrief& brief) const {
    const std::string own = where + "/force_length";
    check_pose_name(check, brief.pose, own);
    if (brief.from) check.selector(*brief.from, own + "/from");
    check.selector(brief.to, own + "/to");
    if (brief.axis) check.direction(*brief.axis, own + "/axis");
    file(brief.file, own);
    check.not_negative(brief.sigma, own + "/sigma", "standard deviation");
    if (!brief.from && !brief.axis) {
      check.fail(ErrorCode::kConflict, own, "it is not said from where or along which axis the length counts",
                 "give \"from\", \"axis\" or both");
    }
  }
  void operator()(const ShapesBrief& brief) const {
    const std::string own = where + "/shapes";
    if (!brief.pose.empty()) check_pose_name(check, brief.pose, own);
    file(brief.file, own);
    check.not_negative(brief.sigma, own + "/sigma", "standard deviation");
  }

  void file(const std::string& name, const std::string& own) const {
    if (name.empty()) check.fail(ErrorCode::kType, own + "/file", "no file is named", "name the CSV file");
  }
};

}  // namespace

void check_calibration(Checker& check, const Calibration& calibration, const std::string& where) {
  for (std::size_t i = 0; i < calibration.parameters.size() && !check.failed(); ++i) {
    if (may_be_calibrated(calibration.parameters[i].what)) continue;
    check.fail(ErrorCode::kUnsupported, fmt::format("{}/parameters/{}", where, i),
               "a calibration finds numbers of materials and natural shapes, nothing else",
               "choose among \"youngs_modulus\", \"fabric\" and \"natural\", or describe a \"design\"");
  }
  check_parameters(check, calibration.parameters, where);
  if (calibration.measurements.empty()) {
    check.fail(ErrorCode::kType, where + "/measurements", "there is no measurement", "name a file of measurements");
  }
  for (std::size_t i = 0; i < calibration.measurements.size() && !check.failed(); ++i) {
    const std::string own = fmt::format("{}/measurements/{}", where, i);
    std::visit(MeasurementCheck{check, own}, calibration.measurements[i]);
  }
  if (!(calibration.confidence > 0 && calibration.confidence < 1)) {
    check.fail(ErrorCode::kRange, where + "/confidence", "the confidence has to lie between 0 and 1", "95 % is usual");
  }
  if (calibration.iterations < 1) {
    check.fail(ErrorCode::kRange, where + "/iterations", "at least one iteration is needed", "100 is usual");
  }
  check.positive(calibration.solve_tolerance, where + "/solve_tolerance", "tolerance");
}

}  // namespace lissom
