#include "lissom/view/canvas.h"

#include <algorithm>
#include <cairo-svg.h>
#include <cairo.h>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "lissom/view/svg_compact.h"
#include "lissom/view/svg_writer.h"
#include "lissom/view/text.h"

namespace lissom {
namespace {

cairo_status_t append(void* closure, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(closure)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

struct Canvas::Surface {
  ImageFormat format;
  std::string bytes;
  cairo_surface_t* surface = nullptr;
  cairo_t* cr = nullptr;
  std::unique_ptr<SvgWriter> writer;  // inline SVG, for which cairo only measures text
};

Canvas::Canvas(ImageFormat format, int width, int height)
    : surface_(std::make_unique<Surface>()), width_(width), height_(height) {
  Surface& s = *surface_;
  s.format = format;
  if (format == ImageFormat::kPng) {
    s.surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
  } else if (format == ImageFormat::kInlineSvg) {
    s.writer = std::make_unique<SvgWriter>(width, height);
    s.surface = cairo_recording_surface_create(CAIRO_CONTENT_COLOR, nullptr);
  } else {
    s.surface = cairo_svg_surface_create_for_stream(append, &s.bytes, width, height);
    cairo_svg_surface_set_document_unit(s.surface, CAIRO_SVG_UNIT_PX);
  }
  s.cr = cairo_create(s.surface);
  cairo_set_line_join(s.cr, CAIRO_LINE_JOIN_ROUND);
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(s.cr, options);
  cairo_font_options_destroy(options);
}

Canvas::~Canvas() {
  cairo_destroy(surface_->cr);
  cairo_surface_destroy(surface_->surface);
}

namespace {

void set_color(cairo_t* cr, const Color& c, double opacity = 1) { cairo_set_source_rgba(cr, c.r, c.g, c.b, opacity); }

/// Eighths of a pixel cannot be told apart, and keep SVG numbers short.
void trace(cairo_t* cr, std::span<const Vec2> points) {
  cairo_new_path(cr);
  for (const Vec2& p : points) cairo_line_to(cr, std::round(p.x() * 8) / 8, std::round(p.y() * 8) / 8);
}

void set_stroke(cairo_t* cr, const Stroke& stroke) {
  set_color(cr, stroke.color, stroke.opacity);
  cairo_set_line_width(cr, stroke.width);
  cairo_set_line_cap(cr, stroke.cap == Stroke::Cap::kRound ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_BUTT);
  cairo_set_dash(cr, stroke.dash.data(), static_cast<int>(stroke.dash.size()), 0);
}

void set_font(cairo_t* cr, const TextStyle& style) {
  cairo_select_font_face(cr, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         style.weight == TextStyle::Weight::kBold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cr, style.size);
}

}  // namespace

void Canvas::fill(const Color& color) {
  if (surface_->writer) return;  // the ground is the page's
  rectangle(Vec2::Zero(), Vec2(width_, height_), color);
}

void Canvas::rectangle(const Vec2& corner, const Vec2& size, const Color& color) {
  if (SvgWriter* svg = surface_->writer.get()) return svg->rectangle(corner, size, color);
  cairo_t* cr = surface_->cr;
  set_color(cr, color);
  cairo_rectangle(cr, corner.x(), corner.y(), size.x(), size.y());
  cairo_fill(cr);
}

void Canvas::disc(const Vec2& centre, double radius, const Color& color) {
  if (SvgWriter* svg = surface_->writer.get()) return svg->disc(centre, radius, color);
  cairo_t* cr = surface_->cr;
  cairo_new_path(cr);
  set_color(cr, color);
  cairo_arc(cr, centre.x(), centre.y(), radius, 0, 2 * std::numbers::pi);
  cairo_fill(cr);
}

void Canvas::polygon(std::span<const Vec2> points, const Color& color, double opacity) {
  if (SvgWriter* svg = surface_->writer.get()) return svg->polygon(points, color, opacity);
  cairo_t* cr = surface_->cr;
  trace(cr, points);
  cairo_close_path(cr);
  set_color(cr, color, opacity);
  cairo_fill(cr);
}

void Canvas::outline(std::span<const Vec2> points, const Stroke& stroke) {
  if (SvgWriter* svg = surface_->writer.get()) return svg->polyline(points, stroke, true);
  trace(surface_->cr, points);
  cairo_close_path(surface_->cr);
  set_stroke(surface_->cr, stroke);
  cairo_stroke(surface_->cr);
}

void Canvas::polyline(std::span<const Vec2> points, const Stroke& stroke) {
  if (SvgWriter* svg = surface_->writer.get()) return svg->polyline(points, stroke, false);
  trace(surface_->cr, points);
  set_stroke(surface_->cr, stroke);
  cairo_stroke(surface_->cr);
}

void Canvas::gradient(const Vec2& corner, const Vec2& size, std::span<const Color> colors) {
  if (SvgWriter* svg = surface_->writer.get()) {  // a definition would need an id: thin rows of one colour each
    const double row = size.y() / static_cast<double>(colors.size());
    for (size_t i = 0; i < colors.size(); ++i) {
      svg->rectangle(corner + Vec2(0, size.y() - row * static_cast<double>(i + 1)), {size.x(), row}, colors[i]);
    }
    return;
  }
  cairo_t* cr = surface_->cr;
  cairo_pattern_t* pattern = cairo_pattern_create_linear(0, corner.y() + size.y(), 0, corner.y());
  for (size_t i = 0; i < colors.size(); ++i) {
    const double at = colors.size() > 1 ? static_cast<double>(i) / static_cast<double>(colors.size() - 1) : 0;
    cairo_pattern_add_color_stop_rgb(pattern, at, colors[i].r, colors[i].g, colors[i].b);
  }
  cairo_set_source(cr, pattern);
  cairo_rectangle(cr, corner.x(), corner.y(), size.x(), size.y());
  cairo_fill(cr);
  cairo_pattern_destroy(pattern);
}

void Canvas::text(const Vec2& at, const std::string& text, const TextStyle& style) {
  if (text.empty()) return;
  const double capital_height = 0.73 * style.size;
  if (SvgWriter* svg = surface_->writer.get()) return svg->text(at, text, style, style.vertical * capital_height);
  cairo_t* cr = surface_->cr;
  const double across = -style.horizontal * text_width(text, style);
  cairo_save(cr);
  set_font(cr, style);
  set_color(cr, style.color);
  cairo_translate(cr, at.x(), at.y());
  cairo_rotate(cr, -style.angle);
  cairo_move_to(cr, across, style.vertical * capital_height);
  cairo_show_text(cr, printable(text).c_str());
  cairo_restore(cr);
  cairo_new_path(cr);
}

double Canvas::text_width(const std::string& text, const TextStyle& style) {
  cairo_t* cr = surface_->cr;
  set_font(cr, style);
  cairo_text_extents_t extents;
  cairo_text_extents(cr, printable(text).c_str(), &extents);
  return extents.x_advance;
}

void Canvas::clip(const Vec2& corner, const Vec2& size) {
  if (SvgWriter* svg = surface_->writer.get()) return svg->clip(corner, size);
  cairo_save(surface_->cr);
  cairo_rectangle(surface_->cr, corner.x(), corner.y(), size.x(), size.y());
  cairo_clip(surface_->cr);
}

void Canvas::unclip() {
  if (SvgWriter* svg = surface_->writer.get()) return svg->unclip();
  cairo_restore(surface_->cr);
}

Result<std::string> Canvas::finish(const std::string& title) {
  Surface& s = *surface_;
  if (s.writer) return s.writer->finish(title);
  cairo_status_t status = cairo_status(s.cr);
  if (status == CAIRO_STATUS_SUCCESS && s.format == ImageFormat::kPng) {
    status = cairo_surface_write_to_png_stream(s.surface, append, &s.bytes);
  }
  cairo_surface_finish(s.surface);
  if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_status(s.surface);
  if (status != CAIRO_STATUS_SUCCESS) {
    return Error{ErrorCode::kFile, "picture", fmt::format("drawing failed: {}", cairo_status_to_string(status)),
                 "try a smaller picture"};
  }
  if (s.format == ImageFormat::kSvg) {
    s.bytes = compact_svg(s.bytes);
    const size_t head = s.bytes.find("<svg");
    const size_t end = head == std::string::npos ? head : s.bytes.find('>', head);
    if (end != std::string::npos && !title.empty()) {
      s.bytes.insert(end + 1, "\n<title>" + xml_escaped(title) + "</title>");
    }
  }
  return std::move(s.bytes);
}

Status check_size(int width, int height) {
  if (width >= 16 && height >= 16 && width <= 16384 && height <= 16384) return {};
  return Error{ErrorCode::kRange, "picture size", fmt::format("{} x {} pixels cannot be drawn", width, height),
               "both sides must be between 16 and 16384"};
}

}  // namespace lissom
