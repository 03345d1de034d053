#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "lissom/model/plan_svg.h"

namespace lissom {

namespace {

constexpr double kMargin = 0.01;  // m, from the frame to the ruler
constexpr double kRuler = 0.1;    // m

/// A length on paper, mm.
std::string mm(double metres) { return fmt::format("{:.12g}", 1000 * metres); }

/// A place on paper: y points down there.
std::string place(const Vec2& p) { return mm(p.x()) + " " + mm(p.y() == 0 ? 0 : -p.y()); }

std::string escaped(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    if (c == '&') {
      safe += "&amp;";
    } else if (c == '<') {
      safe += "&lt;";
    } else if (c == '>') {
      safe += "&gt;";
    } else if (c == '"') {
      safe += "&quot;";
    } else {
      safe += c;
    }
  }
  return safe;
}

std::string path_data(const DrawnLine& line) {
  std::string d = "M " + place(line.path.front().from);
  for (const PathPiece& piece : line.path) {
    switch (piece.kind) {
      case PathPiece::Kind::kLine:
        d += " L " + place(piece.to);
        break;
      case PathPiece::Kind::kCubic:
        d += " C " + place(piece.a) + ", " + place(piece.b) + ", " + place(piece.to);
        break;
      case PathPiece::Kind::kArc: {
        const double radius = (piece.from - circle_centre(piece.from, piece.a, piece.to)).norm();
        const double turn = sweep_of(piece);
        d += fmt::format(" A {0} {0} 0 {1} {2} {3}", mm(radius), std::abs(turn) > std::numbers::pi ? 1 : 0,
                         turn < 0 ? 1 : 0, place(piece.to));
        break;
      }
    }
  }
  return line.closed ? d + " Z" : d;
}

std::string group(const PlanDrawing& drawing, PlanRole role) {
  const bool ghost = role == PlanRole::kGhost;
  std::string text = fmt::format(
      "  <g id=\"{0}\" inkscape:label=\"{0}\" inkscape:groupmode=\"layer\" fill=\"none\" stroke=\"{1}\"{2}>\n",
      ghost ? kGhostLayer : kRodLayer, ghost ? "#888888" : "#000000", ghost ? " stroke-dasharray=\"2 1\"" : "");
  for (std::size_t i = 0; i < drawing.lines.size(); ++i) {
    const DrawnLine& line = drawing.lines[i];
    if (line.role != role || line.path.empty()) continue;
    text += fmt::format("    <path id=\"line{}\" inkscape:label=\"{}\"", i, escaped(line.name));
    if (line.r_b) text += fmt::format(" stroke-width=\"{}\"", mm(2 * *line.r_b));
    if (line.r_n) text += fmt::format(" data-r-n=\"{}\"", mm(*line.r_n));
    text += fmt::format(" d=\"{}\"/>\n", path_data(line));
  }
  return text + "  </g>\n";
}

}  // namespace

std::string write_svg_drawing(const PlanDrawing& drawing, const std::string& title) {
  const DrawingFrame frame = frame_of(drawing);
  const Vec2 ruler(frame.frame_low.x(), frame.frame_low.y() - kMargin);
  const double left = frame.frame_low.x() - kMargin / 2, top = -(frame.frame_high.y() + kMargin / 2);
  const double width = std::max(frame.frame_high.x() - frame.frame_low.x(), kRuler) + kMargin;
  const double height = frame.frame_high.y() - frame.frame_low.y() + 2.5 * kMargin;
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:inkscape=\"http://www.inkscape.org/namespaces/inkscape\" "
      "version=\"1.1\"\n     width=\"{0}mm\" height=\"{1}mm\" viewBox=\"{2} {3} {0} {1}\">\n  <title>{4}</title>\n",
      mm(width), mm(height), mm(left), mm(top), escaped(title));
  const auto layer = [](std::string_view name) {
    return fmt::format(
        "  <g id=\"{0}\" inkscape:label=\"{0}\" inkscape:groupmode=\"layer\" fill=\"none\" stroke=\"#3366aa\" "
        "stroke-width=\"0.2\">\n",
        name);
  };
  const Vec2 size = frame.frame_high - frame.frame_low;
  text += layer(kFrameLayer);
  text += fmt::format("    <rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n  </g>\n", mm(frame.frame_low.x()),
                      mm(-frame.frame_high.y()), mm(size.x()), mm(size.y()));
  text += group(drawing, PlanRole::kGhost) + group(drawing, PlanRole::kRod);
  text += layer(kMarkLayer);
  std::string ticks;
  for (int k = 0; k <= 10; ++k) {
    const Vec2 foot = ruler + Vec2(k * kRuler / 10, 0);
    ticks += fmt::format("M {} v {} ", place(foot), k % 5 == 0 ? "-4" : "-2");
  }
  text += fmt::format("    <path d=\"M {} h 100 {}\"/>\n", place(ruler), ticks.substr(0, ticks.size() - 1));
  text += fmt::format(
      "    <text x=\"{}\" y=\"{}\" font-size=\"4\" fill=\"#3366aa\" stroke=\"none\">100 mm</text>\n  </g>\n</svg>\n",
      mm(ruler.x()), mm(-ruler.y() + 0.005));
  return text;
}

}  // namespace lissom
