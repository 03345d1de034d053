#include "lissom/view/picture.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "lissom/view/picture_parts.h"
#include "lissom/view/ticks.h"

namespace lissom {
namespace {

constexpr int kPngBudget = 60000, kSvgBudget = 9000;  // pieces per panel

/// Everything that the panels share.
struct Shared {
  std::vector<Vec3> points;   // m, what must be visible
  std::vector<double> radii;  // m
  MarkerScale markers;
  double ground = 0;  // m
  int supports = 0;
  Legend legend;
  const Field* field = nullptr;  // first one of that name
  ColorRange range;              // as stored
};

bool shown(const Marker& marker, const PictureOptions& options) {
  return (marker.kind == Marker::Kind::kForce ? options.forces : options.supports) == Visibility::kShown;
}

Status check(const std::vector<Panel>& panels, const PictureOptions& options) {
  if (Status status = check_size(options.width, options.height); !status) return status;
  if (Status status = options.view.validate(); !status) return status;
  if (options.range && !(std::isfinite(options.range->low) && options.range->high > options.range->low &&
                         std::isfinite(options.range->high))) {
    return Error{ErrorCode::kRange, "range", "the colour range is empty", "give a lower and a higher finite number"};
  }
  bool any = false;
  for (const Panel& panel : panels) {
    for (const Layer& layer : panel.layers) {
      any = true;
      if (Status status = check_drawing(layer.drawing); !status) return status;
      if (options.field.empty() || layer.style != Layer::Style::kSolid) continue;
      if (layer.drawing.field(options.field) != nullptr) continue;
      std::string names;
      for (const Field& f : layer.drawing.fields) names += (names.empty() ? "" : ", ") + f.name;
      return Error{ErrorCode::kUnknown, "field", fmt::format("there is no field \"{}\"", options.field),
                   names.empty() ? "this drawing has no fields" : "known fields: " + names};
    }
  }
  if (!any) return Error{ErrorCode::kGeometry, "picture", "there is nothing to draw", "give at least one state"};
  return {};
}

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

void gather_colors(const std::vector<Panel>& panels, const PictureOptions& options, Shared& shared) {
  if (options.field.empty()) return;
  bool any = false;
  ColorRange found;
  for (const Panel& panel : panels) {
    for (const Layer& layer : panel.layers) {
      if (layer.style != Layer::Style::kSolid) continue;
      const Field& field = *layer.drawing.field(options.field);
      if (shared.field == nullptr) shared.field = &field;
      const bool has_values =
          std::any_of(field.values.begin(), field.values.end(), [](double v) { return !std::isnan(v); });
      shared.legend.has_missing |=
          std::any_of(field.values.begin(), field.values.end(), [](double v) { return std::isnan(v); });
      if (!has_values) continue;
      const ColorRange fitted = ColorRange::fitting(field.colors, field.values);
      const ColorRange extremes = ColorRange::fitting(Field::Colors::kSequential, field.values);
      shared.range = any ? shared.range.including(fitted) : fitted;
      found = any ? found.including(extremes) : extremes;
      any = true;
    }
  }
  if (shared.field == nullptr) return;
  if (options.range) shared.range = *options.range;
  const double scale = shared.field->display_scale;
  shared.legend.title = shared.field->name;
  shared.legend.unit = shared.field->display_unit;
  shared.legend.colors = shared.field->colors;
  shared.legend.range = {shared.range.low * scale, shared.range.high * scale};
  shared.legend.found = {found.low * scale, found.high * scale};
  shared.legend.has_values = any;
}

void draw_panel(Canvas& canvas, const Panel& panel, const PictureOptions& options, const Shared& shared,
                const Camera& camera, int budget) {
  const ThemeColors colors = theme_colors(options.theme);
  if (options.shadow == Visibility::kShown && options.view.elevation > 0.05) {
    Scene shadow(camera, shared.ground, colors.shadow);
    for (const Layer& layer : panel.layers) {
      if (layer.style == Layer::Style::kSolid)
        add_rods(shadow, camera, layer.drawing, {.plain = colors.shadow}, budget / 4);
    }
    shadow.paint(canvas);
  }
  Scene behind(camera), front(camera);
  for (const Layer& layer : panel.layers) {
    switch (layer.style) {
      case Layer::Style::kDashed: {
        const double em = std::sqrt(static_cast<double>(options.width) * options.height) / 85;
        draw_centrelines(canvas, camera, layer.drawing,
                         {.color = mix(colors.ghost, colors.ink, 0.25),
                          .width = 0.1 * em,
                          .cap = Stroke::Cap::kButt,
                          .dash = {0.5 * em, 0.35 * em}});
        break;
      }
      case Layer::Style::kGhost:
        add_rods(behind, camera, layer.drawing, {.plain = colors.ghost, .contrast = 0.3}, budget / 3);
        break;
      case Layer::Style::kSolid:
        add_rods(front, camera, layer.drawing,
                 {.field = options.field.empty() ? nullptr : layer.drawing.field(options.field),
                  .range = shared.range,
                  .plain = colors.rod},
                 budget);
        break;
    }
    for (const Marker& marker : layer.drawing.markers) {
      if (shown(marker, options)) add_marker(front, marker, shared.markers, colors);
    }
  }
  behind.paint(canvas);
  front.paint(canvas);
}

std::string force_note(const MarkerScale& scale) {
  if (scale.largest_force == 0) return {};
  const double f = scale.largest_force;
  const std::string text = f >= 1000 ? number_text(f / 1000) + " kN"
                           : f < 0.1 ? number_text(f * 1000) + " mN"
                                     : number_text(f) + " N";
  return "longest arrow: " + text;
}

/// Rows and columns of panels.
struct Grid {
  int columns = 1, rows = 1;
};

Grid make_grid(int panels, int columns) {
  Grid grid;
  grid.columns = columns > 0   ? std::min(columns, panels)
                 : panels <= 4 ? panels
                               : static_cast<int>(std::ceil(std::sqrt(static_cast<double>(panels))));
  grid.rows = (panels + grid.columns - 1) / grid.columns;
  return grid;
}

}  // namespace

Result<std::string> draw_picture(const std::vector<Panel>& panels, const PictureOptions& options, ImageFormat format) {
  if (Status status = check(panels, options); !status) return status.error();
  Shared shared;
  gather_shape(panels, options, shared);
  gather_colors(panels, options, shared);

  const ThemeColors colors = theme_colors(options.theme);
  Canvas canvas(format, options.width, options.height);
  canvas.fill(colors.page);
  const double em = std::clamp(std::sqrt(static_cast<double>(options.width) * options.height) / 85, 7.0, 60.0);
  const double margin = 1.6 * em;

  const bool captions = std::any_of(panels.begin(), panels.end(), [](const Panel& p) { return !p.caption.empty(); });
  const double title_height = options.title.empty() ? 0 : 2.6 * em;
  const double caption_height = captions ? 2.2 * em : 0;
  const std::string note = options.forces == Visibility::kShown ? force_note(shared.markers) : "";
  const bool footer = options.ruler == Visibility::kShown || options.axes == Visibility::kShown || !note.empty();
  const double footer_height = footer ? 2.6 * em : 0;
  const double legend_width = shared.field != nullptr ? 9 * em : 0;

  const Vec2 area_corner(margin, margin + title_height);
  const Vec2 area =
      (Vec2(options.width, options.height) - area_corner - Vec2(margin + legend_width, margin + footer_height))
          .cwiseMax(4);
  const Grid grid = make_grid(static_cast<int>(panels.size()), options.columns);
  const double gap = em;
  const Vec2 cell((area.x() - gap * (grid.columns - 1)) / grid.columns, (area.y() - gap * (grid.rows - 1)) / grid.rows);
  const Vec2 view = (cell - Vec2(0, caption_height)).cwiseMax(4);

  if (!options.title.empty()) {
    canvas.text({margin, margin + 1.05 * em}, options.title,
                {.size = 1.35 * em, .color = colors.ink, .weight = TextStyle::Weight::kBold});
  }
  for (size_t i = 0; i < panels.size(); ++i) {
    const int column = static_cast<int>(i) % grid.columns, row = static_cast<int>(i) / grid.columns;
    const Vec2 corner = area_corner + Vec2(column * (cell.x() + gap), row * (cell.y() + gap));
    const Camera camera(options.view, shared.points, shared.radii, corner, view);
    draw_panel(canvas, panels[i], options, shared, camera, format == ImageFormat::kPng ? kPngBudget : kSvgBudget);
    if (!panels[i].caption.empty()) {
      canvas.text(corner + Vec2(view.x() / 2, view.y() + 1.5 * em), panels[i].caption,
                  {.size = em, .color = colors.ink, .horizontal = 0.5});
    }
  }
  if (shared.field != nullptr) {
    draw_legend(canvas, shared.legend, colors, Vec2(options.width - margin - legend_width + 1.5 * em, area_corner.y()),
                Vec2(legend_width - 1.5 * em, area.y()), em);
  }
  const Camera camera(options.view, shared.points, shared.radii, area_corner, view);
  const double base = options.height - margin;
  double x = margin;
  if (options.ruler == Visibility::kShown) {
    x += draw_ruler(canvas, camera, colors, {x, base}, std::min(0.25 * view.x(), 14 * em), em);
    if (options.view.projection == Projection::kPerspective) {
      canvas.text({x + 0.5 * em, base}, "at mid depth",
                  {.size = 0.9 * em, .color = colors.faint_ink, .vertical = 0.35});
      x += 7 * em;
    }
    x += 2 * em;
  }
  if (!note.empty()) canvas.text({x, base}, note, {.size = 0.9 * em, .color = colors.force, .vertical = 0.35});
  if (options.axes == Visibility::kShown) {
    draw_axes(canvas, camera, colors, {options.width - margin - 2.2 * em, base - 1.2 * em}, em);
  }
  return canvas.finish(options.title.empty() ? "Structure drawn by lissom" : options.title);
}

}  // namespace lissom
