#pragma once
/// All numbers and names of a model as text, every double by its bits: two models are the same when their texts are.

#include <array>
#include <bit>
#include <cstdint>
#include <string>

#include "lissom/model/model.h"

namespace lissom {

class ModelBits {
 public:
  static std::string of(const Model& model) {
    ModelBits bits;
    bits.add(model);
    return bits.text_;
  }

 private:
  void add(double x) { text_ += std::to_string(std::bit_cast<std::uint64_t>(x)) + ' '; }
  void add(int x) { text_ += std::to_string(x) + ' '; }
  void add(bool x) { text_ += x ? "yes " : "no "; }
  void add(const std::string& x) { text_ += '"' + x + "\" "; }
  void add(const Vec3& x) { add_all(x[0], x[1], x[2]); }
  void add(const Vec2& x) { add_all(x[0], x[1]); }
  template <class E>
  requires std::is_enum_v<E>
  void add(E x) { add(static_cast<int>(x)); }
  template <class T>
  void add(const std::optional<T>& x) {
    text_ += x ? "some " : "none ";
    if (x) add(*x);
  }
  template <class T>
  void add(const std::vector<T>& list) {
    text_ += std::to_string(list.size()) + ": ";
    for (const T& x : list) add(x);
  }
  void add(const Polyline& x) { add_all(x.points, x.closed); }
  void add(const Spline& x) { add_all(x.points, x.closed); }
  void add(const Arc& x) { add_all(x.centre, x.start, x.axis, x.angle, x.closed); }
  void add(const Helix& x) { add_all(x.centre, x.start, x.axis, x.pitch, x.turns); }
  void add(const Curve& x) {
    add(static_cast<int>(x.index()));
    std::visit([this](const auto& curve) { add(curve); }, x);
  }
  void add(const Material& x) {
    add_all(x.name, x.youngs_modulus, x.poisson_ratio, x.density, x.strain_limit, x.source);
  }
  void add(const SectionProfile& x) { add_all(x.shape, x.r_n, x.r_b, x.wall); }
  void add(const MaterialAxes& x) { add_all(x.kind, x.normal, x.normals); }
  void add(const Natural& x) {
    add_all(x.kind, x.curvature_b, x.curvature_n, x.twist, x.length_factor, x.curve, x.axes);
  }
  void add(const Rod& x) { add_all(x.name, x.curve, x.material, x.section, x.axes, x.natural, x.edges, x.edge_length); }
  void add(const NetworkFile& x) {
    add_all(x.name, x.file, x.unit, x.rods, x.chain_angle, x.edges_per_piece, x.rod_count, x.notes);
  }
  void add(const Selector& x) {
    add_all(x.kind, x.name, x.fraction, x.point, x.tolerance, x.low, x.high, x.rim, x.parts);
  }
  void add(const MembraneMaterial& x) {
    add_all(x.name, x.stiffness_1, x.stiffness_2, x.poisson_ratio, x.thickness, x.area_density, x.source);
  }
  void add(const MembraneGrid& x) { add_all(x.corner, x.size, x.cells_x, x.cells_y); }
  void add(const MembraneDisc& x) { add_all(x.centre, x.radius, x.inner_radius, x.rings, x.sectors); }
  void add(const MembraneTriangles& x) { add_all(x.corner, x.edge, x.columns, x.rows); }
  void add(const std::array<int, 3>& x) { add_all(x[0], x[1], x[2]); }
  void add(const std::array<int, 4>& x) { add_all(x[0], x[1], x[2], x[3]); }
  void add(const MembraneMesh& x) { add_all(x.points, x.triangles, x.stiffness, x.density); }
  void add(const Solid& x) { add_all(x.name, x.points, x.tetrahedra, x.material, x.stiffness, x.density); }
  void add(const Membrane& x) {
    add_all(x.name, static_cast<int>(x.shape.index()), x.material, x.pre_stretch, x.warp_angle, x.bending,
            x.rest_folds);
    std::visit([this](const auto& shape) { add(shape); }, x.shape);
  }
  void add(const StripPull& x) { add_all(x.angle, x.stretch, x.force_per_width, x.across); }
  void add(const FabricTest& x) { add_all(x.name, x.pulls); }
  void add(const JointChoice& x) { add_all(x.at, x.kind); }
  void add(const NamedSet& x) { add_all(x.name, x.nodes); }
  void add(const Support& x) {
    add_all(x.at, x.kind, x.directions, x.rotations, x.roll, x.normal, x.move, x.move_inwards, x.shrink, x.turn_axis,
            x.turn_angle);
    for (int i = 0; i < 3; ++i) add(Vec3(x.deform.row(i)));
  }
  void add(const SoftPin& x) { add_all(x.at, x.stiffness, x.target); }
  void add(const PointForce& x) { add_all(x.at, x.force, x.shared, x.scaling); }
  void add(const PointMoment& x) { add_all(x.at, x.moment, x.scaling); }
  void add(const LineLoad& x) { add_all(x.rods, x.force_per_length, x.scaling); }
  void add(const EdgeLoad& x) { add_all(x.at, x.force_per_length, x.scaling); }
  void add(const FormFinding& x) { add_all(x.rounds, x.tolerance); }
  void add(const Gravity& x) { add_all(x.acceleration, x.scaling); }
  void add(const LoadPath& x) { add_all(x.from, x.to, x.steps, x.follow, x.stop_at_critical, x.switch_branch); }
  void add(const Seed& x) { add_all(x.shape, x.direction, x.amplitude); }
  void add(const Pose& x) {
    add_all(x.name, x.supports, x.soft_pins, x.forces, x.moments, x.line_loads, x.edge_loads, x.gravity, x.path, x.seed,
            x.rigid_motion, x.frozen, x.stretch_scaling, x.form_finding);
  }
  void add(const MotionCase::Kick& x) { add_all(x.at, x.velocity); }
  void add(const MotionCase& x) {
    add_all(x.name, x.start_pose, x.pose, x.duration, x.step, x.record_every, x.adaptive, x.error_tolerance,
            x.rho_infinity, x.mass_damping, x.stiffness_damping, x.roll_inertia, x.load_factor, x.kicks);
  }
  void add(const RadiiBrief& x) { add_all(x.controls, x.range); }
  void add(const RestShapeBrief& x) { add_all(x.controls, x.reach, x.gauge); }
  void add(const LengthBrief& x) { add_all(x.rods, x.factors); }
  void add(const ModulusBrief& x) { add_all(x.per, x.range); }
  void add(const FabricBrief& x) {
    add_all(x.stiffness, x.stiffness_1, x.stiffness_2, x.poisson_ratio, x.thickness, x.pre_stretch);
  }
  void add(const NaturalBrief& x) { add_all(x.rods, x.curvature_b, x.curvature_n, x.twist, x.length_factor); }
  void add(const LoadBrief& x) { add_all(x.kind, x.pose, x.number, x.size, x.xyz[0], x.xyz[1], x.xyz[2]); }
  void add(const PlanBrief& x) { add_all(x.points, x.radii, x.reach, x.pre_stretch, x.axes); }
  void add(const MirrorBrief& x) { add_all(x.normal, x.offset, x.tolerance); }
  void add(const ParameterBrief& x) {
    add_all(static_cast<int>(x.what.index()), x.mirror, x.freedom);
    std::visit([this](const auto& what) { add(what); }, x.what);
  }
  void add(const GoalValue& x) { add_all(x.kind, x.value); }
  void add(const PositionsGoal& x) { add_all(x.at, x.targets, x.weights); }
  void add(const PlaceGoal& x) { add_all(x.at, x.target); }
  void add(const AngleGoal& x) { add_all(x.from, x.to, x.axis, x.wanted); }
  void add(const ReactionGoal& x) { add_all(x.at, x.axis, x.wanted); }
  void add(const AreaGoal& x) { add_all(x.membranes, x.wanted); }
  void add(const VolumeGoal& x) { add_all(x.membranes, x.wanted); }
  void add(const MassGoal& x) { add_all(x.rods, x.membranes, x.wanted); }
  void add(const EnergyGoal& x) { add(x.wanted); }
  void add(const StretchGoal& x) { add_all(x.membranes, x.wanted); }
  void add(const StrainGoal& x) { add_all(x.rods, x.wanted); }
  void add(const StabilityGoal& x) { add(x.wanted); }
  void add(const GoalBrief& x) {
    add_all(static_cast<int>(x.what.index()), x.pose, x.strength, x.weight);
    std::visit([this](const auto& what) { add(what); }, x.what);
  }
  void add(const DesignSettings& x) {
    add_all(x.method, x.control, x.iterations, x.gradient_tolerance, x.decrease_tolerance, x.constraint_tolerance,
            x.solve_tolerance);
  }
  void add(const Brief& x) {
    add_all(x.parameters, x.goals, x.wishes.closeness, x.wishes.smoothness, x.wishes.clearance, x.settings);
  }
  void add(const ForceLengthBrief& x) { add_all(x.pose, x.file, x.from, x.to, x.axis, x.prescribed, x.sigma); }
  void add(const ShapesBrief& x) { add_all(x.pose, x.file, x.sigma); }
  void add(const MeasurementBrief& x) {
    add(static_cast<int>(x.index()));
    std::visit([this](const auto& brief) { add(brief); }, x);
  }
  void add(const Calibration& x) {
    add_all(x.parameters, x.measurements, x.confidence, x.iterations, x.solve_tolerance);
  }
  void add(const Expectation& x) {
    add_all(x.label, x.quantity, x.poses, x.at, x.to, x.axis, x.rod, x.membrane, x.fabric_test, x.parameter, x.fraction,
            x.mode, x.mode_kind, x.combine, x.edges, x.scale, x.offset, x.value, x.unit, x.tolerance_relative,
            x.tolerance_absolute, x.source);
  }
  void add(const Model& x) {
    add_all(x.title, x.source, x.materials, x.rods, x.network_files, x.membrane_materials, x.membranes, x.solids,
            x.fabric_tests, x.joint_kind, x.joint_weights, x.joints, x.merge_distance, x.torsion, x.sets, x.poses,
            x.motions, x.design, x.calibration, x.expectations);
  }
  template <class... T>
  void add_all(const T&... x) {
    ((add(x), text_ += '\n'), ...);
  }

  std::string text_;
};

}  // namespace lissom
