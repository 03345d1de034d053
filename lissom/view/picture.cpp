#include "lissom/view/picture.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "lissom/view/picture_parts.h"
#include "lissom/view/ticks.h"

namespace lissom {
namespace {

constexpr int kPngBudget = 60000, kSvgBudget = 9000;  // pieces per panel
constexpr double kSeenThrough = 0.2;                  // of rods behind cloth
constexpr double kLineEm = 0.13;                      // width of kLines
constexpr double kTrackEm = 0.5;  // least width of kTrack: lines in its middle show it on both sides

double em_of(const PictureOptions& options) {
  const double fitting = std::sqrt(static_cast<double>(options.width) * options.height) / 85;
  return options.text_size > 0 ? options.text_size : fitting;
}

const Field* field_of(const Drawing& drawing, const std::string& name) {
  return name.empty() ? nullptr : drawing.field(name);
}

void draw_panel(Canvas& canvas, const Panel& panel, const PictureOptions& options, const Shared& shared,
                const Camera& camera, int budget) {
  const ThemeColors colors = theme_colors(options.theme);
  const double em = em_of(options);
  const Stroke dashed{.color = mix(colors.ghost, colors.ink, 0.25),
                      .width = 0.1 * em,
                      .cap = Stroke::Cap::kButt,
                      .dash = {0.5 * em, 0.35 * em}};
  Stroke guide_stroke = dashed;  // has to stand out before cloth and its hem
  guide_stroke.color = mix(colors.fabric, colors.ink, 0.75);
  guide_stroke.width = 0.16 * em;
  if (options.shadow == Visibility::kShown && options.view.elevation > 0.05) {
    Scene shadow(camera, shared.ground, colors.shadow);
    for (const Layer& layer : panel.layers) {
      if (layer.style != Layer::Style::kSolid) continue;
      add_membranes(shadow, camera, layer.drawing, {.plain = colors.shadow}, {}, 0);
      add_rods(shadow, camera, layer.drawing, {.plain = colors.shadow}, budget / 4);
    }
    shadow.paint(canvas);
  }
  Scene track(camera), behind(camera), front(camera), through(camera);
  for (const Layer& layer : panel.layers) {
    switch (layer.style) {
      case Layer::Style::kDashed:
        draw_centrelines(canvas, camera, layer.drawing, dashed);
        break;
      case Layer::Style::kGhost:
        add_rods(behind, camera, layer.drawing, {.plain = colors.ghost, .contrast = 0.3}, budget / 3);
        break;
      case Layer::Style::kTrack:
        add_rods(track, camera, layer.drawing, {.plain = layer.ink, .line = 0, .thinnest = kTrackEm * em}, budget / 3);
        break;
      case Layer::Style::kLines:
        break;
      case Layer::Style::kSolid: {
        Paint rods{.field = field_of(layer.drawing, options.field),
                   .range = shared.colors.range,
                   .plain = colors.rod,
                   .steps = options.steps};
        if (options.sections == Sections::kFlat) rods.line = 0;
        const bool own = !options.membrane_field.empty();
        const Paint cloth{.field = field_of(layer.drawing, own ? options.membrane_field : options.field),
                          .range = own ? shared.membrane_colors.range : shared.colors.range,
                          .plain = colors.fabric};
        const bool any = !layer.drawing.membranes.empty();
        const Bed bed = add_membranes(front, camera, layer.drawing, cloth, shared.marks, budget / 2);
        add_rods(front, camera, layer.drawing, rods, any ? budget / 2 : budget, bed);
        if (any) add_rods(through, camera, layer.drawing, rods, budget / 4);
        break;
      }
    }
    for (const Marker& marker : layer.drawing.markers) {
      if (shown(marker, options)) add_marker(front, marker, shared.markers, colors);
    }
  }
  track.paint(canvas);
  behind.paint(canvas);
  front.paint(canvas);
  through.paint(canvas, kSeenThrough);
  for (const Layer& layer : panel.layers) {
    if (layer.style != Layer::Style::kLines) continue;
    Scene lines(camera);  // of its own: where shapes coincide the later one is seen whole instead of both in patches
    add_rods(lines, camera, layer.drawing, {.plain = layer.ink, .line = kLineEm * em * layer.weight}, budget / 3);
    lines.paint(canvas);
  }
  for (const Layer& layer : panel.layers) {
    for (const std::vector<Vec3>& guide : layer.guides) {
      std::vector<Vec2> page;
      for (const Vec3& p : guide) page.push_back(camera.project(p));
      canvas.polyline(page, guide_stroke);
    }
    for (const Vec3& p : layer.dots) canvas.disc(camera.project(p), 0.3 * em, layer.ink);
  }
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
  if (Status status = check_picture(panels, options); !status) return status.error();
  const ThemeColors colors = theme_colors(options.theme);
  Canvas canvas(format, options.width, options.height);
  canvas.fill(colors.page);
  const double em = std::clamp(em_of(options), 7.0, 60.0);
  const Shared shared = gather(panels, options, em);
  const bool keys = shared.colors.field != nullptr || shared.membrane_colors.field != nullptr;
  const double margin = 1.6 * em;

  const bool captions = std::any_of(panels.begin(), panels.end(), [](const Panel& p) { return !p.caption.empty(); });
  const double title_height = options.title.empty() ? 0 : 2.6 * em;
  const double caption_height = captions ? 2.2 * em : 0;
  const std::string note = options.forces == Visibility::kShown ? force_note(shared.markers) : "";
  const bool footer = options.ruler == Visibility::kShown || options.axes == Visibility::kShown || !note.empty();
  const double footer_height = footer ? 2.6 * em : 0;
  const bool marks = shared.marks.hatch > 0 || shared.marks.stroke > 0;
  const double legend_width = keys || marks ? 9 * em : 0;

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
  if (legend_width > 0) {
    const Vec2 corner(options.width - margin - legend_width + 1.5 * em, area_corner.y());
    const double foot = options.axes == Visibility::kShown ? 1.4 * em : 0;  // the axes stand up into the area
    const double marks_height =
        draw_marks_legend(canvas, shared.marks, colors, corner + Vec2(0, area.y() - foot), em) + foot;
    std::vector<const Legend*> legends;
    for (const ColorKey* key : {&shared.colors, &shared.membrane_colors}) {
      if (key->field != nullptr) legends.push_back(&key->legend);
    }
    const double height =
        (area.y() - (marks ? marks_height : 0)) / static_cast<double>(std::max<size_t>(1, legends.size()));
    for (size_t i = 0; i < legends.size(); ++i) {
      draw_legend(canvas, *legends[i], colors, corner + Vec2(0, height * static_cast<double>(i)),
                  Vec2(legend_width - 1.5 * em, height), em);
    }
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
