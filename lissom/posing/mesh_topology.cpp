#include "lissom/posing/mesh_topology.h"

#include "lissom/core/assert.h"
#include "lissom/geometry/cell_network.h"
#include "lissom/geometry/drawn_network.h"
#include "lissom/geometry/dual_network.h"
#include "lissom/geometry/line_patterns.h"

namespace lissom {

namespace {

constexpr double kCorner = 0.7;     // rad, turn of a drawn line that makes a joint
constexpr double kEverywhere = -1;  // every point of a pattern is a joint

PatternCell cell_of(PatternTopology::Shape shape) {
  switch (shape) {
    case PatternTopology::Shape::kQuads:
      return PatternCell::kSquare;
    case PatternTopology::Shape::kTriangles:
      return PatternCell::kTriangle;
    case PatternTopology::Shape::kHexagons:
      break;
  }
  return PatternCell::kHexagon;
}

/// One overload per topology.
struct LayOut {
  const Surface& surface;
  const std::optional<ObjLines>& drawn;
  const std::string& where;
  const Context& context;

  Result<SurfaceNetwork> operator()(const CellTopology& wanted) const {
    CellOptions options;
    options.cells = wanted.cells;
    options.contrast = wanted.contrast;
    options.seed = static_cast<uint32_t>(wanted.seed);
    const Result<SurfaceCells> cells = tessellate(surface, options, where + "/cells", context);
    if (!cells) return cells.error();
    return cell_network(surface, cells.value(), where + "/cells");
  }
  Result<SurfaceNetwork> operator()(const DualTopology& wanted) const {
    return dual_network(surface, {wanted.triangles}, where + "/dual");
  }
  Result<SurfaceNetwork> operator()(const PatternTopology& wanted) const {
    const Result<ObjLines> lines = pattern_on_sheet(surface, cell_of(wanted.shape), wanted.width, where + "/pattern");
    if (!lines) return lines.error();
    return drawn_network(surface, lines.value(), kEverywhere, where + "/pattern");
  }
  Result<SurfaceNetwork> operator()(const DrawnTopology&) const {
    LISSOM_ASSERT(drawn.has_value());
    return drawn_network(surface, *drawn, kCorner, where + "/lines");
  }
};

}  // namespace

Result<SurfaceNetwork> lay_out(const Surface& surface, const Topology& topology, const MeshRods& rods,
                               const std::optional<ObjLines>& drawn, const std::string& where, const Context& context) {
  Result<SurfaceNetwork> network = std::visit(LayOut{surface, drawn, where, context}, topology);
  if (!network) return network;
  if (Status s = find_paths(surface, network.value(), where); !s) return s.error();
  const NetworkOptions options{rods.shortest, rods.valence};
  if (Status s = merge_short_lines(surface, network.value(), options, where); !s) return s.error();
  if (Status s = check_network(surface, network.value(), where); !s) return s.error();
  return network;
}

}  // namespace lissom
