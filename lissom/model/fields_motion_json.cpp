#include "lissom/model/entries_json.h"

namespace lissom {

void describe(Fields& fields, MotionCase::Kick& kick) {
  fields.field("at", kick.at, SelectorOf(), kRequired, "The nodes that are kicked.")
      .field("velocity", kick.velocity, VectorOf{Measure::kVelocity}, kRequired, "Velocity at the start.");
}

void describe(Fields& fields, MotionCase& motion) {
  const NumberOf positive_time{Measure::kTime, kPositive}, time{Measure::kTime, kNotNegative};
  fields.field("name", motion.name, TextOf{false}, kRequired, "Name of the motion.")
      .field("start_pose", motion.start_pose, TextOf(), kOptional,
             "Pose whose equilibrium is the start; the drawn shape at rest when absent.")
      .field("pose", motion.pose, TextOf{false}, kRequired, "Pose whose supports and loads act during the motion.")
      .field("duration", motion.duration, positive_time, kRequired, "How long it lasts.")
      .field("step", motion.step, positive_time, kRequired, "First (and largest, when adaptive) time step.")
      .field("record_every", motion.record_every, time, kOptional, "Time between recorded states; every step when 0.")
      .field("adaptive", motion.adaptive, FlagOf(), kOptional, "Whether the step follows the error.")
      .field("error_tolerance", motion.error_tolerance, NumberOf{Measure::kRatio, kPositive}, kOptional,
             "Error per step relative to the size of the structure.")
      .field("rho_infinity", motion.rho_infinity, NumberOf{Measure::kRatio, between(0, 1)}, kOptional,
             "Numerical damping: what is left of the fastest motions after a step; 1 is none.")
      .field("mass_damping", motion.mass_damping, NumberOf{Measure::kRate, kNotNegative}, kOptional,
             "Rayleigh damping by mass.")
      .field("stiffness_damping", motion.stiffness_damping, time, kOptional, "Rayleigh damping by stiffness.")
      .field("roll_inertia", motion.roll_inertia, FlagOf(), kOptional,
             "Whether turning about the rod axis has inertia.")
      .field("load_factor", motion.load_factor, ListOf<PairOf>{{Measure::kTime, Measure::kRatio}, 1}, kOptional,
             "[time, load factor] pairs, linear in between; 1 throughout when absent.")
      .field("kicks", motion.kicks, ListOf<ObjectOf<MotionCase::Kick>>{{"kick"}}, kOptional, "Initial velocities.");
}

void MotionOf::read(Reader& reader, const JsonValue& json, MotionCase& motion) const {
  ObjectOf<MotionCase>{"motion"}.read(reader, json, motion);
}
JsonValue MotionOf::write(const MotionCase& motion) const { return ObjectOf<MotionCase>{"motion"}.write(motion); }
JsonValue MotionOf::schema(Schema& schema) const { return ObjectOf<MotionCase>{"motion"}.schema(schema); }

}  // namespace lissom
