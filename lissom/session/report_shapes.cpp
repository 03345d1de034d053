#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "lissom/session/report_figures.h"
#include "lissom/session/report_pose.h"
#include "lissom/session/report_words.h"
#include "lissom/view/histogram.h"
#include "lissom/view/page_colors.h"
#include "lissom/view/picture.h"
#include "lissom/view/text.h"

namespace lissom {

namespace {

using ReportPose = DesignReport::Pose;

constexpr int kWidth = 520, kHeight = 430, kChartHeight = 260;  // px, half of the page
constexpr double kText = 12.5;                                  // px
constexpr double kMuchCloser = 4;  // from this on the deviations before say nothing in a histogram with those after

const DesignReport::Measure kMillimetres{};

/// Deviations of nodes from their targets, m.
struct Deviations {
  std::vector<double> before, after;
  double rms_before = 0, rms_after = 0, largest_before = 0, largest_after = 0;
};

Deviations deviations(const ReportPose& pose) {
  Deviations d;
  for (const DesignReport::Target& t : pose.targets) {
    d.before.push_back((t.before - t.wanted).norm());
    d.after.push_back((t.after - t.wanted).norm());
    d.rms_before += d.before.back() * d.before.back();
    d.rms_after += d.after.back() * d.after.back();
    d.largest_before = std::max(d.largest_before, d.before.back());
    d.largest_after = std::max(d.largest_after, d.after.back());
  }
  const double count = std::max<double>(1, static_cast<double>(pose.targets.size()));
  d.rms_before = std::sqrt(d.rms_before / count);
  d.rms_after = std::sqrt(d.rms_after / count);
  return d;
}

/// Rods only: cloth would hide what is behind it.
Drawing rods_of(const Drawing& drawing, const char* field) {
  Drawing bare;
  bare.rods = drawing.rods;
  if (field == nullptr) return bare;
  if (const Field* found = drawing.field(field)) {
    bare.fields = {*found};
    bare.fields.front().values.resize(static_cast<size_t>(bare.rod_point_count()));
  }
  return bare;
}

PictureOptions options_of(const ReportPose& pose, const std::string& title) {
  return {.width = kWidth,
          .height = kHeight,
          .view = view_of_deviations(pose),
          .title = title,
          .sections = Sections::kFlat,
          .steps = kPageSteps,
          .text_size = kText};
}

Result<std::string> drawn(const std::vector<Layer>& layers, const PictureOptions& options, const ReportPose& pose) {
  Result<std::string> picture = draw_picture({{layers, ""}}, options, ImageFormat::kInlineSvg);
  if (picture) return picture;
  Error error = picture.error();
  error.where = fmt::format("pose \"{}\": {}", pose.name, error.where);
  return error;
}

std::string swatch(const char* kind, const char* words) {
  return fmt::format("<span class=\"key\"><i class=\"{}\"></i>{}</span>", kind, words);
}

Result<std::string> overlay(const ReportPose& pose) {
  std::vector<Layer> layers;
  std::string keys;
  if (!pose.target.rods.empty() || !pose.dots.empty()) {
    Layer target{.drawing = pose.target, .style = Layer::Style::kTrack, .ink = theme_colors(Theme::kLight).ghost};
    target.dots = pose.dots;
    if (pose.target.rods.empty()) target.drawing = rods_of(pose.before, nullptr), target.style = Layer::Style::kLines;
    layers.push_back(std::move(target));
    keys += swatch("band", "target, wide grey");
  }
  Layer before{.drawing = rods_of(pose.before, nullptr), .style = Layer::Style::kLines, .ink = kSeriesInk[1]};
  before.weight = 0.7;
  Layer after{.drawing = rods_of(pose.after, nullptr), .style = Layer::Style::kLines, .ink = kSeriesInk[0]};
  after.weight = 1.15;
  layers.push_back(std::move(before));
  layers.push_back(std::move(after));
  const Result<std::string> picture = drawn(layers, options_of(pose, "Target, before and after"), pose);
  if (!picture) return picture.error();
  keys += swatch("before", "before, thin orange") + swatch("after", "after, thick blue");
  return "<figure>" + picture.value() + "<figcaption>" + keys + "</figcaption></figure>\n";
}

Result<std::string> deviation_figure(const ReportPose& pose, const Deviations& d, double scale_end) {
  PictureOptions options = options_of(pose, "Distance from the target, after");
  options.field = kDeviation;
  options.range = ColorRange{0, scale_end};
  options.axes = Visibility::kHidden;  // those of the picture beside it
  const Result<std::string> picture =
      drawn({{.drawing = rods_of(pose.after, kDeviation), .style = Layer::Style::kSolid}}, options, pose);
  if (!picture) return picture.error();
  return fmt::format(
      "<figure>{}<figcaption>Largest distance {}; the scale is the same for all poses.</figcaption></figure>\n",
      picture.value(), report_quantity(d.largest_after, kMillimetres));
}

Result<std::string> spread_figure(const Deviations& d) {
  Histogram histogram;
  histogram.title = "Nodes by distance";
  histogram.x = {.label = "distance from the target", .unit = "mm", .display_scale = 1000};
  histogram.counted = "nodes";
  histogram.width = kWidth;
  histogram.height = kChartHeight;
  histogram.text_size = kText;
  histogram.series = {{.name = "after", .values = d.after}};
  const bool comparable = d.rms_before < kMuchCloser * d.rms_after;
  if (comparable) histogram.series.push_back({.name = "before", .values = d.before});
  const Result<std::string> picture = draw_histogram(histogram, ImageFormat::kInlineSvg);
  if (!picture) return picture.error();
  return fmt::format(
      "<figure>{}<figcaption>{}</figcaption></figure>\n", picture.value(),
      comparable ? "How many nodes are how far from their targets."
                 : fmt::format("How many nodes are how far from their targets. Before, the root mean square was {}.",
                               report_quantity(d.rms_before, kMillimetres)));
}

std::string numbers_table(const ReportPose& pose, const Deviations& d) {
  const auto row = [](const char* name, double before, double after) {
    return fmt::format("<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td></tr>", name,
                       report_value(before, kMillimetres), report_value(after, kMillimetres));
  };
  const auto median = [](std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  };
  return fmt::format(
      "<div class=\"numbers\"><table><caption>Distance of {} from their targets (mm)</caption><thead><tr><td></td>"
      "<th scope=\"col\">before</th><th scope=\"col\">after</th></tr></thead><tbody>{}{}{}</tbody></table></div>\n",
      report_count(static_cast<int>(pose.targets.size()), "node", "nodes"),
      row("root mean square", d.rms_before, d.rms_after), row("median", median(d.before), median(d.after)),
      row("largest", d.largest_before, d.largest_after));
}

}  // namespace

Result<std::string> report_shapes(const DesignReport& report) {
  double scale_end = 0;  // m
  for (const ReportPose& pose : report.poses) scale_end = std::max(scale_end, deviations(pose).largest_after);
  std::string html;
  for (const ReportPose& pose : report.poses) {
    html += fmt::format("<section class=\"pose\"><h3>Pose {}</h3>\n<div class=\"grid\">\n", xml_escaped(pose.name));
    const Result<std::string> shapes = overlay(pose);
    if (!shapes) return shapes.error();
    html += shapes.value();
    if (!pose.targets.empty()) {
      const Deviations d = deviations(pose);
      if (pose.after.field(kDeviation) != nullptr && scale_end > 0) {
        const Result<std::string> left = deviation_figure(pose, d, scale_end);
        if (!left) return left.error();
        html += left.value();
      }
      const Result<std::string> spread = spread_figure(d);
      if (!spread) return spread.error();
      html += spread.value() + numbers_table(pose, d);
    }
    html += "</div></section>\n";
  }
  return html;
}

}  // namespace lissom
