#include "lissom/session/report_figures.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "lissom/session/report_words.h"
#include "lissom/view/chart.h"
#include "lissom/view/histogram.h"
#include "lissom/view/text.h"

namespace lissom {

namespace {

using Step = DesignReport::Step;

constexpr int kWidth = 520, kHeight = 300;  // px, half of the page
constexpr double kText = 12.5;              // px
constexpr size_t kMostSeries = 6;           // in one chart; colours repeat after that

std::string figure(const std::string& picture, const std::string& caption) {
  return "<figure>" + picture + "<figcaption>" + caption + "</figcaption></figure>\n";
}

ChartAxis iterations() { return {.label = "iteration", .numbers = ChartAxis::Numbers::kWhole}; }

/// Marks where another stage begins.
std::vector<ChartGuide> stage_guides(const std::vector<Step>& history) {
  std::vector<ChartGuide> guides;
  for (size_t i = 1; i < history.size(); ++i) {
    if (history[i].stage == history[i - 1].stage || history[i].stage.empty()) continue;
    guides.push_back({ChartGuide::Direction::kVertical, static_cast<double>(history[i].iteration), history[i].stage});
  }
  return guides;
}

template <class Of>
ChartSeries series_of(const std::string& name, const std::vector<Step>& history, const Of& of) {
  ChartSeries series{.name = name, .style = ChartSeries::Style::kLineAndPoints};
  for (const Step& step : history) {
    series.x.push_back(step.iteration);
    series.y.push_back(of(step));
  }
  if (history.size() > 60) series.style = ChartSeries::Style::kLine;
  return series;
}

bool has_points(const Chart& chart) {
  const bool logarithmic = chart.y.scale == ChartAxis::Scale::kLogarithmic;
  for (const ChartSeries& series : chart.series) {
    for (const double y : series.y) {
      if (std::isfinite(y) && (y > 0 || !logarithmic)) return true;
    }
  }
  return false;
}

/// Adds the chart as a figure; one without any point is left out.
Status add_chart(Chart chart, const std::vector<Step>& history, const std::string& caption, std::string& html) {
  chart.x = iterations();
  chart.guides = stage_guides(history);
  chart.width = kWidth;
  chart.height = kHeight;
  chart.text_size = kText;
  if (!has_points(chart)) return {};
  const Result<std::string> picture = draw_chart(chart, ImageFormat::kInlineSvg);
  if (!picture) return picture.error();
  html += figure(picture.value(), caption);
  return {};
}

/// Numbers of goals that are measured alike, in the order in which a chart of their own begins.
std::vector<std::vector<size_t>> goals_by_unit(const std::vector<DesignReport::Goal>& goals) {
  std::vector<std::vector<size_t>> groups;
  for (size_t i = 0; i < goals.size(); ++i) {
    const auto same = std::find_if(groups.begin(), groups.end(), [&](const std::vector<size_t>& group) {
      return goals[group.front()].measure.unit == goals[i].measure.unit && group.size() < kMostSeries;
    });
    if (same == groups.end()) {
      groups.push_back({i});
    } else {
      same->push_back(i);
    }
  }
  return groups;
}

}  // namespace

Result<std::string> report_convergence(const DesignReport& report) {
  const std::vector<Step>& history = report.history;
  constexpr auto kLog = ChartAxis::Scale::kLogarithmic;
  std::string html;
  Chart objective;
  objective.title = "Objective";
  objective.y = {.label = "objective", .scale = kLog};
  objective.series = {series_of("", history, [](const Step& s) { return s.objective; })};
  if (const Status s = add_chart(objective, history, "What is minimised: half the sum of all squared residuals.", html);
      !s)
    return s.error();
  for (const std::vector<size_t>& group : goals_by_unit(report.goals)) {
    const DesignReport::Measure& measure = report.goals[group.front()].measure;
    Chart rms;
    rms.title = "Distance from the goals";
    rms.y = {.label = "RMS", .unit = measure.unit, .display_scale = measure.display_scale, .scale = kLog};
    for (const size_t g : group) {
      rms.series.push_back(series_of(report.goals[g].name, history, [g](const Step& s) { return s.rms[g]; }));
    }
    if (const Status s = add_chart(rms, history, "Root mean square of the deviations, per goal.", html); !s)
      return s.error();
  }
  Chart gradient;
  gradient.title = "Projected gradient";
  gradient.y = {.label = "norm", .scale = kLog};
  gradient.series = {series_of("", history, [](const Step& s) { return s.gradient; })};
  if (const Status s =
          add_chart(gradient, history, "Falls towards zero when no allowed change of parameters helps.", html);
      !s)
    return s.error();
  Chart bounds;
  bounds.title = "Parameters at a bound";
  bounds.y = {.label = "count", .numbers = ChartAxis::Numbers::kWhole, .low = 0};
  int most = 1;
  for (const Step& step : history) most = std::max(most, step.active_bounds);
  bounds.y.high = 1.08 * most;
  bounds.series = {series_of("", history, [](const Step& s) { return static_cast<double>(s.active_bounds); })};
  const std::string caption = fmt::format("Of {}.", report_count(report.size.parameters, "parameter", "parameters"));
  if (const Status s = add_chart(bounds, history, caption, html); !s) return s.error();
  if (html.empty()) return std::string("<p>No iteration was accepted: there is nothing to plot.</p>\n");
  return "<div class=\"grid\">" + html + "</div>\n";
}

Result<std::string> report_histograms(const DesignReport& report) {
  using Parameter = DesignReport::Parameter;
  std::vector<std::string> kinds;
  for (const Parameter& p : report.parameters) {
    if (std::find(kinds.begin(), kinds.end(), p.kind) == kinds.end()) kinds.push_back(p.kind);
  }
  std::string html;
  for (const std::string& kind : kinds) {
    Histogram histogram;
    histogram.title = kind;
    histogram.counted = "parameters";
    histogram.bins = 40;
    histogram.width = kWidth;
    histogram.height = kHeight;
    histogram.text_size = kText;
    HistogramSeries final_values{.name = "after"}, start{.name = "before"};
    int lower = 0, upper = 0, count = 0;
    double low = -INFINITY, high = INFINITY;
    bool first = true, same_bounds = true;
    DesignReport::Measure measure;
    for (const Parameter& p : report.parameters) {
      if (p.kind != kind) continue;
      if (first) low = p.lower, high = p.upper;
      same_bounds &= p.lower == low && p.upper == high;
      measure = p.measure;
      final_values.values.push_back(p.value);
      start.values.push_back(p.start);
      lower += p.bound == Parameter::Bound::kLower;
      upper += p.bound == Parameter::Bound::kUpper;
      ++count;
      first = false;
    }
    histogram.series = {final_values};
    const auto [least, most] = std::minmax_element(start.values.begin(), start.values.end());
    const bool one_start = *least == *most;  // a single bar as high as all others together would say less than words
    if (!one_start) histogram.series.push_back(start);
    histogram.x = {.label = "value", .unit = measure.unit, .display_scale = measure.display_scale};
    if (same_bounds && std::isfinite(low)) {
      histogram.guides.push_back({ChartGuide::Direction::kVertical, low, "lower bound"});
    }
    if (same_bounds && std::isfinite(high)) {
      histogram.guides.push_back({ChartGuide::Direction::kVertical, high, "upper bound"});
    }
    if (!histogram_bins(histogram)) continue;  // not one finite value
    const Result<std::string> picture = draw_histogram(histogram, ImageFormat::kInlineSvg);
    if (!picture) return picture.error();
    html += figure(picture.value(),
                   fmt::format("{}: {} at the lower bound, {} at the upper one.{}{}",
                               report_count(count, "parameter", "parameters"), lower, upper,
                               one_start ? " All started at " + report_quantity(*least, measure) + "." : "",
                               same_bounds ? "" : " Bounds differ between them and are in the table."));
  }
  return html.empty() ? std::string() : "<div class=\"grid\">" + html + "</div>\n";
}

}  // namespace lissom
