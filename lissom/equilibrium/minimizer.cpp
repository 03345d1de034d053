#include "lissom/equilibrium/minimizer.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "lissom/equilibrium/block_relaxation.h"
#include "lissom/equilibrium/escape.h"
#include "lissom/equilibrium/shift.h"
#include "lissom/equilibrium/step_limits.h"
#include "lissom/equilibrium/step_path.h"

namespace lissom {

namespace {

constexpr double kArmijo = 1e-4;
constexpr double kEnergyNoise = 1e-13;  // of the energy: differences below it are rounding
constexpr double kSmallestStep = 1e-7;
constexpr int kFirstRelaxation = 8;
constexpr double kBalance = 1e-3;           // of the forces before a step: rods are left with that in its trials
constexpr double kPredictedBalance = 1e-5;  // after a prediction, whose forces are those of a changed design
constexpr double kCgTolerance = 1e-2;       // of a step by conjugate gradients, in the norm of the preconditioner
constexpr double kCgFinest = 1e-4;          // where that ends the solve
constexpr int kCgIterations = 16;           // cost about as much as one factorisation
constexpr int kMostChords = 4;              // steps in a run that take the old factor for the present one
constexpr double kCrawl = 0.01;             // rad; steps this small along a shifted Hessian end in a saddle point
constexpr int kMostCrawling = 3;            // of them in a row before it is left
constexpr double kReuseGain = 0.3;          // forces have to fall to this share in a step without a factor of its own
constexpr double kReuseTurn = 0.05;         // rad; after larger steps a factor is not worth trying
constexpr double kRunawaySizes = 1e4;

}  // namespace

Minimizer::Minimizer(NewtonWorkspace& workspace, const SolveOptions& options)
    : workspace_(workspace), options_(options), path_(workspace, options.path), shift_(options.shift) {
  if (options.frames == Relaxation::kOn) {
    frames_.emplace(workspace, frame_unknowns(workspace.system()), path_.drift().can_move());
  }
  const bool membranes = !workspace.system().structure.triangles.empty();
  if (options.rods == Relaxation::kOn && membranes) {
    rods_.emplace(workspace, rod_unknowns(workspace.system()), path_.drift().can_move());
  }
  escapes_ = options.at_saddle == AtSaddle::kEscape && membranes;
  reuse_ = options.reuse == FactorReuse::kOn && membranes;
}

void Minimizer::renew_terms() {
  if (frames_) frames_->renew_terms();
  if (rods_) rods_->renew_terms();
}

double Minimizer::try_at(double a) {
  if (!path_.at(a, trial_)) return INFINITY;
  if (frames_) frames_->relax(trial_, 2, 0, tolerance_);
  if (rods_) {
    // No better than the whole will be after this step.
    const double enough = std::max(tolerance_, (predicted_ ? kPredictedBalance : kBalance) * residual_);
    if (predicted_) rods_->relax(trial_, kFirstRelaxation, 0, enough, Crumpled::kMend);
    if (!predicted_) rods_->relax(trial_, 2, shift(), enough);
  }
  const double v = workspace_.energy(trial_);
  return std::isfinite(v) ? v : INFINITY;
}

bool Minimizer::line_search(double slope, double curvature, double reach) {
  double a = reach;
  first_trial_ = true;
  while (a > kSmallestStep) {
    trial_energy_ = try_at(a);
    const double bound =
        energy_ + kArmijo * a * (slope + std::min(0.0, 0.5 * a * curvature)) + kEnergyNoise * std::abs(energy_);
    if (trial_energy_ <= bound) {
      taken_ = a;
      return true;
    }
    first_trial_ = false;
    if (std::isinf(trial_energy_)) {
      a *= 0.3;
      continue;
    }
    const double parabola = -slope * a * a / (2 * (trial_energy_ - energy_ - slope * a));
    a = std::isfinite(parabola) ? std::clamp(parabola, 0.4 * a, 0.65 * a) : 0.4 * a;
  }
  return false;
}

void Minimizer::expand(double slope, double turn, double roll) {
  for (int k = 0; k < 6; ++k) {
    double next = 2 * taken_;
    const double excess = trial_energy_ - energy_ - slope * taken_;
    if (excess > 0) next = std::min(3 * taken_, -slope * taken_ * taken_ / (2 * excess));
    if (turn > 0) next = std::min(next, options_.max_turn / turn);
    if (roll > 0) next = std::min(next, 3 * options_.max_roll / roll);
    if (next < 1.25 * taken_) return;
    std::swap(trial_, best_);
    const double reached = trial_energy_, v = try_at(next);
    if (!(v < reached)) {
      std::swap(trial_, best_);
      trial_energy_ = reached;
      return;
    }
    taken_ = next;
    trial_energy_ = v;
  }
}

bool Minimizer::newton_step() {
  free_ = -workspace_.free_gradient();
  predicted_ = predict_;
  if (predict_) {
    predict_ = own_factor_ = false;
    workspace_.factor().solve(free_, free_);
    return true;
  }
  if (stale_) {
    own_factor_ = false;
    image_ = free_;
    // The last step is worth a few more of them, as it saves an iteration.
    const double wanted = std::clamp(0.1 * tolerance_ / residual_, kCgFinest, kCgTolerance);
    const CgEnd end = cg_.solve(workspace_, image_, wanted, kCgIterations, free_);
    if (end == CgEnd::kConverged) return true;
    free_ = image_;
    if (end == CgEnd::kNegative && chords_ < kMostChords) {
      // The old matrix was positive definite: its step lowers the energy where the present one has no minimum.
      ++chords_;
      workspace_.factor().solve(free_, free_);
      return true;
    }
  }
  own_factor_ = true;
  if (!shift_.factorize(workspace_)) return false;
  workspace_.factor().solve(free_, free_);
  return true;
}

void Minimizer::fit_lengths(std::span<const double> strains) {
  step_.setZero(workspace_.system().layout.size());
  path_.begin(*state_, step_, 1, false, strains);
  if (path_.at(1, trial_)) std::swap(*state_, trial_);
}

void Minimizer::leave_saddle() {
  crawling_ = 0;
  const VecX free = shift_.negative_direction();
  if (free.size() != workspace_.problem().supports.unknowns()) return;
  VecX direction;
  workspace_.to_increment(free, direction);
  // A sign that does not depend on the solver: the largest entry is positive.
  int largest = 0;
  direction.cwiseAbs().maxCoeff(&largest);
  if (direction[largest] < 0) direction = -direction;
  if (escape(workspace_, options_.path, trial_, direction)) {
    if (rods_) rods_->relax(trial_, kFirstRelaxation, shift(), tolerance_);
    trial_energy_ = workspace_.energy(trial_);
  }
}

Descent Minimizer::run(State& state, double tolerance, int max_iterations, std::vector<IterationRecord>& records,
                       FirstStep first, std::span<const double> arrival) {
  Descent result;
  state_ = &state;
  crawling_ = chords_ = 0;
  tolerance_ = tolerance;
  predicted_move_ = 0;
  predict_ = first == FirstStep::kFactorAtHand && workspace_.has_plain_factor();
  stale_ = reuse_ && workspace_.has_plain_factor();
  if (!predict_ && !arrival.empty()) fit_lengths(arrival);
  if (rods_ && !predict_) {
    workspace_.assemble(state);  // for the metric of shifts
    rods_->relax(state, kFirstRelaxation, 0, tolerance_, Crumpled::kMend);
  }
  energy_ = workspace_.energy(*state_);
  if (!std::isfinite(energy_)) return result;
  int without_progress = 0;
  double last_residual = INFINITY, least_residual = INFINITY;
  for (;; ++result.iterations) {
    workspace_.assemble(*state_);
    result.residual = workspace_.residual();
    if (!std::isfinite(result.residual)) return result;
    if (result.residual <= tolerance) {
      result.verdict = Verdict::kStable;
      return result;
    }
    // Forces that are rounding of much larger ones cannot be lowered further.
    if (result.residual <= 10 * workspace_.problem().scales.rounding && result.residual >= 0.5 * last_residual) {
      result.verdict = Verdict::kStable;
      return result;
    }
    if (result.iterations >= max_iterations) {
      result.verdict = Verdict::kIterationLimit;
      return result;
    }
    if (workspace_.context().cancelled()) {
      result.verdict = Verdict::kCancelled;
      return result;
    }
    // An old factor that no longer brings the forces down has served its time.
    if (!own_factor_ && result.residual > kReuseGain * last_residual) stale_ = false;
    last_residual = residual_ = result.residual;
    if (!newton_step()) {
      result.verdict = Verdict::kStalled;
      return result;
    }
    const double slope = workspace_.free_gradient().dot(free_);
    workspace_.multiply_free(free_, image_);
    const double curvature = free_.dot(image_);
    workspace_.to_increment(free_, step_);
    path_.drift().remove(*state_, step_);
    if (predicted_) {
      const int nodes = workspace_.system().layout.nodes();
      predicted_move_ = step_.head(3 * nodes).norm() / std::sqrt(nodes);
    }
    const double reach = step_reach(workspace_.system(), *state_, step_, options_);
    path_.begin(*state_, step_, reach, own_factor_, predicted_ ? arrival : std::span<const double>());
    const bool moved = line_search(slope, curvature, reach);
    if (!moved) {
      // Near the end energies no longer tell steps apart: the full Newton step counts if it lowers the forces.
      const double residual = result.residual;
      if (!own_factor_) {  // the old factor misled: the next step gets its own
        stale_ = false;
        continue;
      }
      bool polished = false;
      if (shift() == 0 && path_.at(reach, trial_)) {
        workspace_.gradient(trial_, image_);
        workspace_.problem().supports.restrict(image_, free_);
        polished = workspace_.residual(free_) < 0.9 * residual;
      }
      if (!polished) {
        const bool rounding = residual <= 100 * workspace_.problem().scales.rounding;
        result.verdict = rounding ? Verdict::kStable : Verdict::kStalled;
        return result;
      }
      trial_energy_ = workspace_.energy(trial_);
      taken_ = reach;
    }
    const double turn = step_turn(workspace_.system(), *state_, step_);
    if (moved && first_trial_ && shift() > 0 && options_.expansion == Expansion::kOn) {
      expand(slope, turn, largest_roll(workspace_.system(), step_));
    }
    if (own_factor_) shift_.learn(workspace_);
    crawling_ = own_factor_ && shift_.negative() < 0 && taken_ * turn < kCrawl ? crawling_ + 1 : 0;
    if (crawling_ >= kMostCrawling && escapes_) leave_saddle();
    stale_ = reuse_ && workspace_.has_plain_factor() && taken_ * turn < kReuseTurn;
    std::swap(*state_, trial_);
    const double before = energy_;
    energy_ = trial_energy_;
    records.push_back({static_cast<int>(records.size()), state_->load_factor, energy_, result.residual, shift(), taken_,
                       taken_ * turn, workspace_.factorizations()});
    workspace_.context().report({"solve", -1, static_cast<int>(records.size()), result.residual, "minimising energy"});
    workspace_.show(*state_, result.residual);
    // Rounding in the energy can hide a cycle: stop when neither energy nor residual improves for a while.
    without_progress = (before - energy_ > kEnergyNoise * std::abs(energy_) || result.residual < 0.5 * least_residual)
                           ? 0
                           : without_progress + 1;
    least_residual = std::min(least_residual, result.residual);
    if (without_progress > 12) {
      result.verdict =
          result.residual <= 100 * workspace_.problem().scales.rounding ? Verdict::kStable : Verdict::kStalled;
      return result;
    }
    const double size = workspace_.problem().scales.length;
    if ((state_->position(0) - workspace_.system().structure.nodes[0]).norm() > kRunawaySizes * size ||
        state_->q.head(3 * workspace_.system().layout.nodes()).cwiseAbs().maxCoeff() >
            2 * kRunawaySizes * size + 1e6 * size) {
      result.verdict = Verdict::kRunaway;
      return result;
    }
  }
}

Descent minimize(NewtonWorkspace& workspace, State& state, double tolerance, const SolveOptions& options,
                 int max_iterations, std::vector<IterationRecord>& records) {
  return Minimizer(workspace, options).run(state, tolerance, max_iterations, records);
}

}  // namespace lissom
