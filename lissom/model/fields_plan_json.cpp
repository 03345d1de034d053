#include <algorithm>
#include <map>

#include "lissom/model/entries_json.h"

namespace lissom {
namespace {

constexpr std::pair<std::string_view, PlanCurve> kCurves[] = {
    {"spline", PlanCurve::kSpline}, {"straight", PlanCurve::kStraight}, {"arc", PlanCurve::kArc}};

constexpr PairOf kPlace{Measure::kLength, Measure::kLength};
constexpr NumberOf kRadius{Measure::kLength, kPositive};

/// A point in full; most are written as [x, y] alone.
struct PointEntry {
  std::string name;
  Vec2 at = Vec2::Zero();
  std::optional<double> r_n, r_b;
  bool split = false;
};

void describe(Fields& fields, PointEntry& point) {
  fields.field("at", point.at, kPlace, kRequired, "Where it is.")
      .field("r_n", point.r_n, kRadius, kOptional, "Radius of the rods here, out of the plane.")
      .field("r_b", point.r_b, kRadius, kOptional, "Radius of the rods here, in the plane.")
      .field("split", point.split, FlagOf(), kOptional, "Whether rods are cut here: they hold together but may kink.");
}

constexpr ObjectOf<PointEntry> kPoint{"point of the plan"};

struct PointOf {
  void read(Reader& reader, const JsonValue& json, PointEntry& point) const {
    if (json.is(JsonValue::Kind::kArray)) return kPlace.read(reader, json, point.at);
    kPoint.read(reader, json, point);
  }
  JsonValue write(const PointEntry& point) const {
    return point.r_n || point.r_b || point.split ? kPoint.write(point) : kPlace.write(point.at);
  }
  JsonValue schema(Schema& schema) const { return any_of({kPlace.schema(schema), kPoint.schema(schema)}); }
};

struct RodEntry {
  std::string name;
  std::vector<std::string> points;
  PlanCurve curve = PlanCurve::kSpline;
  bool closed = false, ghost = false;
};

void describe(Fields& fields, RodEntry& rod) {
  fields.field("name", rod.name, TextOf{false}, kRequired, "Name of the rod; its parts between splits are NAME-0, ...")
      .field("points", rod.points, ListOf<TextOf>{{false}, 2}, kRequired,
             "Names of the points it runs through, in order.")
      .field("curve", rod.curve, ChoiceOf<PlanCurve>{kCurves}, kOptional,
             "A smooth curve through the points, straight pieces, or arcs through three points each.")
      .field("closed", rod.closed, FlagOf(), kOptional, "Whether it returns to its first point.")
      .field("ghost", rod.ghost, FlagOf(), kOptional,
             "Whether it is only drawn: not printed, but the fabric follows it.");
}

/// One number for both axes, or [warp, weft].
struct StretchOf {
  static constexpr NumberOf kStretch{Measure::kRatio, kPositive};
  void read(Reader& reader, const JsonValue& json, Vec2& stretch) const {
    if (json.is(JsonValue::Kind::kArray)) {
      std::vector<double> both;
      ListOf<NumberOf>{kStretch, 2, 2}.read(reader, json, both);
      if (!reader.failed()) stretch = Vec2(both[0], both[1]);
      return;
    }
    double one = 1;
    kStretch.read(reader, json, one);
    stretch = Vec2(one, one);
  }
  JsonValue write(const Vec2& stretch) const {
    if (stretch[0] == stretch[1]) return kStretch.write(stretch[0]);
    return ListOf<NumberOf>{kStretch, 2, 2}.write(std::vector<double>{stretch[0], stretch[1]});
  }
  JsonValue schema(Schema& schema) const {
    return any_of({kStretch.schema(schema), ListOf<NumberOf>{kStretch, 2, 2}.schema(schema)});
  }
};

struct PlanEntry {
  std::vector<PointEntry> points;
  std::vector<RodEntry> rods;
  std::optional<double> r_n, r_b;
  Plan plan;  ///< all but points and rods
};

void describe(Fields& fields, PlanEntry& entry) {
  Plan& plan = entry.plan;
  fields
      .field("points", entry.points, TableOf<PointOf, PointEntry>{{}, &PointEntry::name}, kRequired,
             "Points that rods run through, by name; rods that share one are joined there.")
      .field("rods", entry.rods, ListOf<ObjectOf<RodEntry>>{{"rod of the plan"}, 1}, kRequired, "Rods and ghosts.")
      .field("material", plan.material, TextOf{false}, kRequired, "Material of the rods.")
      .field("r_n", entry.r_n, kRadius, kOptional, "Radius out of the plane at points that do not give their own.")
      .field("r_b", entry.r_b, kRadius, kOptional, "Radius in the plane at points that do not give their own.")
      .field("edge_length", plan.edge_length, NumberOf{Measure::kLength, kPositive}, kOptional,
             "Length that the edges of rods should have.")
      .field("max_turn", plan.max_turn, NumberOf{Measure::kAngle, kPositive}, kOptional,
             "Largest turn of a rod from edge to edge; edges are shorter where needed.")
      .field("fabric", plan.fabric, ObjectOf<Fabric>{"fabric of the plan"}, kRequired, "What the rods are printed on.");
}

/// The value that most points have, the first of equals.
std::optional<double> most_common(const std::vector<PlanPoint>& points, double PlanPoint::*radius) {
  std::map<double, int> counts;
  std::optional<double> best;
  int most = 0;
  for (const PlanPoint& point : points) most = std::max(most, ++counts[point.*radius]);
  for (const PlanPoint& point : points) {
    if (!best && counts[point.*radius] == most) best = point.*radius;
  }
  return best;
}

void read_points(Reader& reader, const PlanEntry& entry, Plan& plan) {
  const Reader::Step in_points(reader, "points");
  for (const PointEntry& from : entry.points) {
    const Reader::Step in_point(reader, from.name);
    const std::optional<double> r_n = from.r_n ? from.r_n : entry.r_n, r_b = from.r_b ? from.r_b : entry.r_b;
    if (!r_n || !r_b) {
      return reader.fail(ErrorCode::kType, "the rods have no radius at this point",
                         std::string("give \"") + (r_n ? "r_b" : "r_n") + "\" here, or in the plan for all points");
    }
    plan.points.push_back({from.name, from.at, *r_n, *r_b, from.split});
  }
}

void read_rods(Reader& reader, const PlanEntry& entry, Plan& plan) {
  std::map<std::string, int> numbers;
  std::vector<std::string> names;
  for (const PlanPoint& point : plan.points) {
    numbers.emplace(point.name, static_cast<int>(names.size()));
    names.push_back(point.name);
  }
  const Reader::Step in_rods(reader, "rods");
  for (std::size_t r = 0; r < entry.rods.size(); ++r) {
    const Reader::Step in_rod(reader, r);
    const Reader::Step in_points(reader, "points");
    const RodEntry& from = entry.rods[r];
    PlanRod& rod = plan.rods.emplace_back();
    rod.name = from.name;
    rod.curve = from.curve;
    rod.closed = from.closed;
    rod.role = from.ghost ? PlanRole::kGhost : PlanRole::kRod;
    for (std::size_t i = 0; i < from.points.size(); ++i) {
      const auto found = numbers.find(from.points[i]);
      if (found == numbers.end()) {
        const Reader::Step in_name(reader, i);
        return reader.fail(ErrorCode::kUnknown, "the plan has no point named \"" + from.points[i] + "\"",
                           suggestion(from.points[i], names));
      }
      rod.points.push_back(found->second);
    }
  }
}

void to_model(Reader& reader, const PlanEntry& entry, Plan& plan) {
  plan = entry.plan;
  read_points(reader, entry, plan);
  if (!reader.failed()) read_rods(reader, entry, plan);
}

void to_entry(const Plan& plan, PlanEntry& entry) {
  entry.plan = plan;
  entry.r_n = most_common(plan.points, &PlanPoint::r_n);
  entry.r_b = most_common(plan.points, &PlanPoint::r_b);
  for (const PlanPoint& point : plan.points) {
    PointEntry& to = entry.points.emplace_back();
    to.name = point.name;
    to.at = point.at;
    to.split = point.split;
    if (point.r_n != entry.r_n) to.r_n = point.r_n;
    if (point.r_b != entry.r_b) to.r_b = point.r_b;
  }
  for (const PlanRod& rod : plan.rods) {
    RodEntry& to = entry.rods.emplace_back();
    to.name = rod.name;
    to.curve = rod.curve;
    to.closed = rod.closed;
    to.ghost = rod.role == PlanRole::kGhost;
    for (const int i : rod.points) to.points.push_back(plan.points[static_cast<std::size_t>(i)].name);
  }
}

constexpr ConvertedOf<Plan, PlanEntry> kPlan{"plan"};

}  // namespace

void describe(Fields& fields, Fabric& fabric) {
  fields.field("material", fabric.material, TextOf{false}, kRequired, "Membrane material.")
      .field("pre_stretch", fabric.pre_stretch, StretchOf(), kOptional,
             "Stretched length by length at rest when the rods are printed, one number or [warp, weft].")
      .field("warp_angle", fabric.warp_angle, NumberOf{Measure::kAngle}, kOptional,
             "Turn from x to the warp direction.")
      .field("edge_length", fabric.edge_length, NumberOf{Measure::kLength, kPositive}, kOptional,
             "Length of the edges of triangles; that of rod edges when absent.")
      .field("min_angle", fabric.min_angle, NumberOf{Measure::kAngle, kNotNegative}, kOptional,
             "Smallest angle asked of the triangles, at most 30 degrees.")
      .field("bending", fabric.bending, NumberOf{Measure::kRatio, kNotNegative}, kOptional,
             "Multiplies the bending stiffness of the material; 0 switches it off.")
      .field("outline", fabric.outline, ListOf<TextOf>{{false}}, kOptional,
             "Names of the rods that form its edge; the outer loop of all rods when absent.")
      .field("holes", fabric.holes, ListOf<PairOf>{kPlace}, kOptional,
             "A point in each hole, which reaches up to the rods around it.");
}

void PlanOf::read(Reader& reader, const JsonValue& json, Plan& plan) const { kPlan.read(reader, json, plan); }
JsonValue PlanOf::write(const Plan& plan) const { return kPlan.write(plan); }
JsonValue PlanOf::schema(Schema& schema) const { return kPlan.schema(schema); }

}  // namespace lissom
