#include "lissom/design/rest_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "lissom/core/nearest_name.h"
#include "lissom/design/redrawn.h"
#include "lissom/mechanics/rest_numbers.h"

namespace lissom {

namespace {

constexpr double kScale = 0.1;      // of the range: a change that is felt
constexpr double kStraight = 1e-9;  // of the length

using Triplets = std::vector<Eigen::Triplet<double>>;
using Fixed = std::vector<std::array<bool, 3>>;  // by control

/// The index of the place for which `measure` is largest; the first of equals.
template <class Measure>
std::size_t farthest(const std::vector<Vec3>& places, const Measure& measure) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < places.size(); ++i) {
    if (measure(places[i]) > measure(places[best]) * (1 + 1e-9)) best = i;
  }
  return best;
}

int largest_component(const Vec3& v) {
  int largest = 0;
  v.cwiseAbs().maxCoeff(&largest);
  return largest;
}

/// The six coordinates that hold the drawing in place. Chosen among the ends, which all stages share.
Fixed fixed_six(const RodControls& controls, const Structure& structure) {
  Fixed fixed(static_cast<std::size_t>(controls.size()), {false, false, false});
  std::vector<Vec3> ends;
  for (int c = 0; c < controls.ends(); ++c) ends.push_back(controls.place(c, structure));
  Vec3 middle = Vec3::Zero();
  for (const Vec3& end : ends) middle += end / static_cast<double>(ends.size());
  const std::size_t a = farthest(ends, [&](const Vec3& x) { return (x - middle).norm(); });
  const std::size_t b = farthest(ends, [&](const Vec3& x) { return (x - ends[a]).norm(); });
  const Vec3 line = ends[b] - ends[a];
  const std::size_t c = farthest(ends, [&](const Vec3& x) { return line.cross(x - ends[a]).norm(); });
  fixed[a] = {true, true, true};
  const int along = largest_component(line);
  for (int axis = 0; axis < 3; ++axis) fixed[b][static_cast<std::size_t>(axis)] = axis != along;
  // A straight structure has no plane: any direction across turns it about itself.
  const Vec3 normal = line.cross(ends[c] - ends[a]);
  if (c != a && c != b && normal.norm() > 0) {
    // Turning about the line moves the third end along the normal.
    fixed[c][static_cast<std::size_t>(largest_component(normal))] = true;
  }
  return fixed;
}

Result<int> straight_rod(const Design& base, const std::string& name) {
  const Structure& structure = base.system.structure;
  const int r = structure.rod_index(name);
  if (r < 0) {
    std::vector<std::string> known;
    for (const StructureRod& rod : structure.rods) known.push_back(rod.name);
    return Error{ErrorCode::kUnknown, "/rods", fmt::format("there is no rod \"{}\"", name), suggestion(name, known)};
  }
  const StructureRod& rod = structure.rods[static_cast<std::size_t>(r)];
  const Vec3 &start = structure.nodes[rod.nodes.front()], &end = structure.nodes[rod.nodes.back()];
  const double length = (end - start).norm();
  for (const int node : rod.nodes) {
    const Vec3 arm = structure.nodes[node] - start;
    if (!rod.closed && arm.cross(end - start).norm() <= kStraight * length * length) continue;
    return Error{ErrorCode::kUnsupported, "/rods", fmt::format("rod \"{}\" is not straight", name),
                 "change the rest shape of curved rods by its controls"};
  }
  std::vector<bool> own(structure.nodes.size(), false);
  for (std::size_t k = 1; k < rod.nodes.size(); ++k) own[rod.nodes[k]] = true;
  for (const StructureRod& other : structure.rods) {
    if (&other == &rod) continue;
    for (const int node : other.nodes) {
      if (!own[node]) continue;
      return Error{ErrorCode::kUnsupported, "/rods",
                   fmt::format("rod \"{}\" is met by rod \"{}\" away from its start", name, other.name),
                   "turn the rod around, or change the rest shape by its controls"};
    }
  }
  return r;
}

}  // namespace

Result<LinearSpace> rest_shape_space(std::shared_ptr<const Design> base, const RestShapeOptions& options) {
  const Structure& structure = base->system.structure;
  if (Status s = check_redrawable(base->model, structure); !s) return s.error();
  if (!(options.reach > 0) || !std::isfinite(options.reach)) {
    return Error{ErrorCode::kRange, "/rods",
                 fmt::format("controls of the rest shape may move by {:g} m", options.reach), "give a positive reach"};
  }
  for (const Pose& pose : base->model.poses) {
    for (const Support& support : pose.supports) {
      if (support.kind != SupportKind::kClampEdge) continue;
      return Error{ErrorCode::kUnsupported, "pose \"" + pose.name + "\"",
                   "a support clamps whole edges, whose roll would turn with the rest shape",
                   "use hold \"clamp\" there"};
    }
  }
  const Result<RodControls> made = RodControls::make(structure, options.stage);
  if (!made) return made.error();
  const RodControls& controls = made.value();
  const SparseMatrix weights = controls.node_weights(structure);
  const Fixed fixed = options.gauge == RestShapeGauge::kFixSix
                          ? fixed_six(controls, structure)
                          : Fixed(static_cast<std::size_t>(controls.size()), {false, false, false});
  std::vector<Parameter> parameters;
  Triplets entries;
  for (int c = 0; c < controls.size(); ++c) {
    for (int axis = 0; axis < 3; ++axis) {
      if (fixed[static_cast<std::size_t>(c)][static_cast<std::size_t>(axis)]) continue;
      const int column = static_cast<int>(parameters.size());
      parameters.push_back({ParameterKind::kDisplacement,
                            fmt::format("{}: move along {}", controls.name(c, structure), "xyz"[axis]), -options.reach,
                            options.reach, kScale * 2 * options.reach, controls.place(c, structure), axis});
      for (SparseMatrix::InnerIterator it(weights, c); it; ++it) {
        entries.emplace_back(3 * static_cast<int>(it.row()) + axis, column, it.value());
      }
    }
  }
  LinearRows rows;
  rows.inputs.resize(RestInputs(structure).size(), static_cast<Eigen::Index>(parameters.size()));
  rows.inputs.setFromTriplets(entries.begin(), entries.end());
  VecX start = VecX::Zero(static_cast<Eigen::Index>(parameters.size()));
  return LinearSpace::make(std::move(base), std::move(parameters), std::move(start), std::move(rows),
                           LinearSpace::Offset::kBase);
}

Result<LinearSpace> straight_length_space(std::shared_ptr<const Design> base, const std::vector<std::string>& rods,
                                          const Vec2& factors) {
  const Structure& structure = base->system.structure;
  if (Status s = check_redrawable(base->model, structure); !s) return s.error();
  if (rods.empty() || !(factors[0] > 0 && factors[0] < factors[1] && std::isfinite(factors[1]))) {
    return Error{ErrorCode::kRange, "/rods",
                 rods.empty() ? "no rod is named whose length could change"
                              : fmt::format("lengths may be from {:g} to {:g} times as drawn", factors[0], factors[1]),
                 rods.empty() ? "name one" : "give a positive lower and a larger upper bound"};
  }
  std::vector<std::string> names = rods;
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  double unit = 1;  // of the parameter when lengths are as drawn
  Triplets entries;
  for (const std::string& name : names) {
    const Result<int> r = straight_rod(*base, name);
    if (!r) return r.error();
    const std::vector<int>& nodes = structure.rods[static_cast<std::size_t>(r.value())].nodes;
    const Vec3& start = structure.nodes[nodes.front()];
    if (names.size() == 1) unit = (structure.nodes[nodes.back()] - start).norm();
    for (std::size_t k = 1; k < nodes.size(); ++k) {
      const Vec3 arm = structure.nodes[nodes[k]] - start;
      for (int axis = 0; axis < 3; ++axis) {
        if (arm[axis] != 0) entries.emplace_back(3 * nodes[k] + axis, 0, arm[axis] / unit);
      }
    }
  }
  const bool single = names.size() == 1;
  std::vector<Parameter> parameters{{single ? ParameterKind::kLength : ParameterKind::kFactor,
                                     single ? fmt::format("rod \"{}\": length", names[0]) : "length of rods",
                                     factors[0] * unit, factors[1] * unit, kScale * (factors[1] - factors[0]) * unit}};
  LinearRows rows;
  rows.inputs.resize(RestInputs(structure).size(), 1);
  rows.inputs.setFromTriplets(entries.begin(), entries.end());
  return LinearSpace::make(std::move(base), std::move(parameters), VecX::Constant(1, unit), std::move(rows),
                           LinearSpace::Offset::kBase);
}

}  // namespace lissom
