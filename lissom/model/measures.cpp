#include <cstddef>
#include <iterator>

#include "lissom/model/units.h"

namespace lissom {
namespace {

constexpr MeasureInfo kMeasureInfos[] = {
    {Measure::kLength, "length", "length", "a length", "0.8 mm", "mm", "m", {"mm", "m", "um"}},
    {Measure::kForce, "force", "force", "a force", "25 mN", "N", "N", {"N", "mN", "kN"}},
    {Measure::kStress, "stress", "stress", "a stress", "32 MPa", "MPa", "Pa", {"MPa", "GPa", "kPa", "Pa"}},
    {Measure::kAngle, "angle", "angle", "an angle", "90 deg", "deg", "rad", {"deg", "rad"}},
    {Measure::kTime, "time", "time", "a time", "10 ms", "s", "s", {"s", "ms"}},
    {Measure::kMass, "mass", "mass", "a mass", "12 g", "g", "kg", {"g", "kg"}},
    {Measure::kDensity, "density", "density", "a density", "1240 kg/m^3", "", "kg/m^3", {"kg/m^3"}},
    {Measure::kAreaDensity,
     "area_density",
     "mass per area",
     "a mass per area",
     "120 g/m^2",
     "",
     "kg/m^2",
     {"g/m^2", "kg/m^2"}},
    {Measure::kAcceleration, "acceleration", "acceleration", "an acceleration", "9.81 m/s^2", "", "m/s^2", {"m/s^2"}},
    {Measure::kVelocity, "velocity", "velocity", "a velocity", "0.5 m/s", "", "m/s", {"m/s", "mm/s"}},
    {Measure::kMoment, "moment", "moment", "a moment", "2 N mm", "", "N m", {"N mm", "N m"}},
    {Measure::kForcePerLength,
     "force_per_length",
     "force per length",
     "a force per length",
     "0.3 N/m",
     "",
     "N/m",
     {"N/m", "N/mm"}},
    {Measure::kCurvature, "curvature", "curvature", "a curvature", "20 1/m", "", "1/m", {"1/m", "1/mm"}},
    {Measure::kTwistRate,
     "twist_rate",
     "angle per length",
     "an angle per length",
     "10 deg/m",
     "",
     "rad/m",
     {"rad/m", "deg/m"}},
    {Measure::kRate, "rate", "rate", "a rate", "10 1/s", "", "1/s", {"1/s"}},
    {Measure::kRatio, "ratio", "plain number", "a plain number", "5 %", "1", "1", {"1"}},
};
static_assert(std::size(kMeasureInfos) == kMeasures);

}  // namespace

const MeasureInfo& info(Measure measure) { return kMeasureInfos[static_cast<int>(measure)]; }

Dimension dimension(Measure measure) { return parse_unit(info(measure).si_unit).value().dimension; }

std::string write_quantity(double si, Measure measure) {
  std::string best;
  for (const std::string_view name : info(measure).written) {
    if (name.empty()) continue;
    std::string number = in_unit(si, parse_unit(name).value());
    if (number.empty()) continue;
    std::string text = number + " " + std::string(name);
    if (best.empty() || text.size() < best.size()) best = std::move(text);
  }
  return best;
}

bool compatible(Dimension expected, Dimension got) {
  if (expected == got) return true;
  expected.angle = got.angle = 0;
  return expected == got && expected != Dimension{};
}

std::string si_unit(Dimension dimension) {
  std::string text;
  const auto add = [&text](std::string_view name, int power) {
    if (power == 0) return;
    text += (text.empty() ? "" : " ") + std::string(name);
    if (power != 1) text += "^" + std::to_string(power);
  };
  add("m", dimension.length);
  add("kg", dimension.mass);
  add("s", dimension.time);
  add("rad", dimension.angle);
  return text.empty() ? "1" : text;
}

std::string in_words(Dimension wanted) {
  for (const MeasureInfo& entry : kMeasureInfos) {
    if (dimension(entry.measure) == wanted) return std::string(entry.article);
  }
  return "a quantity in " + si_unit(wanted);
}

Error wrong_dimension(Measure expected, Dimension got) {
  const MeasureInfo& wanted = info(expected);
  return {ErrorCode::kUnit,
          {},
          "expected " + std::string(wanted.article) + " such as \"" + std::string(wanted.example) + "\", got " +
              in_words(got),
          {}};
}

}  // namespace lissom
