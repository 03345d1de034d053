/// The four cases of the square frame on four meshes [mathematics 8]: heights, diagonals and smallest stretches, which have to
/// settle as the mesh is refined. Rows of name, metric, value, unit.

#include <algorithm>
#include <cmath>
#include <string>

#include "bench/fabric_problems.h"
#include "bench/first_pose.h"
#include "bench/timing.h"
#include "lissom/equilibrium/solve.h"
#include "lissom/mechanics/membrane_strain.h"

namespace lissom {
namespace {

struct Case {
  const char* name;
  double r_n, r_b, pre_stretch;  ///< mm, mm
};

constexpr Case kCases[] = {{"i base", 0.2, 0.4, 1.3},
                           {"ii more stretch", 0.2, 0.4, 1.6},
                           {"iii lower in plane", 0.2, 0.2, 1.3},
                           {"iv thick", 0.4, 0.4, 1.3}};

/// m; the longer of the two, corner to corner. The corners are where two rods meet.
double diagonal(const System& system, const State& state) {
  double longest = 0;
  for (const StructureJoint& a : system.structure.joints) {
    for (const StructureJoint& b : system.structure.joints) {
      longest = std::max(longest, (state.position(a.node) - state.position(b.node)).norm());
    }
  }
  return longest;
}

void measure(const Case& c, int cells) {
  networks::SquareFrame frame;
  frame.cells = cells;
  frame.r_n = 1e-3 * c.r_n;
  frame.r_b = 1e-3 * c.r_b;
  frame.pre_stretch = c.pre_stretch;
  const Model model = networks::square_frame_on_fabric(frame);
  const std::string name = std::string("frame ") + c.name + ", " + std::to_string(cells) + " cells";
  const FirstPose ready = first_pose(name, model);
  if (!ready.problem) return;
  const Equilibrium found = solve(*ready.problem, start_state(*ready.problem, model.poses[0]), 1, {});
  double low = INFINITY, high = -INFINITY, least = INFINITY;
  for (int i = 0; i < ready.system->layout.nodes(); ++i) {
    low = std::min(low, found.state.position(i).z());
    high = std::max(high, found.state.position(i).z());
  }
  for (const TriangleStretch& t : triangle_stretches(*ready.system, found.state, 1))
    least = std::min(least, t.smallest);
  row(name, "height", 1e3 * (high - low), "mm");
  row(name, "diagonal", 1e3 * diagonal(*ready.system, found.state), "mm");
  row(name, "smallest stretch", least, "");
  row(name, "energy", 1e3 * found.energy, "N mm");
  row(name, "factorizations", found.factorizations, "");
  row(name, "stable", found.verdict == Verdict::kStable, "");
}

}  // namespace
}  // namespace lissom

int main() {
  using namespace lissom;
  for (const Case& c : kCases) {
    for (const int cells : {8, 16, 32, 64}) measure(c, cells);
  }
  return 0;
}
