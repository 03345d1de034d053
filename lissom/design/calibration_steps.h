#pragma once
/// What was measured on a structure, as poses to be solved and goals for them: every pair of a force and a length is a step of
/// its own, and so is every measured shape.

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/design/design.h"
#include "lissom/design/goal.h"
#include "lissom/model/calibration.h"

namespace lissom {

struct ForceLengthPair {
  double force = 0;             ///< N
  double length = 0;            ///< m
  std::optional<double> sigma;  ///< of what is measured, m or N
  std::string where;            ///< "pull.csv:7"
};

struct ForceLengthData {
  enum class Length {
    kWhole,   ///< from end to end
    kChange,  ///< against the drawn shape
  };
  ForceLengthBrief brief;  ///< its pose is named
  Length meaning = Length::kWhole;
  std::vector<ForceLengthPair> pairs;
  std::string where;  ///< of the entry in the document
};

struct MeasuredPlace {
  int node = 0;
  Vec3 place = Vec3::Zero();    ///< m; NaN: not measured
  std::optional<double> sigma;  ///< of each coordinate, m
  std::string where;            ///< "shapes.csv:7"
};

struct ShapeData {
  struct Shape {
    int pose = 0;  ///< of the model
    std::vector<MeasuredPlace> places;
  };
  ShapesBrief brief;
  std::vector<Shape> shapes;
  std::string where;  ///< of the entry in the document
};

using MeasurementData = std::variant<ForceLengthData, ShapeData>;

/// One number that was measured.
struct MeasuredNumber {
  int set = 0;            ///< entry of the measurements
  int step = 0;           ///< of CalibrationSteps
  int component = 0;      ///< of the goal of the step
  double prescribed = 0;  ///< of pairs: the force (N) or length (m) that was set
  double measured = 0;    ///< SI, as the goal counts it
  double shift = 0;       ///< of lengths that are changes: measured, as it is in the file, plus this is `measured`
  double sigma = 1;       ///< SI, by which it is weighed
  std::string where;      ///< "pull.csv:7"
};

struct CalibrationStep {
  int pose = 0;       ///< of CalibrationSteps::model
  int base_pose = 0;  ///< that it is a copy of
  int set = 0;
  std::string where;                                                  ///< first line of the file that it stands for
  std::vector<int> nodes;                                             ///< of shapes, in the order of the goal
  ForceLengthData::Length meaning = ForceLengthData::Length::kWhole;  ///< of pairs: what their lengths are
};

struct CalibrationSteps {
  Model model;                          ///< with a pose for each step after its own, without design and calibration
  std::vector<CalibrationStep> steps;   ///< in the order of poses
  std::vector<Goal> goals;              ///< one for each step; residuals are deviations over sigma
  std::vector<MeasuredNumber> numbers;  ///< in the order of residuals
  bool sigma_known = false;             ///< else residuals are over a nominal one, common to all
};

/// `base` is the discretised document. Errors name the entry, or file and line: forces without a pattern to scale, lengths
/// that no support makes, nodes that nothing holds, several sets without standard deviations that would weigh them.
Result<CalibrationSteps> make_calibration_steps(const Design& base, const std::vector<MeasurementData>& data);

}  // namespace lissom
