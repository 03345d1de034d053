#pragma once
/// A page to draw on, in pixels with y down: SVG or PNG from the same calls, without a display. The only file that knows
/// the drawing library (cairo); see docs/decisions/0003-pictures.md.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/core/types.h"
#include "lissom/view/color_map.h"

namespace lissom {

enum class ImageFormat {
  kPng,
  kSvg,
  kInlineSvg,  ///< an <svg> element for an HTML page that sets the colours of page_colors.h; for the light theme
};

struct Stroke {
  enum class Cap { kButt, kRound };
  Color color;
  double width = 1;  ///< px
  Cap cap = Cap::kRound;
  std::vector<double> dash = {};  ///< px on, px off, ...; empty: solid
  double opacity = 1;
};

struct TextStyle {
  enum class Weight { kRegular, kBold };
  double size = 14;  ///< px
  Color color;
  Weight weight = Weight::kRegular;
  double horizontal = 0;  ///< 0: `at` is the left end, 0.5 the middle, 1 the right end
  double vertical = 0;    ///< 0: `at` is on the base line, 0.5 at half the height of capitals, 1 at their top
  double angle = 0;       ///< rad, counter-clockwise
};

class Canvas {
 public:
  Canvas(ImageFormat format, int width, int height);  ///< px
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  int width() const { return width_; }
  int height() const { return height_; }

  void fill(const Color& color);  ///< the whole page
  void rectangle(const Vec2& corner, const Vec2& size, const Color& color);
  void disc(const Vec2& centre, double radius, const Color& color);

  void polygon(std::span<const Vec2> points, const Color& color, double opacity = 1);
  void outline(std::span<const Vec2> points, const Stroke& stroke);  ///< closed
  void polyline(std::span<const Vec2> points, const Stroke& stroke);

  /// Column of colours from bottom to top, blended.
  void gradient(const Vec2& corner, const Vec2& size, std::span<const Color> colors);

  void text(const Vec2& at, const std::string& text, const TextStyle& style);
  double text_width(const std::string& text, const TextStyle& style);  ///< px

  void clip(const Vec2& corner, const Vec2& size);  ///< until `unclip`
  void unclip();

  /// The bytes of the file, or the element. `title` names the picture for screen readers in SVG. Nothing can be drawn afterwards.
  Result<std::string> finish(const std::string& title);

 private:
  struct Surface;
  std::unique_ptr<Surface> surface_;
  int width_, height_;
};

/// Size within what can be drawn (16 to 16384 px a side).
Status check_size(int width, int height);

}  // namespace lissom
