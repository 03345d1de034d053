#include "scenes/plan_sketch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "lissom/geometry/segment_pairs.h"

namespace lissom::scene_models {

namespace {

constexpr double kLeastAngle = 0.5;  // rad, between two rods that meet
constexpr double kMeeting = 2.6;     // clearances from a common point within which rods may be near to each other
constexpr double kSpacing = 1.5;     // clearances between neighbouring points of a rod
constexpr double kLeastChord = 0.4;  // of the way along a rod, where it bends back
constexpr double kShortest = 0.12;   // clearances: edges get shorter than that in tight bends only
constexpr std::size_t kMostCrossings = 12;  // of one new rod

double cross(const Vec2& u, const Vec2& v) { return u.x() * v.y() - u.y() * v.x(); }

}  // namespace

int PlanSketch::add_point(const Vec2& at) {
  PlanPoint point;
  point.at = at;
  plan_.points.push_back(point);
  return static_cast<int>(plan_.points.size()) - 1;
}

void PlanSketch::add_outline(PlanRod rod) {
  plan_.rods.push_back(std::move(rod));
  ++outline_rods_;
}

bool PlanSketch::close_outline() { return points_fit() && sample() && fits(); }

bool PlanSketch::sample() {
  Plan fine = plan_;
  fine.edge_length = clearance_ / 2;
  Result<PlanSamples> samples = sample_plan(fine, 1);
  if (!samples) return false;
  samples_ = std::move(samples).value();
  segments_.clear();
  lengths_.clear();
  for (std::size_t r = 0; r < plan_.rods.size(); ++r) {
    const std::vector<int>& nodes = samples_.rods[r];
    std::size_t i = 0;
    double along = 0;
    for (std::size_t piece = 0; piece < samples_.pieces[r].size(); ++piece) {
      for (int step = 0; step < samples_.pieces[r][piece]; ++step, ++i) {
        const int from = nodes[i], to = nodes[(i + 1) % nodes.size()];
        const double length =
            (samples_.nodes[static_cast<std::size_t>(to)] - samples_.nodes[static_cast<std::size_t>(from)]).norm();
        if (length < kShortest * clearance_) return false;
        segments_.push_back({from, to, static_cast<int>(r), static_cast<int>(piece), along + length / 2});
        along += length;
      }
    }
    lengths_.push_back(along);
  }
  return true;
}

std::optional<PlanSketch::Crossing> PlanSketch::first_crossing(std::size_t rod) const {
  const auto at = [&](int node) -> const Vec2& { return samples_.nodes[static_cast<std::size_t>(node)]; };
  for (const Segment& own : segments_) {
    if (own.rod != static_cast<int>(rod)) continue;
    for (const Segment& other : segments_) {
      if (other.rod == own.rod) continue;
      if (own.from == other.from || own.from == other.to || own.to == other.from || own.to == other.to) continue;
      const Vec2 u = at(own.to) - at(own.from), v = at(other.to) - at(other.from), w = at(other.from) - at(own.from);
      const double d = cross(u, v), s = cross(w, v) / d, t = cross(w, u) / d;
      if (!(s >= 0 && s <= 1 && t >= 0 && t <= 1)) continue;
      return Crossing{static_cast<std::size_t>(other.rod), static_cast<std::size_t>(own.piece),
                      static_cast<std::size_t>(other.piece), at(own.from) + s * u};
    }
  }
  return std::nullopt;
}

bool PlanSketch::add_rod(PlanRod rod, std::size_t first_new) {
  Plan before = plan_;
  before.points.resize(first_new);
  const std::size_t own = plan_.rods.size();
  plan_.rods.push_back(std::move(rod));
  const auto give_up = [&] {
    plan_ = std::move(before);
    sample();
    return false;
  };
  for (std::size_t round = 0;; ++round) {
    if (!points_fit() || !sample()) return give_up();
    const std::optional<Crossing> crossing = first_crossing(own);
    if (!crossing) break;
    const bool bound = is_outline(crossing->other) || plan_.rods[crossing->other].curve == PlanCurve::kArc ||
                       plan_.rods[own].curve == PlanCurve::kArc;
    if (bound || round == kMostCrossings) return give_up();
    const int point = add_point(crossing->at);
    for (const auto& [r, piece] :
         {std::pair{own, crossing->own_piece}, std::pair{crossing->other, crossing->other_piece}}) {
      std::vector<int>& points = plan_.rods[r].points;
      points.insert(points.begin() + static_cast<std::ptrdiff_t>(piece) + 1, point);
    }
  }
  return fits() ? true : give_up();
}

bool PlanSketch::fits() const {
  if (!corners_fit()) return false;
  std::vector<std::array<int, 2>> ends;
  for (const Segment& segment : segments_) ends.push_back({segment.from, segment.to});
  for (const auto& [i, j] : near_segments(samples_.nodes, ends, clearance_)) {
    if (!pair_fits(segments_[static_cast<std::size_t>(i)], segments_[static_cast<std::size_t>(j)])) return false;
  }
  for (const Segment& segment : segments_) {
    const bool apart = is_outline(static_cast<std::size_t>(segment.rod));
    if (!apart && !inside((samples_.nodes[static_cast<std::size_t>(segment.from)] +
                           samples_.nodes[static_cast<std::size_t>(segment.to)]) /
                          2)) {
      return false;
    }
  }
  return true;
}

bool PlanSketch::points_fit() const {
  for (const PlanRod& rod : plan_.rods) {
    for (std::size_t i = 0; i + (rod.closed ? 0 : 1) < rod.points.size(); ++i) {
      const int a = rod.points[i], b = rod.points[(i + 1) % rod.points.size()];
      const Vec2 chord = plan_.points[static_cast<std::size_t>(b)].at - plan_.points[static_cast<std::size_t>(a)].at;
      if (chord.norm() < kSpacing * clearance_) return false;
    }
    std::vector<int> once = rod.points;
    std::sort(once.begin(), once.end());
    if (std::adjacent_find(once.begin(), once.end()) != once.end()) return false;
  }
  return true;
}

bool PlanSketch::corners_fit() const {
  std::vector<std::vector<Vec2>> arms(plan_.points.size());
  for (const Segment& segment : segments_) {
    const Vec2 &from = samples_.nodes[static_cast<std::size_t>(segment.from)],
               &to = samples_.nodes[static_cast<std::size_t>(segment.to)];
    if (static_cast<std::size_t>(segment.from) < arms.size()) {
      arms[static_cast<std::size_t>(segment.from)].push_back((to - from).normalized());
    }
    if (static_cast<std::size_t>(segment.to) < arms.size()) {
      arms[static_cast<std::size_t>(segment.to)].push_back((from - to).normalized());
    }
  }
  for (const std::vector<Vec2>& at_point : arms) {
    for (std::size_t i = 0; i < at_point.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (at_point[i].dot(at_point[j]) > std::cos(kLeastAngle)) return false;
      }
    }
  }
  return true;
}

bool PlanSketch::pair_fits(const Segment& a, const Segment& b) const {
  const double near = kMeeting * clearance_;
  const auto middle = [&](const Segment& s) -> Vec2 {
    return (samples_.nodes[static_cast<std::size_t>(s.from)] + samples_.nodes[static_cast<std::size_t>(s.to)]) / 2;
  };
  if (a.rod == b.rod) {
    const double between = std::abs(a.along - b.along), length = lengths_[static_cast<std::size_t>(a.rod)];
    const bool closed = plan_.rods[static_cast<std::size_t>(a.rod)].closed;
    const double along = std::min(between, closed ? length - between : between);
    if (along < near) return (middle(a) - middle(b)).norm() > kLeastChord * along;
  }
  const std::vector<int>& others = plan_.rods[static_cast<std::size_t>(b.rod)].points;
  for (const int point : plan_.rods[static_cast<std::size_t>(a.rod)].points) {
    if (std::find(others.begin(), others.end(), point) == others.end()) continue;
    const Vec2& at = plan_.points[static_cast<std::size_t>(point)].at;
    if ((at - middle(a)).norm() < near && (at - middle(b)).norm() < near) return true;
  }
  return false;
}

bool PlanSketch::inside(const Vec2& p) const {
  bool in = false;
  for (const Segment& segment : segments_) {
    if (!is_outline(static_cast<std::size_t>(segment.rod))) continue;
    const Vec2 &a = samples_.nodes[static_cast<std::size_t>(segment.from)],
               &b = samples_.nodes[static_cast<std::size_t>(segment.to)];
    if ((a.y() > p.y()) == (b.y() > p.y())) continue;
    if (p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y())) in = !in;
  }
  return in;
}

double PlanSketch::distance_to_rods(const Vec2& p) const {
  double least = INFINITY;
  for (const Segment& segment : segments_) {
    least = std::min(least, segment_distance(p, p, samples_.nodes[static_cast<std::size_t>(segment.from)],
                                             samples_.nodes[static_cast<std::size_t>(segment.to)]));
  }
  return least;
}

}  // namespace lissom::scene_models
