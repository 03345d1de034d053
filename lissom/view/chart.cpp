#include "lissom/view/chart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "lissom/view/ticks.h"

namespace lissom {
namespace {

// Okabe and Ito, "Color universal design" (2008): told apart with any common colour vision.
constexpr std::array<Color, 6> kInk = {{{0.00, 0.45, 0.70},
                                        {0.84, 0.37, 0.00},
                                        {0.00, 0.62, 0.45},
                                        {0.80, 0.47, 0.65},
                                        {0.90, 0.62, 0.00},
                                        {0.34, 0.71, 0.91}}};

/// One axis ready for drawing: displayed values to 0..1.
struct Scale {
  bool logarithmic = false;
  double low = 0, high = 1;  // as displayed
  Ticks ticks;

  double place(double shown) const {
    if (!logarithmic) return (shown - low) / (high - low);
    return shown > 0 ? std::log(shown / low) / std::log(high / low) : std::numeric_limits<double>::quiet_NaN();
  }
};

Result<Scale> make_scale(const ChartAxis& axis, const std::vector<double>& given, const std::string& where) {
  Scale scale;
  scale.logarithmic = axis.scale == ChartAxis::Scale::kLogarithmic;
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (double v : given) {
    const double shown = v * axis.display_scale;
    if (!std::isfinite(shown) || (scale.logarithmic && shown <= 0)) continue;
    low = std::min(low, shown);
    high = std::max(high, shown);
  }
  if (low > high) {
    return Error{ErrorCode::kRange, where,
                 scale.logarithmic ? "no value can be shown on a logarithmic axis" : "there is no value to show",
                 scale.logarithmic ? "values must be above zero" : "give at least one finite point"};
  }
  if (scale.logarithmic) {
    if (high / low < 1.01) low /= 2, high *= 2;
    const double margin = std::pow(high / low, 0.04);
    low /= margin, high *= margin;
  } else {
    if (!(high - low > 1e-12 * std::max(std::abs(low), std::abs(high)))) {
      const double half = low == 0 ? 1 : 0.5 * std::abs(low);
      low -= half, high += half;
    }
    const double margin = 0.04 * (high - low);
    if (low > 0 && low < 0.35 * high)
      low = 0;
    else if (low != 0)
      low -= margin;
    high += high == 0 ? 0 : margin;
  }
  if (axis.low) low = *axis.low * axis.display_scale;
  if (axis.high) high = *axis.high * axis.display_scale;
  if (!(std::isfinite(low) && std::isfinite(high) && high > low && (!scale.logarithmic || low > 0))) {
    return Error{ErrorCode::kRange, where, "the ends of the axis are not possible",
                 "the upper end must be above the lower one, and both above zero on a logarithmic axis"};
  }
  scale.low = low;
  scale.high = high;
  scale.ticks = scale.logarithmic ? log_ticks(low, high, 8) : linear_ticks(low, high, 7);
  return scale;
}

std::string axis_title(const ChartAxis& axis, const Scale& scale) {
  std::string unit = axis.unit;
  if (scale.ticks.exponent != 0) unit = power_of_ten(scale.ticks.exponent) + (unit.empty() ? "" : " " + unit);
  return unit.empty() ? axis.label : fmt::format("{} ({})", axis.label, unit);
}

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

/// The drawing of one chart: where things are on the page.
class Page {
 public:
  Page(Canvas& canvas, const Chart& chart, const Scale& x, const Scale& y)
      : canvas_(canvas), chart_(chart), x_(x), y_(y), colors_(theme_colors(chart.theme)) {
    em_ = std::clamp(std::sqrt(static_cast<double>(chart.width) * chart.height) / 52, 7.0, 40.0);
    label_ = {.size = 0.9 * em_, .color = colors_.ink};
    double widest = 0;
    for (const std::string& text : y.ticks.labels) widest = std::max(widest, canvas.text_width(text, label_));
    left_ = 3.4 * em_ + widest;
    top_ = chart.title.empty() ? 1.2 * em_ : 3.2 * em_;
    right_ = chart.width - 1.6 * em_;
    bottom_ = chart.height - 4.2 * em_;
  }

  void draw() {
    canvas_.fill(colors_.page);
    draw_grid();
    const double room = 0.35 * em_;  // marks on the frame stay whole
    canvas_.clip({left_ - room, top_ - room}, {right_ - left_ + 2 * room, bottom_ - top_ + 2 * room});
    for (const ChartGuide& guide : chart_.guides) draw_guide(guide);
    for (size_t i = 0; i < chart_.series.size(); ++i) draw_series(i);
    canvas_.unclip();
    if (chart_.series.size() > 1 || !chart_.series.front().name.empty()) draw_names();
  }

 private:
  Vec2 at(double x, double y) const {
    return {left_ + (right_ - left_) * x_.place(x * chart_.x.display_scale),
            bottom_ - (bottom_ - top_) * y_.place(y * chart_.y.display_scale)};
  }

  void draw_grid() {
    const Stroke rule{.color = colors_.rule, .width = 0.06 * em_, .cap = Stroke::Cap::kButt};
    for (size_t i = 0; i < x_.ticks.at.size(); ++i) {
      const double px = left_ + (right_ - left_) * x_.place(x_.ticks.at[i]);
      canvas_.polyline(std::array{Vec2(px, top_), Vec2(px, bottom_)}, rule);
      TextStyle style = label_;
      style.horizontal = 0.5, style.vertical = 1;
      canvas_.text({px, bottom_ + 0.5 * em_}, x_.ticks.labels[i], style);
    }
    for (size_t i = 0; i < y_.ticks.at.size(); ++i) {
      const double py = bottom_ - (bottom_ - top_) * y_.place(y_.ticks.at[i]);
      canvas_.polyline(std::array{Vec2(left_, py), Vec2(right_, py)}, rule);
      TextStyle style = label_;
      style.horizontal = 1, style.vertical = 0.5;
      canvas_.text({left_ - 0.5 * em_, py}, y_.ticks.labels[i], style);
    }
    const Stroke frame{.color = colors_.faint_ink, .width = 0.09 * em_, .cap = Stroke::Cap::kButt};
    canvas_.polyline(std::array{Vec2(left_, top_), Vec2(left_, bottom_), Vec2(right_, bottom_)}, frame);
    const TextStyle title{.size = em_, .color = colors_.ink, .horizontal = 0.5};
    canvas_.text({(left_ + right_) / 2, chart_.height - 1.2 * em_}, axis_title(chart_.x, x_), title);
    TextStyle upright = title;
    upright.angle = std::numbers::pi / 2;
    canvas_.text({1.7 * em_, (top_ + bottom_) / 2}, axis_title(chart_.y, y_), upright);
    canvas_.text({left_, 2 * em_}, chart_.title,
                 {.size = 1.2 * em_, .color = colors_.ink, .weight = TextStyle::Weight::kBold});
  }

  void draw_guide(const ChartGuide& guide) {
    const bool level = guide.direction == ChartGuide::Direction::kHorizontal;
    const double shown = guide.value * (level ? chart_.y : chart_.x).display_scale;
    const double place = (level ? y_ : x_).place(shown);
    if (!std::isfinite(place)) return;
    const Stroke stroke{
        .color = colors_.faint_ink, .width = 0.09 * em_, .cap = Stroke::Cap::kButt, .dash = {0.5 * em_, 0.35 * em_}};
    TextStyle style{.size = 0.85 * em_, .color = colors_.faint_ink};
    if (level) {
      const double py = bottom_ - (bottom_ - top_) * place;
      canvas_.polyline(std::array{Vec2(left_, py), Vec2(right_, py)}, stroke);
      canvas_.text({left_ + 0.6 * em_, py - 0.4 * em_}, guide.label, style);
    } else {
      const double px = left_ + (right_ - left_) * place;
      canvas_.polyline(std::array{Vec2(px, top_), Vec2(px, bottom_)}, stroke);
      style.angle = std::numbers::pi / 2;
      canvas_.text({px - 0.4 * em_, bottom_ - 0.6 * em_}, guide.label, style);
    }
  }

  Stroke line_of(size_t index) const {
    const std::array<std::vector<double>, 4> dashes = {{{}, {0.9, 0.45}, {0.25, 0.35}, {0.9, 0.35, 0.25, 0.35}}};
    Stroke stroke{.color = color_of(index),
                  .width = 0.16 * em_,
                  .cap = Stroke::Cap::kButt,
                  .dash = dashes[index % dashes.size()]};
    for (double& length : stroke.dash) length *= em_;
    return stroke;
  }

  Color color_of(size_t index) const {
    const Color& ink = kInk[index % kInk.size()];
    return chart_.theme == Theme::kDark ? mix(ink, {1, 1, 1}, 0.25) : ink;
  }

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
    for (const ChartSeries& series : chart_.series) widest = std::max(widest, canvas_.text_width(series.name, label_));
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
    canvas_.rectangle(corner, size, colors_.page);
    const std::array<Vec2, 4> box = {corner, corner + Vec2(size.x(), 0), corner + size, corner + Vec2(0, size.y())};
    canvas_.outline(box, {.color = colors_.rule, .width = 0.08 * em_});
    for (size_t i = 0; i < chart_.series.size(); ++i) {
      const Vec2 at_line = corner + Vec2(0.6 * em_, 1.5 * em_ * (static_cast<double>(i) + 0.5) + 0.25 * em_);
      const ChartSeries& series = chart_.series[i];
      if (series.style != ChartSeries::Style::kPoints) {
        canvas_.polyline(std::array{at_line, Vec2(at_line + Vec2(2.2 * em_, 0))}, line_of(i));
      }
      if (series.style != ChartSeries::Style::kLine) {
        draw_mark(canvas_, at_line + Vec2(1.1 * em_, 0), i, 0.3 * em_, color_of(i));
      }
      TextStyle style = label_;
      style.vertical = 0.5;
      canvas_.text(at_line + Vec2(2.7 * em_, 0), series.name, style);
    }
  }

  Canvas& canvas_;
  const Chart& chart_;
  const Scale& x_;
  const Scale& y_;
  ThemeColors colors_;
  double em_ = 12, left_ = 0, right_ = 0, top_ = 0, bottom_ = 0;  // px
  TextStyle label_;
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
  const Result<Scale> x = make_scale(chart.x, xs, "x axis");
  if (!x) return x.error();
  const Result<Scale> y = make_scale(chart.y, ys, "y axis");
  if (!y) return y.error();
  Canvas canvas(format, chart.width, chart.height);
  Page(canvas, chart, x.value(), y.value()).draw();
  return canvas.finish(chart.title.empty() ? "Chart drawn by lissom" : chart.title);
}

}  // namespace lissom
