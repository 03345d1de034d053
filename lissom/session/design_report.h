#pragma once
/// The report of an inverse design for people: one HTML file without any reference to the outside, light or dark as its reader
/// likes, that says first what came of it and then why. Made from plain data, which says nothing of the method that found the
/// design. All values are SI; `unit` and `display_scale` say how they are shown (shown = value * display_scale).

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "lissom/view/rod_drawing.h"

namespace lissom {

struct DesignReport {
  enum class Tone {
    kReached,  ///< as good as asked for, or as good as it gets
    kStopped,  ///< usable, but more time might have made it better
    kTrouble,  ///< something is wrong and needs a decision
  };

  /// What is measured in which unit.
  struct Measure {
    std::string unit = "mm";  ///< as displayed; empty: a pure number
    double display_scale = 1000;
  };

  struct Named {
    std::string name = {}, value = {};
  };

  struct Share {
    std::string name = {};
    double seconds = 0;
  };

  struct Size {
    int rods = 0, nodes = 0, unknowns = 0, poses = 0, parameters = 0, goals = 0;
  };

  /// One accepted iteration; number 0 is the start. Numbers that do not exist are NaN and shown as a dash.
  struct Step {
    int iteration = 0;
    double seconds = 0;    ///< since the start
    double objective = 0;  ///< h, a pure number
    double gradient = 0;   ///< norm of the projected gradient, a pure number
    int active_bounds = 0;
    double radius = 0;             ///< cap of the step, in scaled parameters
    std::string stage = {};        ///< "coarse", "fine"; a change of it is marked in the plots
    std::vector<double> rms = {};  ///< per goal, SI
  };

  struct Goal {
    std::string name = {}, pose = {};
    Measure measure = {};
    double rms_before = 0, rms_after = 0;          ///< SI
    double largest_before = 0, largest_after = 0;  ///< SI, largest deviation of a component
  };

  struct Parameter {
    enum class Bound { kFree, kLower, kUpper };
    std::string name = {}, kind = {};  ///< parameters of one kind share a histogram
    Measure measure = {};
    double start = 0, value = 0, lower = 0, upper = 0;  ///< SI; bounds may be infinite
    double gradient = 0;                                ///< of the objective, per scaled parameter, at the end
    Bound bound = Bound::kFree;
  };

  /// Node with a target, m.
  struct Target {
    Vec3 wanted = Vec3::Zero(), before = Vec3::Zero(), after = Vec3::Zero();
  };

  /// Shapes of one pose (report_pose.h makes them).
  struct Pose {
    std::string name = {};
    std::vector<Target> targets = {};  ///< empty: this pose has no targets for nodes
    Drawing target = {};               ///< pieces of rods whose nodes have targets; may be empty
    std::vector<Vec3> dots = {};       ///< m, targets that are in no piece of a rod
    Drawing before = {}, after = {};   ///< `after` may have a field "deviation" (report_pose.h)
  };

  /// Plain text in rows. Columns whose names begin with '<' hold words, the others numbers.
  struct Table {
    std::string caption = {};
    std::vector<std::string> columns = {};
    std::vector<std::vector<std::string>> rows = {};
  };

  std::string title = {};     ///< of the structure
  std::string document = {};  ///< file
  Tone tone = Tone::kReached;
  std::string verdict = {};   ///< "settled at a minimum"
  std::string sentence = {};  ///< why, in a sentence
  std::string remedy = {};    ///< what to do; empty: nothing
  std::string method = {};    ///< in words
  std::vector<Named> options = {};
  Size size = {};
  double seconds = 0;
  std::vector<Share> shares = {};  ///< where the time went; what is missing to `seconds` is shown as other
  std::vector<Step> history = {};
  std::vector<Goal> goals = {};
  std::vector<Parameter> parameters = {};
  std::vector<Pose> poses = {};
  std::vector<Table> project = {};         ///< what the structure was made from, and how poses come out
  std::vector<Table> print = {};           ///< what can be said of printing it
  std::vector<std::string> warnings = {};  ///< sentences
  std::vector<std::string> files = {};     ///< written beside the report
  std::string command = {};                ///< line that makes this again
  std::string version = {};                ///< of lissom
  std::optional<uint64_t> seed = {};       ///< absent: nothing was random
};

/// The page. Same report, same bytes. Errors: a history whose steps do not have one value per goal, shapes that cannot be
/// drawn (names the pose).
Result<std::string> design_report_html(const DesignReport& report);

}  // namespace lissom
