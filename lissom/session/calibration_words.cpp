#include "lissom/session/calibration_words.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace lissom {

namespace {

using Certainty = ParameterCertainty::State;
using Measure = DesignReport::Measure;

constexpr double kSmallForce = 0.1;  // N, from which on forces are shown in N

std::string with_unit(std::string number, const Measure& measure) {
  return measure.unit.empty() ? number : std::move(number) + " " + measure.unit;
}

/// With two digits of what is uncertain about it, and not more than eight in all; with six where nothing says how many count.
std::string number_words(double value, double error) {
  if (!(error > 0) || value == 0) return fmt::format("{:.6g}", value);
  const int size = static_cast<int>(std::floor(std::log10(std::abs(value))));
  const int digit = static_cast<int>(std::floor(std::log10(error)));
  return fmt::format("{:.{}f}", value, std::clamp(std::min(1 - digit, 7 - size), 0, 15));
}

std::string list_of(const std::vector<int>& numbers, int without, const CalibrationFit& fit) {
  std::string text;
  for (const int i : numbers) {
    if (i == without) continue;
    text += (text.empty() ? "" : ", ") + fit.parameters[static_cast<std::size_t>(i)].name;
  }
  return text;
}

std::string undetermined_words(int number, const CalibrationFit& fit) {
  for (const std::vector<int>& group : fit.statistics.combinations) {
    if (group.size() < 2 || std::find(group.begin(), group.end(), number) == group.end()) continue;
    return "not determined: only a combination with " + list_of(group, number, fit) + " is";
  }
  return "not determined: the measurements do not depend on it";
}

}  // namespace

const char* certainty_name(Certainty state) {
  switch (state) {
    case Certainty::kDetermined:
      return "determined";
    case Certainty::kAtLowerBound:
      return "at_lower_bound";
    case Certainty::kAtUpperBound:
      return "at_upper_bound";
    case Certainty::kUndetermined:
      return "undetermined";
    case Certainty::kUncertain:
      break;
  }
  return "uncertain";
}

Measure measure_of(ParameterKind kind) {
  if (kind == ParameterKind::kYoungsModulus) return {"MPa", 1e-6};
  const std::string unit = si_unit(kind);
  if (unit == "m") return {"mm", 1e3};
  return {unit, 1};
}

std::string confidence_words(double confidence) { return fmt::format("{:.6g} %", 100 * confidence); }

std::vector<CertaintyWords> certainty_words(const CalibrationFit& fit) {
  std::vector<CertaintyWords> words;
  for (std::size_t i = 0; i < fit.parameters.size(); ++i) {
    const Parameter& parameter = fit.parameters[i];
    const ParameterCertainty& own = fit.statistics.parameters[i];
    const Measure measure = measure_of(parameter.kind);
    const double scale = measure.display_scale, value = scale * fit.values[static_cast<Eigen::Index>(i)];
    const double error = scale * own.standard_error, half = scale * own.half_width;
    CertaintyWords& w = words.emplace_back();
    w.name = parameter.name;
    switch (own.state) {
      case Certainty::kDetermined:
        w.value = with_unit(number_words(value, error), measure);
        if (std::isfinite(half)) {
          w.interval =
              with_unit(number_words(value - half, error) + " to " + number_words(value + half, error), measure);
          w.error = with_unit(fmt::format("{:.2g}", error), measure);
        } else {
          w.remark = "no interval: there are as many parameters as measured numbers";
        }
        break;
      case Certainty::kAtLowerBound:
      case Certainty::kAtUpperBound:
        w.value = with_unit(fmt::format("{:.6g}", value), measure);
        w.remark = own.state == Certainty::kAtLowerBound ? "at its lower bound: the measurements ask for less"
                                                         : "at its upper bound: the measurements ask for more";
        break;
      case Certainty::kUncertain:
        w.remark = "not determined: its interval is wider than its bounds, or reaches beyond 0";
        break;
      case Certainty::kUndetermined:
        w.remark = undetermined_words(static_cast<int>(i), fit);
    }
  }
  return words;
}

std::string count_words(const CalibrationFit& fit) {
  const FitStatistics& s = fit.statistics;
  const int m = static_cast<int>(fit.parameters.size());
  const auto counted = [](int count, const char* one, const char* many) {
    return fmt::format("{} {}", count, count == 1 ? one : many);
  };
  std::string text = counted(s.residuals, "measured number", "measured numbers") + ", " +
                     counted(m, "parameter", "parameters") + ", " +
                     counted(s.freedom, "degree of freedom", "degrees of freedom");
  if (!std::isfinite(s.deviation)) return text;
  if (fit.steps.sigma_known) {
    text += fmt::format("; residual standard deviation {:.3g} times the given ones", s.deviation);
    return text;
  }
  // All numbers are of one unit and have one nominal standard deviation.
  const MeasuredNumber& first = fit.steps.numbers.front();
  const bool length = fit.steps.goals[static_cast<std::size_t>(first.step)].objective->unit() == "m";
  const double deviation = (length ? 1e3 : 1) * s.deviation * first.sigma;
  text += fmt::format("; residual standard deviation {:.3g} {}", deviation, length ? "mm" : "N");
  return text;
}

std::vector<MeasuredSet> measured_sets(const CalibrationFit& fit, const std::vector<MeasurementBrief>& briefs) {
  std::vector<MeasuredSet> sets;
  for (const MeasurementBrief& brief : briefs) {
    MeasuredSet& set = sets.emplace_back();
    set.file = std::visit([](const auto& b) { return b.file; }, brief);
    const auto* pairs = std::get_if<ForceLengthBrief>(&brief);
    set.shapes = pairs == nullptr;
    set.length_word = pairs == nullptr || pairs->from ? "length" : "displacement";
    set.by_force = pairs != nullptr && pairs->prescribed == ForceLengthBrief::Prescribed::kForce;
  }
  for (std::size_t i = 0; i < fit.steps.numbers.size(); ++i) {
    sets[static_cast<std::size_t>(fit.steps.numbers[i].set)].numbers.push_back(static_cast<int>(i));
  }
  for (MeasuredSet& set : sets) {
    double force = 0;
    for (const int i : set.numbers) {
      const MeasuredNumber& n = fit.steps.numbers[static_cast<std::size_t>(i)];
      const double left = n.measured - fit.fitted[i];
      const CalibrationStep& step = fit.steps.steps[static_cast<std::size_t>(n.step)];
      if (step.meaning == ForceLengthData::Length::kChange) set.length_word = "displacement";
      set.rms += left * left;
      set.largest = std::max(set.largest, std::abs(left));
      force = std::max(force, std::abs(set.by_force ? n.prescribed : n.measured));
    }
    set.rms = std::sqrt(set.rms / static_cast<double>(std::max<std::size_t>(1, set.numbers.size())));
    set.force = force < kSmallForce ? Measure{"mN", 1e3} : Measure{"N", 1};
    set.measured = set.shapes || set.by_force ? Measure{"mm", 1e3} : set.force;
  }
  return sets;
}

}  // namespace lissom
