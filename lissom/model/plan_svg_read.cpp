#include <array>
#include <cctype>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <pugixml.hpp>

#include "lissom/model/plan_svg.h"
#include "lissom/model/svg_path_data.h"

namespace lissom {

namespace {

constexpr int kDeepest = 200;  // groups in groups
constexpr double kPixel = 25.4e-3 / 96;

/// What elements take from the groups around them.
struct Style {
  PlanarTransform transform;
  std::string layer;
  std::optional<double> width;  ///< of strokes, in the units of the element
};

bool is_layer(std::string_view name) {
  std::string upper;
  for (const char c : name) upper += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return upper == kRodLayer || upper == kGhostLayer || upper == kFrameLayer || upper == kMarkLayer;
}

/// An attribute, or the same from the style attribute, which wins.
std::string property(const pugi::xml_node& node, std::string_view name) {
  const std::string_view style = node.attribute("style").value();
  std::size_t from = 0;
  while (from < style.size()) {
    const std::size_t end = std::min(style.find(';', from), style.size()), colon = style.find(':', from);
    if (colon < end) {
      const auto trimmed = [](std::string_view text) {
        while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
        while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
        return text;
      };
      if (trimmed(style.substr(from, colon - from)) == name) {
        return std::string(trimmed(style.substr(colon + 1, end - colon - 1)));
      }
    }
    from = end + 1;
  }
  return node.attribute(std::string(name).c_str()).value();
}

class SvgReader {
 public:
  explicit SvgReader(std::string where) : where_(std::move(where)) {}

  Result<PlanDrawing> read(std::string_view text) {
    pugi::xml_document document;
    const pugi::xml_parse_result parsed = document.load_buffer(text.data(), text.size());
    if (!parsed) {
      const auto offset = static_cast<std::size_t>(std::max<std::ptrdiff_t>(parsed.offset, 0));
      const auto line =
          1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(std::min(offset, text.size())), '\n');
      return Error{ErrorCode::kSyntax, fmt::format("{}:{}", where_, line), "this is not an SVG drawing",
                   "save it as plain SVG"};
    }
    const pugi::xml_node root = document.child("svg");
    if (!root) return Error{ErrorCode::kSyntax, where_, "this is not an SVG drawing", "save it as plain SVG"};
    const double scale = metres_per_unit(root);
    if (!(scale > 0)) {
      return Error{ErrorCode::kRange, where_, "the width or the view box of the drawing is not positive",
                   "give the drawing a width in mm and a view box"};
    }
    Style style{PlanarTransform::Identity(), {}, {}};
    style.transform.scale(Vec2(scale, -scale));
    if (Status s = children(root, style, 0); !s) return s.error();
    return std::move(drawing_);
  }

 private:
  static double metres_per_unit(const pugi::xml_node& root) {
    const std::vector<double> box = read_numbers(root.attribute("viewBox").value());
    const std::optional<double> width = read_length(root.attribute("width").value());
    if (box.size() == 4 && width) return *width * kPixel / box[2];
    return kPixel;
  }

  Status children(const pugi::xml_node& parent, const Style& style, int depth) {
    if (depth > kDeepest) {
      return Error{ErrorCode::kUnsupported, where_, "the groups of the drawing are nested too deeply", "ungroup some"};
    }
    for (const pugi::xml_node& node : parent.children()) {
      if (node.type() != pugi::node_element) continue;
      if (Status s = element(node, style, depth); !s) return s;
    }
    return {};
  }

  Status element(const pugi::xml_node& node, const Style& around, int depth) {
    const std::string_view name = node.name();
    if (property(node, "display") == "none") return {};
    Style style = around;
    const Result<PlanarTransform> transform = read_transform(node.attribute("transform").value());
    if (!transform) return located(transform.error(), node);
    style.transform = around.transform * transform.value();
    if (const std::optional<double> width = read_length(property(node, "stroke-width"))) style.width = width;
    if (name == "g" || name == "a" || name == "svg") {
      for (const char* key : {"inkscape:label", "id"}) {
        const std::string_view label = node.attribute(key).value();
        if (is_layer(label)) style.layer = label;
      }
      return children(node, style, depth + 1);
    }
    Result<std::vector<SubPath>> shape = shape_of(node, name);
    if (!shape) return located(shape.error(), node);
    for (const SubPath& part : shape.value()) add(node, style, part);
    return {};
  }

  Error located(Error error, const pugi::xml_node& node) const {
    const std::string_view id = node.attribute("id").value();
    error.where = id.empty() ? where_ : fmt::format("{}: element \"{}\"", where_, id);
    return error;
  }

  /// Lines of an element in its own coordinates; none for what is no shape.
  static Result<std::vector<SubPath>> shape_of(const pugi::xml_node& node, std::string_view name) {
    const auto number = [&](const char* key) { return read_length(node.attribute(key).value()).value_or(0); };
    if (name == "path") return read_path_data(node.attribute("d").value());
    SubPath part;
    if (name == "line") {
      part.path.push_back(PathPiece::line({number("x1"), number("y1")}, {number("x2"), number("y2")}));
    } else if (name == "polyline" || name == "polygon") {
      const std::vector<double> v = read_numbers(node.attribute("points").value());
      for (std::size_t i = 3; i < v.size(); i += 2) {
        part.path.push_back(PathPiece::line({v[i - 3], v[i - 2]}, {v[i - 1], v[i]}));
      }
      part.closed = name == "polygon";
    } else if (name == "circle" || name == "ellipse") {
      const double rx = number(name == "circle" ? "r" : "rx"), ry = number(name == "circle" ? "r" : "ry");
      if (rx > 0 && ry > 0) {
        part.path = ellipse_path({number("cx"), number("cy")}, rx, ry, 0, 0, 2 * std::numbers::pi);
        part.path.back().to = part.path.front().from;
      }
      part.closed = true;
    } else if (name == "rect") {
      const Vec2 low(number("x"), number("y")), high = low + Vec2(number("width"), number("height"));
      const std::array<Vec2, 4> corner{low, Vec2(high.x(), low.y()), high, Vec2(low.x(), high.y())};
      for (std::size_t k = 0; k < 4; ++k) part.path.push_back(PathPiece::line(corner[k], corner[(k + 1) % 4]));
      part.closed = true;
    }
    if (part.path.empty()) return std::vector<SubPath>{};
    return std::vector<SubPath>{std::move(part)};
  }

  void add(const pugi::xml_node& node, const Style& style, const SubPath& part) {
    const std::optional<PlanRole> role = role_of_layer(style.layer);
    if (!role) {
      ++drawing_.left_out;
      return;
    }
    DrawnLine line;
    line.role = *role;
    const std::string_view label = node.attribute("inkscape:label").value();
    line.name = label.empty() ? node.attribute("id").value() : std::string(label);
    line.path = transformed(style.transform, part.path);
    line.closed = part.closed;
    const double scale = std::sqrt(std::abs(style.transform.linear().determinant()));
    if (style.width && *style.width > 0) line.r_b = scale * *style.width / 2;
    const std::vector<double> thickness = read_numbers(node.attribute("data-r-n").value());
    if (thickness.size() == 1 && thickness[0] > 0) line.r_n = thickness[0] / 1000;
    drawing_.lines.push_back(std::move(line));
  }

  std::string where_;
  PlanDrawing drawing_;
};

}  // namespace

Result<PlanDrawing> read_svg_drawing(std::string_view text, const std::string& where) {
  return SvgReader(where).read(text);
}

}  // namespace lissom
