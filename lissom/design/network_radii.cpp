#include "lissom/design/network_radii.h"

#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "lissom/core/assert.h"
#include "lissom/mechanics/rest_numbers.h"

namespace lissom {

namespace {

constexpr double kBeyondControls = 0.125;  // of the range [mathematics 6.1]
constexpr double kScale = 0.1;             // of the range: a change that is felt

}  // namespace

Result<NetworkRadii> NetworkRadii::make(const Model& model, const Structure& structure, ControlStage stage,
                                        const Vec2& range) {
  if (model.plan || model.rods.size() != structure.rods.size()) {
    return Error{ErrorCode::kUnsupported, "/rods", "rods that a plan or a drawing describes have their radii there",
                 "give the rods one by one, or use the control points of the plan"};
  }
  if (!(range[0] > 0 && range[0] < range[1] && std::isfinite(range[1]))) {
    return Error{ErrorCode::kRange, "/rods",
                 fmt::format("the range of radii is from {:g} to {:g} mm", 1e3 * range[0], 1e3 * range[1]),
                 "give a positive lower and a larger upper bound"};
  }
  const double least = range[0] - kBeyondControls * (range[1] - range[0]);
  if (stage != ControlStage::kEnds && !(least > 0)) {
    return Error{ErrorCode::kRange, "/rods",
                 fmt::format("radii between controls of {:g} and {:g} mm can fall to {:.2g} mm", 1e3 * range[0],
                             1e3 * range[1], 1e3 * least),
                 "raise the lower bound above an eighth of the range, or lower the upper one"};
  }
  for (const Rod& rod : model.rods) {
    if (rod.section.shape != SectionShape::kTube) continue;
    return Error{ErrorCode::kUnsupported, "/rods", fmt::format("rod \"{}\" is a tube", rod.name),
                 "use a solid section: the wall of a tube is not a parameter"};
  }
  Result<RodControls> controls = RodControls::make(structure, stage);
  if (!controls) return controls.error();
  NetworkRadii out(std::move(controls).value());
  out.weights_ = out.controls_.edge_weights(structure);
  for (const StructureRod& rod : structure.rods) out.rod_edges_.push_back(rod.edges);
  for (int axis = 0; axis < 2; ++axis) {
    for (int c = 0; c < out.controls_.size(); ++c) {
      out.parameters_.push_back(
          {ParameterKind::kRadius, fmt::format("{}: {}", out.controls_.name(c, structure), axis == 0 ? "r_n" : "r_b"),
           range[0], range[1], kScale * (range[1] - range[0]), out.controls_.place(c, structure), axis});
    }
  }
  return out;
}

VecX NetworkRadii::constant(double r_n, double r_b) const {
  VecX p(size());
  p << VecX::Constant(controls_.size(), r_n), VecX::Constant(controls_.size(), r_b);
  return p;
}

MatX NetworkRadii::edge_extents(const VecX& p) const {
  LISSOM_ASSERT(p.size() == size());
  MatX extents(weights_.rows(), 2);
  extents.col(0) = weights_ * p.head(controls_.size());
  extents.col(1) = weights_ * p.tail(controls_.size());
  return extents;
}

Result<Model> NetworkRadii::model_at(const Model& model, const VecX& p) const {
  LISSOM_ASSERT(p.size() == size() && model.rods.size() == rod_edges_.size());
  if (Status s = check_bounds(parameters_, p); !s) return s.error();
  const MatX extents = edge_extents(p);
  Model changed = model;
  for (std::size_t r = 0; r < rod_edges_.size(); ++r) {
    // A profile is linear between even places: with two to an edge every middle of an edge is one of them.
    const std::vector<int>& edges = rod_edges_[r];
    const int n = static_cast<int>(edges.size());
    SectionProfile& section = changed.rods[r].section;
    for (int axis = 0; axis < 2; ++axis) {
      std::vector<double>& values = axis == 0 ? section.r_n : section.r_b;
      values.assign(2 * static_cast<std::size_t>(n) + 1, 0);
      for (int k = 0; k < n; ++k) values[2 * k + 1] = extents(edges[k], axis);
      values.front() = values[1];
      values.back() = values[2 * n - 1];
      for (int k = 1; k < n; ++k) values[2 * k] = 0.5 * (values[2 * k - 1] + values[2 * k + 1]);
    }
  }
  return changed;
}

SparseMatrix NetworkRadii::rest_inputs(const Structure& structure) const {
  LISSOM_ASSERT(static_cast<int>(structure.edges.size()) == weights_.rows());
  const RestInputs inputs(structure);
  const int controls = controls_.size();
  std::vector<Eigen::Triplet<double>> entries;
  for (int c = 0; c < weights_.outerSize(); ++c) {
    for (SparseMatrix::InnerIterator it(weights_, c); it; ++it) {
      const int edge = static_cast<int>(it.row()), control = static_cast<int>(it.col());
      entries.emplace_back(inputs.extent_n(edge), control, it.value());
      entries.emplace_back(inputs.extent_b(edge), controls + control, it.value());
    }
  }
  SparseMatrix jacobian(inputs.size(), size());
  jacobian.setFromTriplets(entries.begin(), entries.end());
  return jacobian;
}

VecX NetworkRadii::prolonged(const VecX& p, const NetworkRadii& finer) const {
  LISSOM_ASSERT(p.size() == size());
  const SparseMatrix map = controls_.prolongation(finer.controls_);
  VecX fine(finer.size());
  fine << map * p.head(controls_.size()), map * p.tail(controls_.size());
  return fine;
}

Result<LinearSpace> radii_space(std::shared_ptr<const Design> base, ControlStage stage, const Vec2& range) {
  const Structure& structure = base->system.structure;
  const Result<NetworkRadii> made = NetworkRadii::make(base->model, structure, stage, range);
  if (!made) return made.error();
  const NetworkRadii& radii = made.value();
  const SparseMatrix weights = radii.controls().edge_weights(structure);
  const int controls = radii.controls().size(), edges = static_cast<int>(structure.edges.size());
  VecX start(radii.size());
  for (int axis = 0; axis < 2; ++axis) {
    VecX extents(edges);
    for (int e = 0; e < edges; ++e) {
      const Section& section = structure.edges[static_cast<std::size_t>(e)].section;
      extents[e] = axis == 0 ? section.r_n : section.r_b;
    }
    start.segment(axis * controls, controls) =
        least_squares(weights, extents, VecX::Constant(controls, extents.mean()));
  }
  start = start.cwiseMax(range[0]).cwiseMin(range[1]);
  return LinearSpace::make(std::move(base), {radii.parameters().begin(), radii.parameters().end()}, std::move(start),
                           {radii.rest_inputs(structure), {}}, LinearSpace::Offset::kZero);
}

}  // namespace lissom
