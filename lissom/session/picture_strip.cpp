#include "lissom/session/picture_strip.h"

#include <algorithm>
#include <cmath>

namespace lissom {

namespace {

constexpr double kBestAspect = 1.6;  ///< of a strip, width over height
// Parts of a strip over its width: height of a caption, height of title and ruler, width of the legend.
constexpr double kCaption = 0.03, kFrame = 0.09, kLegend = 0.11;

/// Width over height of what is seen of all panels together.
double aspect_of(const std::vector<Panel>& panels, const Viewpoint& view) {
  std::vector<Vec3> points;
  std::vector<double> radii;
  for (const Panel& panel : panels) {
    for (const Layer& layer : panel.layers) {
      for (const RodStrip& rod : layer.drawing.rods) {
        for (size_t i = 0; i < rod.points.size(); ++i) {
          const size_t edge = std::min(i, rod.b.size() - 1);
          points.push_back(rod.points[i]);
          radii.push_back(std::max(rod.r_b[edge], rod.r_n[edge]));
        }
      }
      for (const MembraneSheet& sheet : layer.drawing.membranes) {
        points.insert(points.end(), sheet.points.begin(), sheet.points.end());
      }
      for (const std::vector<Vec3>& guide : layer.guides) points.insert(points.end(), guide.begin(), guide.end());
      radii.resize(points.size(), 0);
    }
  }
  constexpr double kAmple = 1e9;
  const double width = 1 / Camera(view, points, radii, Vec2::Zero(), Vec2(1, kAmple)).scale();
  const double height = 1 / Camera(view, points, radii, Vec2::Zero(), Vec2(kAmple, 1)).scale();
  return std::clamp(width / height, 0.1, 10.0);
}

}  // namespace

Result<std::string> draw_panels(const PictureStrip& strip, const std::vector<Panel>& panels, ImageFormat format) {
  for (const Panel& panel : panels) {
    for (const Layer& layer : panel.layers) {
      if (Status status = check_drawing(layer.drawing); !status) return status.error();
    }
  }
  const double aspect = aspect_of(panels, strip.view);
  const bool legend = !strip.field.empty() || !strip.membrane_field.empty();
  const double pictures_width = strip.width * (legend ? 1 - kLegend : 1);
  const int count = static_cast<int>(panels.size());
  PictureOptions options;
  double best = 0;
  for (int columns = 1; columns <= count; ++columns) {
    const int rows = (count + columns - 1) / columns;
    const double height = rows * (pictures_width / columns / aspect + kCaption * strip.width) + kFrame * strip.width;
    const double empty = static_cast<double>(rows * columns - count) / count;
    const double miss = std::abs(std::log(strip.width / height / kBestAspect)) + empty;
    if (columns > 1 && miss >= best) continue;
    best = miss;
    options.columns = columns;
    options.height = static_cast<int>(height);
  }
  options.title = strip.title;
  options.field = strip.field;
  options.membrane_field = strip.membrane_field;
  options.view = strip.view;
  options.width = strip.width;
  options.forces = Visibility::kHidden;
  options.theme = strip.theme;
  options.shadow = strip.shadow;
  options.tension = strip.tension;
  return draw_picture(panels, options, format);
}

}  // namespace lissom
