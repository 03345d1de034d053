#include "lissom/model/entries_json.h"

namespace lissom {
namespace {

constexpr VectorOf kPoint{Measure::kLength};
constexpr ListOf<VectorOf> kPoints{kPoint, 2};

}  // namespace

void describe(Fields& fields, Arc& arc) {
  fields.field("centre", arc.centre, kPoint, kRequired, "Centre of the circle.")
      .field("start", arc.start, kPoint, kRequired, "Where the arc begins; its distance from the axis is the radius.")
      .field("axis", arc.axis, DirectionOf(), kOptional, "Axis of the turn, right-handed.")
      .field("angle", arc.angle, NumberOf{Measure::kAngle, kNotZero}, kRequired,
             "Angle of the turn; 360 deg is a full circle.");
}

void describe(Fields& fields, Helix& helix) {
  fields.field("centre", helix.centre, kPoint, kRequired, "A point of the axis.")
      .field("start", helix.start, kPoint, kRequired,
             "Where the helix begins; its distance from the axis is the radius.")
      .field("axis", helix.axis, DirectionOf(), kOptional, "Direction of the axis.")
      .field("pitch", helix.pitch, NumberOf{Measure::kLength}, kRequired, "Rise along the axis per turn.")
      .field("turns", helix.turns, NumberOf{Measure::kRatio, kNotZero}, kRequired,
             "Number of turns; negative: left-handed.");
}

void describe_curve(Fields& fields, CurveEntry& entry) {
  fields
      .field("polyline", entry.polyline, kPoints, kOptional,
             "Straight pieces between points; every point becomes a node.")
      .field("spline", entry.spline, kPoints, kOptional, "Smooth curve through control points (Catmull-Rom).")
      .field("line", entry.line, ListOf<VectorOf>{kPoint, 2, 2}, kOptional, "Straight line between two points.")
      .field("arc", entry.arc, ObjectOf<Arc>{"arc"}, kOptional, "Circular arc.")
      .field("helix", entry.helix, ObjectOf<Helix>{"helix"}, kOptional, "Circular helix.")
      .field("closed", entry.closed, FlagOf(), kOptional,
             "Whether the last point joins the first again (polyline, spline, arc of a full turn).");
}

void describe(Fields& fields, CurveEntry& entry) { describe_curve(fields, entry); }

void to_model(Reader& reader, const CurveEntry& entry, Curve& curve) {
  const int kinds = entry.polyline.has_value() + entry.spline.has_value() + entry.line.has_value() +
                    entry.arc.has_value() + entry.helix.has_value();
  if (kinds == 0) {
    return reader.fail(ErrorCode::kType, "the centreline is missing",
                       "give one of \"line\", \"polyline\", \"spline\", \"arc\" or \"helix\"");
  }
  if (kinds > 1) {
    return reader.fail(ErrorCode::kConflict, "more than one centreline is given",
                       "keep one of \"line\", \"polyline\", \"spline\", \"arc\" and \"helix\"");
  }
  if (entry.closed && (entry.line || entry.helix)) {
    const Reader::Step step(reader, "closed");
    return reader.fail(ErrorCode::kConflict, entry.line ? "a line cannot be closed" : "a helix cannot be closed",
                       "remove \"closed\"");
  }
  if (entry.polyline) curve = Polyline{*entry.polyline, entry.closed};
  if (entry.spline) curve = Spline{*entry.spline, entry.closed};
  if (entry.line) curve = Polyline{*entry.line, false};
  if (entry.arc) {
    Arc arc = *entry.arc;
    arc.closed = entry.closed;
    curve = arc;
  }
  if (entry.helix) curve = *entry.helix;
}

void to_entry(const Curve& curve, CurveEntry& entry) {
  if (const auto* polyline = std::get_if<Polyline>(&curve)) {
    (polyline->points.size() == 2 && !polyline->closed ? entry.line : entry.polyline) = polyline->points;
    entry.closed = polyline->closed;
  } else if (const auto* spline = std::get_if<Spline>(&curve)) {
    entry.spline = spline->points;
    entry.closed = spline->closed;
  } else if (const auto* arc = std::get_if<Arc>(&curve)) {
    entry.arc = *arc;
    entry.closed = arc->closed;
  } else {
    entry.helix = std::get<Helix>(curve);
  }
}

}  // namespace lissom
