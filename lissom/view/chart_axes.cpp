#include "lissom/view/chart_axes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>

namespace lissom {
namespace {

std::string axis_title(const ChartAxis& axis, const AxisScale& scale) {
  std::string unit = axis.unit;
  if (scale.ticks.exponent != 0) unit = power_of_ten(scale.ticks.exponent) + (unit.empty() ? "" : " " + unit);
  return unit.empty() ? axis.label : fmt::format("{} ({})", axis.label, unit);
}

/// Only the ticks at whole numbers.
Ticks whole(const Ticks& ticks) {
  Ticks kept;
  kept.exponent = ticks.exponent;
  for (size_t i = 0; i < ticks.at.size(); ++i) {
    if (std::abs(ticks.at[i] - std::round(ticks.at[i])) > 1e-9) continue;
    kept.at.push_back(ticks.at[i]);
    kept.labels.push_back(number_text(std::round(ticks.at[i]) / std::pow(10.0, ticks.exponent), 6));
  }
  return kept;
}

}  // namespace

double AxisScale::place(double shown) const {
  if (!logarithmic) return (shown - low) / (high - low);
  return shown > 0 ? std::log(shown / low) / std::log(high / low) : std::numeric_limits<double>::quiet_NaN();
}

Result<AxisScale> make_scale(const ChartAxis& axis, const std::vector<double>& given, const std::string& where) {
  AxisScale scale;
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
  if (axis.numbers == ChartAxis::Numbers::kWhole) scale.ticks = whole(scale.ticks);
  return scale;
}

Color series_color(Theme theme, size_t index) {
  const Color& ink = kSeriesInk[index % kSeriesInk.size()];
  return theme == Theme::kDark ? mix(ink, {1, 1, 1}, 0.25) : ink;
}

ChartFrame::ChartFrame(Canvas& canvas, const AxisScale& x, const AxisScale& y, Theme theme, double em, double top_px)
    : top(top_px), canvas_(canvas), x_(x), y_(y), colors_(theme_colors(theme)), em_(em) {
  label_ = {.size = 0.9 * em_, .color = colors_.ink};
  double widest = 0;
  for (const std::string& text : y.ticks.labels) widest = std::max(widest, canvas.text_width(text, label_));
  left = 3.4 * em_ + widest;
  right = canvas.width() - 1.6 * em_;
  bottom = canvas.height() - 4.2 * em_;
}

void ChartFrame::clip() const {
  const double room = 0.35 * em_;  // marks on the frame stay whole
  canvas_.clip({left - room, top - room}, {right - left + 2 * room, bottom - top + 2 * room});
}

void ChartFrame::draw_grid(const ChartAxis& x, const ChartAxis& y, const std::string& title) const {
  const Stroke rule{.color = colors_.rule, .width = 0.06 * em_, .cap = Stroke::Cap::kButt};
  for (size_t i = 0; i < x_.ticks.at.size(); ++i) {
    const double px = left + (right - left) * x_.place(x_.ticks.at[i]);
    canvas_.polyline(std::array{Vec2(px, top), Vec2(px, bottom)}, rule);
    TextStyle style = label_;
    style.horizontal = 0.5, style.vertical = 1;
    canvas_.text({px, bottom + 0.5 * em_}, x_.ticks.labels[i], style);
  }
  for (size_t i = 0; i < y_.ticks.at.size(); ++i) {
    const double py = bottom - (bottom - top) * y_.place(y_.ticks.at[i]);
    canvas_.polyline(std::array{Vec2(left, py), Vec2(right, py)}, rule);
    TextStyle style = label_;
    style.horizontal = 1, style.vertical = 0.5;
    canvas_.text({left - 0.5 * em_, py}, y_.ticks.labels[i], style);
  }
  const Stroke frame{.color = colors_.faint_ink, .width = 0.09 * em_, .cap = Stroke::Cap::kButt};
  canvas_.polyline(std::array{Vec2(left, top), Vec2(left, bottom), Vec2(right, bottom)}, frame);
  const TextStyle name{.size = em_, .color = colors_.ink, .horizontal = 0.5};
  canvas_.text({(left + right) / 2, canvas_.height() - 1.2 * em_}, axis_title(x, x_), name);
  TextStyle upright = name;
  upright.angle = std::numbers::pi / 2;
  canvas_.text({1.7 * em_, (top + bottom) / 2}, axis_title(y, y_), upright);
  canvas_.text({left, 2 * em_}, title, {.size = 1.2 * em_, .color = colors_.ink, .weight = TextStyle::Weight::kBold});
}

void ChartFrame::draw_guide(ChartGuide::Direction direction, double value, const std::string& label) const {
  const bool level = direction == ChartGuide::Direction::kHorizontal;
  const double place = (level ? y_ : x_).place(value);
  if (!std::isfinite(place)) return;
  const Stroke stroke{
      .color = colors_.faint_ink, .width = 0.09 * em_, .cap = Stroke::Cap::kButt, .dash = {0.5 * em_, 0.35 * em_}};
  TextStyle style{.size = 0.85 * em_, .color = colors_.faint_ink};
  if (level) {
    const double py = bottom - (bottom - top) * place;
    canvas_.polyline(std::array{Vec2(left, py), Vec2(right, py)}, stroke);
    canvas_.text({left + 0.6 * em_, py - 0.4 * em_}, label, style);
  } else {
    const double px = left + (right - left) * place;
    canvas_.polyline(std::array{Vec2(px, top), Vec2(px, bottom)}, stroke);
    style.angle = std::numbers::pi / 2;
    canvas_.text({px - 0.4 * em_, bottom - 0.6 * em_}, label, style);
  }
}

}  // namespace lissom
