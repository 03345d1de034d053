#include "lissom/design/calibration_loads.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "lissom/design/objective_distance.h"
#include "lissom/design/objective_reaction_force.h"

namespace lissom {

namespace {

constexpr double kSamePlace = 1e-9;  // of the size of the structure
constexpr double kCancelled = 1e-9;  // of the forces whose sum it is

Vec3 mean_place(const Structure& structure, const std::vector<int>& nodes) {
  Vec3 sum = Vec3::Zero();
  for (const int node : nodes) sum += structure.nodes[static_cast<std::size_t>(node)];
  return sum / static_cast<double>(nodes.size());
}

}  // namespace

Status check_held(const Design& base, const StaticProblem& problem, const std::vector<int>& nodes,
                  const std::string& pose, const std::string& where) {
  const std::vector<int>& parts = problem.supports.free_parts();
  for (const int node : nodes) {
    const int part = base.system.structure.component[static_cast<std::size_t>(node)];
    if (std::find(parts.begin(), parts.end(), part) == parts.end()) continue;
    return Error{ErrorCode::kConflict, where,
                 fmt::format("pose \"{}\" does not hold the part that node {} belongs to, so that it may lie anywhere",
                             pose, node),
                 "hold it with a support or soft pins"};
  }
  return {};
}

Result<LengthLoads> LengthLoads::make(const Design& base, int pose, const ForceLengthBrief& brief,
                                      const std::string& where) {
  LengthLoads loads(base, pose);
  if (const Status s = loads.find_ends(brief, where); !s) return s.error();
  const bool by_force = brief.prescribed == ForceLengthBrief::Prescribed::kForce;
  const Status load = by_force ? loads.find_pattern(where) : loads.find_support(where);
  if (!load) return load.error();
  return loads;
}

Status LengthLoads::find_ends(const ForceLengthBrief& brief, const std::string& where) {
  const Structure& structure = base_.system.structure;
  Result<std::vector<int>> to = select(base_.model, structure, brief.to, where + "/to");
  if (!to) return to.error();
  to_ = std::move(to).value();
  std::vector<int> from;
  if (brief.from) {
    Result<std::vector<int>> selected = select(base_.model, structure, *brief.from, where + "/from");
    if (!selected) return selected.error();
    from = std::move(selected).value();
  }
  const Vec3 end = mean_place(structure, to_), start = from.empty() ? end : mean_place(structure, from);
  if (brief.axis) {
    direction_ = brief.axis->normalized();
    drawn_length_ = direction_.dot(end - start);
  } else {
    drawn_length_ = (end - start).norm();
    if (!(drawn_length_ > kSamePlace * structure.size)) {
      return Error{ErrorCode::kConflict, where, "both ends of the length are at one place, so that it has no direction",
                   "give other ends, or the \"axis\" along which the length counts"};
    }
    direction_ = (end - start) / drawn_length_;
  }
  length_ = from.empty() ? make_distance(start, to_, brief.axis) : make_distance(from, to_, brief.axis);
  reaction_ = make_reaction_force(to_, {direction_});
  const Result<StaticProblem> problem =
      make_static_problem(base_.model, base_.system, pose(), fmt::format("/poses/{}", pose_));
  if (!problem) return problem.error();
  if (brief.from && !brief.axis) return {};  // a distance does not change with where the structure lies
  return check_held(base_, problem.value(), to_, pose().name, where);
}

Status LengthLoads::find_pattern(const std::string& where) {
  Vec3 sum = Vec3::Zero();
  double size = 0;
  for (std::size_t i = 0; i < pose().forces.size(); ++i) {
    const PointForce& load = pose().forces[i];
    if (load.scaling != Scaling::kProportional) continue;
    const Result<std::vector<int>> at =
        select(base_.model, base_.system.structure, load.at, fmt::format("/poses/{}/forces/{}/at", pose_, i));
    if (!at) return at.error();
    const Vec3 force = load.shared ? load.force : Vec3(load.force * static_cast<double>(at.value().size()));
    sum += force;
    size += force.norm();
  }
  if (!(size > 0)) {
    return Error{ErrorCode::kConflict, where + "/prescribed",
                 fmt::format("pose \"{}\" has no force that could be scaled to those of the file", pose().name),
                 "add one to its \"forces\", of any size, or write \"prescribed\": \"length\""};
  }
  resultant_ = sum.norm();
  if (resultant_ > kCancelled * size) return {};
  return Error{ErrorCode::kConflict, fmt::format("/poses/{}/forces", pose_),
               "these forces cancel each other, so that they cannot be scaled to a measured one",
               "hold one end with a support instead of pulling at both"};
}

Status LengthLoads::find_support(const std::string& where) {
  const std::vector<Support>& supports = pose().supports;
  for (std::size_t i = 0; i < supports.size(); ++i) {
    const Result<std::vector<int>> at =
        select(base_.model, base_.system.structure, supports[i].at, fmt::format("/poses/{}/supports/{}/at", pose_, i));
    if (!at) return at.error();
    if (at.value() != to_) continue;
    support_ = static_cast<int>(i);
    return {};
  }
  return Error{ErrorCode::kConflict, where + "/to",
               fmt::format("no support of pose \"{}\" holds just these nodes, so that nothing moves them", pose().name),
               "let \"to\" name the nodes of the support that pulls, or write \"prescribed\": \"force\""};
}

Pose LengthLoads::with_force(double force) const {
  Pose loaded = pose();
  for (PointForce& load : loaded.forces) {
    if (load.scaling == Scaling::kProportional) load.force *= force / resultant_;
  }
  return loaded;
}

Result<Pose> LengthLoads::with_length(double length, const std::string& row) const {
  Pose loaded = pose();
  Vec3& move = loaded.supports[static_cast<std::size_t>(support_)].move;
  move += (length - drawn_length_ - direction_.dot(move)) * direction_;
  const Result<StaticProblem> problem =
      make_static_problem(base_.model, base_.system, loaded, fmt::format("/poses/{}", pose_));
  if (!problem) return problem.error();
  const State start = start_state(problem.value(), loaded);
  State moved;
  VecX there = VecX::Constant(1, std::nan(""));
  if (advance(base_.system, start, problem.value().supports.prescribed_increment(base_.system, start, 1), moved)) {
    length_->values({base_, loaded, problem.value(), moved}, there);
  }
  if (std::abs(there[0] - length) <= kSamePlace * base_.system.structure.size) return loaded;
  return Error{ErrorCode::kConflict, row,
               fmt::format("the supports of pose \"{}\" do not bring the ends to a distance of {:.6g} mm", pose().name,
                           1e3 * length),
               "hold both ends of the length in its direction, and check the unit"};
}

}  // namespace lissom
