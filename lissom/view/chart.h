#pragma once
/// Line charts as SVG or PNG: load paths, convergence histories, energies over time. Why not a plotting library:
/// docs/decisions/0003-pictures.md.

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/view/canvas.h"
#include "lissom/view/theme.h"

namespace lissom {

struct ChartAxis {
  enum class Scale { kLinear, kLogarithmic };
  enum class Numbers { kReal, kWhole };
  std::string label = {};
  std::string unit = {};     ///< as displayed; empty: a pure number
  double display_scale = 1;  ///< shown value = given value * display_scale
  Scale scale = Scale::kLinear;
  Numbers numbers = Numbers::kReal;           ///< whole: ticks at whole numbers only
  std::optional<double> low = {}, high = {};  ///< ends, as given (before display_scale); absent: fits the data
};

struct ChartSeries {
  enum class Style { kLine, kPoints, kLineAndPoints };
  std::string name = {};
  std::vector<double> x = {},
                      y = {};  ///< same length; NaN leaves a gap, and so does a value <= 0 on a logarithmic axis
  Style style = Style::kLine;
};

/// A line across the chart with a label: a critical load, a tolerance.
struct ChartGuide {
  enum class Direction { kHorizontal, kVertical };
  Direction direction = Direction::kHorizontal;
  double value = 0;  ///< as given on that axis
  std::string label = {};
};

struct Chart {
  std::string title;
  ChartAxis x, y;
  std::vector<ChartSeries> series;
  std::vector<ChartGuide> guides;
  int width = 1000, height = 640;  ///< px
  double text_size = 0;            ///< px; 0: follows from the size
  Theme theme = Theme::kLight;
};

/// Series differ in colour, dashes and marker shape. Errors: no finite point at all, x and y of different length,
/// impossible size or axis.
Result<std::string> draw_chart(const Chart& chart, ImageFormat format);

}  // namespace lissom
