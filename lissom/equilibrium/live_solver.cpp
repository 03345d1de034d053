#include "lissom/equilibrium/live_solver.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lissom/equilibrium/escape.h"
#include "lissom/equilibrium/report.h"
#include "lissom/equilibrium/rigid_drift.h"
#include "lissom/equilibrium/root_finder.h"
#include "lissom/equilibrium/solve.h"
#include "lissom/equilibrium/stability.h"
#include "lissom/equilibrium/start_smoothing.h"

namespace lissom {

namespace {

constexpr int kMaxEscapes = 8;
constexpr double kFarFromPrediction = 5;  // times the predicted move [mathematics 5.4]
constexpr double kNoticed = 1e-3;         // of the size: smaller moves are none to speak of

}  // namespace

LiveSolver::LiveSolver(const StaticProblem& problem, const SolveOptions& options, const Context& context)
    : problem_(problem), options_(options), context_(context), workspace_(problem, context_) {
  if (options.method == Method::kMinimize) minimizer_.emplace(workspace_, options_);
}

void LiveSolver::renew_terms() {
  if (minimizer_) minimizer_->renew_terms();
}

double LiveSolver::tolerance() const {
  return std::max(options_.tolerance * problem_.scales.force, 2 * problem_.scales.rounding);
}

Equilibrium LiveSolver::finish(Equilibrium result, Verdict verdict) {
  result.verdict = verdict;
  result.factorizations = workspace_.factorizations() - factorizations_before_;
  describe(problem_, workspace_, result);
  remember_strains(result.state);
  return result;
}

void LiveSolver::remember_strains(const State& state) {
  strains_.clear();
  const std::vector<EdgeRest>& rest = problem_.system->rest.edges;
  for (std::size_t e = 0; e < rest.size(); ++e) strains_.push_back(state.edges[e].length / rest[e].length - 1);
}

Equilibrium LiveSolver::settle(const State& start, double load_factor, std::span<const double> strains) {
  Equilibrium result;
  factorizations_before_ = workspace_.factorizations();
  result.state = start;
  result.records.reserve(std::clamp(options_.max_iterations, 1, 1024));
  result.tolerance = tolerance();
  if (!start.q.allFinite()) return finish(std::move(result), Verdict::kBadStart);
  if (is_crumpled(workspace_.system(), result.state)) {
    result.state = smoothed_start(problem_, result.state);
    result.start_smoothed = true;
  }
  const Descent moves = move_to_load(workspace_, result.state, load_factor, result.tolerance, options_,
                                     options_.max_iterations, result.records);
  result.iterations = moves.iterations;
  if (moves.verdict != Verdict::kStable) return finish(std::move(result), moves.verdict);
  return descend(std::move(result), FirstStep::kNewton, options_.max_iterations, strains);
}

bool LiveSolver::take_up(const State& equilibrium) {
  if (minimizer_) minimizer_->forget();
  following_ = {};
  remember_strains(equilibrium);
  workspace_.assemble(equilibrium);
  return workspace_.factorize(0).positive_definite;
}

Equilibrium LiveSolver::resettle(const State& before, std::optional<int> max_iterations) {
  Equilibrium result;
  factorizations_before_ = workspace_.factorizations();
  result.state = before;
  result.tolerance = tolerance();
  following_ = {};
  if (!before.q.allFinite()) return finish(std::move(result), Verdict::kBadStart);
  const System& system = workspace_.system();
  const VecX held = problem_.supports.prescribed_increment(system, before, before.load_factor);
  if (!held.isZero(0) && !advance(system, before, held, result.state)) {
    return finish(std::move(result), Verdict::kBadStart);
  }
  result = descend(std::move(result), FirstStep::kFactorAtHand,
                   std::min(max_iterations.value_or(options_.max_iterations), options_.max_iterations), strains_);
  following_.predicted = minimizer_ ? minimizer_->predicted_move() : 0;
  const double expected = kFarFromPrediction * following_.predicted + kNoticed * problem_.scales.length;
  following_.jumped = following_.jumped || following_.moved > expected;
  return result;
}

Equilibrium LiveSolver::descend(Equilibrium result, FirstStep first, int max_iterations,
                                std::span<const double> strains) {
  const VecX before = result.state.q;
  for (int escapes = 0;; ++escapes, first = FirstStep::kNewton, strains = {}) {
    const int left = std::max(max_iterations - result.iterations, 0);
    const Descent descent = minimizer_
                                ? minimizer_->run(result.state, result.tolerance, left, result.records, first, strains)
                                : find_root(workspace_, result.state, result.tolerance, options_, left, result.records);
    result.iterations += descent.iterations;
    result.residual = descent.residual;
    if (descent.verdict != Verdict::kStable) return finish(std::move(result), descent.verdict);

    const int nodes = problem_.system->layout.nodes();
    following_.moved = (result.state.q - before).head(3 * nodes).norm() / std::sqrt(nodes);
    following_.jumped = escapes > 0;
    if (!problem_.system->structure.triangles.empty()) {
      // Before the last factorisation: it has to be that of the state which is handed out.
      lay_down(problem_, result.state);
      workspace_.assemble(result.state);
    }
    const Stability stability = examine_stability(workspace_, options_.modes);
    result.modes = stability.modes;
    result.negative_modes = stability.negative;
    result.spins = stability.spins;
    if (stability.negative == 0) {
      return finish(std::move(result), stability.critical ? Verdict::kCritical : Verdict::kStable);
    }
    const bool leave = options_.at_saddle == AtSaddle::kEscape && minimizer_ && escapes < kMaxEscapes &&
                       !stability.modes.empty() && !context_.cancelled();
    if (!leave || !escape(workspace_, options_.path, result.state, stability.modes.front().shape)) {
      return finish(std::move(result), Verdict::kUnstable);
    }
  }
}

Equilibrium solve(const StaticProblem& problem, const State& start, double load_factor, const SolveOptions& options,
                  const Context& context) {
  return LiveSolver(problem, options, context).settle(start, load_factor);
}

}  // namespace lissom
