#include "lissom/design/redrawn.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "lissom/core/assert.h"
#include "lissom/design/kept_selectors.h"

namespace lissom {

namespace {

constexpr double kShortest = 1e-6;  // of the size of the structure: below it nodes merge
constexpr double kAlong = 1e-3;     // sine between an edge and its normal, as when frames are made

/// A direction for every edge and every place between two: what MaterialAxes::Kind::kPerPoint interpolates.
MaterialAxes axes_per_edge(const Structure& structure, const StructureRod& rod) {
  const auto normal = [&](std::size_t k) -> const Vec3& {
    return structure.edges[static_cast<std::size_t>(rod.edges[k])].drawn.n;
  };
  const std::size_t n = rod.edges.size();
  MaterialAxes axes;
  axes.kind = MaterialAxes::Kind::kPerPoint;
  axes.normals.resize(2 * n + (rod.closed ? 0 : 1));
  for (std::size_t k = 0; k < n; ++k) {
    axes.normals[2 * k + 1] = normal(k);
    const Vec3 between = normal(k) + normal(k > 0 ? k - 1 : rod.closed ? n - 1 : 0);
    axes.normals[2 * k] = between.norm() > 1e-3 ? Vec3(between.normalized()) : normal(k);
  }
  if (!rod.closed) axes.normals.back() = normal(n - 1);
  return axes;
}

/// Rods as their nodes, with normals that depend on no other rod.
void describe_by_nodes(Model& model, Structure& structure) {
  for (std::size_t r = 0; r < model.rods.size(); ++r) {
    Rod& rod = model.rods[r];
    const StructureRod& made = structure.rods[r];
    rod.edges = static_cast<int>(made.edges.size());
    rod.edge_length = 0;
    const bool bare = structure.edges[static_cast<std::size_t>(made.edges[0])].natural_normal.isZero();
    if (!bare) continue;
    rod.axes = axes_per_edge(structure, made);
    for (const int e : made.edges) {
      StructureEdge& edge = structure.edges[static_cast<std::size_t>(e)];
      edge.natural_normal = edge.drawn.n;
    }
  }
}

Error lost(const Structure& structure, int edge, const char* what) {
  return {ErrorCode::kGeometry, "/rods",
          fmt::format("an edge of rod \"{}\" {}", structure.rods[structure.edges[edge].rod].name, what),
          "move the rods less"};
}

Status update_edges(Structure& structure) {
  double sum = 0;
  for (int e = 0; e < static_cast<int>(structure.edges.size()); ++e) {
    StructureEdge& edge = structure.edges[e];
    const Vec3 along = structure.nodes[edge.node1] - structure.nodes[edge.node0];
    const double length = along.norm();
    if (!(length > kShortest * structure.size)) return lost(structure, e, "would lose its length");
    const Vec3 t = along / length;
    if (!(t.cross(edge.natural_normal).norm() > kAlong * edge.natural_normal.norm())) {
      return lost(structure, e, "would run along its own normal");
    }
    sum += length;
    edge.rest_length = structure.rods[edge.rod].length_factor * length;
    edge.drawn = edge.rest = frame_from_normal(t, edge.natural_normal);
  }
  structure.mean_edge_length = sum / static_cast<double>(structure.edges.size());
  return {};
}

Status update_strains(Structure& structure) {
  for (StructurePair& pair : structure.pairs) {
    const Frame &first = structure.edges[pair.edge0].drawn, &second = structure.edges[pair.edge1].drawn;
    if (!(1 + first.t.dot(second.t) > 1e-9)) return lost(structure, pair.edge1, "would turn back on the one before");
    const PairStrain strain = pair_strain(first, second);
    pair.rest_kappa_1 = strain.kappa_1;
    pair.rest_kappa_2 = strain.kappa_2;
    pair.rest_twist = strain.twist;
  }
  for (StructureJoint& joint : structure.joints) {
    for (JointConnection& connection : joint.connections) connection.rest = structure.edges[connection.edge].drawn;
  }
  return {};
}

double size_of(const Structure& structure) {
  Eigen::AlignedBox3d box;
  for (const Vec3& node : structure.nodes) box.extend(node);
  return box.diagonal().norm();
}

}  // namespace

Status check_redrawable(const Model& model, const Structure& structure) {
  if (model.plan || !model.membranes.empty()) {
    return Error{ErrorCode::kUnsupported, model.plan ? "/plan" : "/membranes",
                 "the drawing of a structure with fabric is moved by the control points of its plan",
                 "use the control points of the plan as parameters"};
  }
  LISSOM_ASSERT(structure.rods.size() == model.rods.size());
  for (const Rod& rod : model.rods) {
    if (rod.natural.kind == Natural::Kind::kAsDrawn) continue;
    return Error{ErrorCode::kUnsupported, "/rods",
                 fmt::format("the natural shape of rod \"{}\" is described apart from its drawing", rod.name),
                 "draw the rod in its natural shape, or leave the rest shape alone"};
  }
  return {};
}

bool has_own_normals(const Structure& structure) {
  return std::none_of(structure.edges.begin(), structure.edges.end(),
                      [](const StructureEdge& edge) { return edge.natural_normal.isZero(); });
}

Status redraw(Model& model, Structure& structure, const VecX& places) {
  LISSOM_ASSERT(places.size() == 3 * static_cast<Eigen::Index>(structure.nodes.size()));
  if (!places.allFinite()) {
    return Error{ErrorCode::kRange, "/rods", "a place of the drawing is not finite", "give finite parameters"};
  }
  KeptSelectors selectors(model, structure);
  describe_by_nodes(model, structure);
  for (int i = 0; i < static_cast<int>(structure.nodes.size()); ++i) structure.nodes[i] = places.segment<3>(3 * i);
  structure.size = size_of(structure);
  if (Status s = update_edges(structure); !s) return s;
  if (Status s = update_strains(structure); !s) return s;
  for (std::size_t r = 0; r < model.rods.size(); ++r) {
    Polyline line;
    line.closed = structure.rods[r].closed;
    for (const int node : structure.rods[r].nodes) line.points.push_back(structure.nodes[node]);
    model.rods[r].curve = std::move(line);
  }
  return selectors.rename(model, structure);
}

}  // namespace lissom
