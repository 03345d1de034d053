#include "lissom/fabrication/solid_plan.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "lissom/fabrication/near_points.h"

namespace lissom {

namespace {

/// Along a rod, against straight across: nearer than this share is a rod that comes back to itself.
constexpr double kDetour = 1.6;
constexpr double kTrianglesPerCell = 3.2;  // in the area of one side, measured on single rods
constexpr double kMostTriangles = 1.3e6;
constexpr double kMostCoarser = 1.6;  // with larger cells thin rods would fall apart

class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  int find(int i) {
    while (parent_[i] != i) {
      int& up = parent_[i];
      up = parent_[up];
      i = up;
    }
    return i;
  }
  void unite(int a, int b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<int> parent_;
};

/// A station among those of all pieces.
struct Place {
  int piece = 0, station = 0;
  Vec3 centre;
  double along = 0, reach = 0, margin = 0;  // m
};

double piece_cell(const RodPiece& piece, double tolerance) {
  double cell = INFINITY;
  for (const RodStation& s : piece.stations) {
    cell = std::min(cell, surface_spacing(s.least_radius(piece.shape), std::min(s.r_b, s.r_n), tolerance));
  }
  return cell;
}

std::vector<Place> places_of(const std::vector<RodPiece>& pieces, const std::vector<double>& cells) {
  std::vector<Place> places;
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    for (std::size_t i = 0; i < pieces[p].stations.size(); ++i) {
      const RodStation& s = pieces[p].stations[i];
      // Half of what two surfaces need between them: the rounded valley, and two cells.
      const double margin = kValley * std::min(s.r_b, s.r_n) / 2 + 1.5 * cells[p];
      places.push_back({static_cast<int>(p), static_cast<int>(i), s.centre, s.along, s.reach(pieces[p].shape), margin});
    }
  }
  return places;
}

bool near(const std::vector<RodPiece>& pieces, const Place& a, const Place& b) {
  const double needed = a.reach + a.margin + b.reach + b.margin;
  if ((a.centre - b.centre).squaredNorm() > needed * needed) return false;
  if (a.piece != b.piece) return true;
  const RodPiece& piece = pieces[a.piece];
  double along = std::abs(a.along - b.along);
  if (piece.closed) along = std::min(along, piece.length() - along);
  return along > kDetour * needed;
}

/// Calls visit(i, j) for pairs of places near each other.
template <class Visit>
void for_near_places(const std::vector<RodPiece>& pieces, const std::vector<Place>& places, const Visit& visit) {
  double largest = 0;
  std::vector<Vec3> centres;
  for (const Place& p : places) {
    largest = std::max(largest, p.reach + p.margin);
    centres.push_back(p.centre);
  }
  for_near_points(centres, 2 * largest, [&](int i, int j) {
    if (near(pieces, places[i], places[j])) visit(i, j);
  });
}

/// Begins a closed piece at another of its stations; behind the old seam axes may have to turn by half a turn.
void rotate_piece(RodPiece& piece, int start) {
  const std::size_t n = piece.stations.size() - 1;
  const double length = piece.length();
  const double sign = piece.stations.back().n.dot(piece.stations.front().n) < 0 ? -1 : 1;
  std::vector<RodStation> turned;
  for (std::size_t i = 0; i <= n; ++i) {
    const std::size_t at = static_cast<std::size_t>(start) + i;
    RodStation s = piece.stations[at <= n ? at : at - n];
    if (at > n) {
      s.along += length;
      s.n *= sign;
      s.b *= sign;
    }
    s.along -= piece.stations[start].along;
    turned.push_back(s);
  }
  piece.stations = std::move(turned);
}

/// The spans of one piece: runs of free stations that are long enough.
std::vector<FreeSpan> spans_of(const RodPiece& piece, int number, const std::vector<bool>& free, double cell) {
  std::vector<FreeSpan> spans;
  const int count = static_cast<int>(free.size());
  if (std::all_of(free.begin(), free.end(), [](bool f) { return f; })) return {{number, 0, count - 1, {-1, -1}}};
  for (int i = 0; i < count; ++i) {
    if (!free[i]) continue;
    FreeSpan span{number, i, i, {0, 0}};
    while (span.last + 1 < count && free[span.last + 1]) ++span.last;
    i = span.last;
    if (span.first == 0 && !piece.closed) span.cluster[0] = -1;
    if (span.last == count - 1 && !piece.closed) span.cluster[1] = -1;
    const double length = piece.stations[span.last].along - piece.stations[span.first].along;
    if (length > (2 * kStub + 3 * kLip) * cell) spans.push_back(span);
  }
  return spans;
}

/// Station that lies `distance` (m) or more from station `from` towards `step` (+-1).
int station_beyond(const RodPiece& piece, int from, int step, double distance) {
  const auto along = [&](int i) { return piece.stations[i].along; };
  const int count = static_cast<int>(piece.stations.size());
  int i = from;
  while (i + step >= 0 && i + step < count && std::abs(along(i) - along(from)) < distance) i += step;
  return i;
}

/// What is left of a piece between spans: stations first to last, and whether spans follow there.
struct Rest {
  int piece = 0, first = 0, last = 0;
  std::array<bool, 2> stub{false, false};
};

/// Triangles that looking for the surface between two stations takes, about; fewer where rods overlap.
double triangles_between(const RodPiece& piece, int first, int last, double cell) {
  double area = 0;
  for (int i = first; i < last; ++i) {
    const RodStation &from = piece.stations[i], &to = piece.stations[i + 1];
    area += std::numbers::pi * (from.r_b + from.r_n) * (to.along - from.along);
  }
  return kTrianglesPerCell * area / (cell * cell);
}

class Planner {
 public:
  Planner(std::vector<RodPiece>& pieces, double tolerance, double finer) : pieces_(pieces) {
    for (const RodPiece& piece : pieces) cells_.push_back(piece_cell(piece, tolerance) / finer);
  }

  SolidPlan plan(Tubes tubes) {
    find_free(tubes);
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      for (const FreeSpan& span : spans_of(pieces_[p], static_cast<int>(p), free_[p], cells_[p])) {
        plan_.spans.push_back(span);
      }
    }
    find_rests();
    make_clusters();
    count_triangles();
    add_parts();
    return std::move(plan_);
  }

 private:
  int place(int piece, int station) const { return first_place_[piece] + station; }

  /// Which stations nothing else comes near; closed pieces begin at one that is not, if there is any.
  void find_free(Tubes tubes) {
    for (const RodPiece& piece : pieces_) free_.emplace_back(piece.stations.size(), tubes == Tubes::kYes);
    const std::vector<Place> places = places_of(pieces_, cells_);
    for_near_places(pieces_, places, [&](int i, int j) {
      free_[places[i].piece][places[i].station] = false;
      free_[places[j].piece][places[j].station] = false;
    });
    for (std::size_t p = 0; p < pieces_.size(); ++p) {
      std::vector<bool>& free = free_[p];
      if (pieces_[p].end[0] == PieceEnd::kRound) free.front() = false;
      if (pieces_[p].end[1] == PieceEnd::kRound) free.back() = false;
      if (!pieces_[p].closed) continue;
      free.back() = free.front();
      const auto taken = std::find(free.begin(), free.end(), false);
      if (taken == free.end() || taken == free.begin()) continue;
      const auto start = static_cast<std::size_t>(taken - free.begin()), n = free.size() - 1;
      rotate_piece(pieces_[p], static_cast<int>(start));
      std::vector<bool> turned;
      for (std::size_t i = 0; i <= n; ++i) turned.push_back(free[(start + i) % n]);
      free = turned;
    }
  }

  void find_rests() {
    std::size_t next = 0;
    for (int p = 0; p < static_cast<int>(pieces_.size()); ++p) {
      const int last = static_cast<int>(pieces_[p].stations.size()) - 1;
      Rest rest{p, 0, last, {false, false}};
      for (; next < plan_.spans.size() && plan_.spans[next].piece == p; ++next) {
        const FreeSpan& span = plan_.spans[next];
        rest.last = span.first;
        rest.stub[1] = true;
        if (rest.last > rest.first) rests_.push_back(rest);
        rest = {p, span.last, last, {true, false}};
      }
      if (rest.last > rest.first) rests_.push_back(rest);
    }
  }

  /// What lies between spans belongs together where it is near each other.
  void make_clusters() {
    int count = 0;
    for (const RodPiece& piece : pieces_) {
      first_place_.push_back(count);
      count += static_cast<int>(piece.stations.size());
    }
    Sets sets(static_cast<std::size_t>(count));
    for_near_places(pieces_, places_of(pieces_, cells_), [&](int i, int j) { sets.unite(i, j); });
    for (const Rest& r : rests_) {
      for (int i = r.first; i < r.last; ++i) sets.unite(place(r.piece, i), place(r.piece, i + 1));
      const int last = static_cast<int>(pieces_[r.piece].stations.size()) - 1;
      if (pieces_[r.piece].closed) sets.unite(place(r.piece, 0), place(r.piece, last));
    }
    std::vector<int> number(static_cast<std::size_t>(count), -1);
    const auto cluster_at = [&](int piece, int station) -> int& { return number[sets.find(place(piece, station))]; };
    for (const Rest& r : rests_) {
      int& cluster = cluster_at(r.piece, r.first);
      if (cluster < 0) {
        cluster = static_cast<int>(plan_.clusters.size());
        plan_.clusters.push_back({INFINITY, {}});
      }
      rest_cluster_.push_back(cluster);
      plan_.clusters[cluster].cell = std::min(plan_.clusters[cluster].cell, cells_[r.piece]);
    }
    for (FreeSpan& span : plan_.spans) {
      if (span.cluster[0] == 0) span.cluster[0] = cluster_at(span.piece, span.first);
      if (span.cluster[1] == 0) span.cluster[1] = cluster_at(span.piece, span.last);
    }
  }

  void count_triangles() {
    double triangles = 0;
    for (std::size_t k = 0; k < rests_.size(); ++k) {
      const Rest& r = rests_[k];
      triangles += triangles_between(pieces_[r.piece], r.first, r.last, plan_.clusters[rest_cluster_[k]].cell);
    }
    plan_.coarser = std::clamp(std::sqrt(triangles / kMostTriangles), 1.0, kMostCoarser);
  }

  void add_parts() {
    for (std::size_t k = 0; k < rests_.size(); ++k) {
      const Rest& r = rests_[k];
      const RodPiece& piece = pieces_[r.piece];
      RodCluster& cluster = plan_.clusters[rest_cluster_[k]];
      FieldPart part{&piece, r.piece, r.first, r.last, {}};
      for (int side = 0; side < 2; ++side) {
        part.cap[side] = r.stub[side]                          ? FieldPart::Cap::kFlat
                         : piece.closed                        ? FieldPart::Cap::kOpen
                         : piece.end[side] == PieceEnd::kRound ? FieldPart::Cap::kRound
                                                               : FieldPart::Cap::kFlat;
      }
      if (r.stub[0]) part.first = station_beyond(piece, r.first, -1, kStub * cluster.cell);
      if (r.stub[1]) part.last = station_beyond(piece, r.last, 1, kStub * cluster.cell);
      cluster.parts.push_back(part);
    }
  }

  std::vector<RodPiece>& pieces_;
  std::vector<double> cells_;            // m, per piece
  std::vector<std::vector<bool>> free_;  // per piece and station
  std::vector<Rest> rests_;
  std::vector<int> rest_cluster_, first_place_;
  SolidPlan plan_;
};

}  // namespace

SolidPlan plan_solid(std::vector<RodPiece>& pieces, double tolerance, double finer, Tubes tubes) {
  SolidPlan plan = Planner(pieces, tolerance, finer).plan(tubes);
  if (plan.coarser == 1) return plan;
  const double coarser = plan.coarser;
  plan = Planner(pieces, tolerance, finer / coarser).plan(tubes);
  plan.coarser = coarser;
  return plan;
}

}  // namespace lissom
