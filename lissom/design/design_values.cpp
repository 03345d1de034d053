#include "lissom/design/design_values.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <utility>

#include "lissom/core/assert.h"
#include "lissom/design/redrawn.h"
#include "lissom/design/reshaped.h"
#include "lissom/design/shared_materials.h"
#include "lissom/mechanics/load_numbers.h"
#include "lissom/mechanics/rest_numbers.h"

namespace lissom {

namespace {

Error shared(const char* where, const std::string& what) {
  return {ErrorCode::kUnsupported, where, what + " is described by the plan, together with others",
          "use the parameters of the plan"};
}

/// Control values of a profile whose values at the middles of edges are given: two to an edge, so that every middle is one.
std::vector<double> profile(const std::vector<double>& at_edges, bool closed) {
  const std::size_t n = at_edges.size();
  std::vector<double> values(2 * n + (closed ? 0 : 1));
  for (std::size_t k = 0; k < n; ++k) {
    values[2 * k + 1] = at_edges[k];
    values[2 * k] = k == 0 && !closed ? at_edges[0] : 0.5 * (at_edges[k] + at_edges[k > 0 ? k - 1 : n - 1]);
  }
  if (!closed) values.back() = at_edges.back();
  return values;
}

/// What changes from the inputs `before` to those `after`.
class Change {
 public:
  Change(Design& design, const VecX& before, const VecX& after)
      : model_(design.model),
        structure_(design.system.structure),
        before_(before),
        after_(after),
        inputs_(structure_) {}

  Status make() {
    if (Status s = sections(); !s) return s;
    if (Status s = natural_shapes(); !s) return s;
    if (Status s = rod_moduli(); !s) return s;
    if (Status s = membranes(); !s) return s;
    const Eigen::Index places = 3 * static_cast<Eigen::Index>(structure_.nodes.size());
    if (before_.head(places) == after_.head(places)) return {};
    if (Status s = check_redrawable(model_, structure_); !s) return s;
    return redraw(model_, structure_, after_.head(places));
  }

 private:
  bool differs(int input) const { return before_[input] != after_[input]; }
  bool planned_rod(std::size_t r) const { return r >= model_.rods.size(); }
  bool planned_membrane(std::size_t m) const { return m >= model_.membranes.size(); }

  Status sections() {
    for (std::size_t r = 0; r < structure_.rods.size(); ++r) {
      const StructureRod& rod = structure_.rods[r];
      for (int axis = 0; axis < 2; ++axis) {
        const auto input = [&](int edge) { return axis == 0 ? inputs_.extent_n(edge) : inputs_.extent_b(edge); };
        bool any = false;
        for (const int e : rod.edges) any = any || differs(input(e));
        if (!any) continue;
        if (planned_rod(r)) return shared("/plan", fmt::format("the section of rod \"{}\"", rod.name));
        if (Status s = section(r, axis, input); !s) return s;
      }
    }
    return {};
  }

  template <class Input>
  Status section(std::size_t r, int axis, const Input& input) {
    const StructureRod& rod = structure_.rods[r];
    SectionProfile& section = model_.rods[r].section;
    std::vector<double> here, other;
    for (const int e : rod.edges) {
      Section& own = structure_.edges[static_cast<std::size_t>(e)].section;
      const double value = after_[input(e)];
      if (!(value > 0)) {
        return Error{ErrorCode::kRange, "/rods", fmt::format("a radius of rod \"{}\" would be {:g} m", rod.name, value),
                     "raise the lower bounds of the radii"};
      }
      (axis == 0 ? own.r_n : own.r_b) = value;
      here.push_back(value);
      other.push_back(axis == 0 ? own.r_b : own.r_n);
    }
    (axis == 0 ? section.r_n : section.r_b) = profile(here, rod.closed);
    (axis == 0 ? section.r_b : section.r_n) = profile(other, rod.closed);
    return {};
  }

  Status natural_shapes() {
    for (std::size_t r = 0; r < structure_.rods.size(); ++r) {
      StructureRod& rod = structure_.rods[r];
      const int number = static_cast<int>(r), rate = inputs_.natural_rate(number, 0);
      const bool rates = before_.segment<3>(rate) != after_.segment<3>(rate);
      if (!rates && !differs(inputs_.length_factor(number))) continue;
      if (planned_rod(r)) return shared("/plan", fmt::format("the natural shape of rod \"{}\"", rod.name));
      if (Status s = natural_shape(r, after_[inputs_.length_factor(number)], after_.segment<3>(rate)); !s) return s;
    }
    return {};
  }

  Status natural_shape(std::size_t r, double length_factor, const Vec3& rates);
  Status rod_moduli();
  Status membranes();

  Model& model_;
  Structure& structure_;
  const VecX &before_, &after_;
  RestInputs inputs_;
};

Status Change::natural_shape(std::size_t r, double length_factor, const Vec3& rates) {
  StructureRod& rod = structure_.rods[r];
  Natural& natural = model_.rods[r].natural;
  double longest = 0;
  for (const int e : rod.edges) {
    longest = std::max(longest, structure_.edges[static_cast<std::size_t>(e)].rest_length / rod.length_factor);
  }
  if (!(length_factor > 0)) {
    return Error{
        ErrorCode::kRange, "/rods",
        fmt::format("the natural length of rod \"{}\" would be {:g} times the drawn one", rod.name, length_factor),
        "raise the lower bound of the factor"};
  }
  if (rod.natural_rates) {
    const double most = std::numbers::pi / 2;
    if (std::hypot(rates[0], rates[1]) * length_factor * longest > most ||
        std::abs(rates[2]) * length_factor * longest > most) {
      return Error{
          ErrorCode::kGeometry, "/rods",
          fmt::format("the natural curvature or twist of rod \"{}\" turns by more than 90 degrees per edge", rod.name),
          "use shorter edges or narrower bounds"};
    }
    if (!rates.isZero(0)) natural.kind = Natural::Kind::kCurved;
    natural.curvature_b = rates[0];
    natural.curvature_n = rates[1];
    natural.twist = rates[2];
  }
  natural.length_factor = length_factor;
  reshape(structure_, static_cast<int>(r), length_factor, rates);
  return {};
}

Status Change::rod_moduli() {
  const auto modulus = [&](int r) { return after_[inputs_.youngs_modulus(r)]; };
  return share_out(
      model_.materials, structure_.rods, [&](const std::string& name) { return model_.material(name); },
      [&](int r) { return differs(inputs_.youngs_modulus(r)); }, [&](int a, int b) { return modulus(a) == modulus(b); },
      [&](Material& material, int r) { material.youngs_modulus = modulus(r); },
      [&](int r, const std::string& name) -> Status {
        if (planned_rod(static_cast<std::size_t>(r))) {
          return shared("/plan", fmt::format("the material of rod \"{}\"", structure_.rods[r].name));
        }
        structure_.rods[r].material = model_.rods[static_cast<std::size_t>(r)].material = name;
        return {};
      });
}

Status Change::membranes() {
  using Four = Eigen::Vector4d;  // stiffnesses, Poisson's ratio, thickness
  const auto numbers = [&](const VecX& inputs, int m) -> Four {
    return inputs.segment<4>(inputs_.sheet_stiffness(m, 0));
  };
  for (int m = 0; m < static_cast<int>(structure_.membranes.size()); ++m) {
    const Vec2 stretch = after_.segment<2>(inputs_.pre_stretch(m, 0));
    if (stretch == before_.segment<2>(inputs_.pre_stretch(m, 0))) continue;
    if (!(stretch.minCoeff() > 0)) {
      return Error{ErrorCode::kRange, "/membranes",
                   fmt::format("the pre-stretch of membrane \"{}\" would be {:g} and {:g}",
                               structure_.membranes[m].name, stretch[0], stretch[1]),
                   "raise the lower bounds of the pre-stretch"};
    }
    structure_.membranes[m].pre_stretch = stretch;
    (planned_membrane(static_cast<std::size_t>(m)) ? model_.plan->fabric.pre_stretch
                                                   : model_.membranes[static_cast<std::size_t>(m)].pre_stretch) =
        stretch;
  }
  return share_out(
      model_.membrane_materials, structure_.membranes,
      [&](const std::string& name) { return model_.membrane_material(name); },
      [&](int m) { return numbers(before_, m) != numbers(after_, m); },
      [&](int a, int b) { return numbers(after_, a) == numbers(after_, b); },
      [&](MembraneMaterial& material, int m) {
        const Four four = numbers(after_, m);
        material.stiffness_1 = four[0];
        material.stiffness_2 = four[1];
        material.poisson_ratio = four[2];
        material.thickness = four[3];
      },
      [&](int m, const std::string& name) -> Status {
        structure_.membranes[m].material = name;
        (planned_membrane(static_cast<std::size_t>(m)) ? model_.plan->fabric.material
                                                       : model_.membranes[static_cast<std::size_t>(m)].material) = name;
        return {};
      });
}

void set_pose(Pose& pose, const Structure& structure, const PoseValues& values) {
  const LoadNumbers numbers(pose, structure);
  LISSOM_ASSERT(values.loads.size() == numbers.size());
  const auto three = [&](int first) -> Vec3 { return values.loads.segment<3>(first); };
  const auto count = [](const auto& list) { return static_cast<int>(list.size()); };
  if (pose.gravity) pose.gravity->acceleration = three(numbers.gravity());
  for (int i = 0; i < count(pose.line_loads); ++i) pose.line_loads[i].force_per_length = three(numbers.line_load(i));
  for (int i = 0; i < count(pose.edge_loads); ++i) pose.edge_loads[i].force_per_length = three(numbers.edge_load(i));
  for (int i = 0; i < count(pose.forces); ++i) pose.forces[i].force = three(numbers.force(i));
  for (int i = 0; i < count(pose.moments); ++i) pose.moments[i].moment = three(numbers.moment(i));
  for (int i = 0; i < count(pose.soft_pins); ++i) {
    pose.soft_pins[i].stiffness = values.loads[numbers.pin_stiffness(i)];
    if (pose.soft_pins[i].target) pose.soft_pins[i].target = three(numbers.pin_target(i));
  }
  for (int i = 0; i < count(pose.supports); ++i) pose.supports[i].move = values.moves.segment<3>(3 * i);
}

}  // namespace

DesignValues values_of(const Design& design) {
  DesignValues values{rest_input_values(design.model, design.system), {}};
  for (const Pose& pose : design.model.poses) {
    PoseValues own{load_number_values(pose, design.system.structure), VecX(3 * static_cast<int>(pose.supports.size()))};
    for (int i = 0; i < static_cast<int>(pose.supports.size()); ++i)
      own.moves.segment<3>(3 * i) = pose.supports[i].move;
    values.poses.push_back(std::move(own));
  }
  return values;
}

Result<Design> with_values(Design design, const DesignValues& values) {
  const VecX present = rest_input_values(design.model, design.system);
  LISSOM_ASSERT(values.inputs.size() == present.size() && values.poses.size() == design.model.poses.size());
  bool finite = values.inputs.allFinite();
  for (const PoseValues& pose : values.poses) finite = finite && pose.loads.allFinite() && pose.moves.allFinite();
  if (!finite) {
    return Error{ErrorCode::kRange, "/parameters", "a number of the design is not finite", "give finite parameters"};
  }
  for (std::size_t k = 0; k < values.poses.size(); ++k) {
    set_pose(design.model.poses[k], design.system.structure, values.poses[k]);
  }
  if (values.inputs == present) return design;
  if (!design.system.structure.solids.empty()) {
    return Error{ErrorCode::kUnsupported, "/solids", "only the loads of a structure with solids can be designed",
                 "let a solid pose the surface, and design the rods on it in a document of their own"};
  }
  if (Status s = Change(design, present, values.inputs).make(); !s) return s.error();
  Result<System> system = make_system(design.model, std::move(design.system.structure));
  if (!system) return system.error();
  design.system = std::move(system).value();
  return design;
}

}  // namespace lissom
