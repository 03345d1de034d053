#include "lissom/view/histogram.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

#include "tests/unit/picture_samples.h"

namespace lissom {
namespace {

using samples::count;
using samples::hex;

Histogram sample() {
  Histogram histogram;
  histogram.title = "Radii <n>";
  histogram.x = {.label = "radius", .unit = "mm", .display_scale = 1000};
  histogram.series = {{.name = "after", .values = {0.001, 0.0012, 0.0013, 0.002}},
                      {.name = "before", .values = {0.0015, 0.0015, NAN, INFINITY}}};
  histogram.bins = 4;
  return histogram;
}

TEST(Histogram, BinsAreHalfOpenButTheLast) {
  Histogram histogram = sample();
  histogram.series = {{.name = "", .values = {0, 0.25, 0.5, 0.999, 1, -INFINITY, NAN}}};
  const Result<HistogramBins> bins = histogram_bins(histogram);
  ASSERT_TRUE(bins.ok());
  EXPECT_EQ(bins.value().low, 0);
  EXPECT_EQ(bins.value().width, 0.25);
  EXPECT_EQ(bins.value().counts, (std::vector<std::vector<int>>{{1, 1, 1, 2}}));
}

TEST(Histogram, SeriesShareTheirBinsAndEveryFiniteValueIsCountedOnce) {
  const HistogramBins bins = histogram_bins(sample()).value();
  ASSERT_EQ(bins.counts.size(), 2u);
  EXPECT_EQ(std::accumulate(bins.counts[0].begin(), bins.counts[0].end(), 0), 4);
  EXPECT_EQ(std::accumulate(bins.counts[1].begin(), bins.counts[1].end(), 0), 2);
  EXPECT_EQ(bins.counts[0].size(), bins.counts[1].size());
}

TEST(Histogram, EqualValuesShareOneBinAroundThem) {
  for (const double v : {0.0, 3.0, -2e-3}) {
    Histogram histogram = sample();
    histogram.series = {{.name = "", .values = {v, v, v}}};
    const HistogramBins bins = histogram_bins(histogram).value();
    EXPECT_EQ(bins.counts, (std::vector<std::vector<int>>{{3}}));
    EXPECT_LT(bins.low, v);
    EXPECT_GT(bins.low + bins.width, v);
    EXPECT_TRUE(draw_histogram(histogram, ImageFormat::kPng).ok());
  }
}

TEST(Histogram, OneBarPerFilledBinAndSeriesInItsColour) {
  const std::string svg = draw_histogram(sample(), ImageFormat::kInlineSvg).value();
  // {1, 1.2, 1.3 | 2} and {1.5, 1.5} in bins of 0.25: filled are 0, 1, 3 and 2; one square more per name
  EXPECT_EQ(count(svg, "<rect fill=\"var(--series-0)\""), 3u + 1u);
  EXPECT_EQ(count(svg, "<rect fill=\"var(--series-1)\""), 1u + 1u);
  EXPECT_EQ(count(svg, ">after</text>"), 1u);
  EXPECT_NE(svg.find("aria-label=\"Radii &lt;n&gt;\""), std::string::npos);
  EXPECT_EQ(svg, draw_histogram(sample(), ImageFormat::kInlineSvg).value());
  EXPECT_NE(draw_histogram(sample(), ImageFormat::kSvg).value().find(hex(kSeriesInk[0])), std::string::npos);
}

TEST(Histogram, BoundsAreInsideOfTheAxisAndLabelled) {
  Histogram histogram = sample();
  const std::string without = draw_histogram(histogram, ImageFormat::kInlineSvg).value();
  EXPECT_EQ(count(without, "dasharray"), 0u);
  histogram.guides = {{ChartGuide::Direction::kVertical, 0.0005, "lower"},
                      {ChartGuide::Direction::kVertical, 0.01, "upper"},
                      {ChartGuide::Direction::kHorizontal, 1, "not drawn"}};
  const std::string svg = draw_histogram(histogram, ImageFormat::kInlineSvg).value();
  EXPECT_EQ(count(svg, "dasharray"), 2u);
  EXPECT_EQ(count(svg, ">lower</text>"), 1u);
  EXPECT_EQ(count(svg, ">upper</text>"), 1u);
  EXPECT_EQ(count(svg, "not drawn"), 0u);
  EXPECT_EQ(count(svg, ">10</text>"), 1u);  // mm, on the axis
}

TEST(Histogram, BinsReachFromBoundToBound) {
  Histogram histogram = sample();
  histogram.series = {{.name = "", .values = {1, 2}}};
  histogram.guides = {{ChartGuide::Direction::kVertical, 0, ""}, {ChartGuide::Direction::kVertical, 4, ""}};
  const HistogramBins bins = histogram_bins(histogram).value();
  EXPECT_EQ(bins.low, 0);
  EXPECT_EQ(bins.counts, (std::vector<std::vector<int>>{{0, 1, 1, 0}}));
  histogram.series[0].values = {NAN};
  EXPECT_FALSE(histogram_bins(histogram).ok());  // bounds are no values
}

TEST(Histogram, ErrorsSayWhere) {
  Histogram histogram = sample();
  histogram.series = {{.name = "", .values = {NAN, INFINITY}}};
  EXPECT_EQ(draw_histogram(histogram, ImageFormat::kSvg).error().where, "histogram");
  histogram.series.clear();
  EXPECT_EQ(draw_histogram(histogram, ImageFormat::kSvg).error().where, "histogram");
  histogram = sample();
  histogram.bins = 0;
  EXPECT_EQ(histogram_bins(histogram).error().where, "histogram");
  histogram = sample();
  histogram.width = 1;
  EXPECT_EQ(draw_histogram(histogram, ImageFormat::kSvg).error().where, "picture size");
  histogram = sample();
  histogram.x.low = 1;
  histogram.x.high = 0;
  EXPECT_EQ(draw_histogram(histogram, ImageFormat::kSvg).error().where, "x axis");
}

}  // namespace
}  // namespace lissom
