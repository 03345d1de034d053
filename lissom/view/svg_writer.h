#pragma once
/// SVG for the inside of an HTML page, as Canvas draws it: text stays text, colours follow the page (page_colors.h), the
/// ground is the page's, there are no ids that could meet those of another picture, and neighbours of equal paint share one
/// path. cairo's SVG has none of this.

#include <span>
#include <string>

#include "lissom/view/canvas.h"

namespace lissom {

class SvgWriter {
 public:
  SvgWriter(int width, int height);  ///< px

  void polygon(std::span<const Vec2> points, const Color& color, double opacity);
  void polyline(std::span<const Vec2> points, const Stroke& stroke, bool closed);
  void rectangle(const Vec2& corner, const Vec2& size, const Color& color);
  void disc(const Vec2& centre, double radius, const Color& color);
  /// On a base line `down` px below `at`, across the direction of the text; starts, is centred or ends there.
  void text(const Vec2& at, const std::string& words, const TextStyle& style, double down);
  void clip(const Vec2& corner, const Vec2& size);
  void unclip();

  /// The element. `title` is what screen readers say in its stead.
  std::string finish(const std::string& title);

 private:
  void trace(std::span<const Vec2> points, bool closed, bool backwards);
  void paint(std::string attributes, bool mergeable);
  void flush();

  int width_, height_;
  std::string body_;
  std::string paint_, path_;  // of the run of equal paint so far
  long pen_x_ = 0, pen_y_ = 0;
};

}  // namespace lissom
