#include "lissom/view/histogram.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "lissom/view/chart_axes.h"

namespace lissom {
namespace {

constexpr double kBarShare = 0.9;  // of a bin that its bars fill

/// Squares with the names of the series, at the upper right.
void draw_names(Canvas& canvas, const Histogram& histogram, const ChartFrame& frame) {
  const double em = frame.em();
  TextStyle style = frame.label();
  style.vertical = 0.5;
  double x = frame.right;
  for (size_t i = histogram.series.size(); i-- > 0;) {
    const std::string& name = histogram.series[i].name;
    x -= canvas.text_width(name, style);
    canvas.text({x, 1.6 * em}, name, style);
    x -= 1.2 * em;
    canvas.rectangle({x, 1.25 * em}, {0.75 * em, 0.75 * em}, series_color(histogram.theme, i));
    x -= 1.2 * em;
  }
}

/// With its label above the frame, where no bar hides it.
void draw_guide(Canvas& canvas, const ChartGuide& guide, const ChartAxis& axis, const ChartFrame& frame) {
  const double shown = guide.value * axis.display_scale, px = frame.at(shown, 0).x();
  frame.draw_guide(guide.direction, shown, "");
  TextStyle style{.size = 0.85 * frame.em(), .color = frame.colors().faint_ink};
  style.horizontal = px > (frame.left + frame.right) / 2 ? 1 : 0;
  canvas.text({px, frame.top - 0.4 * frame.em()}, guide.label, style);
}

}  // namespace

Result<HistogramBins> histogram_bins(const Histogram& histogram) {
  if (histogram.bins < 1) {
    return Error{ErrorCode::kRange, "histogram", "there are no bins to count in", "ask for one at least"};
  }
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const HistogramSeries& series : histogram.series) {
    for (const double v : series.values) {
      if (!std::isfinite(v)) continue;
      low = std::min(low, v);
      high = std::max(high, v);
    }
  }
  const bool any = low <= high;
  for (const ChartGuide& guide : histogram.guides) {
    if (guide.direction != ChartGuide::Direction::kVertical || !std::isfinite(guide.value)) continue;
    low = std::min(low, guide.value);
    high = std::max(high, guide.value);
  }
  if (!any) {
    return Error{ErrorCode::kRange, "histogram", "there is no value to count", "give at least one finite value"};
  }
  HistogramBins bins;
  const bool alike = !(high - low > 1e-9 * std::max(std::abs(low), std::abs(high)));
  const int count = alike ? 1 : histogram.bins;
  bins.width = !alike ? (high - low) / count : low == 0 ? 1 : 0.02 * std::abs(low);
  bins.low = alike ? low - bins.width / 2 : low;
  for (const HistogramSeries& series : histogram.series) {
    std::vector<int>& counts = bins.counts.emplace_back(count, 0);
    for (const double v : series.values) {
      if (!std::isfinite(v)) continue;
      ++counts[std::clamp(static_cast<int>(std::floor((v - bins.low) / bins.width)), 0, count - 1)];
    }
  }
  return bins;
}

Result<std::string> draw_histogram(const Histogram& histogram, ImageFormat format) {
  if (Status status = check_size(histogram.width, histogram.height); !status) return status.error();
  const Result<HistogramBins> made = histogram_bins(histogram);
  if (!made) return made.error();
  const HistogramBins& bins = made.value();
  const size_t count = bins.counts.front().size();
  int highest = 1;
  for (const std::vector<int>& counts : bins.counts) {
    highest = std::max(highest, *std::max_element(counts.begin(), counts.end()));
  }
  const std::vector<double> xs{bins.low, bins.low + bins.width * static_cast<double>(count)};
  ChartAxis counted{
      .label = histogram.counted, .numbers = ChartAxis::Numbers::kWhole, .low = 0, .high = 1.08 * highest};
  const Result<AxisScale> x = make_scale(histogram.x, xs, "x axis");
  if (!x) return x.error();
  const Result<AxisScale> y = make_scale(counted, {0, static_cast<double>(highest)}, "y axis");
  if (!y) return y.error();
  const double fitting = std::sqrt(static_cast<double>(histogram.width) * histogram.height) / 52;
  const double em = histogram.text_size > 0 ? histogram.text_size : std::clamp(fitting, 7.0, 40.0);
  Canvas canvas(format, histogram.width, histogram.height);
  const bool named = histogram.series.size() > 1 || !histogram.series.front().name.empty();
  const double head = !histogram.guides.empty() ? 4.2 : named || !histogram.title.empty() ? 3.2 : 1.2;  // em
  const ChartFrame frame(canvas, x.value(), y.value(), histogram.theme, em, head * em);
  canvas.fill(frame.colors().page);
  frame.draw_grid(histogram.x, counted, histogram.title);
  frame.clip();
  const double slot = kBarShare / static_cast<double>(histogram.series.size());
  for (size_t s = 0; s < bins.counts.size(); ++s) {
    for (size_t k = 0; k < count; ++k) {
      if (bins.counts[s][k] == 0) continue;
      const double start = static_cast<double>(k) + (1 - kBarShare) / 2 + slot * static_cast<double>(s);
      const double scale = histogram.x.display_scale;
      const Vec2 foot = frame.at((bins.low + bins.width * start) * scale, 0);
      const Vec2 top = frame.at((bins.low + bins.width * (start + slot)) * scale, bins.counts[s][k]);
      canvas.rectangle({foot.x(), top.y()}, {std::max(top.x() - foot.x(), 1.0), foot.y() - top.y()},
                       series_color(histogram.theme, s));
    }
  }
  canvas.unclip();
  for (const ChartGuide& guide : histogram.guides) {
    if (guide.direction == ChartGuide::Direction::kVertical) draw_guide(canvas, guide, histogram.x, frame);
  }
  if (named) draw_names(canvas, histogram, frame);
  return canvas.finish(histogram.title.empty() ? "Histogram drawn by lissom" : histogram.title);
}

}  // namespace lissom
