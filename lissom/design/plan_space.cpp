#include "lissom/design/plan_space.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "lissom/core/nearest_name.h"
#include "lissom/mechanics/rest_numbers.h"

namespace lissom {

namespace {

constexpr int kBothAxes = 2;
constexpr double kRadiusScale = 0.1;     // of the radius
constexpr double kPositionScale = 0.01;  // of the size of the plan
constexpr double kPreStretchScale = 0.05;

using Triplets = std::vector<Eigen::Triplet<double>>;

double plan_size(const Plan& plan) {
  Eigen::AlignedBox2d box;
  for (const PlanPoint& point : plan.points) box.extend(point.at);
  return box.diagonal().norm();
}

double& radius(PlanPoint& point, int axis) { return axis == 0 ? point.r_n : point.r_b; }
double radius(const PlanPoint& point, int axis) { return axis == 0 ? point.r_n : point.r_b; }

/// Points that printed rods run through.
std::vector<bool> printed_points(const Plan& plan) {
  std::vector<bool> printed(plan.points.size(), false);
  for (const PlanRod& rod : plan.rods) {
    if (rod.role == PlanRole::kGhost) continue;
    for (const int i : rod.points) printed[static_cast<std::size_t>(i)] = true;
  }
  return printed;
}

Result<std::vector<bool>> chosen_points(const Plan& plan, const std::vector<std::string>& names) {
  std::vector<bool> chosen(plan.points.size(), names.empty());
  for (const std::string& name : names) {
    const auto found = std::find_if(plan.points.begin(), plan.points.end(),
                                    [&](const PlanPoint& point) { return point.name == name; });
    if (found == plan.points.end()) {
      std::vector<std::string> known;
      for (const PlanPoint& point : plan.points) known.push_back(point.name);
      return Error{ErrorCode::kUnknown, "/plan/points", fmt::format("there is no control point \"{}\"", name),
                   suggestion(name, known)};
    }
    chosen[static_cast<std::size_t>(found - plan.points.begin())] = true;
  }
  return chosen;
}

Status check_range(const Vec2& range, const char* what) {
  if (range[0] > 0 && range[0] < range[1] && std::isfinite(range[1])) return {};
  return Error{ErrorCode::kRange, "/plan",
               fmt::format("the range of {} is from {:g} to {:g}", what, range[0], range[1]),
               "give a positive lower and a larger upper bound"};
}

}  // namespace

Result<PlanSpace> PlanSpace::make(const Model& model, const PlanSpaceOptions& options) {
  if (!model.plan) {
    return Error{ErrorCode::kConflict, "/plan", "there is no plan whose control points could be parameters",
                 "describe the structure by a plan"};
  }
  const Plan& plan = *model.plan;
  if (Status s = check_range(options.radius_range, "radii"); !s) return s.error();
  if (Status s = check_range(options.pre_stretch_range, "pre-stretch"); !s) return s.error();
  if (!(options.reach > 0) || !std::isfinite(options.reach)) {
    return Error{ErrorCode::kRange, "/plan", fmt::format("control points may move by {:g} sizes", options.reach),
                 "give a positive reach"};
  }
  const Result<std::vector<bool>> chosen = chosen_points(plan, options.points);
  if (!chosen) return chosen.error();
  const std::vector<bool> printed = printed_points(plan);
  const double size = plan_size(plan);

  PlanSpace space;
  const auto add = [&](Slot slot, std::string name, double value, const Vec2& range, double scale) {
    space.slots_.push_back(slot);
    space.parameters_.push_back(
        {slot.kind, std::move(name), std::min(range[0], value), std::max(range[1], value), scale});
    if (slot.point < 0) return;
    const Vec2& at = plan.points[static_cast<std::size_t>(slot.point)].at;
    space.parameters_.back().at = Vec3(at.x(), at.y(), 0);
    space.parameters_.back().axis = slot.axis;
  };
  for (std::size_t i = 0; i < plan.points.size() && options.radii == Choice::kFree; ++i) {
    if (!chosen.value()[i] || !printed[i]) continue;
    for (int axis = 0; axis < 2; ++axis) {
      const double value = radius(plan.points[i], axis);
      add({ParameterKind::kRadius, static_cast<int>(i), axis},
          fmt::format("point \"{}\": {}", plan.points[i].name, axis == 0 ? "r_n" : "r_b"), value, options.radius_range,
          kRadiusScale * value);
    }
  }
  for (std::size_t i = 0; i < plan.points.size() && options.positions == Choice::kFree; ++i) {
    if (!chosen.value()[i]) continue;
    for (int axis = 0; axis < 2; ++axis) {
      const double value = plan.points[i].at[axis], reach = options.reach * size;
      add({ParameterKind::kPosition, static_cast<int>(i), axis},
          fmt::format("point \"{}\": {}", plan.points[i].name, axis == 0 ? "x" : "y"), value,
          {value - reach, value + reach}, kPositionScale * size);
    }
  }
  const Vec2& s = plan.fabric.pre_stretch;
  if (options.pre_stretch == PreStretchChoice::kCommon) {
    add({ParameterKind::kPreStretch, -1, kBothAxes}, "pre-stretch", s[0], options.pre_stretch_range, kPreStretchScale);
  } else if (options.pre_stretch == PreStretchChoice::kPerAxis) {
    add({ParameterKind::kPreStretch, -1, 0}, "pre-stretch along the warp", s[0], options.pre_stretch_range,
        kPreStretchScale);
    add({ParameterKind::kPreStretch, -1, 1}, "pre-stretch across the warp", s[1], options.pre_stretch_range,
        kPreStretchScale);
  }
  return space;
}

VecX PlanSpace::values(const Plan& plan) const {
  VecX p(size());
  for (int k = 0; k < size(); ++k) {
    const Slot& slot = slots_[static_cast<std::size_t>(k)];
    if (slot.kind == ParameterKind::kPreStretch) {
      p[k] = plan.fabric.pre_stretch[slot.axis == kBothAxes ? 0 : slot.axis];
      continue;
    }
    const PlanPoint& point = plan.points[static_cast<std::size_t>(slot.point)];
    p[k] = slot.kind == ParameterKind::kRadius ? radius(point, slot.axis) : point.at[slot.axis];
  }
  return p;
}

Result<Model> PlanSpace::model_at(const Model& model, const VecX& p) const {
  LISSOM_ASSERT(model.plan && p.size() == size());
  Model changed = model;
  Plan& plan = *changed.plan;
  for (int k = 0; k < size(); ++k) {
    const Slot& slot = slots_[static_cast<std::size_t>(k)];
    const Parameter& parameter = parameters_[static_cast<std::size_t>(k)];
    if (!(p[k] >= parameter.lower && p[k] <= parameter.upper)) {
      return Error{ErrorCode::kRange, "/plan",
                   fmt::format("{} would be {:.6g} {}", parameter.name, p[k], si_unit(parameter.kind)),
                   fmt::format("keep it between {:.6g} and {:.6g}", parameter.lower, parameter.upper)};
    }
    if (slot.kind == ParameterKind::kPreStretch) {
      Vec2& s = plan.fabric.pre_stretch;
      if (slot.axis == kBothAxes)
        s *= p[k] / s[0];
      else
        s[slot.axis] = p[k];
      continue;
    }
    PlanPoint& point = plan.points[static_cast<std::size_t>(slot.point)];
    (slot.kind == ParameterKind::kRadius ? radius(point, slot.axis) : point.at[slot.axis]) = p[k];
  }
  return changed;
}

SparseMatrix PlanSpace::rest_inputs(const Model& model, const PlanMesh& mesh, const System& system) const {
  const Plan& plan = *model.plan;
  const Structure& structure = system.structure;
  const RestInputs inputs(structure);
  const int fabric = static_cast<int>(structure.membranes.size()) - 1;
  const std::vector<int>& node_of = structure.membranes[fabric].nodes;  // by vertex
  const std::size_t first_rod = structure.rods.size() - mesh.as_made().rods.size();

  std::vector<int> radius_slot[2], position_slot(2 * plan.points.size(), -1);
  for (auto& slots : radius_slot) slots.assign(plan.points.size(), -1);
  Triplets entries;
  for (int k = 0; k < size(); ++k) {
    const Slot& slot = slots_[static_cast<std::size_t>(k)];
    switch (slot.kind) {
      case ParameterKind::kRadius:
        radius_slot[slot.axis][static_cast<std::size_t>(slot.point)] = k;
        break;
      case ParameterKind::kPosition:
        position_slot[2 * static_cast<std::size_t>(slot.point) + static_cast<std::size_t>(slot.axis)] = k;
        break;
      case ParameterKind::kPreStretch: {
        const Vec2& s = plan.fabric.pre_stretch;
        if (slot.axis == kBothAxes) {
          entries.emplace_back(inputs.pre_stretch(fabric, 0), k, 1);
          entries.emplace_back(inputs.pre_stretch(fabric, 1), k, s[1] / s[0]);
        } else {
          entries.emplace_back(inputs.pre_stretch(fabric, slot.axis), k, 1);
        }
        break;
      }
      default:  // a plan has no others
        LISSOM_ASSERT(false);
    }
  }
  if (std::any_of(position_slot.begin(), position_slot.end(), [](int k) { return k >= 0; })) {
    const SparseMatrix places = mesh.map().position_jacobian(control_positions(plan));
    for (int column = 0; column < places.outerSize(); ++column) {
      const int k = position_slot[static_cast<std::size_t>(column)];
      if (k < 0) continue;
      for (SparseMatrix::InnerIterator entry(places, column); entry; ++entry) {
        const int row = static_cast<int>(entry.row());
        entries.emplace_back(inputs.position(node_of[row / 2]) + row % 2, k, entry.value());
      }
    }
  }
  for (int axis = 0; axis < 2; ++axis) {
    if (std::all_of(radius_slot[axis].begin(), radius_slot[axis].end(), [](int k) { return k < 0; })) continue;
    const SparseMatrix radii =
        mesh.map().radius_jacobian(control_radii(plan, axis == 0 ? &PlanPoint::r_n : &PlanPoint::r_b));
    // An edge has the mean of the radii at its two nodes.
    Eigen::SparseMatrix<double, Eigen::RowMajor> by_node = radii;
    for (std::size_t r = 0; r < mesh.as_made().rods.size(); ++r) {
      const std::vector<int>& vertices = mesh.as_made().rod_vertices[r];
      const std::vector<int>& edges = structure.rods[first_rod + r].edges;
      for (std::size_t i = 0; i < edges.size(); ++i) {
        const int row = axis == 0 ? inputs.extent_n(edges[i]) : inputs.extent_b(edges[i]);
        for (const std::size_t end : {i, (i + 1) % vertices.size()}) {
          for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator entry(by_node, vertices[end]); entry;
               ++entry) {
            const int k = radius_slot[axis][static_cast<std::size_t>(entry.col())];
            if (k >= 0) entries.emplace_back(row, k, 0.5 * entry.value());
          }
        }
      }
    }
  }
  SparseMatrix matrix(inputs.size(), size());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

VecX PlanSpace::curvature(const Model& model, const PlanMesh& mesh, const System& system, const VecX& y,
                          const VecX& v) const {
  VecX result = VecX::Zero(size());
  if (mesh.map().linear()) return result;
  const RestInputs inputs(system.structure);
  const std::vector<int>& node_of = system.structure.membranes.back().nodes;  // of the fabric, by vertex
  const MatX controls = control_positions(*model.plan);
  MatX on_vertices(mesh.map().vertices(), 2), along = MatX::Zero(controls.rows(), 2);
  for (int i = 0; i < mesh.map().vertices(); ++i) {
    for (int d = 0; d < 2; ++d) on_vertices(i, d) = y[inputs.position(node_of[static_cast<std::size_t>(i)]) + d];
  }
  const auto each_position = [&](const auto& f) {
    for (int k = 0; k < size(); ++k) {
      const Slot& slot = slots_[static_cast<std::size_t>(k)];
      if (slot.kind == ParameterKind::kPosition) f(k, slot.point, slot.axis);
    }
  };
  each_position([&](int k, int point, int axis) { along(point, axis) = v[k]; });
  const MatX change = mesh.map().position_curvature(controls, on_vertices, along);
  each_position([&](int k, int point, int axis) { result[k] = change(point, axis); });
  return result;
}

}  // namespace lissom
