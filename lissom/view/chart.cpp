#include "lissom/view/chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "lissom/view/chart_axes.h"

namespace lissom {
namespace {

void draw_mark(Canvas& canvas, const Vec2& at, size_t shape, double size, const Color& color) {
  const auto corner = [&](double x, double y) { return Vec2(at + size * Vec2(x, y)); };
  switch (shape % 4) {
    case 0:
      canvas.disc(at, size, color);
      return;
    case 1:
      canvas.polygon(std::array{corner(-0.9, -0.9), corner(0.9, -0.9), corner(0.9, 0.9), corner(-0.9, 0.9)}, color);
      return;
    case 2:
      canvas.polygon(std::array{corner(0, -1.2), corner(1.1, 0.8), corner(-1.1, 0.8)}, color);
      return;
    default:
      canvas.polygon(std::array{corner(0, -1.3), corner(1.3, 0), corner(0, 1.3), corner(-1.3, 0)}, color);
      return;
  }
}

/// The drawing of one chart.
class Page {
 public:
  Page(Canvas& canvas, const Chart& chart, const AxisScale& x, const AxisScale& y, double em)
      : canvas_(canvas),
        chart_(chart),
        frame_(canvas, x, y, chart.theme, em, chart.title.empty() ? 1.2 * em : 3.2 * em),
        em_(em),
        left_(frame_.left),
        right_(frame_.right),
        top_(frame_.top),
        bottom_(frame_.bottom) {}

  void draw() {
    canvas_.fill(frame_.colors().page);
    frame_.draw_grid(chart_.x, chart_.y, chart_.title);
    frame_.clip();
    for (const ChartGuide& guide : chart_.guides) {
      const bool level = guide.direction == ChartGuide::Direction::kHorizontal;
      frame_.draw_guide(guide.direction, guide.value * (level ? chart_.y : chart_.x).display_scale, guide.label);
    }
    for (size_t i = 0; i < chart_.series.size(); ++i) draw_series(i);
    canvas_.unclip();
    if (chart_.series.size() > 1 || !chart_.series.front().name.empty()) draw_names();
  }

 private:
  Vec2 at(double x, double y) const { return frame_.at(x * chart_.x.display_scale, y * chart_.y.display_scale); }

  Stroke line_of(size_t index) const {
    const std::array<std::vector<double>, 4> dashes = {{{}, {0.9, 0.45}, {0.25, 0.35}, {0.9, 0.35, 0.25, 0.35}}};
    Stroke stroke{.color = color_of(index),
                  .width = 0.16 * em_,
                  .cap = Stroke::Cap::kButt,
                  .dash = dashes[index % dashes.size()]};
    for (double& length : stroke.dash) length *= em_;
    return stroke;
  }

  Color color_of(size_t index) const { return series_color(chart_.theme, index); }

  void draw_series(size_t index) {
    const ChartSeries& series = chart_.series[index];
    std::vector<Vec2> run;
    const auto flush = [&] {
      if (run.size() > 1 && series.style != ChartSeries::Style::kPoints) canvas_.polyline(run, line_of(index));
      run.clear();
    };
    const Vec2 far(20.0 * chart_.width, 20.0 * chart_.height);  // beyond any page; keeps numbers small
    for (size_t i = 0; i < series.x.size(); ++i) {
      const Vec2 p = at(series.x[i], series.y[i]);
      if (p.allFinite()) {
        run.push_back(p.cwiseMin(far).cwiseMax(-far));
      } else {
        flush();
      }
    }
    flush();
    if (series.style == ChartSeries::Style::kLine) return;
    for (size_t i = 0; i < series.x.size(); ++i) {
      const Vec2 p = at(series.x[i], series.y[i]);
      if (p.allFinite()) draw_mark(canvas_, p, index, 0.3 * em_, color_of(index));
    }
  }

  /// Points of all series inside a rectangle of the page.
  int crowd(const Vec2& corner, const Vec2& size) const {
    int count = 0;
    for (const ChartSeries& series : chart_.series) {
      for (size_t i = 0; i < series.x.size(); ++i) {
        const Vec2 p = at(series.x[i], series.y[i]) - corner;
        count += p.x() > -em_ && p.y() > -em_ && p.x() < size.x() + em_ && p.y() < size.y() + em_;
      }
    }
    return count;
  }

  void draw_names() {
    double widest = 0;
    for (const ChartSeries& series : chart_.series)
      widest = std::max(widest, canvas_.text_width(series.name, frame_.label()));
    const Vec2 size(widest + 4 * em_, 1.5 * em_ * static_cast<double>(chart_.series.size()) + 0.5 * em_);
    const double pad = 0.7 * em_;
    const std::array<Vec2, 4> corners = {{{right_ - size.x() - pad, top_ + pad},
                                          {left_ + pad, top_ + pad},
                                          {right_ - size.x() - pad, bottom_ - size.y() - pad},
                                          {left_ + pad, bottom_ - size.y() - pad}}};
    Vec2 corner = corners[0];
    int fewest = crowd(corner, size);
    for (const Vec2& other : corners) {
      if (const int count = crowd(other, size); count < fewest) fewest = count, corner = other;
    }
    canvas_.rectangle(corner, size, frame_.colors().page);
    const std::array<Vec2, 4> box = {corner, corner + Vec2(size.x(), 0), corner + size, corner + Vec2(0, size.y())};
    canvas_.outline(box, {.color = frame_.colors().rule, .width = 0.08 * em_});
    for (size_t i = 0; i < chart_.series.size(); ++i) {
      const Vec2 at_line = corner + Vec2(0.6 * em_, 1.5 * em_ * (static_cast<double>(i) + 0.5) + 0.25 * em_);
      const ChartSeries& series = chart_.series[i];
      if (series.style != ChartSeries::Style::kPoints) {
        canvas_.polyline(std::array{at_line, Vec2(at_line + Vec2(2.2 * em_, 0))}, line_of(i));
      }
      if (series.style != ChartSeries::Style::kLine) {
        draw_mark(canvas_, at_line + Vec2(1.1 * em_, 0), i, 0.3 * em_, color_of(i));
      }
      TextStyle style = frame_.label();
      style.vertical = 0.5;
      canvas_.text(at_line + Vec2(2.7 * em_, 0), series.name, style);
    }
  }

  Canvas& canvas_;
  const Chart& chart_;
  ChartFrame frame_;
  double em_, left_, right_, top_, bottom_;  // px
};

}  // namespace

Result<std::string> draw_chart(const Chart& chart, ImageFormat format) {
  if (Status status = check_size(chart.width, chart.height); !status) return status.error();
  if (chart.series.empty()) return Error{ErrorCode::kRange, "chart", "there is no series to show", ""};
  std::vector<double> xs, ys;
  for (const ChartSeries& series : chart.series) {
    if (series.x.size() != series.y.size()) {
      return Error{ErrorCode::kType, fmt::format("series \"{}\"", series.name),
                   fmt::format("{} x values do not fit {} y values", series.x.size(), series.y.size()), ""};
    }
    xs.insert(xs.end(), series.x.begin(), series.x.end());
    ys.insert(ys.end(), series.y.begin(), series.y.end());
  }
  for (const ChartGuide& guide : chart.guides) {
    (guide.direction == ChartGuide::Direction::kHorizontal ? ys : xs).push_back(guide.value);
  }
  const Result<AxisScale> x = make_scale(chart.x, xs, "x axis");
  if (!x) return x.error();
  const Result<AxisScale> y = make_scale(chart.y, ys, "y axis");
  if (!y) return y.error();
  Canvas canvas(format, chart.width, chart.height);
  const double fitting = std::sqrt(static_cast<double>(chart.width) * chart.height) / 52;
  Page(canvas, chart, x.value(), y.value(), chart.text_size > 0 ? chart.text_size : std::clamp(fitting, 7.0, 40.0))
      .draw();
  return canvas.finish(chart.title.empty() ? "Chart drawn by lissom" : chart.title);
}

}  // namespace lissom
