#pragma once
/// Motion in time of a structure: from an equilibrium or the drawn shape, under the loads and supports of a pose.
///
/// Generalised-alpha steps (integrator.h). An adaptive run keeps the estimated local error of each step below
/// MotionCase::error_tolerance: error_constant dt^3 |da/dt| over the size of the structure, vibrations that the step does not
/// resolve filtered out. A step is kept while 0.8 (tolerance / error)^(1/3) lies between 0.9 and 1.25; below, it shrinks by
/// that factor (at most to a fifth), above for five steps, it grows by 1.25, never beyond MotionCase::step. Every run halves
/// a step that does not converge. Records fall on multiples of record_every exactly,
/// and steps end where the load factor changes its slope.
///
/// The energy balance counts the mass of what is free; total = kinetic + elastic - work of loads and supports + losses
/// stays what it was in a perfect run, so `drift` is the error of the method.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lissom/core/context.h"
#include "lissom/core/result.h"
#include "lissom/mechanics/state.h"
#include "lissom/model/model.h"
#include "lissom/motion/integrator.h"

namespace lissom {

enum class MotionVerdict {
  kFinished,   ///< reached its end
  kNoStart,    ///< the start pose has no stable equilibrium to start from
  kStepLimit,  ///< more steps than allowed
  kStalled,    ///< even the smallest step did not converge
  kCancelled,  ///< stopped by the caller
};

struct MotionVerdictInfo {
  MotionVerdict verdict;
  std::string_view name;      ///< "finished", as in JSON
  std::string_view sentence;  ///< for people
  int exit_code;              ///< of the command line
};
const MotionVerdictInfo& motion_verdict_info(MotionVerdict verdict);

/// A part of the structure whose turning is of interest.
struct MotionWatch {
  std::string name;
  Selector nodes;
  std::optional<Vec3> point;  ///< m, on the axis; absent: the mean of the nodes as drawn
  Vec3 axis = Vec3::UnitZ();
};

struct MotionOptions {
  std::vector<MotionWatch> watches;
  int max_steps = 10'000'000;
};

/// A watch at one time.
struct WatchRecord {
  double angular_momentum = 0;  ///< kg m^2/s about the axis, spin of the edges between its nodes included
  double turn = 0;  ///< rad about the axis since the drawn shape, of the best-fitting rotation; any number of turns
  double turn_rate = 0;  ///< rad/s: angular momentum of the nodes over their moment of inertia
};

struct MotionRecord {
  double time = 0;  ///< s
  double load_factor = 0;
  double translation_energy = 0;         ///< J, kinetic
  double roll_energy = 0;                ///< J, kinetic
  double elastic_energy = 0;             ///< J, with soft pins
  double load_potential = 0;             ///< J, of loads at their present value
  EnergyLedger ledger;                   ///< J, since the start
  double total = 0;                      ///< J
  double drift = 0;                      ///< J, total minus that of the start
  Vec3 momentum = Vec3::Zero();          ///< kg m/s
  Vec3 angular_momentum = Vec3::Zero();  ///< kg m^2/s about the origin
  std::vector<WatchRecord> watches;
  int steps = 0;       ///< so far
  int iterations = 0;  ///< Newton, so far
  double step = 0;     ///< s, the last one
};

struct MotionResult {
  MotionVerdict verdict = MotionVerdict::kFinished;
  std::string message;  ///< one sentence: the verdict with its reason
  std::vector<MotionRecord> records;
  std::vector<State> states;  ///< of the records
  State last;                 ///< last good state, also when it is not recorded
  double last_time = 0;       ///< s
  int steps = 0, rejected_steps = 0, iterations = 0;

  /// Largest drift over the largest energy that moves: kinetic, or change of elastic energy.
  double balance_error() const;
};

/// `where` is the JSON pointer of the motion, for errors ("/motions/0"). Bad input is an error; everything else is a
/// verdict with what was reached.
Result<MotionResult> simulate(const Model& model, const System& system, const MotionCase& motion,
                              const std::string& where, const MotionOptions& options = {}, const Context& context = {});

}  // namespace lissom
