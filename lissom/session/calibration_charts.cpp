#include "lissom/session/calibration_charts.h"

#include <algorithm>
#include <cmath>

namespace lissom {

namespace {

using Style = ChartSeries::Style;

const MeasuredNumber& number_of(const CalibrationFit& fit, int i) {
  return fit.steps.numbers[static_cast<std::size_t>(i)];
}

ChartAxis axis(const std::string& label, const DesignReport::Measure& measure) {
  return {.label = label, .unit = measure.unit, .display_scale = measure.display_scale};
}

const DesignReport::Measure kMillimetres{};

/// In the order of what was set, so that lines do not turn back.
std::vector<int> sorted_numbers(const CalibrationFit& fit, const MeasuredSet& set) {
  std::vector<int> sorted = set.numbers;
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](int a, int b) { return number_of(fit, a).prescribed < number_of(fit, b).prescribed; });
  return sorted;
}

}  // namespace

Chart fitted_chart(const CalibrationFit& fit, const MeasuredSet& set, const std::string& title) {
  Chart chart;
  chart.title = title;
  chart.x = axis(set.length_word, kMillimetres);
  chart.y = axis("force", set.force);
  ChartSeries measured{.name = "measured", .style = Style::kPoints};
  ChartSeries fitted{.name = "fitted", .style = Style::kLine}, start{.name = "at the start", .style = Style::kLine};
  if (set.numbers.size() == 1) fitted.style = start.style = Style::kPoints;
  const auto put = [&set](ChartSeries& series, double prescribed, double other) {
    series.x.push_back(set.by_force ? other : prescribed);
    series.y.push_back(set.by_force ? prescribed : other);
  };
  for (const int i : sorted_numbers(fit, set)) {
    const MeasuredNumber& n = number_of(fit, i);
    put(measured, n.prescribed, n.measured - n.shift);
    put(fitted, n.prescribed, fit.fitted[i] - n.shift);
    put(start, n.prescribed, fit.fitted_at_start[i] - n.shift);
  }
  chart.series = {std::move(fitted), std::move(measured), std::move(start)};
  return chart;
}

Chart residual_chart(const CalibrationFit& fit, const MeasuredSet& set, const std::string& title) {
  Chart chart;
  chart.title = title;
  chart.y = axis("measured - fitted", set.measured);
  constexpr ChartGuide::Direction kAcross = ChartGuide::Direction::kHorizontal;
  chart.guides.push_back({kAcross, 0, ""});
  const double deviation = fit.statistics.deviation;
  double reach = 1.2 * set.largest;
  const double sigma = number_of(fit, set.numbers.front()).sigma;
  const bool common =
      std::all_of(set.numbers.begin(), set.numbers.end(), [&](int i) { return number_of(fit, i).sigma == sigma; });
  if (common && std::isfinite(deviation) && deviation > 0) {
    const double s = deviation * sigma;
    chart.guides.push_back({kAcross, s, "s"});
    chart.guides.push_back({kAcross, -s, "-s"});
    reach = std::max(reach, 1.5 * s);
  }
  if (reach > 0) chart.y.low = -reach, chart.y.high = reach;
  if (set.shapes) {
    chart.x = {.label = "measured place", .numbers = ChartAxis::Numbers::kWhole};
    for (const char* name : {"x", "y", "z"}) chart.series.push_back({.name = name, .style = Style::kPoints});
    std::string line;
    double place = 0;
    for (const int i : set.numbers) {
      const MeasuredNumber& n = number_of(fit, i);
      if (n.where != line) ++place;
      line = n.where;
      ChartSeries& series = chart.series[static_cast<std::size_t>(n.component % 3)];
      series.x.push_back(place);
      series.y.push_back(n.measured - fit.fitted[i]);
    }
    std::erase_if(chart.series, [](const ChartSeries& series) { return series.x.empty(); });
    return chart;
  }
  chart.x = set.by_force ? axis("force", set.force) : axis(set.length_word, kMillimetres);
  ChartSeries left{.name = "", .style = Style::kPoints};
  for (const int i : set.numbers) {
    left.x.push_back(number_of(fit, i).prescribed);
    left.y.push_back(number_of(fit, i).measured - fit.fitted[i]);
  }
  chart.series = {std::move(left)};
  return chart;
}

}  // namespace lissom
