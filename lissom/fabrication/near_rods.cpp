#include "lissom/fabrication/near_rods.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "lissom/design/clearance.h"
#include "lissom/fabrication/near_points.h"

namespace lissom {

namespace {

constexpr double kStep = 0.5;  // between places looked at, of the thinner half-extent

struct Place {
  int piece = 0, order = 0;  // order: among the places of its piece
  const RodStation* station = nullptr;
};

/// Half of the width of a section in a direction, m.
double width(const RodStation& s, SectionShape shape, const Vec3& direction) {
  const double b = s.r_b * s.b.dot(direction), n = s.r_n * s.n.dot(direction);
  return shape == SectionShape::kRectangle ? std::abs(b) + std::abs(n) : std::hypot(b, n);
}

/// Points of two centrelines, m, where they are nearest within a step of two places, straight as far as that.
std::array<Vec3, 2> nearest_points(const RodStation& a, const RodStation& b) {
  const Vec3 difference = b.centre - a.centre;
  const double most_a = kStep * std::min(a.r_b, a.r_n), most_b = kStep * std::min(b.r_b, b.r_n);
  double along_a = 0, along_b = 0;
  for (int i = 0; i < 4; ++i) {
    along_a = std::clamp(a.t.dot(difference + along_b * b.t), -most_a, most_a);
    along_b = std::clamp(b.t.dot(along_a * a.t - difference), -most_b, most_b);
  }
  return {a.centre + along_a * a.t, b.centre + along_b * b.t};
}

/// What is near of another piece, at a place of a piece.
struct Near {
  bool joined = false;    // some of it belongs to a joint
  double gap = INFINITY;  // of the rest
  Vec3 place = Vec3::Zero();
};

class Search {
 public:
  Search(const std::vector<RodPiece>& pieces, double gap) : pieces_(pieces), gap_(gap) {
    for (std::size_t p = 0; p < pieces.size(); ++p) add_places(static_cast<int>(p));
    for (const RodPiece& piece : pieces) {
      for (std::size_t i = 0; i + 1 < piece.nodes.size(); ++i) {
        for (std::size_t j = i + 1; j < piece.nodes.size(); ++j) connect(piece, piece.nodes[i], piece.nodes[j]);
      }
    }
    for (std::size_t p = 0; p < pieces.size(); ++p) connect_along_rod(p);
  }

  std::vector<NearRods> pairs() {
    look();
    std::map<std::array<int, 2>, NearRods> found;
    for (const auto& [pair, places] : near_) {
      const Near worst = worst_of(pair, places);
      if (!(worst.gap < gap_)) continue;
      const int a = pieces_[pair[0]].rod, b = pieces_[pair[1]].rod;
      const std::array<int, 2> rods{std::min(a, b), std::max(a, b)};
      const auto [entry, is_new] = found.emplace(rods, NearRods{rods[0], rods[1], worst.gap, worst.place});
      if (!is_new && worst.gap < entry->second.gap) entry->second = {rods[0], rods[1], worst.gap, worst.place};
    }
    std::vector<NearRods> pairs;
    for (const auto& [rods, near] : found) pairs.push_back(near);
    return pairs;
  }

 private:
  void add_places(int number) {
    const RodPiece& piece = pieces_[number];
    double next = 0;
    int order = 0;
    std::size_t node = 0;
    for (std::size_t i = 0; i < piece.stations.size(); ++i) {
      const RodStation& s = piece.stations[i];
      reach_ = std::max(reach_, s.reach(piece.shape));
      const bool at_node = node < piece.nodes.size() && piece.nodes[node][1] == static_cast<int>(i);
      if (at_node) order_of_node_[{number, piece.nodes[node++][0]}] = order;
      if (!at_node && s.along < next) continue;
      next = s.along + kStep * std::min(s.r_b, s.r_n);
      places_.push_back({number, order++, &s});
    }
  }

  /// Ends of pieces are joined by the way along them.
  void connect(const RodPiece& piece, const std::array<int, 2>& from, const std::array<int, 2>& to) {
    connect(from[0], to[0], piece.stations[to[1]].along - piece.stations[from[1]].along);
  }
  void connect(int from, int to, double way) {
    if (way > 8 * reach_ || from == to) return;
    for (const auto& key : {std::pair(from, to), std::pair(to, from)}) {
      const auto [entry, is_new] = way_.emplace(key, way);
      if (!is_new) entry->second = std::min(entry->second, way);
    }
  }

  /// A rod that is cut into pieces at its kinks is one way all the same.
  void connect_along_rod(std::size_t first) {
    const RodPiece& begin = pieces_[first];
    double way = begin.length();
    for (std::size_t p = first + 1; p < pieces_.size() && pieces_[p].rod == begin.rod; ++p) {
      if (pieces_[p].nodes.front()[0] != pieces_[p - 1].nodes.back()[0]) return;
      way += pieces_[p].length();
      connect(begin.nodes.front()[0], pieces_[p].nodes.back()[0], way);
    }
  }

  void look() {
    std::vector<Vec3> centres;
    for (const Place& p : places_) centres.push_back(p.station->centre);
    for_near_points(centres, 2 * reach_ + gap_, [&](int i, int j) { compare(places_[i], places_[j]); });
  }

  void compare(const Place& a, const Place& b) {
    const std::array<Vec3, 2> nearest = nearest_points(*a.station, *b.station);
    const Vec3 between = nearest[1] - nearest[0];
    const double distance = between.norm();
    const RodPiece &first = pieces_[a.piece], &second = pieces_[b.piece];
    const Vec3 direction = distance > 0 ? Vec3(between / distance) : Vec3::UnitX();
    const double across = width(*a.station, first.shape, direction) + width(*b.station, second.shape, direction);
    const double gap = distance - across;
    if (gap >= gap_) return;
    const bool joined =
        way_between(a, b) <= kJointDetour * (a.station->reach(first.shape) + b.station->reach(second.shape) + gap_);
    if (joined && a.piece == b.piece) return;
    Near& near = near_[{a.piece, b.piece}][a.order];
    near.joined = near.joined || joined;
    if (joined || gap >= near.gap) return;
    near.gap = gap;
    near.place = (nearest[0] + nearest[1]) / 2;
  }

  /// m, along the rods, over at most one rod between; infinite when there is no such way.
  double way_between(const Place& a, const Place& b) const {
    const RodPiece &first = pieces_[a.piece], &second = pieces_[b.piece];
    if (a.piece == b.piece) {
      const double way = std::abs(a.station->along - b.station->along);
      return first.closed ? std::min(way, first.length() - way) : way;
    }
    double least = INFINITY;
    const double limit = 4 * kJointDetour * (reach_ + gap_);
    for (const std::array<int, 2>& i : first.nodes) {
      const double to = std::abs(first.stations[i[1]].along - a.station->along);
      if (to > limit) continue;
      for (const std::array<int, 2>& j : second.nodes) {
        const double from = std::abs(second.stations[j[1]].along - b.station->along);
        if (to + from >= least) continue;
        if (i[0] == j[0]) {
          least = to + from;
        } else if (const auto way = way_.find({i[0], j[0]}); way != way_.end()) {
          least = std::min(least, to + from + way->second);
        }
      }
    }
    return least;
  }

  /// The smallest gap among places that are not joined to a node of both pieces by places that are near too.
  Near worst_of(const std::array<int, 2>& pair, const std::map<int, Near>& places) const {
    std::set<int> shared;
    if (pair[0] != pair[1]) {
      for (const std::array<int, 2>& node : pieces_[pair[0]].nodes) {
        const auto own = order_of_node_.find({pair[0], node[0]});
        if (order_of_node_.count({pair[1], node[0]}) > 0) shared.insert(own->second);
      }
    }
    Near worst;
    for (auto begin = places.begin(); begin != places.end();) {
      auto end = begin;
      int last = begin->first;
      bool joined = false;
      for (; end != places.end() && end->first <= last + 1; ++end) {
        last = end->first;
        joined = joined || shared.count(end->first) > 0;
      }
      for (auto it = begin; it != end && !joined; ++it) {
        if (it->second.gap < worst.gap) worst = it->second;
      }
      begin = end;
    }
    return worst;
  }

  const std::vector<RodPiece>& pieces_;
  double gap_, reach_ = 0;  // m
  std::vector<Place> places_;
  std::map<std::pair<int, int>, int> order_of_node_;        // of (piece, node)
  std::map<std::pair<int, int>, double> way_;               // m, between nodes of one rod
  std::map<std::array<int, 2>, std::map<int, Near>> near_;  // by pieces, then places of the first
};

}  // namespace

std::vector<NearRods> near_rods(const std::vector<RodPiece>& pieces, double gap) {
  if (pieces.empty()) return {};
  return Search(pieces, gap).pairs();
}

}  // namespace lissom
