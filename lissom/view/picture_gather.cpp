#include <algorithm>
#include <cmath>
#include <limits>

#include "lissom/view/picture_parts.h"

namespace lissom {

bool shown(const Marker& marker, const PictureOptions& options) {
  return (marker.kind == Marker::Kind::kForce ? options.forces : options.supports) == Visibility::kShown;
}

namespace {

void gather_shape(const std::vector<Panel>& panels, const PictureOptions& options, Shared& shared) {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const Panel& panel : panels) {
    int supports = 0;
    for (const Layer& layer : panel.layers) {
      for (const RodStrip& rod : layer.drawing.rods) {
        for (size_t i = 0; i < rod.points.size(); ++i) {
          const size_t edge = std::min(i, rod.b.size() - 1);
          shared.points.push_back(rod.points[i]);
          shared.radii.push_back(std::max(rod.r_b[edge], rod.r_n[edge]));
          low = low.cwiseMin(rod.points[i] - Vec3::Constant(shared.radii.back()));
          high = high.cwiseMax(rod.points[i] + Vec3::Constant(shared.radii.back()));
        }
      }
      const auto see = [&](const Vec3& p) {
        shared.points.push_back(p);
        shared.radii.push_back(0);
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
      };
      for (const MembraneSheet& sheet : layer.drawing.membranes)
        std::for_each(sheet.points.begin(), sheet.points.end(), see);
      for (const std::vector<Vec3>& guide : layer.guides) std::for_each(guide.begin(), guide.end(), see);
      std::for_each(layer.dots.begin(), layer.dots.end(), see);
      for (const Marker& marker : layer.drawing.markers) {
        if (!shown(marker, options)) continue;
        supports += marker.kind != Marker::Kind::kForce;
        shared.markers.largest_force = std::max(shared.markers.largest_force, marker.vector.norm());
      }
    }
    shared.supports = std::max(shared.supports, supports);
  }
  const double size = (high - low).norm();
  shared.ground = low.z();
  shared.markers.middle = (low + high) / 2;
  shared.markers.support = 0.035 * size * std::clamp(std::sqrt(12.0 / std::max(1, shared.supports)), 0.25, 1.0);
  shared.markers.arrow = 0.17 * size;
  for (const Panel& panel : panels) {
    for (const Layer& layer : panel.layers) {
      for (const Marker& marker : layer.drawing.markers) {
        if (!shown(marker, options)) continue;
        const bool force = marker.kind == Marker::Kind::kForce;
        const Arrow arrow = force ? force_arrow(marker, shared.markers) : Arrow{marker.at, marker.at};
        if (!force) shared.ground = std::min(shared.ground, marker.at.z() - shared.markers.support);
        for (const Vec3& p : {arrow.tail, arrow.tip}) {
          shared.points.push_back(p);
          shared.radii.push_back(force ? 0.08 * shared.markers.arrow : shared.markers.support);
        }
      }
    }
  }
  if (options.shadow == Visibility::kShown) {
    const size_t count = shared.points.size();
    for (size_t i = 0; i < count; ++i) {
      shared.points.push_back({shared.points[i].x(), shared.points[i].y(), shared.ground});
      shared.radii.push_back(0);
    }
  }
}

/// Marks on cloth: slack is hatched when it is known and there is some.
void gather_marks(const std::vector<Panel>& panels, const PictureOptions& options, double em, const ThemeColors& colors,
                  Shared& shared) {
  bool slack = false, pull = false;
  for (const Panel& panel : panels) {
    for (const Layer& layer : panel.layers) {
      if (layer.style != Layer::Style::kSolid) continue;
      for (const MembraneSheet& sheet : layer.drawing.membranes) {
        const std::vector<double>& stretch = sheet.smallest_stretch;
        slack |= std::any_of(stretch.begin(), stretch.end(), [](double s) { return s < 1; });
        pull |= !sheet.tension.empty();
      }
    }
  }
  const bool fields = !options.field.empty() || !options.membrane_field.empty();
  shared.marks.ink = mix(colors.fabric, colors.ink, fields ? 0.75 : 0.45);
  shared.marks.hem = 0.09 * em;
  if (slack && options.slack == Visibility::kShown) shared.marks.hatch = 0.6 * em;
  if (pull && options.tension == Visibility::kShown) shared.marks.stroke = 1.2 * em;
}

}  // namespace

Shared gather(const std::vector<Panel>& panels, const PictureOptions& options, double em) {
  Shared shared;
  gather_shape(panels, options, shared);
  shared.colors = color_key(panels, options.field, options.range);
  shared.colors.legend.steps = options.steps;
  shared.membrane_colors = color_key(panels, options.membrane_field, options.membrane_range);
  gather_marks(panels, options, em, theme_colors(options.theme), shared);
  return shared;
}

}  // namespace lissom
