#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <unordered_set>

#include "lissom/geometry/point_grid.h"
#include "lissom/model/plan_tracing.h"

namespace lissom {

namespace {

constexpr double kMostSize = 1000;  // m

/// Whole nanometres: what the conversion of units leaves behind is not worth keeping.
double rounded(double metres) { return std::round(metres * 1e9) / 1e9; }

/// Turns runs into rods of a plan.
class Tracer {
 public:
  Tracer(const PlanDrawing& drawing, const DrawingOptions& options, double size, Plan& plan)
      : drawing_(drawing),
        options_(options),
        plan_(plan),
        grid_(2 * options.tolerance, std::max(size / 200, 8 * options.tolerance), 1000) {}

  /// Stops come first, so that all runs agree on where they are.
  void place_stops(const std::vector<Run>& runs) {
    for (const Run& run : runs) {
      for (const double stop : run.stops) point(run, stop);
    }
  }

  void trace(const Run& run) {
    PlanRod rod;
    rod.role = line(run).role;
    rod.closed = run.closed;
    switch (run.kind()) {
      case PathPiece::Kind::kLine:
        rod.curve = PlanCurve::kStraight;
        for (const double place : with_nodes(run)) add(rod, point(run, place));
        break;
      case PathPiece::Kind::kArc:
        rod.curve = PlanCurve::kArc;
        trace_arcs(run, rod);
        break;
      case PathPiece::Kind::kCubic: {
        double strays = 0;
        for (const double place : spline_places(run, options_.straying, strays)) add(rod, point(run, place));
        worst_ = std::max(worst_, strays);
        break;
      }
    }
    if (rod.closed && rod.points.front() == rod.points.back()) rod.points.pop_back();
    cut_at_repeats(rod, line(run).name);
  }

  double worst() const { return worst_; }

 private:
  const DrawnLine& line(const Run& run) const { return drawing_.lines[static_cast<std::size_t>(run.line)]; }

  static void add(PlanRod& rod, int point) {
    if (rod.points.empty() || rod.points.back() != point) rod.points.push_back(point);
  }

  /// The point of the plan at a place of a run; it is as thick as the thickest line through it.
  int point(const Run& run, double place) {
    const Vec2 there = run.at(place), at(rounded(there.x()), rounded(there.y()));
    const int number = grid_.insert(Vec3(at.x(), at.y(), 0));
    if (number == static_cast<int>(plan_.points.size()))
      plan_.points.push_back({fmt::format("p{}", number), at, 0, 0, false});
    PlanPoint& known = plan_.points[static_cast<std::size_t>(number)];
    known.r_n = std::max(known.r_n, rounded(line(run).r_n.value_or(line(run).r_b.value_or(options_.r_n))));
    known.r_b = std::max(known.r_b, rounded(line(run).r_b.value_or(options_.r_b)));
    return number;
  }

  static std::vector<double> with_nodes(const Run& run) {
    std::vector<double> places = run.stops;
    for (std::size_t k = 0; k < run.path.size() + (run.closed ? 0 : 1); ++k) places.push_back(double(k));
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    return places;
  }

  /// Arcs have three points each: two spans of one circle make one, a single span gets a point in its middle.
  void trace_arcs(const Run& run, PlanRod& rod) {
    std::vector<double> places = with_nodes(run);
    if (run.closed) places.push_back(run.length() + places[0]);
    const auto same_circle = [&](double from, double middle, double to) {
      const Vec2 a = circle_centre(run.at(from), run.at((from + middle) / 2), run.at(middle));
      const Vec2 b = circle_centre(run.at(middle), run.at((middle + to) / 2), run.at(to));
      return a.allFinite() && b.allFinite() && (a - b).norm() <= options_.tolerance &&
             (run.at(to) - run.at(from)).norm() > 4 * options_.tolerance;
    };
    const std::size_t spans = places.size() - 1;
    if (run.closed && spans == 3 && same_circle(places[0], places[1], places[2])) {
      for (std::size_t k = 0; k < 3; ++k) add(rod, point(run, places[k]));
      return;
    }
    for (std::size_t k = 0; k < spans;) {
      add(rod, point(run, places[k]));
      const bool pair = k + 1 < spans && same_circle(places[k], places[k + 1], places[k + 2]);
      add(rod, point(run, pair ? places[k + 1] : (places[k] + places[k + 1]) / 2));
      k += pair ? 2 : 1;
    }
    if (!run.closed) add(rod, point(run, places.back()));
  }

  /// A rod runs through a point once: where a line returns to one, it is cut half-way in between.
  void cut_at_repeats(PlanRod rod, const std::string& name) {
    const std::size_t least = rod.curve == PlanCurve::kArc ? 3 : 2;
    std::vector<int> left = rod.points;
    if (rod.closed) {
      std::unordered_set<int> seen(left.begin(), left.end());
      if (seen.size() == left.size()) return finish(std::move(rod), name);
      left.push_back(left.front());
      rod.closed = false;
    }
    while (left.size() >= least) {
      std::size_t end = left.size() - 1;
      for (std::size_t j = 1; j < left.size() && end == left.size() - 1; ++j) {
        for (std::size_t i = 0; i < j; ++i) {
          if (left[i] != left[j]) continue;
          end = i + (j - i) / 2;
          if (rod.curve == PlanCurve::kArc) end -= end % 2;
          end = std::max(end, least - 1);
          break;
        }
      }
      PlanRod part = rod;
      part.points.assign(left.begin(), left.begin() + static_cast<std::ptrdiff_t>(end) + 1);
      finish(std::move(part), name);
      left.erase(left.begin(), left.begin() + static_cast<std::ptrdiff_t>(end));
    }
  }

  void finish(PlanRod rod, const std::string& name) {
    const std::string base = name.empty() ? fmt::format("rod {}", plan_.rods.size()) : name;
    rod.name = base;
    for (int k = 2; !names_.insert(rod.name).second; ++k) rod.name = fmt::format("{} {}", base, k);
    plan_.rods.push_back(std::move(rod));
  }

  const PlanDrawing& drawing_;
  const DrawingOptions& options_;
  Plan& plan_;
  PointGrid grid_;
  std::unordered_set<std::string> names_;
  double worst_ = 0;
};

}  // namespace

Result<Plan> plan_from_drawing(const PlanDrawing& drawing, const DrawingOptions& options, const std::string& where,
                               std::vector<std::string>& notes) {
  std::vector<Run> runs = runs_of(drawing, options.tolerance);
  if (runs.empty()) {
    return Error{ErrorCode::kGeometry, where, "the drawing has no lines for rods",
                 fmt::format("draw rods on a layer {} and the edge of the fabric, if it is not printed, on {}",
                             kRodLayer, kGhostLayer)};
  }
  const DrawingFrame frame = frame_of(drawing);
  const double size = (frame.high - frame.low).norm();
  if (!(size > 10 * options.tolerance && size < kMostSize)) {
    return Error{ErrorCode::kRange, where, fmt::format("the drawing measures {:.3g} mm across", 1000 * size),
                 "are its units the right ones?"};
  }
  find_meetings(runs, options.tolerance);
  Plan plan;
  plan.material = options.material;
  plan.fabric.material = options.fabric;
  plan.edge_length = std::max(1e-4, std::round(size / 80 * 1e4) / 1e4);
  Tracer tracer(drawing, options, size, plan);
  tracer.place_stops(runs);
  for (const Run& run : runs) tracer.trace(run);
  if (drawing.left_out > 0) {
    notes.push_back(
        fmt::format("{} lines on the layers {} and {} were left out", drawing.left_out, kFrameLayer, kMarkLayer));
  }
  if (tracer.worst() > options.straying) {
    notes.push_back(fmt::format("a spline strays {:.2g} mm from its line", 1000 * tracer.worst()));
  }
  return plan;
}

}  // namespace lissom
