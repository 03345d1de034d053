#pragma once
/// Helpers of Model::validate(): the first mistake wins, places are JSON pointers of the document.

#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

#include "lissom/model/model.h"

namespace lissom {

/// The names of a model and the first mistake found in it.
class Checker {
 public:
  explicit Checker(const Model& model);

  const Model& model;
  std::vector<std::string> rods, sets, poses, materials, plan_points;  ///< names, in order; rods of the plan come last
  std::vector<std::string> membranes, fabrics, fabric_tests;

  bool failed() const { return error_.has_value(); }
  Status status() const { return error_ ? Status(*error_) : Status(); }
  void fail(ErrorCode code, std::string where, std::string message, std::string hint = {});
  void take(const Status& status);

  void finite(double value, const std::string& where);
  void finite(const Vec3& value, const std::string& where);
  void positive(double value, const std::string& where, const std::string& what);
  void not_negative(double value, const std::string& where, const std::string& what);
  /// A direction that is finite and not zero; with `unit`, of length 1.
  void direction(const Vec3& value, const std::string& where, bool unit = false);
  void selector(const Selector& selector, const std::string& where);
  /// `name` is one of `names`, the names of `what` ("pose").
  void known(const std::string& name, const std::vector<std::string>& names, const std::string& what,
             const std::string& where);
  /// No name is empty or used twice; `where(i)` is the place of name i.
  template <class Where>
  void distinct(const std::vector<std::string>& names, const std::string& what, const Where& where) {
    std::unordered_set<std::string> seen;
    for (std::size_t i = 0; i < names.size() && !failed(); ++i) {
      if (names[i].empty()) fail(ErrorCode::kUnknown, where(i), "the " + what + " has no name", "give it one");
      if (seen.insert(names[i]).second) continue;
      fail(ErrorCode::kConflict, where(i), "the name \"" + names[i] + "\" is used for two " + what + "s",
           "rename one of them");
    }
  }

 private:
  const std::unordered_set<std::string>& lookup(const std::vector<std::string>& names);

  std::unordered_set<std::string> rod_names_, set_names_, pose_names_, material_names_, membrane_names_, fabric_names_,
      fabric_test_names_, point_names_;
  std::optional<Error> error_;
};

void check_curve(Checker& check, const Curve& curve, const std::string& where);
void check_rod(Checker& check, const Rod& rod, const std::string& where);
void check_fabric(Checker& check, const MembraneMaterial& fabric, const std::string& where);
void check_fabric_test(Checker& check, const FabricTest& test, const std::string& where);
void check_membrane(Checker& check, const Membrane& membrane, const std::string& where);
void check_solid(Checker& check, const Solid& solid, const std::string& where);
void check_pose(Checker& check, const Pose& pose, const std::string& where);
void check_design(Checker& check, const Brief& brief, const std::string& where);
/// The parameters of a design, a stage or a calibration, at `where`.
void check_parameters(Checker& check, const std::vector<ParameterBrief>& parameters, const std::string& where);
/// The pose of this name, or the only one; null after a mistake, whose place is `where` + "/pose".
const Pose* check_pose_name(Checker& check, const std::string& name, const std::string& where);
void check_calibration(Checker& check, const Calibration& calibration, const std::string& where);
void check_motion(Checker& check, const MotionCase& motion, const std::string& where);
void check_expectation(Checker& check, const Expectation& expectation, const std::string& where);

}  // namespace lissom
