#include <algorithm>
#include <cmath>

#include "lissom/view/picture_parts.h"
#include "lissom/view/ticks.h"

namespace lissom {
namespace {

/// Words put on lines no wider than `width` where possible.
std::vector<std::string> wrapped(Canvas& canvas, const std::string& text, const TextStyle& style, double width) {
  std::vector<std::string> lines;
  size_t start = 0;
  while (start < text.size()) {
    size_t end = text.find(' ', start);
    if (end == std::string::npos) end = text.size();
    const std::string word = text.substr(start, end - start);
    if (!lines.empty() && canvas.text_width(lines.back() + " " + word, style) <= width) {
      lines.back() += " " + word;
    } else {
      lines.push_back(word);
    }
    start = end + 1;
  }
  return lines;
}

}  // namespace

void draw_legend(Canvas& canvas, const Legend& legend, const ThemeColors& colors, const Vec2& corner, const Vec2& size,
                 double em) {
  const TextStyle bold{.size = em, .color = colors.ink, .weight = TextStyle::Weight::kBold};
  const TextStyle plain{.size = 0.9 * em, .color = colors.ink};
  const TextStyle faint{.size = 0.85 * em, .color = colors.faint_ink};
  const Ticks ticks = linear_ticks(legend.range.low, legend.range.high, 6);

  std::vector<std::string> title = wrapped(canvas, legend.title, bold, size.x());
  std::string unit = legend.unit;
  if (ticks.exponent != 0) unit = power_of_ten(ticks.exponent) + (unit.empty() ? "" : " " + unit);
  const double line = 1.3 * em;
  const double head = static_cast<double>(title.size() + (unit.empty() ? 0 : 1)) * line + 0.6 * em;
  const double foot = (legend.has_missing ? 3 : 2) * line + 1.1 * em;
  const double bar = std::clamp(size.y() - head - foot, 4 * em, 18 * em);
  double y = corner.y() + std::max(0.0, (size.y() - head - bar - foot) / 2);

  for (const std::string& text : title) canvas.text({corner.x(), y += line}, text, bold);
  if (!unit.empty()) canvas.text({corner.x(), y += line}, unit, faint);
  y += 0.9 * em;

  const double bar_width = 1.25 * em;
  if (legend.has_values) {
    std::vector<Color> ramp;
    const int steps = legend.steps;
    const bool flat = !(legend.range.high > legend.range.low);
    for (int k = 0; k <= 32; ++k) ramp.push_back(map_color(legend.colors, flat ? 0.5 : k / 32.0));
    if (steps == 0 || flat) canvas.gradient({corner.x(), y}, {bar_width, bar}, ramp);
    for (int k = 0; k < steps && !flat; ++k) {
      canvas.rectangle({corner.x(), y + bar * (1 - (k + 1.0) / steps)}, {bar_width, bar / steps},
                       map_color(legend.colors, (k + 0.5) / steps));
    }
    const double extent = legend.range.high - legend.range.low;
    for (size_t i = 0; i < ticks.at.size(); ++i) {
      const double at = y + bar * (flat ? 0.5 : 1 - (ticks.at[i] - legend.range.low) / extent);
      canvas.polyline(std::array{Vec2(corner.x() + bar_width, at), Vec2(corner.x() + bar_width + 0.35 * em, at)},
                      {.color = colors.faint_ink, .width = 0.08 * em, .cap = Stroke::Cap::kButt});
      TextStyle label = plain;
      label.vertical = 0.5;
      canvas.text({corner.x() + bar_width + 0.6 * em, at}, ticks.labels[i], label);
    }
    y += bar + 0.6 * em;
    canvas.text({corner.x(), y += line}, "max " + number_text(legend.found.high), faint);
    canvas.text({corner.x(), y += line}, "min " + number_text(legend.found.low), faint);
  }
  if (legend.has_missing) {
    y += line;
    canvas.rectangle({corner.x(), y - 0.7 * em}, {0.8 * em, 0.8 * em}, kNoValueColor);
    canvas.text({corner.x() + 1.1 * em, y}, "no value", faint);
  }
}

double draw_marks_legend(Canvas& canvas, const ClothMarks& marks, const ThemeColors& colors, const Vec2& at,
                         double em) {
  const TextStyle text{.size = 0.85 * em, .color = colors.faint_ink, .vertical = 0.5};
  const double side = 1.25 * em, line = 1.9 * em;
  double height = 0;
  const auto explain = [&](std::string_view words) {
    canvas.text(at + Vec2(side + 0.6 * em, -height - side / 2), std::string(words), text);
    height += line;
  };
  if (marks.stroke > 0) {
    canvas.polyline(std::array{Vec2(at.x(), at.y() - side / 2), Vec2(at.x() + side, at.y() - side / 2)},
                    {.color = marks.ink, .width = marks.stroke / 12});
    explain("largest tension");
  }
  if (marks.hatch > 0) {
    const Vec2 corner = at - Vec2(0, height);
    const auto inside = [&](double x, double y) { return Vec2(corner + Vec2(x, -y) * side); };
    canvas.outline(std::array{inside(0, 0), inside(1, 0), inside(1, 1), inside(0, 1)},
                   {.color = marks.ink, .width = 0.07 * em});
    for (const double shift : {-0.5, 0.0, 0.5}) {
      canvas.polyline(std::array{inside(std::max(0.0, shift), std::max(0.0, -shift)),
                                 inside(std::min(1.0, 1 + shift), std::min(1.0, 1 - shift))},
                      {.color = marks.ink, .width = marks.hatch / 7});
    }
    explain("slack cloth");
  }
  return height;
}

double draw_ruler(Canvas& canvas, const Camera& camera, const ThemeColors& colors, const Vec2& at, double longest,
                  double em) {
  const double length = round_below(longest / camera.scale());
  const double px = length * camera.scale();
  const double tick = 0.35 * em;
  const Stroke stroke{.color = colors.ink, .width = 0.1 * em, .cap = Stroke::Cap::kButt};
  canvas.polyline(
      std::array{Vec2(at.x(), at.y() - tick), at, Vec2(at.x() + px, at.y()), Vec2(at.x() + px, at.y() - tick)}, stroke);
  const TextStyle label{.size = 0.9 * em, .color = colors.ink, .vertical = 0.35};
  canvas.text({at.x() + px + 0.6 * em, at.y()}, length_text(length), label);
  return px + 0.6 * em + canvas.text_width(length_text(length), label);
}

void draw_axes(Canvas& canvas, const Camera& camera, const ThemeColors& colors, const Vec2& centre, double em) {
  const char* names[] = {"x", "y", "z"};
  for (int i = 0; i < 3; ++i) {
    const Vec2 d(camera.right()[i], -camera.up()[i]);
    if (d.norm() < 0.1) continue;
    const Vec2 tip = centre + d * (1.9 * em);
    canvas.polyline(std::array{centre, tip}, {.color = colors.faint_ink, .width = 0.1 * em});
    canvas.text(tip + d.normalized() * (0.55 * em), names[i],
                {.size = 0.85 * em, .color = colors.faint_ink, .horizontal = 0.5, .vertical = 0.4});
  }
}

}  // namespace lissom
