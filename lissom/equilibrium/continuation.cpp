#include "lissom/equilibrium/continuation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lissom/equilibrium/arc_length.h"
#include "lissom/equilibrium/critical_point.h"
#include "lissom/equilibrium/minimizer.h"
#include "lissom/equilibrium/report.h"

namespace lissom {

namespace {

class PathFollower {
 public:
  PathFollower(const StaticProblem& problem, const LoadPath& path, const PathOptions& options, const Context& context)
      : problem_(problem),
        path_(path),
        options_(options),
        context_(context),
        workspace_(problem, context),
        tolerance_(std::max(options.solve.tolerance * problem.scales.force, 2 * problem.scales.rounding)) {}

  PathResult run(const State& start);

 private:
  bool record(const State& state, const PathStability& stability);
  bool critical_between(const State& a, const PathStability& at_a, const State& b, const PathStability& at_b);
  void follow_load(State state, PathStability stability);
  void follow_arc(State state, PathStability stability);
  bool leave_on_branch(const CriticalPoint& point, double towards, State& state);
  PathResult& end(PathEnd how, std::string message);

  const StaticProblem& problem_;
  const LoadPath& path_;
  const PathOptions& options_;
  const Context& context_;
  NewtonWorkspace workspace_;
  double tolerance_;
  bool switched_ = false;
  PathResult result_;
};

PathResult& PathFollower::end(PathEnd how, std::string message) {
  result_.end = how;
  result_.message = std::move(message);
  result_.factorizations = workspace_.factorizations();
  return result_;
}

bool PathFollower::record(const State& state, const PathStability& stability) {
  PathPoint point;
  point.state = state;
  workspace_.assemble(state);
  point.energy = workspace_.energy(state);
  point.residual = workspace_.residual();
  point.negative_modes = stability.negative;
  point.lowest = stability.lowest;
  point.reaction = reactions(problem_, workspace_.local_gradient());
  result_.points.push_back(std::move(point));
  const double range = path_.to - path_.from;
  context_.report({"path", std::clamp((state.load_factor - path_.from) / range, 0.0, 1.0),
                   static_cast<int>(result_.points.size()), result_.points.back().residual, "following the path"});
  return static_cast<int>(result_.points.size()) < options_.max_points;
}

bool PathFollower::critical_between(const State& a, const PathStability& at_a, const State& b,
                                    const PathStability& at_b) {
  if (at_a.negative == at_b.negative) return false;
  const double width = options_.critical_tolerance * std::abs(path_.to - path_.from);
  auto point = locate_critical(workspace_, a, at_a, b, at_b, width, tolerance_, options_.solve);
  if (!point) return false;
  result_.critical.push_back(std::move(*point));
  return true;
}

PathResult PathFollower::run(const State& start) {
  State state = start;
  if (!state.q.allFinite() || !std::isfinite(workspace_.energy(state))) {
    return end(PathEnd::kBadStart, "the start shape has no finite energy");
  }
  std::vector<IterationRecord> records;
  if (move_to_load(workspace_, state, path_.from, tolerance_, options_.solve, options_.solve.max_iterations, records)
          .verdict != Verdict::kStable) {
    return end(PathEnd::kBadStart, "the prescribed places at the start of the path cannot be reached");
  }
  // A path starts in a stable shape if there is one near; the branch is then followed wherever it leads.
  const Descent descent =
      minimize(workspace_, state, tolerance_, options_.solve, options_.solve.max_iterations, records);
  if (descent.verdict != Verdict::kStable) {
    return end(descent.verdict == Verdict::kCancelled ? PathEnd::kCancelled : PathEnd::kBadStart,
               "no equilibrium at the start of the path: " + std::string(verdict_info(descent.verdict).sentence));
  }
  PathStability stability = path_stability(workspace_, state);
  if (path_.follow == LoadPath::Follow::kArcLength) {
    follow_arc(std::move(state), std::move(stability));
  } else {
    follow_load(std::move(state), std::move(stability));
  }
  result_.factorizations = workspace_.factorizations();
  return std::move(result_);
}

void PathFollower::follow_load(State state, PathStability stability) {
  record(state, stability);
  const double range = path_.to - path_.from;
  double stride = range / path_.steps;
  State next;
  for (int step = 1; step <= path_.steps; ++step) {
    const double target = path_.from + range * step / path_.steps;
    while (state.load_factor != target) {
      if (context_.cancelled()) {
        end(PathEnd::kCancelled, "stopped by you");
        return;
      }
      double load = state.load_factor + stride;
      if ((range > 0) == (load >= target) || std::abs(target - load) < 1e-9 * std::abs(range)) load = target;
      if (!step_load(workspace_, state, load, tolerance_, options_.solve, next)) {
        stride *= 0.5;
        if (std::abs(stride) < 1e-7 * std::abs(range)) {
          end(PathEnd::kStepTooSmall, "no equilibrium next to load factor " + std::to_string(state.load_factor) +
                                          " on this branch: follow the arc length to pass a fold");
          return;
        }
        continue;
      }
      PathStability at_next = path_stability(workspace_, next);
      if (critical_between(state, stability, next, at_next)) {
        const CriticalPoint& point = result_.critical.back();
        if (path_.stop_at_critical) {
          record(point.state, path_stability(workspace_, point.state));
          end(PathEnd::kStoppedAtCritical, "stopped at the first critical point");
          return;
        }
        if (path_.switch_branch && !switched_ && at_next.negative > stability.negative) {
          State branch;
          if (leave_on_branch(point, load, branch)) {
            switched_ = true;
            next = std::move(branch);
            at_next = path_stability(workspace_, next);
          }
        }
      }
      std::swap(state, next);
      stability = std::move(at_next);
      stride = std::copysign(std::min(1.6 * std::abs(stride), std::abs(range) / path_.steps), range);
    }
    if (!record(state, stability)) {
      end(PathEnd::kIterationLimit, "the path has more points than allowed");
      return;
    }
  }
  end(PathEnd::kReached, "the end of the path was reached");
}

bool PathFollower::leave_on_branch(const CriticalPoint& point, double towards, State& state) {
  // From the critical point sideways along its mode, then down to the stable shape at the next load.
  const System& system = *problem_.system;
  const double turn = largest_turn(system, point.state, point.mode.shape);
  for (const double size : {0.05, 0.1, 0.2, 0.4}) {
    State sideways;
    const VecX step = (size / std::max(turn, 1e-300)) * point.mode.shape;
    if (!advance(system, point.state, step, sideways)) continue;
    std::vector<IterationRecord> records;
    const Descent moved =
        move_to_load(workspace_, sideways, towards, tolerance_, options_.solve, options_.solve.max_iterations, records);
    if (moved.verdict != Verdict::kStable) continue;
    const Descent descent =
        minimize(workspace_, sideways, tolerance_, options_.solve, options_.solve.max_iterations, records);
    if (descent.verdict != Verdict::kStable) continue;
    if (path_stability(workspace_, sideways).negative > point.negative_before) continue;
    state = std::move(sideways);
    return true;
  }
  return false;
}

void PathFollower::follow_arc(State state, PathStability stability) {
  record(state, stability);
  const double range = path_.to - path_.from;
  ArcLength arc(workspace_, tolerance_, range / path_.steps);
  State next;
  while (true) {
    if (context_.cancelled()) {
      end(PathEnd::kCancelled, "stopped by you");
      return;
    }
    const ArcLength::Outcome outcome = arc.step(state, next);
    if (outcome == ArcLength::Outcome::kStuck) {
      end(PathEnd::kStepTooSmall,
          "the path cannot be continued beyond load factor " + std::to_string(state.load_factor));
      return;
    }
    PathStability at_next = path_stability(workspace_, next);
    if (at_next.negative != stability.negative) {
      const bool turned = (arc.direction_before() > 0) != (arc.direction() > 0);
      if (turned) {
        // The load has passed its extremum between the two points: a fold, at the larger of them.
        CriticalPoint point;
        point.kind = CriticalKind::kFold;
        point.state = std::abs(at_next.nearest) < std::abs(stability.nearest) ? next : state;
        point.load_factor = arc.extremum();
        point.negative_before = stability.negative;
        point.negative_after = at_next.negative;
        const PathStability& nearest = std::abs(at_next.nearest) < std::abs(stability.nearest) ? at_next : stability;
        point.mode.stiffness = nearest.nearest;
        if (nearest.nearest_shape.size() > 0) workspace_.to_increment(nearest.nearest_shape, point.mode.shape);
        result_.critical.push_back(std::move(point));
      } else {
        critical_between(state, stability, next, at_next);
      }
      if (path_.stop_at_critical && !result_.critical.empty()) {
        record(next, at_next);
        end(PathEnd::kStoppedAtCritical, "stopped at the first critical point");
        return;
      }
    }
    std::swap(state, next);
    stability = std::move(at_next);
    if (!record(state, stability)) {
      end(PathEnd::kIterationLimit, "the path has more points than allowed");
      return;
    }
    const double place = (state.load_factor - path_.from) / range;
    if (place >= 1) {
      end(PathEnd::kReached, "the end of the path was reached");
      return;
    }
    if (place < -1) {
      end(PathEnd::kReached, "the branch has turned back beyond the start of the path");
      return;
    }
  }
}

}  // namespace

PathResult follow_path(const StaticProblem& problem, const State& start, const LoadPath& path,
                       const PathOptions& options, const Context& context) {
  return PathFollower(problem, path, options, context).run(start);
}

}  // namespace lissom
