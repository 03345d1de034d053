#include "lissom/geometry/surface_repair.h"

#include <cmath>
#include <fmt/format.h>

#include "lissom/geometry/surface_file.h"
#include "lissom/geometry/surface_mending.h"

namespace lissom {

namespace {

/// Vertices that no triangle of the surface has used from the start.
void note_unused(Mending& mending) {
  std::vector<char> used(mending.surface.vertices.size(), 0);
  for (const auto& t : mending.surface.triangles) {
    for (const int v : t) used[v] = 1;
  }
  SurfaceNote note{.what = "vertices that no triangle uses", .places = {}, .done = "left out"};
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (used[v]) continue;
    const Vec3& at = mending.surface.vertices[v];
    note.add(fmt::format("vertex {}", v), at.allFinite() ? std::optional<Vec3>(at) : std::nullopt);
  }
  mending.note(std::move(note));
}

/// Without the vertices that are not used any more.
Surface compacted(const Surface& surface) {
  std::vector<int> number(surface.vertices.size(), -1);
  for (const auto& t : surface.triangles) {
    for (const int v : t) number[v] = 0;
  }
  Surface kept;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] < 0) continue;
    number[v] = static_cast<int>(kept.vertices.size());
    kept.vertices.push_back(surface.vertices[v]);
    if (!surface.darkness.empty()) kept.darkness.push_back(surface.darkness[v]);
  }
  kept.triangles.reserve(surface.triangles.size());
  for (const auto& t : surface.triangles) kept.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
  return kept;
}

Status anything_left(const Mending& mending) {
  if (!mending.surface.triangles.empty()) return {};
  return Error{ErrorCode::kGeometry, mending.where, "no triangle with an area is left of the surface",
               "the file is damaged; export the surface again"};
}

/// Every step once.
Status mend_once(Mending& mending) {
  drop_repeated_corners(mending);
  sew_rims(mending);
  drop_duplicates(mending);
  if (Status s = anything_left(mending); !s) return s;
  if (Status s = leave_one_piece(mending); !s) return s;
  if (Status s = turn_alike(mending); !s) return s;
  close_small_holes(mending);
  split_fans(mending);
  if (Status s = mend_thin_triangles(mending); !s) return s;
  if (Status s = anything_left(mending); !s) return s;
  turn_outward(mending);
  return {};
}

/// Until a round finds nothing to mend: what is returned stays as it is when it is brought again.
Status mend_until_sound(Mending& mending) {
  constexpr int kRounds = 5;  // the second finds nothing in nearly all surfaces
  for (int round = 0; round < kRounds; ++round) {
    const std::size_t before = mending.notes.size();
    mending.extent = largest_extent(mending.surface);
    if (Status s = mend_once(mending); !s) return s;
    if (mending.notes.size() == before) return {};
  }
  const SurfaceNote& last = mending.notes.back();
  return Error{ErrorCode::kGeometry, mending.where,
               fmt::format("the surface lies on itself or is crumpled so that mending finds no end: {}", last.text()),
               "remesh it in the program that made it"};
}

}  // namespace

Status SurfaceRepairOptions::validate() const {
  const auto fraction = [](double x) { return x >= 0 && x < 1; };
  if (fraction(merge) && fraction(thin) && fraction(small_hole) && fraction(debris)) return {};
  return Error{ErrorCode::kRange, "options", "merge, thin, small_hole and debris are fractions",
               "give 0 to less than 1"};
}

Result<RepairedSurface> repair_surface(Surface surface, const SurfaceRepairOptions& options, const std::string& where) {
  if (Status s = options.validate(); !s) return s.error();
  Mending mending{.surface = std::move(surface), .origins = {}, .options = options, .where = where, .notes = {}};
  if (Status s = check_numbers(mending); !s) return s.error();
  note_unused(mending);
  if (Status s = mend_until_sound(mending); !s) return s.error();
  note_small_holes(mending);
  if (Status s = look_for_crossings(mending); !s) return s.error();
  return RepairedSurface{compacted(mending.surface), std::move(mending.notes)};
}

}  // namespace lissom
