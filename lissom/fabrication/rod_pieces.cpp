#include "lissom/fabrication/rod_pieces.h"

#include <algorithm>
#include <cmath>

namespace lissom {

namespace {

constexpr double kKinkCosine = 0.82;    // 35 degrees, as in pictures
constexpr double kShare = 2.0 / 3;      // of the chord whose height is the tolerance
constexpr double kThinnestShare = 0.6;  // of the thinner half-extent: four cells across the thinnest section
constexpr double kMostTaper = 1.5;      // between the middle of the last edge and its end
constexpr int kMostStations = 4000;     // per edge

/// The chain of edges of a piece: `nodes` one more than edges, also when closed.
struct Chain {
  const Structure& structure;
  const StructureRod& rod;
  std::vector<int> nodes, edges;
  bool closed = false;
  std::array<bool, 2> joined{false, false};  ///< whether others meet it at its start, its end

  int count() const { return static_cast<int>(edges.size()); }
  const StructureEdge& edge(int e) const { return structure.edges[edges[e]]; }
  Vec3 side(int e) const { return point(e + 1) - point(e); }
  const Vec3& point(int i) const { return structure.nodes[nodes[i]]; }
};

/// Values at the ends and the middle of every edge.
struct Knot {
  Vec3 n = Vec3::Zero();
  double r_b = 0, r_n = 0;
};

Knot mean(const Knot& a, const Knot& b, double weight_b) {
  const double w = 1 - weight_b;
  return {w * a.n + weight_b * b.n, w * a.r_b + weight_b * b.r_b, w * a.r_n + weight_b * b.r_n};
}

class Spine {
 public:
  explicit Spine(const Chain& chain) : chain_(chain) {
    const int edges = chain.count();
    double sign = 1;
    for (int e = 0; e < edges; ++e) {
      const StructureEdge& edge = chain.edge(e);
      if (e > 0 && edge.drawn.n.dot(chain.edge(e - 1).drawn.n) < 0) sign = -sign;
      middle_.push_back({sign * edge.drawn.n, edge.section.r_b, edge.section.r_n});
      length_.push_back(chain.side(e).norm());
    }
    const bool reversed = chain.closed && middle_.back().n.dot(middle_.front().n) < 0;
    for (int i = 0; i <= edges; ++i) {
      const bool inner = i > 0 && i < edges;
      if (inner || chain.closed) {
        const int before = inner ? i - 1 : edges - 1, after = inner ? i : 0;
        Knot first = middle_[before], second = middle_[after];
        if (!inner && reversed) (i == 0 ? first : second).n *= -1;
        const double l0 = length_[before], l1 = length_[after];
        at_node_.push_back(mean(first, second, l0 / (l0 + l1)));
        slope_.push_back((chain.side(before) * (l1 / l0) + chain.side(after) * (l0 / l1)) / (l0 + l1));
      } else {
        at_node_.push_back(free_knot(i));
        slope_.emplace_back(Vec3::Zero());
      }
    }
    if (!chain.closed) set_end_slopes();
  }

  /// u from 0 to 1 along edge e; `along` is left to the caller.
  RodStation station(int e, double u) const {
    const auto at = static_cast<std::size_t>(e);
    const Vec3 &p0 = chain_.point(e), p1 = chain_.point(e + 1);
    const Vec3 m0 = slope_[at] * length_[at], m1 = slope_[at + 1] * length_[at];
    const double v = 1 - u;
    RodStation s;
    s.centre = p0 * (v * v * (1 + 2 * u)) + p1 * (u * u * (1 + 2 * v)) + m0 * (u * v * v) - m1 * (u * u * v);
    s.t = ((p1 - p0) * (6 * u * v) + m0 * (v * (1 - 3 * u)) + m1 * (u * (1 - 3 * v))).normalized();
    const Knot knot = u < 0.5 ? mean(at_node_[at], middle_[at], 2 * u) : mean(middle_[at], at_node_[at + 1], 2 * u - 1);
    const Frame frame = frame_from_normal(s.t, knot.n);
    s.b = frame.b;
    s.n = frame.n;
    s.r_b = knot.r_b;
    s.r_n = knot.r_n;
    return s;
  }
  double length(int e) const { return length_[e]; }
  double turn(int e) const {  // rad, between the tangents at both ends of an edge
    const auto at = static_cast<std::size_t>(e);
    return std::acos(std::clamp(slope_[at].normalized().dot(slope_[at + 1].normalized()), -1.0, 1.0));
  }

 private:
  /// At a free end half-extents go on as they change between the two last middles, within reason. Where others meet it a rod
  /// stays as it is at the last middle: its radii may turn there, and going on would make it thinner than it was meant to be.
  Knot free_knot(int node) const {
    const int edges = chain_.count();
    const auto own = static_cast<std::size_t>(node == 0 ? 0 : edges - 1);
    Knot knot = middle_[own];
    if (edges == 1 || chain_.joined[node == 0 ? 0 : 1]) return knot;
    const auto next = static_cast<std::size_t>(node == 0 ? 1 : edges - 2);
    const double share = length_[own] / (length_[own] + length_[next]);
    const auto extended = [share](double r, double inner) {
      return std::clamp(r + (r - inner) * share, r / kMostTaper, r * kMostTaper);
    };
    knot.r_b = extended(knot.r_b, middle_[next].r_b);
    knot.r_n = extended(knot.r_n, middle_[next].r_n);
    return knot;
  }

  /// The parabola of the last edge that has the slope of its inner node.
  void set_end_slopes() {
    const int edges = chain_.count();
    const auto last = static_cast<std::size_t>(edges);
    if (edges == 1) {
      slope_[0] = slope_[1] = chain_.side(0) / length_[0];
      return;
    }
    slope_[0] = 2 * chain_.side(0) / length_[0] - slope_[1];
    slope_[last] = 2 * chain_.side(edges - 1) / length_[last - 1] - slope_[last - 1];
  }

  const Chain& chain_;
  std::vector<Knot> middle_, at_node_;
  std::vector<double> length_;  // m, per edge
  std::vector<Vec3> slope_;     // per node, derivative of the curve by length
};

bool kinked(const Chain& chain, int before, int after) {
  return chain.side(before).normalized().dot(chain.side(after).normalized()) < kKinkCosine;
}

/// Cuts a rod at its kinks; a closed one begins at one of them.
std::vector<Chain> smooth_chains(const Structure& structure, const StructureRod& rod) {
  Chain whole{structure, rod, rod.nodes, rod.edges, rod.closed};
  if (rod.closed) whole.nodes.push_back(rod.nodes.front());
  const int edges = whole.count();
  std::vector<int> kinks;
  for (int i = rod.closed ? 0 : 1; i < edges; ++i) {
    if (kinked(whole, (i + edges - 1) % edges, i)) kinks.push_back(i);
  }
  if (kinks.empty()) return {whole};
  std::vector<int> cuts = kinks;
  if (rod.closed) {
    cuts.push_back(kinks.front() + edges);
  } else {
    cuts.insert(cuts.begin(), 0);
    cuts.push_back(edges);
  }
  std::vector<Chain> chains;
  for (std::size_t c = 0; c + 1 < cuts.size(); ++c) {
    Chain chain{structure, rod, {}, {}, false};
    for (int e = cuts[c]; e < cuts[c + 1]; ++e) {
      chain.edges.push_back(rod.edges[e % edges]);
      chain.nodes.push_back(rod.nodes[e % rod.nodes.size()]);
    }
    chain.nodes.push_back(rod.nodes[cuts[c + 1] % rod.nodes.size()]);
    chains.push_back(chain);
  }
  return chains;
}

RodPiece make_piece(const Chain& chain, int rod, double tolerance) {
  RodPiece piece;
  piece.rod = rod;
  piece.shape = chain.edge(0).section.shape;
  piece.closed = chain.closed;
  const Spine spine(chain);
  double spacing = INFINITY;
  for (int e = 0; e < chain.count(); ++e) {
    const RodStation s = spine.station(e, 0.5);
    spacing = std::min(spacing, surface_spacing(s.least_radius(piece.shape), std::min(s.r_b, s.r_n), tolerance) / 2);
  }
  double along = 0;
  piece.nodes.push_back({chain.nodes.front(), 0});
  for (int e = 0; e < chain.count(); ++e) {
    const double wanted = std::max({spine.length(e) / spacing, spine.turn(e) / 0.05, 2.0});
    const int cuts = static_cast<int>(std::ceil(std::min(wanted, double{kMostStations})));
    for (int k = e == 0 ? 0 : 1; k <= cuts; ++k) {
      RodStation s = spine.station(e, double(k) / cuts);
      if (!piece.stations.empty()) along += (s.centre - piece.stations.back().centre).norm();
      s.along = along;
      piece.stations.push_back(s);
    }
    piece.nodes.push_back({chain.nodes[e + 1], static_cast<int>(piece.stations.size()) - 1});
  }
  return piece;
}

constexpr int kLooked = 12;  // stations between two rings

const RodStation& station(const RodPiece& piece, int i) { return piece.stations[i]; }

/// m, how far the section of a station is from the straight tube between two others.
double bulge(const RodStation& from, const RodStation& to, const RodStation& at) {
  const double s = (at.along - from.along) / (to.along - from.along);
  double worst = 0;
  for (int k = 0; k < 4; ++k) {
    const auto point = [k](const RodStation& r) {
      return Vec3(r.centre + (k % 2 == 0 ? r.r_b * r.b : r.r_n * r.n) * (k < 2 ? 1 : -1));
    };
    worst = std::max(worst, (point(from) + s * (point(to) - point(from)) - point(at)).norm());
  }
  return worst;
}

bool straight(const RodPiece& piece, int from, int to, double tolerance) {
  const int looked = std::min(to - from - 1, kLooked);
  for (int k = 1; k <= looked; ++k) {
    const int at = from + (to - from) * k / (looked + 1);
    if (at > from && bulge(station(piece, from), station(piece, to), station(piece, at)) > tolerance) return false;
  }
  return true;
}

}  // namespace

double RodStation::reach(SectionShape shape) const {
  return shape == SectionShape::kRectangle ? std::hypot(r_b, r_n) : std::max(r_b, r_n);
}

double RodStation::least_radius(SectionShape shape) const {
  const double thin = std::min(r_b, r_n);
  return shape == SectionShape::kEllipse ? thin * thin / std::max(r_b, r_n) : thin;
}

double surface_spacing(double radius, double thinnest, double tolerance) {
  return std::min(kShare * std::sqrt(8 * radius * tolerance), kThinnestShare * thinnest);
}

std::vector<RodPiece> rod_pieces(const Structure& structure, double tolerance) {
  std::vector<int> uses(structure.nodes.size(), 0);  // how many ends, or passing rods, a node has
  std::vector<Chain> chains;
  std::vector<int> rod_of;
  for (std::size_t r = 0; r < structure.rods.size(); ++r) {
    for (Chain& chain : smooth_chains(structure, structure.rods[r])) {
      for (const int node : chain.nodes) ++uses[node];
      chains.push_back(std::move(chain));
      rod_of.push_back(static_cast<int>(r));
    }
  }
  std::vector<RodPiece> pieces;
  for (std::size_t c = 0; c < chains.size(); ++c) {
    chains[c].joined = {uses[chains[c].nodes.front()] > 1, uses[chains[c].nodes.back()] > 1};
    RodPiece piece = make_piece(chains[c], rod_of[c], tolerance);
    const auto end = [&](std::size_t side) { return chains[c].joined[side] ? PieceEnd::kRound : PieceEnd::kFlat; };
    if (!piece.closed) piece.end = {end(0), end(1)};
    pieces.push_back(std::move(piece));
  }
  return pieces;
}

std::vector<int> ring_stations(const RodPiece& piece, int first, int last, double deviation) {
  std::vector<int> chosen{first};
  int at = first;
  while (at < last) {
    int step = 1;
    while (at + 2 * step <= last && straight(piece, at, at + 2 * step, deviation)) step *= 2;
    int more = step / 2;  // between step and twice as far
    for (; more > 0; more /= 2) {
      if (at + step + more <= last && straight(piece, at, at + step + more, deviation)) step += more;
    }
    if (at + step < last && straight(piece, at, last, deviation)) step = last - at;
    at = std::min(at + step, last);
    chosen.push_back(at);
  }
  return chosen;
}

}  // namespace lissom
