#include <algorithm>
#include <cmath>

#include "lissom/core/nearest_name.h"
#include "lissom/model/check_plan.h"
#include "lissom/model/expand_plan.h"
#include "lissom/model/json_value.h"
#include "lissom/model/limits.h"
#include "lissom/model/units.h"
#include "lissom/model/validate_parts.h"

namespace lissom {
namespace {

constexpr int kDeepestUnion = 64;

std::string at(const std::string& where, const std::string& key, std::size_t index) {
  return where + "/" + key + "/" + std::to_string(index);
}

int depth(const Selector& selector) {
  int deepest = 0;
  for (const Selector& part : selector.parts) deepest = std::max(deepest, depth(part));
  return 1 + deepest;
}

/// Follows sets that refer to sets; a set that contains itself would never end.
struct SetWalk {
  const Model& model;
  std::vector<int> state;  ///< per set: 0 not seen, 1 being followed, 2 done
  bool circular = false;

  void follow(const Selector& selector) {
    if (selector.kind == Selector::Kind::kUnion) {
      for (const Selector& part : selector.parts) follow(part);
    }
    if (selector.kind != Selector::Kind::kSet) return;
    for (std::size_t i = 0; i < model.sets.size(); ++i) {
      if (model.sets[i].name == selector.name) visit(i);
    }
  }

  void visit(std::size_t i) {
    if (state[i] == 1) circular = true;
    if (state[i] != 0) return;
    state[i] = 1;
    follow(model.sets[i].nodes);
    state[i] = 2;
  }
};

void check_sets(Checker& check, const Model& model) {
  for (std::size_t i = 0; i < model.sets.size() && !check.failed(); ++i) {
    const std::string where = "/sets/" + pointer_step(model.sets[i].name);
    for (const SelectorWord& known : selector_words()) {
      if (model.sets[i].name == known.word) {
        return check.fail(ErrorCode::kConflict, where, "\"" + model.sets[i].name + "\" is a built-in selection",
                          "choose another name");
      }
    }
    check.selector(model.sets[i].nodes, where);
  }
  if (check.failed()) return;
  SetWalk walk{model, std::vector<int>(model.sets.size(), 0)};
  for (std::size_t i = 0; i < model.sets.size(); ++i) {
    walk.visit(i);
    if (walk.circular) {
      return check.fail(ErrorCode::kConflict, "/sets/" + pointer_step(model.sets[i].name), "this set contains itself",
                        "define it by rods, points or boxes");
    }
  }
}

}  // namespace

Checker::Checker(const Model& described) : model(described) {
  for (const Rod& rod : model.rods) rods.push_back(rod.name);
  if (model.plan) {
    for (std::string& name : plan_rod_names(*model.plan)) rods.push_back(std::move(name));
    for (const PlanPoint& point : model.plan->points) plan_points.push_back(point.name);
  }
  for (const NamedSet& set : model.sets) sets.push_back(set.name);
  for (const Pose& pose : model.poses) poses.push_back(pose.name);
  for (const Material& material : model.materials) materials.push_back(material.name);
  for (const Material& material : material_library()) materials.push_back(material.name);
  for (const Membrane& membrane : model.membranes) membranes.push_back(membrane.name);
  if (model.plan) membranes.emplace_back(kFabricName);
  for (const MembraneMaterial& fabric : model.membrane_materials) fabrics.push_back(fabric.name);
  for (const MembraneMaterial& fabric : membrane_library()) fabrics.push_back(fabric.name);
  for (const FabricTest& test : model.fabric_tests) fabric_tests.push_back(test.name);
  rod_names_.insert(rods.begin(), rods.end());
  point_names_.insert(plan_points.begin(), plan_points.end());
  set_names_.insert(sets.begin(), sets.end());
  pose_names_.insert(poses.begin(), poses.end());
  material_names_.insert(materials.begin(), materials.end());
  membrane_names_.insert(membranes.begin(), membranes.end());
  fabric_names_.insert(fabrics.begin(), fabrics.end());
  fabric_test_names_.insert(fabric_tests.begin(), fabric_tests.end());
}

void Checker::fail(ErrorCode code, std::string where, std::string message, std::string hint) {
  if (!error_) error_ = Error{code, std::move(where), std::move(message), std::move(hint)};
}

void Checker::take(const Status& status) {
  if (!status && !error_) error_ = status.error();
}

void Checker::finite(double value, const std::string& where) {
  if (!std::isfinite(value)) {
    fail(ErrorCode::kRange, where, "this number is not finite");
  } else if (std::abs(value) > kLargest) {
    fail(ErrorCode::kRange, where, "this number is too large: " + number_text(value) + " in SI units",
         "is its unit the right one?");
  }
}

void Checker::finite(const Vec3& value, const std::string& where) {
  if (!value.allFinite()) fail(ErrorCode::kRange, where, "these numbers are not finite");
  if (!failed()) finite(value.cwiseAbs().maxCoeff(), where);
}

void Checker::positive(double value, const std::string& where, const std::string& what) {
  finite(value, where);
  if (!(value > 0)) fail(ErrorCode::kRange, where, "the " + what + " has to be positive");
  if (value > 0 && value < kSmallest) {
    fail(ErrorCode::kRange, where, "the " + what + " is too small: " + number_text(value) + " in SI units",
         "is its unit the right one?");
  }
}

void Checker::not_negative(double value, const std::string& where, const std::string& what) {
  finite(value, where);
  if (!(value >= 0)) fail(ErrorCode::kRange, where, "the " + what + " must not be negative");
}

void Checker::direction(const Vec3& value, const std::string& where, bool unit) {
  constexpr double kUnitTolerance = 1e-6;
  finite(value, where);
  if (value.isZero(0)) fail(ErrorCode::kRange, where, "a direction must not be zero", "write for example [0, 0, 1]");
  if (unit && std::abs(value.norm() - 1) > kUnitTolerance) {
    fail(ErrorCode::kRange, where, "this direction has to have length 1", "normalise it");
  }
}

const std::unordered_set<std::string>& Checker::lookup(const std::vector<std::string>& names) {
  if (&names == &rods) return rod_names_;
  if (&names == &plan_points) return point_names_;
  if (&names == &sets) return set_names_;
  if (&names == &membranes) return membrane_names_;
  if (&names == &fabrics) return fabric_names_;
  if (&names == &fabric_tests) return fabric_test_names_;
  return &names == &poses ? pose_names_ : material_names_;
}

void Checker::known(const std::string& name, const std::vector<std::string>& names, const std::string& what,
                    const std::string& where) {
  if (failed() || lookup(names).contains(name)) return;
  fail(ErrorCode::kUnknown, where, "there is no " + what + " \"" + name + "\"", suggestion(name, names));
}

void Checker::selector(const Selector& selector, const std::string& where) {
  if (failed()) return;
  switch (selector.kind) {
    case Selector::Kind::kAll:
    case Selector::Kind::kJoints:
    case Selector::Kind::kEnds:
    case Selector::Kind::kBoundary:
      return;
    case Selector::Kind::kSet:
      return known(selector.name, sets, "set", where);
    case Selector::Kind::kRod:
      known(selector.name, rods, "rod", where + "/rod");
      finite(selector.fraction, where + "/at");
      if (selector.fraction > 1) {
        fail(ErrorCode::kRange, where + "/at", "the place on a rod has to be between 0 and 1",
             "0 is its start, 1 its end");
      }
      return;
    case Selector::Kind::kPlanPoint:
      return known(selector.name, plan_points, "point of the plan", where + "/plan_point");
    case Selector::Kind::kPoint:
      finite(selector.point, where + "/point");
      return not_negative(selector.tolerance, where + "/within", "distance");
    case Selector::Kind::kBox:
      finite(selector.low, where + "/box/0");
      finite(selector.high, where + "/box/1");
      if ((selector.low.array() > selector.high.array()).any()) {
        fail(ErrorCode::kConflict, where + "/box", "the low corner of the box is above its high corner",
             "give the smaller x, y and z first");
      }
      return;
    case Selector::Kind::kMembrane:
    case Selector::Kind::kRim:
      return known(selector.name, membranes, "membrane", where + "/membrane");
    case Selector::Kind::kUnion: {
      if (selector.parts.empty()) fail(ErrorCode::kType, where, "this union of selectors is empty", "name some nodes");
      if (depth(selector) > kDeepestUnion) fail(ErrorCode::kUnsupported, where, "the unions are nested too deeply");
      for (std::size_t i = 0; i < selector.parts.size() && !failed(); ++i) {
        this->selector(selector.parts[i], where + "/" + std::to_string(i));
      }
      return;
    }
  }
}

Status Model::validate() const {
  Checker check(*this);
  std::vector<std::string> own, own_fabrics, motion_names, solid_names;
  for (const Material& material : materials) own.push_back(material.name);
  for (const MembraneMaterial& fabric : membrane_materials) own_fabrics.push_back(fabric.name);
  for (const MotionCase& motion : motions) motion_names.push_back(motion.name);
  for (const Solid& solid : solids) solid_names.push_back(solid.name);
  const auto listed = [](const char* key) { return [key](std::size_t i) { return at("", key, i) + "/name"; }; };
  check.distinct(own, "material", [&own](std::size_t i) { return "/materials/" + pointer_step(own[i]); });
  check.distinct(own_fabrics, "fabric",
                 [&own_fabrics](std::size_t i) { return "/membrane_materials/" + pointer_step(own_fabrics[i]); });
  check.distinct(check.rods, "rod", [this](std::size_t i) {
    return i < rods.size() ? at("", "rods", i) + "/name" : std::string("/plan/rods");
  });
  check.distinct(check.membranes, "membrane", listed("membranes"));
  check.distinct(check.sets, "set", [&check](std::size_t i) { return "/sets/" + pointer_step(check.sets[i]); });
  check.distinct(check.poses, "pose", listed("poses"));
  check.distinct(motion_names, "motion", listed("motions"));
  for (std::size_t i = 0; i < materials.size() && !check.failed(); ++i) {
    const std::string where = "/materials/" + pointer_step(own[i]);
    check.take(materials[i].validate(where));
    check.positive(materials[i].youngs_modulus, where + "/youngs_modulus", "Young's modulus");
    check.finite(materials[i].density, where + "/density");
  }
  for (std::size_t i = 0; i < membrane_materials.size() && !check.failed(); ++i) {
    check_fabric(check, membrane_materials[i], "/membrane_materials/" + pointer_step(own_fabrics[i]));
  }
  if (rods.empty() && membranes.empty() && solids.empty() && !plan && fabric_tests.empty()) {
    check.fail(ErrorCode::kGeometry, "/rods", "the document describes no rods, no membranes and no solids",
               "add some to \"rods\", \"networks\", \"membranes\" or \"solids\"");
  }
  if (plan && !check.failed()) check.take(check_plan(*this));
  for (std::size_t i = 0; i < rods.size() && !check.failed(); ++i) check_rod(check, rods[i], at("", "rods", i));
  check.distinct(check.fabric_tests, "fabric test",
                 [&check](std::size_t i) { return "/fabric_tests/" + pointer_step(check.fabric_tests[i]); });
  for (std::size_t i = 0; i < fabric_tests.size() && !check.failed(); ++i) {
    check_fabric_test(check, fabric_tests[i], "/fabric_tests/" + pointer_step(fabric_tests[i].name));
  }
  for (std::size_t i = 0; i < membranes.size() && !check.failed(); ++i) {
    check_membrane(check, membranes[i], at("", "membranes", i));
  }
  check.distinct(solid_names, "solid", listed("solids"));
  for (std::size_t i = 0; i < solids.size() && !check.failed(); ++i) {
    check_solid(check, solids[i], at("", "solids", i));
  }
  check_sets(check, *this);
  for (std::size_t i = 0; i < joints.size() && !check.failed(); ++i) {
    check.selector(joints[i].at, at("/joints", "exceptions", i) + "/at");
  }
  check.finite(merge_distance, "/joints/merge_distance");
  for (std::size_t i = 0; i < poses.size() && !check.failed(); ++i) check_pose(check, poses[i], at("", "poses", i));
  for (std::size_t i = 0; i < motions.size() && !check.failed(); ++i)
    check_motion(check, motions[i], at("", "motions", i));
  if (design && !check.failed()) check_design(check, *design, "/design");
  if (calibration && !check.failed()) check_calibration(check, *calibration, "/calibration");
  for (std::size_t i = 0; i < expectations.size() && !check.failed(); ++i) {
    check_expectation(check, expectations[i], at("", "expect", i));
  }
  return check.status();
}

}  // namespace lissom
