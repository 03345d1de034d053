#include "lissom/model/svg_path_data.h"

#include <cctype>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <utility>

namespace lissom {

namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// Walks over a text of letters and numbers.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  bool done() {
    skip();
    return at_ >= text_.size();
  }
  bool letter() {
    skip();
    return at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_])) != 0;
  }
  char take() { return text_[at_++]; }
  std::size_t place() const { return at_; }

  bool number(double& value) {
    skip();
    std::size_t from = at_;
    if (from < text_.size() && text_[from] == '+') ++from;
    const auto [end, code] = std::from_chars(text_.data() + from, text_.data() + text_.size(), value);
    if (code != std::errc() || !std::isfinite(value)) return false;
    at_ = static_cast<std::size_t>(end - text_.data());
    return true;
  }

  /// Flags of arcs may stand without space before what follows.
  bool flag(bool& value) {
    skip();
    if (at_ >= text_.size() || (text_[at_] != '0' && text_[at_] != '1')) return false;
    value = text_[at_++] == '1';
    return true;
  }

  std::string_view word() {
    skip();
    const std::size_t from = at_;
    while (at_ < text_.size() && std::isalpha(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
    return text_.substr(from, at_ - from);
  }

  bool sign(char c) {
    skip();
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }

 private:
  void skip() {
    while (at_ < text_.size() && (std::isspace(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == ','))
      ++at_;
  }
  std::string_view text_;
  std::size_t at_ = 0;
};

/// Elliptical arc from end points to centre [SVG 1.1, F.6.5].
PlanarPath arc_to(const Vec2& from, double rx, double ry, double turn, bool large, bool sweep, const Vec2& to) {
  rx = std::abs(rx);
  ry = std::abs(ry);
  if ((to - from).norm() == 0) return {};
  if (rx == 0 || ry == 0) return {PathPiece::line(from, to)};
  const Eigen::Rotation2Dd axes(turn);
  const Vec2 half = axes.inverse() * ((from - to) / 2);
  const double spread = std::pow(half.x() / rx, 2) + std::pow(half.y() / ry, 2);
  if (spread > 1) {
    rx *= std::sqrt(spread);
    ry *= std::sqrt(spread);
  }
  const double a = rx * rx * half.y() * half.y() + ry * ry * half.x() * half.x();
  const double root = std::sqrt(std::max(0.0, (rx * rx * ry * ry - a) / a)) * (large == sweep ? -1 : 1);
  const Vec2 shifted(root * rx * half.y() / ry, -root * ry * half.x() / rx);
  const Vec2 centre = axes * shifted + (from + to) / 2;
  const auto angle = [&](const Vec2& p) { return std::atan2((p.y() - shifted.y()) / ry, (p.x() - shifted.x()) / rx); };
  const double start = angle(half);
  double by = angle(-half) - start;
  if (sweep && by < 0) by += 2 * std::numbers::pi;
  if (!sweep && by > 0) by -= 2 * std::numbers::pi;
  PlanarPath path = ellipse_path(centre, rx, ry, turn, start, by);
  path.front().from = from;
  path.back().to = to;
  return path;
}

class PathReader {
 public:
  explicit PathReader(std::string_view text) : scan_(text) {}

  Result<std::vector<SubPath>> read() {
    char command = 0;
    while (!scan_.done()) {
      if (scan_.letter()) {
        command = scan_.take();
      } else if (command == 0 || command == 'Z' || command == 'z') {
        return bad("a command letter is missing");
      }
      if (parts_.empty() && command != 'M' && command != 'm') return bad("the path does not begin with M");
      if (!step(command)) return bad(fmt::format("the numbers after {} are not complete", command));
      if (command == 'M') command = 'L';
      if (command == 'm') command = 'l';
    }
    std::erase_if(parts_, [](const SubPath& part) { return part.path.empty(); });
    return std::move(parts_);
  }

 private:
  Error bad(const std::string& what) const {
    return {ErrorCode::kSyntax,
            {},
            fmt::format("{} at character {} of the path", what, scan_.place() + 1),
            "save the drawing again with the program that made it"};
  }

  bool point(bool relative, Vec2& p) {
    Vec2 read;
    if (!scan_.number(read.x()) || !scan_.number(read.y())) return false;
    p = relative ? Vec2(now_ + read) : read;
    return true;
  }

  void add(const PathPiece& piece) {
    if (fresh_) {
      parts_.push_back({});
      start_ = piece.from;
      fresh_ = false;
    }
    parts_.back().path.push_back(piece);
    now_ = piece.to;
  }

  /// One command with one set of numbers.
  bool step(char command) {
    const bool relative = std::islower(static_cast<unsigned char>(command)) != 0;
    const char kind = static_cast<char>(std::toupper(static_cast<unsigned char>(command)));
    const char before = std::exchange(last_, kind);
    Vec2 to, a, b;
    double value = 0;
    switch (kind) {
      case 'M':
        if (!point(relative, to)) return false;
        now_ = start_ = to;
        parts_.push_back({});
        fresh_ = false;
        return true;
      case 'Z':
        if ((start_ - now_).norm() > 0) add(PathPiece::line(now_, start_));
        if (!parts_.empty()) parts_.back().closed = true;
        now_ = start_;
        fresh_ = true;
        return true;
      case 'L':
        if (!point(relative, to)) return false;
        add(PathPiece::line(now_, to));
        return true;
      case 'H':
      case 'V':
        if (!scan_.number(value)) return false;
        to = now_;
        to[kind == 'H' ? 0 : 1] = relative ? now_[kind == 'H' ? 0 : 1] + value : value;
        add(PathPiece::line(now_, to));
        return true;
      case 'C':
      case 'S':
        a = kind == 'S' ? (before == 'C' || before == 'S' ? Vec2(2 * now_ - handle_) : now_) : now_;
        if ((kind == 'C' && !point(relative, a)) || !point(relative, b) || !point(relative, to)) return false;
        handle_ = b;
        add(PathPiece::cubic(now_, a, b, to));
        return true;
      case 'Q':
      case 'T':
        a = before == 'Q' || before == 'T' ? Vec2(2 * now_ - handle_) : now_;
        if ((kind == 'Q' && !point(relative, a)) || !point(relative, to)) return false;
        handle_ = a;
        add(PathPiece::cubic(now_, now_ + 2.0 / 3 * (a - now_), to + 2.0 / 3 * (a - to), to));
        return true;
      case 'A':
        return arc(relative);
      default:
        return false;
    }
  }

  bool arc(bool relative) {
    double rx = 0, ry = 0, turn = 0;
    bool large = false, sweep = false;
    Vec2 to;
    if (!scan_.number(rx) || !scan_.number(ry) || !scan_.number(turn) || !scan_.flag(large) || !scan_.flag(sweep) ||
        !point(relative, to)) {
      return false;
    }
    for (const PathPiece& piece : arc_to(now_, rx, ry, turn * kDegree, large, sweep, to)) add(piece);
    now_ = to;
    return true;
  }

  Scanner scan_;
  std::vector<SubPath> parts_;
  Vec2 now_ = Vec2::Zero(), start_ = Vec2::Zero(), handle_ = Vec2::Zero();
  char last_ = 0;
  bool fresh_ = true;  ///< the next piece begins a part
};

}  // namespace

Result<std::vector<SubPath>> read_path_data(std::string_view text) { return PathReader(text).read(); }

std::vector<double> read_numbers(std::string_view text) {
  Scanner scan(text);
  std::vector<double> numbers;
  double value = 0;
  while (!scan.done() && scan.number(value)) numbers.push_back(value);
  return numbers;
}

Result<PlanarTransform> read_transform(std::string_view text) {
  Scanner scan(text);
  PlanarTransform whole = PlanarTransform::Identity();
  while (!scan.done()) {
    const std::string name(scan.word());
    std::vector<double> v;
    double value = 0;
    bool good = !name.empty() && scan.sign('(');
    while (good && !scan.sign(')')) {
      good = scan.number(value);
      v.push_back(value);
    }
    PlanarTransform one = PlanarTransform::Identity();
    const std::size_t n = v.size();
    if (name == "matrix" && n == 6) {
      one.matrix() << v[0], v[2], v[4], v[1], v[3], v[5], 0, 0, 1;
    } else if (name == "translate" && (n == 1 || n == 2)) {
      one.translate(Vec2(v[0], n == 2 ? v[1] : 0));
    } else if (name == "scale" && (n == 1 || n == 2)) {
      one.scale(Vec2(v[0], n == 2 ? v[1] : v[0]));
    } else if (name == "rotate" && (n == 1 || n == 3)) {
      const Vec2 centre = n == 3 ? Vec2(v[1], v[2]) : Vec2::Zero();
      one.translate(centre).rotate(v[0] * kDegree).translate(-centre);
    } else if (name == "skewX" && n == 1) {
      one.linear()(0, 1) = std::tan(v[0] * kDegree);
    } else if (name == "skewY" && n == 1) {
      one.linear()(1, 0) = std::tan(v[0] * kDegree);
    } else {
      good = false;
    }
    if (!good) {
      return Error{ErrorCode::kSyntax,
                   {},
                   fmt::format("the transform \"{}\" cannot be read", text),
                   "save the drawing again with the program that made it"};
    }
    whole = whole * one;
  }
  return whole;
}

std::optional<double> read_length(std::string_view text) {
  Scanner scan(text);
  double value = 0;
  if (!scan.number(value)) return {};
  const std::string_view unit = scan.word();
  constexpr std::pair<std::string_view, double> kUnits[] = {
      {"", 1},    {"px", 1},         {"mm", 96 / 25.4}, {"cm", 960 / 25.4},
      {"in", 96}, {"pt", 96.0 / 72}, {"pc", 16},        {"Q", 24 / 25.4}};
  for (const auto& [name, pixels] : kUnits) {
    if (name == unit && scan.done()) return value * pixels;
  }
  return {};
}

PlanarPath transformed(const PlanarTransform& transform, const PlanarPath& path) {
  const Eigen::Matrix2d m = transform.linear();
  const double along = m.col(0).norm(), across = m.col(1).norm();
  const bool circles =
      std::abs(along - across) < 1e-9 * along && std::abs(m.col(0).dot(m.col(1))) < 1e-9 * along * across;
  PlanarPath moved;
  for (const PathPiece& piece : path) {
    if (piece.kind != PathPiece::Kind::kArc || circles) {
      moved.push_back(
          {piece.kind, transform * piece.from, transform * piece.to, transform * piece.a, transform * piece.b});
      continue;
    }
    const Vec2 centre = circle_centre(piece.from, piece.a, piece.to);
    const double radius = (piece.from - centre).norm();
    const auto angle = [&](const Vec2& p) { return std::atan2(p.y() - centre.y(), p.x() - centre.x()); };
    const double start = angle(piece.from), half = std::remainder(angle(piece.a) - start, 2 * std::numbers::pi);
    const double other = std::remainder(angle(piece.to) - angle(piece.a), 2 * std::numbers::pi);
    const double sweep = half + other;
    const int n = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / (std::numbers::pi / 4) - 1e-9)));
    const double step = sweep / n, handle = 4.0 / 3 * std::tan(step / 4);
    for (int k = 0; k < n; ++k) {
      const auto place = [&](double a) -> Vec2 { return centre + radius * Vec2(std::cos(a), std::sin(a)); };
      const auto slope = [&](double a) -> Vec2 { return radius * Vec2(-std::sin(a), std::cos(a)); };
      const double from = start + k * step, to = from + step;
      moved.push_back(PathPiece::cubic(transform * place(from), transform * Vec2(place(from) + handle * slope(from)),
                                       transform * Vec2(place(to) - handle * slope(to)), transform * place(to)));
    }
  }
  return moved;
}

}  // namespace lissom
