#include "lissom/session/totals.h"

#include <algorithm>

#include "lissom/mechanics/membrane_strain.h"

namespace lissom {

Totals totals(const System& system, const State& state, double stretch_share) {
  Totals totals;
  std::vector<Vec3> positions;
  for (int i = 0; i < system.layout.nodes(); ++i) positions.push_back(state.position(i));
  LISSOM_ASSERT(!positions.empty());
  totals.low = totals.high = positions.front();
  for (const Vec3& p : positions) {
    totals.low = totals.low.cwiseMin(p);
    totals.high = totals.high.cwiseMax(p);
  }
  totals.height = totals.high.z() - totals.low.z();
  bool first = true;
  for (const TriangleStretch& s : triangle_stretches(system, state, stretch_share)) {
    totals.area += s.area;
    totals.rest_area += s.rest_area;
    if (s.smallest < 1) totals.slack_area += s.area;
    totals.smallest_stretch = first ? s.smallest : std::min(totals.smallest_stretch, s.smallest);
    first = false;
  }
  return totals;
}

}  // namespace lissom
