#include <algorithm>
#include <cmath>

#include "lissom/core/nearest_name.h"
#include "lissom/model/limits.h"
#include "lissom/model/units.h"
#include "lissom/model/validate_parts.h"

namespace lissom {
namespace {

std::string at(const std::string& where, const char* key, std::size_t index) {
  return where + "/" + key + "/" + std::to_string(index);
}

/// Held directions have to be perpendicular: otherwise their prescribed displacements contradict each other.
void check_perpendicular(Checker& check, const std::vector<Vec3>& directions, const std::string& where,
                         const std::string& what) {
  constexpr double kTolerance = 1e-9;
  for (const Vec3& direction : directions) check.direction(direction, where, true);
  if (directions.size() > 3) check.fail(ErrorCode::kConflict, where, "more than three " + what + " are held");
  for (std::size_t i = 0; i < directions.size() && !check.failed(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (std::abs(directions[i].dot(directions[j])) <= kTolerance) continue;
      return check.fail(ErrorCode::kConflict, where, "the held " + what + " are not perpendicular to each other",
                        "give each once, at right angles");
    }
  }
}

void check_support(Checker& check, const Support& support, const std::string& where) {
  check.selector(support.at, where + "/at");
  if (support.kind == SupportKind::kFree) {
    check_perpendicular(check, support.directions, where + "/hold", "directions");
    check_perpendicular(check, support.rotations, where + "/hold", "rotations");
    if (support.directions.empty() && support.rotations.empty() && !support.roll) {
      check.fail(ErrorCode::kType, where + "/hold", "this support holds nothing", "remove it, or list what is held");
    }
  }
  if (support.kind == SupportKind::kSymmetry) check.direction(support.normal, where + "/normal");
  check.finite(support.move, where + "/move");
  if (support.move_inwards) check.finite(*support.move_inwards, where + "/move_inwards");
  if (!(support.shrink < 1)) {
    check.fail(ErrorCode::kRange, where + "/shrink", "the held nodes would meet in their middle or pass through it",
               "use less than 100 %; negative numbers spread them");
  }
  for (int i = 0; i < 3; ++i) check.finite(Vec3(support.deform.row(i)), where + "/deform/" + std::to_string(i));
  check.direction(support.turn_axis, where + "/turn/axis");
  check.finite(support.turn_angle, where + "/turn/angle");
  const bool holds_positions = support.kind != SupportKind::kFree || !support.directions.empty();
  const bool moves = !support.move.isZero(0) || support.move_inwards.value_or(0) != 0 || support.shrink != 0 ||
                     !support.deform.isIdentity(0);
  const std::string moved_by = support.shrink != 0             ? "/shrink"
                               : !support.deform.isIdentity(0) ? "/deform"
                               : support.move_inwards          ? "/move_inwards"
                                                               : "/move";
  if (moves && !holds_positions) {
    check.fail(ErrorCode::kConflict, where + moved_by, "the support moves but holds no displacement",
               "hold the directions that it moves along");
  }
  if (moves && support.kind == SupportKind::kSymmetry) {
    check.fail(ErrorCode::kConflict, where + moved_by, "a mirror plane does not move",
               "hold the direction along its normal instead");
  }
  const bool holds_frame = support.kind == SupportKind::kClamp || support.kind == SupportKind::kClampEdge ||
                           (support.kind == SupportKind::kFree && (!support.rotations.empty() || support.roll));
  if (support.turn_angle != 0 && !holds_frame) {
    check.fail(ErrorCode::kConflict, where + "/turn", "the support turns but holds no rotation",
               "use a clamp, or hold the rotation that it turns about");
  }
}

/// Whether two selectors are written alike. Others may still overlap; that is seen when nodes are known.
bool same(const Selector& a, const Selector& b) {
  if (a.kind != b.kind || a.parts.size() != b.parts.size()) return false;
  for (std::size_t i = 0; i < a.parts.size(); ++i) {
    if (!same(a.parts[i], b.parts[i])) return false;
  }
  return a.name == b.name && a.fraction == b.fraction && a.point == b.point && a.tolerance == b.tolerance &&
         a.low == b.low && a.high == b.high && a.rim == b.rim;
}

/// Two supports that hold all of the position of the same nodes and move them differently.
void check_contradictions(Checker& check, const std::vector<Support>& supports, const std::string& where) {
  const auto holds_position = [](const Support& s) {
    return s.kind == SupportKind::kPin || s.kind == SupportKind::kClamp || s.kind == SupportKind::kClampEdge;
  };
  for (std::size_t i = 0; i < supports.size() && !check.failed(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!holds_position(supports[i]) || !holds_position(supports[j]) || !same(supports[i].at, supports[j].at))
        continue;
      const bool moved_alike = supports[i].move == supports[j].move &&
                               supports[i].move_inwards == supports[j].move_inwards &&
                               supports[i].shrink == supports[j].shrink && supports[i].deform == supports[j].deform;
      return check.fail(ErrorCode::kConflict, at(where, "supports", i),
                        moved_alike ? "support " + std::to_string(j) + " already holds the position of the same nodes"
                                    : "support " + std::to_string(j) + " moves the same nodes differently",
                        "merge the two");
    }
  }
}

void check_loads(Checker& check, const Pose& pose, const std::string& where) {
  for (std::size_t i = 0; i < pose.soft_pins.size() && !check.failed(); ++i) {
    const std::string here = at(where, "soft_pins", i);
    check.selector(pose.soft_pins[i].at, here + "/at");
    check.positive(pose.soft_pins[i].stiffness, here + "/stiffness", "stiffness");
    if (pose.soft_pins[i].target) check.finite(*pose.soft_pins[i].target, here + "/target");
  }
  for (std::size_t i = 0; i < pose.forces.size() && !check.failed(); ++i) {
    check.selector(pose.forces[i].at, at(where, "forces", i) + "/at");
    check.finite(pose.forces[i].force, at(where, "forces", i) + "/force");
  }
  for (std::size_t i = 0; i < pose.moments.size() && !check.failed(); ++i) {
    check.selector(pose.moments[i].at, at(where, "moments", i) + "/at");
    check.finite(pose.moments[i].moment, at(where, "moments", i) + "/moment");
  }
  for (std::size_t i = 0; i < pose.line_loads.size() && !check.failed(); ++i) {
    const std::string here = at(where, "line_loads", i);
    for (std::size_t j = 0; j < pose.line_loads[i].rods.size(); ++j) {
      check.known(pose.line_loads[i].rods[j], check.rods, "rod", at(here, "rods", j));
    }
    check.finite(pose.line_loads[i].force_per_length, here + "/force_per_length");
  }
  for (std::size_t i = 0; i < pose.edge_loads.size() && !check.failed(); ++i) {
    const std::string here = at(where, "edge_loads", i);
    check.selector(pose.edge_loads[i].at, here + "/at");
    check.finite(pose.edge_loads[i].force_per_length, here + "/force_per_length");
  }
  if (!pose.gravity) return;
  check.finite(pose.gravity->acceleration, where + "/gravity");
  bool heavy = false;
  for (const Rod& rod : check.model.rods) {
    const Material* material = check.model.material(rod.material);
    heavy = heavy || (material && material->density > 0);
  }
  for (const Membrane& membrane : check.model.membranes) {
    const MembraneMaterial* fabric = check.model.membrane_material(membrane.material);
    heavy = heavy || (fabric && fabric->area_density > 0);
  }
  for (const Solid& solid : check.model.solids) {
    const Material* material = check.model.material(solid.material);
    heavy = heavy || (material && material->density > 0);
  }
  heavy = heavy || check.model.plan.has_value();
  if (!heavy) {
    check.fail(ErrorCode::kConflict, where + "/gravity", "gravity acts, but no material has a density",
               "add \"density\" to a material, or remove \"gravity\"");
  }
}

}  // namespace

void check_pose(Checker& check, const Pose& pose, const std::string& where) {
  for (std::size_t i = 0; i < pose.supports.size() && !check.failed(); ++i) {
    check_support(check, pose.supports[i], at(where, "supports", i));
  }
  check_contradictions(check, pose.supports, where);
  check_loads(check, pose, where);
  if (pose.path) {
    check.finite(pose.path->from, where + "/path/from");
    check.finite(pose.path->to, where + "/path/to");
    if (pose.path->from == pose.path->to) {
      check.fail(ErrorCode::kConflict, where + "/path", "the path ends where it begins",
                 "give different \"from\" and \"to\"");
    }
    if (pose.path->steps < 1) check.fail(ErrorCode::kRange, where + "/path/steps", "a path needs at least one step");
    if (pose.path->stop_at_critical && pose.path->switch_branch) {
      check.fail(ErrorCode::kConflict, where + "/path",
                 "the path both stops at a critical point and continues on its branch",
                 "keep one of \"stop_at_critical\" and \"switch_branch\"");
    }
  }
  if (pose.form_finding) {
    const std::string here = where + "/form_finding";
    check.positive(pose.form_finding->tolerance, here + "/tolerance", "tolerance");
    if (pose.form_finding->rounds < 2) check.fail(ErrorCode::kRange, here + "/rounds", "it takes at least two rounds");
    if (pose.path || pose.frozen) {
      check.fail(ErrorCode::kConflict, here, "a form is found in one state, not along a path nor in a frozen shape",
                 "remove \"path\" and \"frozen\", or \"form_finding\"");
    }
    if (check.model.membranes.empty() && !check.model.plan) {
      check.fail(ErrorCode::kConflict, here, "there is no membrane whose form could be found",
                 "add one to \"membranes\", or remove \"form_finding\"");
    }
  }
  if (pose.seed) {
    check.direction(pose.seed->direction, where + "/seed/direction");
    check.finite(pose.seed->amplitude, where + "/seed/amplitude");
  }
}

void check_motion(Checker& check, const MotionCase& motion, const std::string& where) {
  if (!motion.start_pose.empty()) check.known(motion.start_pose, check.poses, "pose", where + "/start_pose");
  check.known(motion.pose, check.poses, "pose", where + "/pose");
  for (const std::string& name : {motion.start_pose, motion.pose}) {
    const Pose* pose = check.model.pose(name);
    if (pose == nullptr || !pose->form_finding) continue;
    check.fail(ErrorCode::kConflict, where + (name == motion.pose ? "/pose" : "/start_pose"),
               "pose \"" + name + "\" finds a form, which a motion cannot start from nor go on with",
               "use a pose without \"form_finding\"");
  }
  check.positive(motion.duration, where + "/duration", "duration");
  check.positive(motion.step, where + "/step", "time step");
  if (motion.step > motion.duration) {
    check.fail(ErrorCode::kConflict, where + "/step", "the time step is longer than the motion", "shorten it");
  }
  if (motion.duration > kMostSteps * motion.step) {
    check.fail(ErrorCode::kRange, where + "/step",
               "the motion would take " + number_text(std::ceil(motion.duration / motion.step)) + " steps",
               "use longer steps or a shorter duration: at most " + number_text(kMostSteps) + " steps");
  }
  check.not_negative(motion.record_every, where + "/record_every", "time between recorded states");
  check.positive(motion.error_tolerance, where + "/error_tolerance", "error tolerance");
  if (!(motion.rho_infinity >= 0 && motion.rho_infinity <= 1)) {
    check.fail(ErrorCode::kRange, where + "/rho_infinity", "rho_infinity has to be between 0 and 1");
  }
  check.not_negative(motion.mass_damping, where + "/mass_damping", "damping");
  check.not_negative(motion.stiffness_damping, where + "/stiffness_damping", "damping");
  for (std::size_t i = 0; i < motion.load_factor.size() && !check.failed(); ++i) {
    const std::string here = at(where, "load_factor", i);
    check.finite(motion.load_factor[i][0], here + "/0");
    check.finite(motion.load_factor[i][1], here + "/1");
    if (i > 0 && !(motion.load_factor[i][0] > motion.load_factor[i - 1][0])) {
      check.fail(ErrorCode::kConflict, here, "the times of the load factor have to increase", "sort the pairs by time");
    }
  }
  for (std::size_t i = 0; i < motion.kicks.size() && !check.failed(); ++i) {
    check.selector(motion.kicks[i].at, at(where, "kicks", i) + "/at");
    check.finite(motion.kicks[i].velocity, at(where, "kicks", i) + "/velocity");
  }
}

void check_expectation(Checker& check, const Expectation& expectation, const std::string& where) {
  if (expectation.quantity.empty()) check.fail(ErrorCode::kUnknown, where + "/quantity", "the quantity has no name");
  const bool one = expectation.poses.size() == 1;
  for (std::size_t i = 0; i < expectation.poses.size(); ++i) {
    check.known(expectation.poses[i], check.poses, "pose", one ? where + "/pose" : at(where, "poses", i));
  }
  check.selector(expectation.at, where + "/at");
  if (expectation.to) check.selector(*expectation.to, where + "/to");
  if (expectation.axis) check.direction(*expectation.axis, where + "/axis", true);
  if (!expectation.rod.empty()) check.known(expectation.rod, check.rods, "rod", where + "/rod");
  if (!expectation.membrane.empty()) {
    check.known(expectation.membrane, check.membranes, "membrane", where + "/membrane");
  }
  if (!expectation.fabric_test.empty()) {
    check.known(expectation.fabric_test, check.fabric_tests, "fabric test", where + "/fabric_test");
  }
  if (!(expectation.fraction <= 1)) {
    check.fail(ErrorCode::kRange, where + "/fraction", "the place on a rod has to be between 0 and 1");
  }
  const std::vector<std::string> kinds = {"bending", "axial", "torsional"};
  if (!expectation.mode_kind.empty() && std::find(kinds.begin(), kinds.end(), expectation.mode_kind) == kinds.end()) {
    check.fail(ErrorCode::kUnknown, where + "/mode_kind", "there is no kind of mode \"" + expectation.mode_kind + "\"",
               suggestion(expectation.mode_kind, kinds));
  }
  const std::vector<std::string> combinations = {"difference", "ratio", "order", "limit"};
  if (!expectation.combine.empty() &&
      std::find(combinations.begin(), combinations.end(), expectation.combine) == combinations.end()) {
    check.fail(ErrorCode::kUnknown, where + "/combine",
               "measurements cannot be combined by \"" + expectation.combine + "\"",
               suggestion(expectation.combine, combinations));
  }
  check.finite(expectation.scale, where + "/divide_by");
  if (expectation.scale == 0) check.fail(ErrorCode::kRange, where + "/divide_by", "this number must not be zero");
  check.finite(expectation.offset, where + "/offset");
  if (!expectation.unit.empty()) {
    if (const Result<Unit> unit = parse_unit(expectation.unit); !unit) {
      check.fail(unit.error().code, where + "/unit", unit.error().message, unit.error().hint);
    }
  }
  for (std::size_t i = 0; i < expectation.value.size(); ++i) check.finite(expectation.value[i], where + "/value");
  const std::size_t values = expectation.value.size();
  const std::size_t poses = expectation.poses.empty() ? check.model.poses.size() : expectation.poses.size();
  if (values != 1 && values != poses && expectation.edges.empty()) {
    check.fail(ErrorCode::kConflict, where + "/value",
               "there are " + std::to_string(values) + " values for " + std::to_string(poses) +
                   (poses == 1 ? " pose" : " poses"),
               "give one value per pose, or one for all");
  }
  const double relative = expectation.tolerance_relative, absolute = expectation.tolerance_absolute;
  check.not_negative(relative, where + "/tolerance", "tolerance");
  check.not_negative(absolute, where + "/tolerance", "tolerance");
  if ((relative > 0) == (absolute > 0)) {
    check.fail(ErrorCode::kConflict, where + "/tolerance",
               relative > 0 ? "the tolerance is both relative and absolute" : "the tolerance is missing",
               "give one, for example \"0.5 %\"");
  }
}

}  // namespace lissom
