#include "lissom/model/entries_json.h"

namespace lissom {

// Found by argument-dependent lookup, hence in the namespace of the struct.
void describe(Fields& fields, StripPull& pull) {
  fields.field("angle", pull.angle, NumberOf{Measure::kAngle}, kRequired, "From the warp to the length of the strip.")
      .field("stretch", pull.stretch, NumberOf{Measure::kRatio, kPositive}, kRequired, "Stretch along the strip.")
      .field("force_per_width", pull.force_per_width, NumberOf{Measure::kForcePerLength, kPositive}, kRequired,
             "Force over the rest width.")
      .field("across", pull.across, NumberOf{Measure::kRatio, kPositive}, kOptional,
             "Stretch of lines across the strip, where it was measured.");
}

void FabricTestOf::read(Reader& reader, const JsonValue& json, FabricTest& test) const {
  ListOf<ObjectOf<StripPull>>{{"pull"}, 1}.read(reader, json, test.pulls);
}
JsonValue FabricTestOf::write(const FabricTest& test) const {
  return ListOf<ObjectOf<StripPull>>{{"pull"}, 1}.write(test.pulls);
}
JsonValue FabricTestOf::schema(Schema& schema) const { return ListOf<ObjectOf<StripPull>>{{"pull"}, 1}.schema(schema); }

}  // namespace lissom
