#include "lissom/session/warnings.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <utility>

#include "lissom/mechanics/membrane_strain.h"
#include "lissom/mechanics/solid_strain.h"
#include "lissom/session/slack_remedy.h"

namespace lissom {

namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

struct Shape {
  const System& system;
  const State& state;
  double stretch_share;
  const WarningLimits& limits;

  const Structure& structure() const { return system.structure; }
  std::string rod_name(int rod) const {
    const std::string& name = structure().rods[rod].name;
    return name.empty() ? fmt::format("rod {}", rod) : fmt::format("rod \"{}\"", name);
  }
};

std::string place_text(const Vec3& p) {
  return fmt::format("near ({:.4g}, {:.4g}, {:.4g}) mm", 1e3 * p.x(), 1e3 * p.y(), 1e3 * p.z());
}

void warn_of_slack(const Shape& shape, std::vector<Warning>& list) {
  const Structure& s = shape.structure();
  const std::vector<TriangleStretch> stretches = triangle_stretches(shape.system, shape.state, shape.stretch_share);
  for (const StructureMembrane& membrane : s.membranes) {
    int slackest = -1;
    double area = 0, all = 0;
    for (int t = membrane.first_triangle; t < membrane.first_triangle + membrane.triangles; ++t) {
      all += stretches[t].area;
      if (stretches[t].smallest >= shape.limits.stretch) continue;
      area += stretches[t].area;
      if (slackest < 0 || stretches[t].smallest < stretches[slackest].smallest) slackest = t;
    }
    if (slackest < 0) continue;
    Vec3 middle = Vec3::Zero();
    for (const int node : s.triangles[slackest].node) middle += shape.state.position(node) / 3;
    Warning warning{
        "slack fabric",
        fmt::format("{}, {}", membrane.name.empty() ? "fabric" : fmt::format("membrane \"{}\"", membrane.name),
                    place_text(middle)),
        stretches[slackest].smallest,
        "1",
        {},
        s.triangles[slackest].node[0]};
    const Vec2 present = Vec2::Ones() + shape.stretch_share * (membrane.pre_stretch - Vec2::Ones());
    const std::optional<SlackRemedy> remedy = slack_remedy(shape.system.rest.triangles[slackest], present,
                                                           stretches[slackest].smallest, shape.limits.wanted_stretch);
    const std::string share =
        fmt::format("{:.3g} % of it is stretched by less than {:.3g}", 100 * area / all, shape.limits.stretch);
    if (!remedy) {
      warning.remedy = share + "; give it a pre-stretch, about 1.4 to begin with";
    } else {
      const Vec2& to = remedy->pre_stretch;
      const std::string stretch =
          to.x() == to.y() ? fmt::format("{:.3g}", to.x()) : fmt::format("{:.3g} x {:.3g}", to.x(), to.y());
      warning.remedy = fmt::format("{}{}raise the pre-stretch to {} and multiply all radii by {:.3g}", share,
                                   kEstimatedRemedy, stretch, remedy->radius_factor);
      if (to.maxCoeff() > shape.limits.pre_stretch) {
        warning.remedy +=
            fmt::format(", or, as few fabrics bear more than {:.2g}, make the rods thicker until the shape is flatter",
                        shape.limits.pre_stretch);
      }
    }
    list.push_back(std::move(warning));
  }
}

/// Whether each rod runs along the edge of a membrane.
std::vector<char> boundary_rods(const Structure& s) {
  std::map<std::pair<int, int>, int> triangles;  // at each side
  for (const StructureTriangle& t : s.triangles) {
    for (int k = 0; k < 3; ++k) ++triangles[std::minmax(t.node[k], t.node[(k + 1) % 3])];
  }
  std::vector<char> boundary(s.rods.size(), 0);
  for (const StructureEdge& edge : s.edges) {
    const auto side = triangles.find(std::minmax(edge.node0, edge.node1));
    if (side != triangles.end() && side->second == 1) boundary[edge.rod] = 1;
  }
  return boundary;
}

/// The boundary rod that shares the node nearest to `at` with this rod, or itself when it is one; -1: none does.
int boundary_rod_next_to(const Shape& shape, int rod, const Vec3& at, const std::vector<char>& boundary) {
  if (boundary[rod]) return rod;
  const Structure& s = shape.structure();
  std::vector<char> own(s.nodes.size(), 0);
  for (const int node : s.rods[rod].nodes) own[node] = 1;
  int nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (int r = 0; r < static_cast<int>(s.rods.size()); ++r) {
    if (!boundary[r]) continue;
    for (const int node : s.rods[r].nodes) {
      const double distance = (shape.state.position(node) - at).norm();
      if (!own[node] || distance >= least) continue;
      least = distance;
      nearest = r;
    }
  }
  return nearest;
}

void warn_of_compression(const Shape& shape, std::vector<Warning>& list) {
  const Structure& s = shape.structure();
  const std::vector<char> boundary = boundary_rods(s);
  std::vector<Warning> found;
  for (int r = 0; r < static_cast<int>(s.rods.size()); ++r) {
    int worst = -1;
    double most = shape.limits.compression;
    for (const int e : s.rods[r].edges) {
      const double compression = 1 - shape.state.edges[e].length / shape.system.rest.edges[e].length;
      if (compression <= most) continue;
      most = compression;
      worst = e;
    }
    if (worst < 0) continue;
    const Vec3 at = (shape.state.position(s.edges[worst].node0) + shape.state.position(s.edges[worst].node1)) / 2;
    const int ghost = boundary_rod_next_to(shape, r, at, boundary);
    Warning warning{"compressed rod",     fmt::format("{}, {}", shape.rod_name(r), place_text(at)), most, "1", {},
                    s.edges[worst].node0, ghost >= 0 ? s.rods[ghost].name : std::string()};
    const std::string amount = fmt::format("it is shortened by {:.2g} %", 100 * most);
    warning.remedy = ghost == r ? amount + "; make it a ghost, so that the edge of the fabric is free there"
                     : ghost >= 0
                         ? fmt::format("{}; make the boundary {} a ghost, so that the fabric can give way there",
                                       amount, shape.rod_name(ghost))
                         : amount + "; make it thicker, or lower the pre-stretch";
    found.push_back(std::move(warning));
  }
  std::stable_sort(found.begin(), found.end(), [](const Warning& a, const Warning& b) { return a.value > b.value; });
  list.insert(list.end(), found.begin(), found.end());
}

void warn_of_turns(const Shape& shape, std::vector<Warning>& list) {
  const Structure& s = shape.structure();
  std::vector<std::pair<double, int>> most(s.rods.size(), {shape.limits.turn, -1});  // rad, node
  for (const StructurePair& pair : s.pairs) {
    const Vec3 &a = shape.state.edges[pair.edge0].t, &b = shape.state.edges[pair.edge1].t;
    const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
    auto& [largest, node] = most[s.edges[pair.edge0].rod];
    if (angle <= largest) continue;
    largest = angle;
    node = s.edges[pair.edge0].node1;
  }
  std::vector<Warning> found;
  for (int r = 0; r < static_cast<int>(most.size()); ++r) {
    const auto& [angle, node] = most[r];
    if (node < 0) continue;
    const double edges = static_cast<double>(s.rods[r].edges.size());
    found.push_back(
        {"turning angle", fmt::format("{}, {}", shape.rod_name(r), place_text(shape.state.position(node))), angle,
         "rad",
         fmt::format("it turns by {:.3g} degrees from edge to edge, so that its bending is {}; use about {} "
                     "edges, shorter edges, or a smaller largest turn of the plan",
                     kDegrees * angle, angle > shape.limits.strong_turn ? "clearly wrong" : "some percent off",
                     static_cast<int>(std::ceil(edges * angle / (shape.limits.turn / 2)))),
         node});
  }
  std::stable_sort(found.begin(), found.end(), [](const Warning& a, const Warning& b) { return a.value > b.value; });
  list.insert(list.end(), found.begin(), found.end());
}

/// One warning for all of them: the remedy is for the whole structure.
void warn_of_thin_rods(const Shape& shape, std::vector<Warning>& list) {
  const Structure& s = shape.structure();
  std::vector<char> thin(s.rods.size(), 0);
  int thinnest = -1, node = -1;
  double least = shape.limits.diameter / 2 * (1 - 1e-9);
  for (const StructureEdge& edge : s.edges) {
    const double r = std::min(edge.section.r_n, edge.section.r_b);
    if (2 * r < shape.limits.diameter * (1 - 1e-9)) thin[edge.rod] = 1;
    if (r >= least) continue;
    least = r;
    thinnest = edge.rod;
    node = edge.node0;
  }
  if (thinnest < 0) return;
  const auto count = std::count(thin.begin(), thin.end(), 1);
  const double factor = shape.limits.diameter / (2 * least);
  list.push_back(
      {"thin rod",
       count == 1 ? shape.rod_name(thinnest) : fmt::format("{} and {} more", shape.rod_name(thinnest), count - 1),
       least, "m",
       fmt::format("{:.3g} mm thin, printers make {:.3g} mm and more; multiply all radii by {:.3g} and the "
                   "stiffness of the fabric by {:.3g}, which leaves the shape as it is",
                   2e3 * least, 1e3 * shape.limits.diameter, factor, std::pow(factor, 4)),
       node});
}

/// Tetrahedra that their load turned inside out, by solid.
void warn_of_inverted(const Shape& shape, std::vector<Warning>& list) {
  const std::vector<double> ratios = volume_ratios(shape.system, shape.state);
  for (const StructureSolid& solid : shape.structure().solids) {
    const auto first = ratios.begin() + solid.first_tetrahedron, end = first + solid.tetrahedra;
    const auto count = std::count_if(first, end, [](double ratio) { return !(ratio > 0); });
    if (count == 0) continue;
    const auto worst = std::min_element(first, end);
    Vec3 middle = Vec3::Zero();
    for (const int node : shape.structure().tetrahedra[worst - ratios.begin()].node) {
      middle += shape.state.position(node) / 4;
    }
    list.push_back(
        {"inverted tetrahedra", fmt::format("solid \"{}\", {}", solid.name, place_text(middle)), *worst, "1",
         fmt::format("{} of its {} tetrahedra are inside out there: load it less, make it stiffer, or spread "
                     "the load over more points",
                     count, solid.tetrahedra)});
  }
}

}  // namespace

std::vector<Warning> warnings(const System& system, const State& state, double stretch_share,
                              const WarningLimits& limits) {
  std::vector<Warning> list;
  const Shape shape{system, state, stretch_share, limits};
  warn_of_inverted(shape, list);
  if (system.structure.triangles.empty()) return list;
  warn_of_slack(shape, list);
  warn_of_compression(shape, list);
  warn_of_turns(shape, list);
  warn_of_thin_rods(shape, list);
  return list;
}

}  // namespace lissom
