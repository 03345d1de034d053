#pragma once
/// How often values occur: deviations before and after, parameters between their bounds. In the style of chart.h.

#include <string>
#include <vector>

#include "lissom/view/chart.h"

namespace lissom {

struct HistogramSeries {
  std::string name = {};
  std::vector<double> values = {};  ///< numbers that are not finite are left out
};

struct Histogram {
  std::string title = {};
  ChartAxis x = {};               ///< linear
  std::string counted = "count";  ///< what the bars count, on the y axis
  std::vector<HistogramSeries> series = {};
  std::vector<ChartGuide> guides = {};  ///< vertical ones are drawn, and are inside of the bins
  int bins = 24;                        ///< at most, from the lowest to the highest value or guide
  int width = 1000, height = 640;       ///< px
  double text_size = 0;                 ///< px; 0: follows from the size
  Theme theme = Theme::kLight;
};

/// Bins of even width from `low`, with a count per series and bin. Values on an edge belong to the bin above it, the
/// highest value to the last bin.
struct HistogramBins {
  double low = 0, width = 1;             ///< as given
  std::vector<std::vector<int>> counts;  ///< (series x bins)
};

/// Errors: no finite value, fewer than one bin.
Result<HistogramBins> histogram_bins(const Histogram& histogram);

/// Bars of several series stand side by side. Errors: those of histogram_bins, impossible size or axis.
Result<std::string> draw_histogram(const Histogram& histogram, ImageFormat format);

}  // namespace lissom
