#pragma once
/// What charts of all kinds share: axes with ticks, the frame with its grid, guides, and the colours of series.

#include <string>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/view/canvas.h"
#include "lissom/view/chart.h"
#include "lissom/view/ticks.h"

namespace lissom {

/// One axis ready for drawing: displayed values to 0..1.
struct AxisScale {
  bool logarithmic = false;
  double low = 0, high = 1;  ///< as displayed
  Ticks ticks;

  double place(double shown) const;  ///< NaN for what a logarithmic axis cannot show
};

/// Fits `given` (before display_scale) unless the axis names its ends. `where` names the axis in errors.
Result<AxisScale> make_scale(const ChartAxis& axis, const std::vector<double>& given, const std::string& where);

/// Colour of a series, by its number.
Color series_color(Theme theme, size_t index);

/// Where a chart is on its page, px, and what is around it.
class ChartFrame {
 public:
  /// `em` (px) is the size of its text; `top` (px) is the place of its upper edge.
  ChartFrame(Canvas& canvas, const AxisScale& x, const AxisScale& y, Theme theme, double em, double top);

  /// Place on the page of displayed values.
  Vec2 at(double x, double y) const {
    return {left + (right - left) * x_.place(x), bottom - (bottom - top) * y_.place(y)};
  }

  void draw_grid(const ChartAxis& x, const ChartAxis& y, const std::string& title) const;
  /// `value` as displayed.
  void draw_guide(ChartGuide::Direction direction, double value, const std::string& label) const;

  /// Drawing outside of the frame, but for marks on it, is cut off until `unclip` of the canvas.
  void clip() const;

  double left = 0, right = 0, top = 0, bottom = 0;  ///< px

  const ThemeColors& colors() const { return colors_; }
  const TextStyle& label() const { return label_; }
  double em() const { return em_; }

 private:
  Canvas& canvas_;
  const AxisScale& x_;
  const AxisScale& y_;
  ThemeColors colors_;
  double em_;
  TextStyle label_;
};

}  // namespace lissom
