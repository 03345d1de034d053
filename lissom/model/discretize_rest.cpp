#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "lissom/model/discretize_parts.h"
#include "lissom/model/natural_formulas.h"
#include "lissom/model/sampling.h"

namespace lissom {

namespace {

/// Strain of constant natural curvature and twist over a drawn length.
PairStrain natural_strain(const Natural& natural, double drawn) {
  if (natural.kind == Natural::Kind::kStraight) return {};
  const double length = natural.length_factor * drawn;
  const Curvature<double> k = natural_curvature<double>(natural.curvature_b, natural.curvature_n, length);
  return {k.kappa_1, k.kappa_2, natural.twist * length};
}

/// `longest`: m, of the edges at rest.
Status check_natural(const Natural& natural, double longest, const std::string& where) {
  if (!std::isfinite(natural.curvature_b) || !std::isfinite(natural.curvature_n) || !std::isfinite(natural.twist)) {
    return Error{ErrorCode::kRange, where, "the natural curvature or twist is not finite", "give finite numbers"};
  }
  const double most = std::numbers::pi / 2;
  if (std::hypot(natural.curvature_b, natural.curvature_n) * longest > most ||
      std::abs(natural.twist) * longest > most) {
    return Error{ErrorCode::kGeometry, where, "the natural curvature or twist turns by more than 90 degrees per edge",
                 "use shorter edges"};
  }
  return {};
}

/// Samples the natural curve of a rod into its edges, with frames.
Status set_rest_curve(Draft& draft, size_t r) {
  const Rod& rod = draft.model.rods[r];
  const RodShape& drawn = draft.drawn[r];
  const std::string where = rod_place(r) + "/natural";
  if (!rod.natural.curve) {
    return Error{ErrorCode::kConflict, where, "the natural shape is a curve, but none is given", "describe the curve"};
  }
  if (drawn.closed && !is_closed(*rod.natural.curve)) {
    return Error{ErrorCode::kConflict, where, "the rod is closed but its natural curve is open",
                 "close the natural curve, or cut the rod and join its ends"};
  }
  const MaterialAxes& axes = rod.natural.axes ? *rod.natural.axes : rod.axes;
  if (axes.kind == MaterialAxes::Kind::kJoints) {
    return Error{ErrorCode::kConflict, where, "a natural curve has no joints that could give its material axes",
                 "give the natural curve axes of its own"};
  }
  Result<CurveSamples> cut = sample(*rod.natural.curve, drawn.edges(), where + "/curve");
  if (!cut) return cut.error();
  CurveSamples samples = std::move(cut).value();
  RodShape& rest = draft.rest[r];
  rest.points = std::move(samples.points);
  rest.node_tangents = std::move(samples.tangents);
  rest.closed = samples.closed;
  const std::string label = "natural curve of " + rod_label(draft.model, r);
  if (Status s = measure_edges(rest, where, label); !s) return s;
  set_frames(rest, axes, Vec3::Zero(), Vec3::Zero(), label, draft.structure.notes);
  return {};
}

/// StructureEdge::natural_normal of all edges of a rod, or nothing.
std::vector<Vec3> natural_normals(const Rod& rod, const RodShape& drawn) {
  if (rod.natural.kind != Natural::Kind::kAsDrawn) return {};
  std::vector<Vec3> normals = directions_of_normals(drawn, rod.axes);
  for (size_t i = 0; i < normals.size(); ++i) {
    if (parallel(drawn.edge_tangents[i], normals[i])) return {};
    normals[i].normalize();
  }
  return normals;
}

}  // namespace

Status set_rest_shapes(Draft& draft) {
  Structure& s = draft.structure;
  draft.rest.resize(draft.drawn.size());
  for (size_t r = 0; r < draft.drawn.size(); ++r) {
    const Natural& natural = draft.model.rods[r].natural;
    const RodShape& drawn = draft.drawn[r];
    if (!(natural.length_factor > 0) || !std::isfinite(natural.length_factor)) {
      return Error{ErrorCode::kRange, rod_place(r) + "/natural",
                   fmt::format("the natural length is {:g} times the drawn one", natural.length_factor),
                   "give a positive factor"};
    }
    if (natural.kind == Natural::Kind::kCurve) {
      if (Status status = set_rest_curve(draft, r); !status) return status;
    } else if (natural.kind == Natural::Kind::kCurved) {
      double longest = 0;
      for (double length : drawn.lengths) longest = std::max(longest, natural.length_factor * length);
      if (Status status = check_natural(natural, longest, rod_place(r) + "/natural"); !status) return status;
    }
    s.rods[r].length_factor = natural.length_factor;
    if (natural.kind == Natural::Kind::kStraight || natural.kind == Natural::Kind::kCurved) {
      const bool straight = natural.kind == Natural::Kind::kStraight;
      s.rods[r].natural_rates =
          straight ? Vec3(Vec3::Zero()) : Vec3(natural.curvature_b, natural.curvature_n, natural.twist);
    }
    const std::vector<Vec3> normals = natural_normals(draft.model.rods[r], drawn);
    const RodShape& measured = draft.rest[r].lengths.empty() ? drawn : draft.rest[r];
    for (size_t i = 0; i < drawn.lengths.size(); ++i) {
      StructureEdge& edge = s.edges[static_cast<size_t>(s.rods[r].edges[i])];
      edge.rest_length = natural.length_factor * measured.lengths[i];
      if (!normals.empty()) edge.natural_normal = normals[i];
      if (natural.kind == Natural::Kind::kAsDrawn || natural.kind == Natural::Kind::kCurve) {
        edge.rest = measured.frames[i];
      } else if (i == 0) {
        edge.rest = edge.drawn;
      } else {
        const double between = (drawn.lengths[i - 1] + drawn.lengths[i]) / 2;
        edge.rest =
            advanced(s.edges[static_cast<size_t>(s.rods[r].edges[i - 1])].rest, natural_strain(natural, between));
      }
    }
  }
  return {};
}

PairStrain rest_strain(const Draft& draft, int rod, int edge, int next) {
  const auto r = static_cast<size_t>(rod), i = static_cast<size_t>(edge), j = static_cast<size_t>(next);
  const Natural& natural = draft.model.rods[r].natural;
  switch (natural.kind) {
    case Natural::Kind::kAsDrawn:
      return pair_strain(draft.drawn[r].frames[i], draft.drawn[r].frames[j]);
    case Natural::Kind::kCurve:
      return pair_strain(draft.rest[r].frames[i], draft.rest[r].frames[j]);
    case Natural::Kind::kStraight:
    case Natural::Kind::kCurved:
      break;
  }
  return natural_strain(natural, (draft.drawn[r].lengths[i] + draft.drawn[r].lengths[j]) / 2);
}

Frame connection_rest(const Draft& draft, int rod, int edge, bool at_end) {
  const auto r = static_cast<size_t>(rod), i = static_cast<size_t>(edge);
  const Natural& natural = draft.model.rods[r].natural;
  const RodShape& drawn = draft.drawn[r];
  if (natural.kind == Natural::Kind::kAsDrawn) return drawn.frames[i];
  const Frame node = node_frame(drawn, edge, at_end);
  if (natural.kind == Natural::Kind::kCurve) {
    const Frame rest = node_frame(draft.rest[r], edge, at_end);
    const Mat3 turn = node.t * rest.t.transpose() + node.b * rest.b.transpose() + node.n * rest.n.transpose();
    return rotated(turn, draft.rest[r].frames[i]);
  }
  PairStrain half = natural_strain(natural, drawn.lengths[i] / 2);
  if (at_end) half = {-half.kappa_1, -half.kappa_2, -half.twist};
  return advanced(node, half);
}

}  // namespace lissom
