#include "lissom/design/total_space.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "lissom/core/assert.h"
#include "lissom/equilibrium/step_limits.h"

namespace lissom {

namespace {

constexpr double kStateScale = 0.01;  // of the size, and rad

/// Local axes to global, (unknowns x unknowns).
SparseMatrix axes_of(const Supports& supports, int unknowns) {
  std::vector<bool> turned(static_cast<std::size_t>(unknowns), false);
  std::vector<Eigen::Triplet<double>> entries;
  for (const LocalAxes& local : supports.local_axes()) {
    for (int a = 0; a < 3; ++a) {
      turned[static_cast<std::size_t>(local.first_dof + a)] = true;
      for (int b = 0; b < 3; ++b) entries.emplace_back(local.first_dof + a, local.first_dof + b, local.axes(a, b));
    }
  }
  for (int i = 0; i < unknowns; ++i) {
    if (!turned[static_cast<std::size_t>(i)]) entries.emplace_back(i, i, 1.0);
  }
  SparseMatrix axes(unknowns, unknowns);
  axes.setFromTriplets(entries.begin(), entries.end());
  return axes;
}

/// Which unknown of the layout each free one is.
std::vector<int> free_unknowns(const Supports& supports) {
  std::vector<int> free;
  const std::span<const int> kept = supports.kept();
  for (int i = 0; i < static_cast<int>(kept.size()); ++i) {
    if (kept[static_cast<std::size_t>(i)] >= 0) free.push_back(i);
  }
  return free;
}

const Pose& pose_of(const Design& design, int pose) { return design.model.poses[static_cast<std::size_t>(pose)]; }

}  // namespace

TotalSpace::TotalSpace(const StructureProblem& problem, const Context& context)
    : problem_(&problem), context_(context), first_{0}, design_(problem.design()) {
  scale_.resize(problem.size());
  for (int i = 0; i < problem.size(); ++i) {
    scale_[i] = problem.space().parameters()[static_cast<std::size_t>(i)].scale;
  }
}

Result<std::unique_ptr<TotalSpace>> TotalSpace::make(const StructureProblem& problem, const Context& context) {
  for (std::size_t g = 0; g < problem.goals().size(); ++g) {
    if (problem.goals()[g].force == GoalForce::kSoft) continue;
    return Error{ErrorCode::kUnsupported, "/design/goals/" + std::to_string(g),
                 "in total space there are no hard goals besides equilibrium",
                 "make the goal soft, or use a method of the reduced problem"};
  }
  if ((problem.point().pin_factors.array() != 1).any()) {
    return Error{ErrorCode::kUnsupported, "/design/settings/pins", "in total space soft pins are as stiff as described",
                 "make pins \"fixed\", or use a method of the reduced problem"};
  }
  std::unique_ptr<TotalSpace> space(new TotalSpace(problem, context));
  for (const auto& follower : problem.poses()) {
    if (const Status s = space->add_part(follower->pose()); !s) return s.error();
  }
  if (const Status s = space->stand_at(problem.point()); !s) return s.error();
  return space;
}

Status TotalSpace::add_part(int pose) {
  const std::string where = "/poses/" + std::to_string(pose);
  if (!pose_of(design_, pose).moments.empty()) {
    return Error{ErrorCode::kUnsupported, where + "/moments", "moments have no potential away from equilibrium",
                 "use forces, or a method of the reduced problem"};
  }
  auto part = std::make_unique<Part>();
  part->pose = pose;
  part->system = design_.system;
  Result<StaticProblem> problem = make_static_problem(design_.model, part->system, pose_of(design_, pose), where);
  if (!problem) return problem.error();
  part->problem = std::make_unique<StaticProblem>(std::move(problem).value());
  part->workspace = std::make_unique<NewtonWorkspace>(*part->problem, context_);
  // Second orders of a path need third derivatives at every step; what thin rods need is that edges turn.
  part->path = std::make_unique<StepPathPolicy>(*part->workspace, StepPath::kRotating);
  for (const Goal& goal : problem_->goals()) {
    if (goal.pose == pose) part->goals.push_back(&goal);
  }
  const StaticProblem& made = *part->problem;
  const DofLayout& layout = part->system.layout;
  const double length = kStateScale * made.scales.length;
  part->energy = made.scales.force * length;
  const std::vector<int> free = free_unknowns(made.supports);
  part->scale.resize(static_cast<Eigen::Index>(free.size()));
  SparseMatrix chosen(layout.size(), static_cast<Eigen::Index>(free.size()));
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < static_cast<int>(free.size()); ++i) {
    const int dof = free[static_cast<std::size_t>(i)];
    part->scale[i] = layout.dof_class(dof) == DofClass::kPosition ? length : kStateScale;
    entries.emplace_back(dof, i, part->scale[i]);
  }
  chosen.setFromTriplets(entries.begin(), entries.end());
  part->to_global = axes_of(made.supports, layout.size());
  part->free = part->to_global * chosen;
  first_.push_back(first_.back() + static_cast<int>(free.size()));
  parts_.push_back(std::move(part));
  return {};
}

Status TotalSpace::check_curvature() const {
  for (const Goal& goal : problem_->goals()) {
    if (Status s = lissom::check_curvature(goal); !s) return s;
  }
  return {};
}

Status TotalSpace::renew(const Design& design) {
  for (const auto& part : parts_) {
    const std::string where = "/poses/" + std::to_string(part->pose);
    Status s =
        renew_numbers(design.model, pose_of(design, part->pose), where, design.system, part->system, *part->problem);
    if (!s) return s;
  }
  return {};
}

void TotalSpace::renew_point() {
  if (numbers_ == Numbers::kPoint) return;
  const Status s = renew(design_);
  LISSOM_ASSERT(s);
  numbers_ = Numbers::kPoint;
}

double TotalSpace::tolerance(const Part& part) const {
  const Scales& scales = part.problem->scales;
  return std::max(problem_->options().solve.tolerance * scales.force, 2 * scales.rounding);
}

/// r, c and imbalance of the states in equilibrium or not; numbers are those of the design. False: not finite.
bool TotalSpace::evaluate(const Design& design, const VecX& p, State Part::*state, VecX& residual, VecX& constraint,
                          double& imbalance) {
  ++effort_.evaluations;
  std::vector<VecX> parts;
  constraint.resize(states());
  imbalance = 0;
  VecX gradient, free;
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    Part& part = *parts_[k];
    for (const Goal* goal : part.goals) {
      parts.push_back(goal_residual(*goal, {design, pose_of(design, part.pose), *part.problem, part.*state}));
    }
    part.workspace->gradient(part.*state, gradient);
    part.problem->supports.restrict(gradient, free);
    constraint.segment(first_[k], free.size()) = part.scale.cwiseProduct(free) / part.energy;
    imbalance = std::max(imbalance, part.workspace->residual(free) / tolerance(part));
  }
  for (const ParameterGoal& wish : problem_->wishes()) {
    parts.emplace_back(std::sqrt(wish.weight) * (wish.rows * (p - wish.target)));
  }
  Eigen::Index size = 0;
  for (const VecX& r : parts) size += r.size();
  residual.resize(size);
  size = 0;
  for (const VecX& r : parts) {
    residual.segment(size, r.size()) = r;
    size += r.size();
  }
  return residual.allFinite() && constraint.allFinite() && std::isfinite(imbalance);
}

Status TotalSpace::stand_at(const DesignPoint& point) {
  LISSOM_ASSERT(point.states.size() == parts_.size() && point.p.size() == parameters());
  Result<Design> design = problem_->space().at(point.p);
  if (!design) return design.error();
  linear_ = false;
  design_ = std::move(design).value();
  p_ = point.p;
  x_ = p_.cwiseQuotient(scale_);
  if (Status s = renew(design_); !s) return s;
  numbers_ = Numbers::kPoint;
  for (std::size_t k = 0; k < parts_.size(); ++k) parts_[k]->state = point.states[k];
  if (evaluate(design_, p_, &Part::state, residual_, constraint_, imbalance_)) return {};
  return Error{ErrorCode::kRange, "/design", "forces or goals have no finite value at the start",
               "start from a point where `lissom solve` finds an equilibrium"};
}

DesignPoint TotalSpace::point() const {
  DesignPoint point{p_, {}, VecX::Ones(static_cast<Eigen::Index>(parts_.size()))};
  for (const auto& part : parts_) point.states.push_back(part->state);
  return point;
}

std::string TotalSpace::worst_force() const {
  double worst = -1, force = 0;
  const Part* at = nullptr;
  int unknown = 0;
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    const Part& part = *parts_[k];
    const std::vector<int> free = free_unknowns(part.problem->supports);
    for (int i = 0; i < part.scale.size(); ++i) {
      const int dof = free[static_cast<std::size_t>(i)];
      double own = std::abs(constraint_[first_[k] + i]) * part.energy / part.scale[i];
      if (part.system.layout.dof_class(dof) != DofClass::kPosition) own /= part.system.rest.mean_edge_length;
      if (!(own / tolerance(part) > worst)) continue;
      worst = own / tolerance(part);
      force = own;
      at = &part;
      unknown = dof;
    }
  }
  if (at == nullptr) return "nothing can move";
  const DofLayout& layout = at->system.layout;
  const std::string name = pose_of(design_, at->pose).name;
  switch (layout.dof_class(unknown)) {
    case DofClass::kPosition:
      return fmt::format("pose \"{}\": {:.3g} N are left at node {}", name, force, unknown / 3);
    case DofClass::kRoll:
      return fmt::format("pose \"{}\": {:.3g} N, over an edge, of torque are left in edge {}", name, force,
                         unknown - layout.roll(0));
    case DofClass::kRotation:
      break;
  }
  return fmt::format("pose \"{}\": {:.3g} N, over an edge, of moment are left at a joint", name, force);
}

VecX TotalSpace::increment(int k, const VecX& v) const {
  const Part& part = *parts_[static_cast<std::size_t>(k)];
  VecX dq = part.free * v.segment(first_[static_cast<std::size_t>(k)], part.free.cols());
  if (part.held.cols() > 0) dq += part.held * v.tail(parameters());
  return dq;
}

double TotalSpace::reach(const VecX& step) const {
  double reach = 1;
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    const Part& part = *parts_[k];
    const VecX dq = increment(static_cast<int>(k), step);
    reach = std::min(reach, step_reach(part.system, part.state, dq, problem_->options().solve));
  }
  return std::min(reach, 1.0);
}

bool TotalSpace::attempt(const VecX& step, double fraction) {
  LISSOM_ASSERT(step.size() == size());
  const StructureProblem& problem = *problem_;
  attempted_x_ = (x_ + fraction * step.tail(parameters())).cwiseMax(lower()).cwiseMin(upper());
  attempted_p_.resize(parameters());
  for (int i = 0; i < parameters(); ++i) {
    const Parameter& parameter = problem.space().parameters()[static_cast<std::size_t>(i)];
    attempted_p_[i] = std::clamp(attempted_x_[i] * scale_[i], parameter.lower, parameter.upper);
  }
  if (!step.allFinite()) return false;
  Result<Design> design = problem.space().at(attempted_p_);
  if (!design) return false;
  attempted_design_ = std::move(design).value();
  numbers_ = Numbers::kAttempt;
  if (!renew(attempted_design_)) return false;
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    Part& part = *parts_[k];
    part.path->begin(part.state, increment(static_cast<int>(k), step), fraction, false);
    if (!part.path->at(fraction, part.attempted)) return false;
    if (!holds_) continue;
    // What is held is where this design has it, to the last bit and not to first order.
    const VecX rest = part.problem->supports.prescribed_increment(part.system, part.attempted, part.state.load_factor);
    State moved;
    if (!advance(part.system, part.attempted, rest, moved)) return false;
    part.attempted = std::move(moved);
  }
  return evaluate(attempted_design_, attempted_p_, &Part::attempted, attempted_residual_, attempted_constraint_,
                  attempted_imbalance_);
}

double TotalSpace::attempted_change() const {
  return 0.5 * (attempted_residual_ - residual_).dot(attempted_residual_ + residual_);
}

void TotalSpace::accept() {
  LISSOM_ASSERT(numbers_ == Numbers::kAttempt);
  linear_ = false;
  for (const auto& part : parts_) {
    part->linear.reset();
    std::swap(part->state, part->attempted);
  }
  std::swap(design_, attempted_design_);
  p_ = attempted_p_;
  x_ = p_.cwiseQuotient(scale_);
  residual_ = attempted_residual_;
  constraint_ = attempted_constraint_;
  imbalance_ = attempted_imbalance_;
  numbers_ = Numbers::kPoint;
}

void TotalSpace::count(int factorizations, int back_solves) {
  effort_.factorizations += factorizations;
  effort_.back_solves += back_solves;
}

}  // namespace lissom
