/// Lagrange-Newton: Newton's method on the conditions of optimality of h under c = 0 and bounds [mathematics (4.9)-(4.11); errata
/// E22], as a sequence of quadratic programs
///   min 1/2 d'H_L d + g'd   subject to   J d = -c,  lower <= x + d_x <= upper,
/// whose multipliers are the next lambda. With factors of stiffness at hand J d = -c is d = (back + S v, v), which leaves a
/// problem in v alone. Its products are those of exact Newton on the reduced problem, but at states out of equilibrium and
/// with multipliers that lag behind.
///
/// The merit function is h + weight |H^-1 c|, with H that of the point: c is measured by how far it throws the state off, in
/// which stiff and soft directions compare [Deuflhard 2004, natural level functions]. A norm of the forces themselves would
/// allow thin rods hardly any step. A step that raises it is corrected to second order by the same factor before it is cut
/// [Nocedal & Wright 2006, 18.3 (18.37), 15.6].

#include <algorithm>
#include <cmath>
#include <limits>

#include "lissom/design/box_cg.h"
#include "lissom/design/total_run.h"

namespace lissom {

namespace {

constexpr double kArmijo = 1e-4;
constexpr double kRounding = 64 * std::numeric_limits<double>::epsilon();  // of h: changes that may be none
constexpr double kHidden = 1e-12;  // the same in equilibrium, where steps are the last ones
constexpr double kModel = 1e-10;   // of its first gradient, to which the quadratic program is solved
constexpr double kShare = 0.7;     // of the fall of |H^-1 c| that the merit function has to promise
constexpr int kLeastProducts = 50;

class Lagrange {
 public:
  explicit Lagrange(TotalRun& run)
      : run_(run),
        space_(run.space),
        exact_(run.options.method == TotalMethod::kLagrangeNewton),
        cap_(run.options.first_cap) {}

  void run() {
    while (run_.look()) {
      if (!step()) return;
    }
  }

 private:
  VecX hessian_times(const VecX& v, bool exact) const {
    return exact ? space_.lagrangian_times(lambda_, v) : space_.gauss_newton_times(v);
  }

  /// v of the quadratic program.
  BoxCgSolution solve_model(const MatX& gram, bool exact) {
    const Eliminated& at = run_.eliminated();
    const auto times = [&](const VecX& v) -> VecX {
      return exact ? at.onto(hessian_times(at.along(v), true)) : VecX(gram * v);
    };
    VecX back = VecX::Zero(space_.size()), lower, upper;
    back.head(space_.states()) = at.back;
    const VecX b = at.reduced + at.onto(hessian_times(back, exact));
    box(lower, upper);
    const int products = std::max(kLeastProducts, 4 * space_.parameters());
    return solve_box_cg(times, b, lower, upper, gram, kModel * b.cwiseAbs().maxCoeff(), products);
  }

  /// Largest moves of the parameters that cap and bounds allow.
  void box(VecX& lower, VecX& upper) const {
    lower = (space_.lower() - space_.x()).cwiseMin(0).cwiseMax(-cap_);
    upper = (space_.upper() - space_.x()).cwiseMax(0).cwiseMin(cap_);
  }

  /// False: there is a verdict.
  bool step() {
    const Eliminated& at = run_.eliminated();
    const int n = space_.states();
    const bool fresh = lambda_.size() == 0;
    if (fresh) lambda_ = -space_.solve(at.gradient.head(n));
    const MatX gram = at.jacobian.transpose() * at.jacobian;
    BoxCgSolution model = solve_model(gram, exact_);
    // Where the Lagrangian curves down, as it does far from the end, the Hessian of h alone makes better steps.
    const bool convex = !exact_ || !model.negative_curvature;
    if (!convex) model = solve_model(gram, false);
    const VecX d = at.step(model.x), image = hessian_times(d, exact_ && convex);
    if (!d.allFinite() || !image.allFinite()) return run_.end(TotalVerdict::kSingular, run_.worst()), false;
    const VecX next = -space_.solve(at.gradient.head(n) + image.head(n));

    const double off = at.back.norm(), slope_h = at.gradient.dot(d), curvature = std::max(d.dot(image), 0.0);
    weight_ = at.gradient.head(n).norm();  // what |H^-1 c| may gain in h, to first order
    if (off > 0 && !run_.in_equilibrium()) weight_ = std::max(weight_, (slope_h + 0.5 * curvature) / (kShare * off));
    slope_ = slope_h - weight_ * off;
    run_.record.merit_slope = slope_;
    run_.record.penalty = weight_;
    run_.record.step_length = model.x.cwiseAbs().maxCoeff();
    const double fraction = search(d, off);
    run_.record.fraction = fraction;
    if (fraction == 0) {
      run_.finish_iteration();
      if (run_.cancelled()) return run_.end(TotalVerdict::kCancelled), false;
      if (fresh) return run_.end(TotalVerdict::kStalled, run_.worst()), false;
      lambda_.resize(0);  // those of the point, once, before giving up
      return true;
    }
    lambda_ += fraction * (next - lambda_);
    const double taken = fraction * run_.record.step_length;
    if (fraction == 1 && taken >= 0.99 * cap_) cap_ *= 2;
    if (fraction < 0.5) cap_ = std::max(2 * taken, run_.options.least_step);
    run_.finish_iteration();
    space_.accept();
    return true;
  }

  /// Whether the last attempt lowers the merit function enough. `off`: |H^-1 c| at the point.
  bool good(double fraction, double off, VecX& thrown) {
    thrown = space_.solve(space_.attempted_constraint());
    if (run_.in_equilibrium() && space_.attempted_imbalance() <= 1) {
      // In the end forces that are accepted hide what h does: to first order lambda'c tells the two apart.
      const double change =
          space_.attempted_change() + lambda_.dot(space_.attempted_constraint() - space_.constraint());
      return change <= kArmijo * fraction * std::min(slope_, 0.0) + kHidden * space_.value();
    }
    const double change = space_.attempted_change() + weight_ * (thrown.norm() - off);
    return change <= kArmijo * fraction * std::min(slope_, 0.0) + kRounding * space_.value();
  }

  /// The fraction of the step that was attempted last and is good, 0: none is.
  double search(const VecX& d, double off) {
    VecX thrown;
    for (double a = space_.reach(d); a >= run_.options.least_step; a *= 0.5) {
      if (run_.cancelled()) return 0;
      if (!space_.attempt(d, a)) continue;
      if (good(a, off, thrown)) return a;
      // Where c comes to lie off its linear model, brought back.
      VecX corrected = d;
      corrected.head(space_.states()) -= (thrown + (1 - a) * run_.eliminated().back) / a;
      if (space_.reach(corrected) < a || !space_.attempt(corrected, a)) continue;
      if (good(a, off, thrown)) return a;
    }
    return 0;
  }

  TotalRun& run_;
  TotalSpace& space_;
  bool exact_;
  double cap_;
  VecX lambda_;
  double weight_ = 0, slope_ = 0;
};

}  // namespace

void run_lagrange(TotalRun& run) { Lagrange(run).run(); }

}  // namespace lissom
