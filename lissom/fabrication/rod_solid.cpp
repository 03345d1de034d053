#include "lissom/fabrication/rod_solid.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <utility>

#include "lissom/fabrication/contour.h"
#include "lissom/fabrication/solid_check.h"
#include "lissom/fabrication/stub_cut.h"

namespace lissom {

namespace {

constexpr double kFinestTolerance = 1e-6;  // m
constexpr double kFiner = 1.4;             // cells, at every attempt after the second
constexpr int kAttempts = 4;

const RodStation& station(const RodPiece& piece, int i) { return piece.stations[i]; }

/// Station at a lip's distance from the end `side` of a span, where its tube begins.
int tube_begin(const RodPiece& piece, const FreeSpan& span, int side, double lip) {
  const int end = side == 0 ? span.first : span.last, step = side == 0 ? 1 : -1;
  int i = end;
  while (std::abs(station(piece, i).along - station(piece, end).along) < lip) i += step;
  return i;
}

class Maker {
 public:
  Maker(const std::vector<RodPiece>& pieces, const SolidPlan& plan, double tolerance, const Context& context)
      : pieces_(pieces), plan_(plan), tolerance_(tolerance), context_(context), lips_(plan.spans.size()) {}

  /// kGeometry when stubs could not be cut.
  Result<Surface> make() {
    for (std::size_t c = 0; c < plan_.clusters.size(); ++c) {
      if (const Status s = add_cluster(static_cast<int>(c)); !s) return s.error();
    }
    for (std::size_t s = 0; s < plan_.spans.size(); ++s) add_tube(plan_.spans[s], lips_[s]);
    return std::move(surface_);
  }

 private:
  Status add_cluster(int number) {
    const RodCluster& cluster = plan_.clusters[number];
    Result<Surface> found = contour(RodField(cluster.parts, cluster.cell, tolerance_), cluster.cell, context_);
    if (!found) return found.error();
    Surface& part = found.value();
    std::vector<StubCut> cuts;
    std::vector<VertexRing*> lips;
    for (std::size_t s = 0; s < plan_.spans.size(); ++s) {
      const FreeSpan& span = plan_.spans[s];
      const RodPiece& piece = pieces_[span.piece];
      for (int side = 0; side < 2; ++side) {
        if (span.cluster[side] != number) continue;
        const RodStation& at = station(piece, side == 0 ? span.first : span.last);
        cuts.push_back({at, side == 0 ? 1 : -1, at.reach(piece.shape) + 1.5 * cluster.cell,
                        (kStub + 1.5) * cluster.cell, kPlay * cluster.cell});
        lips.push_back(&lips_[s][side]);
      }
    }
    const std::optional<std::vector<VertexRing>> rings = cut_stubs(cuts, part);
    if (!rings) return Error{ErrorCode::kGeometry, "rods", "a stub could not be cut", {}};
    const int offset = static_cast<int>(surface_.vertices.size());
    surface_.vertices.insert(surface_.vertices.end(), part.vertices.begin(), part.vertices.end());
    for (const std::array<int, 3>& t : part.triangles) {
      surface_.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
    }
    for (std::size_t k = 0; k < lips.size(); ++k) {
      *lips[k] = (*rings)[k];
      for (int& v : lips[k]->vertices) v += offset;
    }
    return {};
  }

  void add_tube(const FreeSpan& span, const std::array<VertexRing, 2>& lips) {
    const RodPiece& piece = pieces_[span.piece];
    std::array<int, 2> ends{span.first, span.last};
    for (int side = 0; side < 2; ++side) {
      const int cluster = span.cluster[side];
      if (cluster < 0) continue;
      ends[side] = tube_begin(piece, span, side, kLip * plan_.clusters[cluster].cell);
    }
    const std::vector<int> stations = ring_stations(piece, ends[0], ends[1], tolerance_ / 4);
    const int sides = ring_sides(piece, ends[0], ends[1], tolerance_);
    const bool whole = piece.closed && span.cluster[0] < 0 && span.cluster[1] < 0;
    VertexRing first, before;
    for (std::size_t k = 0; k + (whole ? 1 : 0) < stations.size(); ++k) {
      const VertexRing ring = add_ring(station(piece, stations[k]), piece.shape, sides, surface_);
      if (k == 0) {
        first = ring;
      } else {
        add_band(before, ring, surface_);
      }
      before = ring;
    }
    if (whole) {
      if (station(piece, span.last).n.dot(station(piece, span.first).n) < 0) {
        for (double& angle : first.angles) angle += std::numbers::pi;
      }
      add_band(before, first, surface_);
      return;
    }
    if (span.cluster[0] < 0)
      add_cap(first, -1, surface_);
    else
      add_band(lips[0], first, surface_);
    if (span.cluster[1] < 0)
      add_cap(before, 1, surface_);
    else
      add_band(before, lips[1], surface_);
  }

  const std::vector<RodPiece>& pieces_;
  const SolidPlan& plan_;
  double tolerance_;
  const Context& context_;
  Surface surface_;
  std::vector<std::array<VertexRing, 2>> lips_;  // per span: where its tube is joined to clusters
};

void drop_unused_vertices(Surface& surface) {
  std::vector<int> number(surface.vertices.size(), -1);
  for (const std::array<int, 3>& t : surface.triangles) {
    for (const int v : t) number[v] = 0;
  }
  int count = 0;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] < 0) continue;
    surface.vertices[count] = surface.vertices[v];
    number[v] = count++;
  }
  surface.vertices.resize(count);
  for (std::array<int, 3>& t : surface.triangles) {
    for (int& v : t) v = number[v];
  }
}

/// The rod whose centreline is nearest to a place.
int nearest_rod(const std::vector<RodPiece>& pieces, const Vec3& place) {
  int rod = -1;
  double least = INFINITY;
  for (const RodPiece& piece : pieces) {
    for (const RodStation& s : piece.stations) {
      if ((s.centre - place).squaredNorm() >= least) continue;
      least = (s.centre - place).squaredNorm();
      rod = piece.rod;
    }
  }
  return rod;
}

/// m, the least half-extent of a section.
double thinnest(const std::vector<RodPiece>& pieces) {
  double least = INFINITY;
  for (const RodPiece& piece : pieces) {
    for (const RodStation& s : piece.stations) least = std::min({least, s.r_b, s.r_n});
  }
  return least;
}

Result<RodSolid> solid_of(const Structure& structure, const std::vector<RodPiece>& all, const SolidOptions& options,
                          const Context& context) {
  SolidCheck check;
  for (int attempt = 1; attempt <= kAttempts; ++attempt) {
    std::vector<RodPiece> pieces = all;
    // First tubes and joints, then one surface for everything, then that on finer lattices.
    const SolidPlan plan = plan_solid(pieces, options.tolerance, attempt > 2 ? std::pow(kFiner, attempt - 2) : 1,
                                      attempt == 1 ? Tubes::kYes : Tubes::kNo);
    Result<Surface> made = Maker(pieces, plan, options.tolerance, context).make();
    if (!made) {
      if (made.error().code != ErrorCode::kGeometry) return made.error();
      continue;
    }
    RodSolid solid;
    solid.surface = std::move(made).value();
    solid.cavities = fill_cavities(solid.surface);
    drop_flakes(solid.surface, std::pow(thinnest(pieces), 3));
    drop_unused_vertices(solid.surface);
    check = check_solid(solid.surface, context);
    if (!check.ok()) continue;
    solid.volume = check.volume;
    solid.parts = check.parts;
    solid.tubes = static_cast<int>(plan.spans.size());
    solid.joints = static_cast<int>(plan.clusters.size());
    for (const RodCluster& cluster : plan.clusters) solid.cell = std::max(solid.cell, cluster.cell);
    solid.attempts = attempt;
    solid.tolerance = options.tolerance * plan.coarser * plan.coarser;  // heights of chords grow with their square
    return solid;
  }
  const int rod = nearest_rod(all, check.place);
  const Vec3 mm = 1e3 * check.place;
  return Error{ErrorCode::kGeometry, rod >= 0 ? structure.rods[rod].name : "rods",
               fmt::format("the solid would have a fault: {}, at ({:.2f}, {:.2f}, {:.2f}) mm", check.problem, mm.x(),
                           mm.y(), mm.z()),
               "give another tolerance, or bend or thin the rod there"};
}

}  // namespace

Status SolidOptions::validate() const {
  if (tolerance >= kFinestTolerance && tolerance <= 1) return {};
  return Error{ErrorCode::kRange, "tolerance", fmt::format("{:g} mm is no tolerance", 1e3 * tolerance),
               "give a length between 0.001 mm and 1 m, such as \"0.1 mm\""};
}

Result<std::vector<RodSolid>> rod_solids(const Structure& structure, const SolidOptions& options,
                                         const Context& context) {
  if (const Status s = options.validate(); !s) return s.error();
  std::vector<std::string> materials;
  for (const StructureRod& rod : structure.rods) {
    if (std::find(materials.begin(), materials.end(), rod.material) == materials.end())
      materials.push_back(rod.material);
  }
  if (materials.empty()) {
    return Error{ErrorCode::kGeometry, "rods", "there are no rods, and fabric is not printed",
                 "print a structure with rods"};
  }
  const std::vector<RodPiece> pieces = rod_pieces(structure, options.tolerance);
  std::vector<RodSolid> solids;
  for (const std::string& material : materials) {
    std::vector<RodPiece> own;
    std::copy_if(pieces.begin(), pieces.end(), std::back_inserter(own),
                 [&](const RodPiece& piece) { return structure.rods[piece.rod].material == material; });
    Result<RodSolid> solid = solid_of(structure, own, options, context);
    if (!solid) return solid.error();
    solid.value().material = material;
    solids.push_back(std::move(solid).value());
  }
  return solids;
}

}  // namespace lissom
