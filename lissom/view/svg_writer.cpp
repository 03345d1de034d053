#include "lissom/view/svg_writer.h"

#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "lissom/view/page_colors.h"
#include "lissom/view/text.h"

namespace lissom {
namespace {

// Units per px: coordinates are whole numbers of tenths, which cannot be told apart and need no decimal point.
constexpr double kUnits = 10;

long units(double px) { return std::lround(px * kUnits); }

/// A number that follows another one; a minus separates by itself.
void append_next(std::string& text, long number) {
  if (number >= 0 && !text.empty() && text.back() >= '0' && text.back() <= '9') text += ' ';
  fmt::format_to(std::back_inserter(text), "{}", number);
}

std::string opacity_attribute(double opacity) {
  return opacity < 1 ? fmt::format(" opacity=\"{:.2f}\"", opacity) : std::string();
}

/// Twice the area, px^2.
double area(std::span<const Vec2> points) {
  double sum = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    const Vec2 &p = points[i], &q = points[(i + 1) % points.size()];
    sum += p.x() * q.y() - p.y() * q.x();
  }
  return sum;
}

}  // namespace

SvgWriter::SvgWriter(int width, int height) : width_(width), height_(height) {}

void SvgWriter::flush() {
  if (!path_.empty()) body_ += fmt::format("<path {} d=\"{}\"/>", paint_, path_);
  path_.clear();
  paint_.clear();
  pen_x_ = pen_y_ = 0;
}

void SvgWriter::paint(std::string attributes, bool mergeable) {
  if (attributes == paint_ && mergeable) return;
  flush();
  paint_ = std::move(attributes);
}

void SvgWriter::trace(std::span<const Vec2> points, bool closed, bool backwards) {
  const size_t count = points.size();
  long first_x = 0, first_y = 0;
  for (size_t i = 0; i < count; ++i) {
    const Vec2& p = points[backwards ? count - 1 - i : i];
    const long x = units(p.x()), y = units(p.y());
    if (i == 0) {
      path_ += 'm';
      first_x = x, first_y = y;
    } else if (x == pen_x_ && y == pen_y_ && i + 1 < count) {
      continue;
    }
    append_next(path_, x - pen_x_);
    append_next(path_, y - pen_y_);
    pen_x_ = x, pen_y_ = y;
  }
  if (!closed) return;
  path_ += 'z';
  pen_x_ = first_x, pen_y_ = first_y;
}

void SvgWriter::polygon(std::span<const Vec2> points, const Color& color, double opacity) {
  if (points.size() < 3) return;
  // Overlapping neighbours in one path must turn alike, or they would make holes.
  paint(fmt::format("fill=\"{}\"{}", page_paint(color), opacity_attribute(opacity)), opacity >= 1);
  trace(points, true, area(points) < 0);
}

void SvgWriter::polyline(std::span<const Vec2> points, const Stroke& stroke, bool closed) {
  if (points.size() < 2) return;
  std::string attributes = fmt::format("stroke=\"{}\" stroke-width=\"{}\"{}", page_paint(stroke.color),
                                       units(stroke.width), opacity_attribute(stroke.opacity));
  if (stroke.cap == Stroke::Cap::kButt) attributes += " stroke-linecap=\"butt\"";
  if (!stroke.dash.empty()) {
    attributes += " stroke-dasharray=\"";
    for (size_t i = 0; i < stroke.dash.size(); ++i) {
      attributes += fmt::format("{}{}", i == 0 ? "" : " ", units(stroke.dash[i]));
    }
    attributes += '"';
  }
  paint(std::move(attributes), stroke.opacity >= 1);
  trace(points, closed, false);
}

void SvgWriter::rectangle(const Vec2& corner, const Vec2& size, const Color& color) {
  flush();
  body_ += fmt::format("<rect fill=\"{}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>", page_paint(color),
                       units(corner.x()), units(corner.y()), units(size.x()), units(size.y()));
}

void SvgWriter::disc(const Vec2& centre, double radius, const Color& color) {
  flush();
  body_ += fmt::format("<circle fill=\"{}\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>", page_paint(color), units(centre.x()),
                       units(centre.y()), units(radius));
}

void SvgWriter::text(const Vec2& at, const std::string& words, const TextStyle& style, double down) {
  flush();
  const char* anchor = style.horizontal > 0.75   ? " text-anchor=\"end\""
                       : style.horizontal > 0.25 ? " text-anchor=\"middle\""
                                                 : "";
  const char* weight = style.weight == TextStyle::Weight::kBold ? " font-weight=\"600\"" : "";
  const Vec2 shift(down * std::sin(style.angle), down * std::cos(style.angle));
  const long x = units(at.x() + shift.x()), y = units(at.y() + shift.y());
  const std::string turn = style.angle == 0 ? std::string()
                                            : fmt::format(" transform=\"rotate({:.0f} {} {})\"",
                                                          -style.angle * 180 / std::numbers::pi, x, y);
  body_ += fmt::format("<text fill=\"{}\" font-size=\"{}\"{}{} x=\"{}\" y=\"{}\"{}>{}</text>", page_paint(style.color),
                       units(style.size), anchor, weight, x, y, turn, xml_escaped(words));
}

void SvgWriter::clip(const Vec2& corner, const Vec2& size) {
  flush();  // a picture in the picture clips without an id
  const long x = units(corner.x()), y = units(corner.y()), width = units(size.x()), height = units(size.y());
  body_ += fmt::format("<svg x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" viewBox=\"{} {} {} {}\">", x, y, width,
                       height, x, y, width, height);
}

void SvgWriter::unclip() {
  flush();
  body_ += "</svg>";
}

std::string SvgWriter::finish(const std::string& title) {
  flush();
  return fmt::format(
      "<svg role=\"img\" aria-label=\"{}\" viewBox=\"0 0 {} {}\" fill=\"none\" stroke-linecap=\"round\" "
      "stroke-linejoin=\"round\">{}</svg>",
      xml_escaped(title), units(width_), units(height_), body_);
}

}  // namespace lissom
