#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "lissom/model/discretize_parts.h"

namespace lissom {

namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kRemark = 20 * kDegree, kStrong = 30 * kDegree;
constexpr int kShown = 8;  // rods that are named

}  // namespace

void note_turning_angles(Draft& draft) {
  Structure& s = draft.structure;
  std::vector<double> most(s.rods.size(), 0);
  for (const StructurePair& pair : s.pairs) {
    const StructureEdge &first = s.edges[static_cast<size_t>(pair.edge0)],
                        &second = s.edges[static_cast<size_t>(pair.edge1)];
    const double drawn = std::atan2(first.drawn.t.cross(second.drawn.t).norm(), first.drawn.t.dot(second.drawn.t));
    const double rest = 2 * std::atan(std::hypot(pair.rest_kappa_1, pair.rest_kappa_2) / 2);
    double& angle = most[static_cast<size_t>(first.rod)];
    angle = std::max(angle, std::max(drawn, rest));
  }
  int remarked = 0;
  for (size_t r = 0; r < most.size(); ++r) {
    if (most[r] <= kRemark + 1e-9 || ++remarked > kShown) continue;
    s.notes.push_back(
        fmt::format("{}: turns by {:.0f} degrees from edge to edge, {}; use about {} edges, or end the rod at "
                    "a corner and start another one",
                    rod_label(draft.model, r), most[r] / kDegree,
                    most[r] > kStrong ? "so its bending is clearly wrong" : "so its bending is several percent off",
                    static_cast<int>(std::ceil(double(s.rods[r].edges.size()) * most[r] / (10 * kDegree)))));
  }
  if (remarked > kShown) s.notes.push_back(fmt::format("{} more rods turn by more than 20 degrees", remarked - kShown));
}

}  // namespace lissom
