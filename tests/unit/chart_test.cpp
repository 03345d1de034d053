#include "lissom/view/chart.h"

#include <cmath>
#include <gtest/gtest.h>

namespace lissom {
namespace {

Chart sample() {
  Chart chart;
  chart.title = "Load <path> & more";
  chart.x = {.label = "deflection", .unit = "mm", .display_scale = 1000};
  chart.y = {.label = "load", .unit = "N"};
  chart.series = {
      {.name = "computed", .x = {0, 0.001, 0.002}, .y = {0, 1, 1.5}},
      {.name = "measured", .x = {0, 0.001, 0.002}, .y = {0.1, 1.1, 1.4}, .style = ChartSeries::Style::kPoints}};
  chart.guides = {{ChartGuide::Direction::kHorizontal, 1.2, "critical"}};
  return chart;
}

size_t count(const std::string& text, const std::string& part) {
  size_t n = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

TEST(Chart, SvgAndPngAreReproducible) {
  for (ImageFormat format : {ImageFormat::kSvg, ImageFormat::kPng}) {
    const Result<std::string> first = draw_chart(sample(), format), second = draw_chart(sample(), format);
    ASSERT_TRUE(first.ok()) << first.error().text();
    EXPECT_EQ(first.value(), second.value());
  }
  const std::string svg = draw_chart(sample(), ImageFormat::kSvg).value();
  EXPECT_NE(svg.find("<title>Load &lt;path&gt; &amp; more</title>"), std::string::npos);
  EXPECT_EQ(draw_chart(sample(), ImageFormat::kPng).value().substr(1, 3), "PNG");
}

TEST(Chart, LineSeriesIsOnePathAndGapsCutIt) {
  Chart chart = sample();
  chart.series.pop_back();
  chart.series[0].name.clear();
  const std::string blue = "stroke:#0073b3";
  EXPECT_EQ(count(draw_chart(chart, ImageFormat::kSvg).value(), blue), 1u);
  chart.series[0].x = {0, 1, 2, 3, 4};
  chart.series[0].y = {0, 1, std::nan(""), 1, 0};
  EXPECT_EQ(count(draw_chart(chart, ImageFormat::kSvg).value(), blue), 2u);
  chart.y.scale = ChartAxis::Scale::kLogarithmic;
  chart.series[0].y = {1, 10, 0, 100, 1e4};
  EXPECT_EQ(count(draw_chart(chart, ImageFormat::kSvg).value(), blue), 2u);
}

TEST(Chart, ConstantAndSinglePointSeriesHaveAnAxis) {
  Chart chart = sample();
  chart.series = {{.name = "one", .x = {2}, .y = {0}, .style = ChartSeries::Style::kLineAndPoints}};
  chart.guides.clear();
  EXPECT_TRUE(draw_chart(chart, ImageFormat::kSvg).ok());
  chart.y.scale = ChartAxis::Scale::kLogarithmic;
  chart.series[0].y = {3};
  EXPECT_TRUE(draw_chart(chart, ImageFormat::kSvg).ok());
}

TEST(Chart, ErrorsSayWhere) {
  Chart chart = sample();
  chart.series.clear();
  EXPECT_EQ(draw_chart(chart, ImageFormat::kSvg).error().where, "chart");
  chart = sample();
  chart.series[1].y.pop_back();
  EXPECT_EQ(draw_chart(chart, ImageFormat::kSvg).error().where, "series \"measured\"");
  chart = sample();
  chart.guides.clear();
  for (ChartSeries& series : chart.series) series.y = {std::nan(""), INFINITY, std::nan("")};
  EXPECT_EQ(draw_chart(chart, ImageFormat::kPng).error().where, "y axis");
  chart = sample();
  chart.x.scale = ChartAxis::Scale::kLogarithmic;
  chart.x.low = -1;
  EXPECT_EQ(draw_chart(chart, ImageFormat::kPng).error().where, "x axis");
  chart = sample();
  chart.width = 1 << 20;
  EXPECT_EQ(draw_chart(chart, ImageFormat::kPng).error().where, "picture size");
}

}  // namespace
}  // namespace lissom
