/// Quadratic penalty and augmented Lagrangian [mathematics (4.13), (4.15); erratum E23]: for fixed mu and lambda the function
///   F = h + lambda'c + mu/2 c'W c = 1/2 |r|^2 + mu/2 (c + b)'W (c + b) + constant,   b = W^-1 lambda / mu,
/// is a sum of squares, lowered by damped Gauss-Newton steps (Levenberg, Marquardt) within the bounds of x:
///   (R'R + mu J'W J + damping) d = -g - mu J'W c - J'lambda.
/// J'W J is never formed, which would square the condition of stiffness. With y = lambda + mu W (c + J d) the states' part is
///   [R_u'R_u + damping   H         ] [d_u]   [-g_u - R_u'R_x d_x        ]
///   [H                   -W^-1 / mu] [ y ] = [-c - W^-1 lambda/mu - M d_x],
/// sparse and well scaled for any mu; what it leaves is a quadratic program over the box of d_x.

#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "lissom/core/assert.h"
#include "lissom/design/box_qp.h"
#include "lissom/design/total_run.h"

namespace lissom {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kCorrections = 3;               // of one step
constexpr double kGood = 0.75, kPoor = 0.25;  // of what the model promises
constexpr double kGrowth = 4;                 // of the damping after a poor step
constexpr double kHidden = 1e-12;             // of F: changes that rounding hides
constexpr double kFirstDamping = 1e-3;        // of the mean diagonal entry of the reduced Gauss-Newton matrix
constexpr double kLeastDamping = 1e-12, kMostDamping = 1e12;  // of the first
constexpr double kFirstPenalty = 10;  // how much dearer it is to leave equilibrium than it gains
constexpr double kLittle = 1e-4;      // of mu/2 |c|^2: not worth a step
constexpr double kEnoughFall = 0.25;  // of |c|, from one update of the multipliers to the next

/// W of |c|^2 = c'W c.
class Metric {
 public:
  /// `hessian` (n x n) is that of kEnergy. Fails where it is not positive definite.
  bool set(PenaltyNorm norm, const SparseMatrix& hessian) {
    const bool energy = norm == PenaltyNorm::kEnergy;
    inverse_ = hessian;
    if (!energy) inverse_.setIdentity();
    factor_.compute(inverse_);
    return factor_.info() == Eigen::Success && factor_.vectorD().minCoeff() > 0;
  }
  const SparseMatrix& inverse() const { return inverse_; }
  VecX times(const VecX& c) const { return factor_.solve(c); }

 private:
  SparseMatrix inverse_;
  Eigen::SimplicialLDLT<SparseMatrix> factor_;
};

/// A step, with the model of F along it: change(a) = slope a + curvature a^2.
struct Step {
  VecX d;
  double slope = 0, curvature = 0, length = 0;

  double change(double a) const { return a * (slope + a * curvature); }
};

class Penalty {
 public:
  explicit Penalty(TotalRun& run)
      : run_(run),
        space_(run.space),
        multiplies_(run.options.method == TotalMethod::kAugmentedLagrangian),
        cap_(run.options.first_cap) {}

  void run() {
    bool begun = false;
    while (run_.look()) {
      if (!begun && !begin()) return;
      begun = true;
      if (!iterate()) return;
    }
  }

 private:
  bool begin() {
    if (!metric_.set(run_.options.norm, space_.hessian())) {
      run_.end(TotalVerdict::kSingular, "the start is not stable");
      return false;
    }
    space_.count(1, 0);
    const Eliminated& at = run_.eliminated();
    const double gains = at.jacobian.squaredNorm();
    const MatX mixed(space_.mixed());
    double costs = mixed.squaredNorm();
    if (run_.options.norm == PenaltyNorm::kEnergy) costs = -at.sensitivity.cwiseProduct(mixed).sum();  // S'H S
    if (!(gains > 0 && costs > 0)) {
      run_.end(TotalVerdict::kSingular, "no parameter moves what the goals look at");
      return false;
    }
    damping_ = first_damping_ = kFirstDamping * gains / space_.parameters();
    first_penalty_ = run_.options.first_penalty > 0 ? run_.options.first_penalty : kFirstPenalty * gains / costs;
    penalty_ = first_penalty_;
    lambda_ = VecX::Zero(space_.states());
    return true;
  }

  /// lambda + mu W c.
  VecX pull(const VecX& c) {
    space_.count(0, 1);
    return lambda_ + penalty_ * metric_.times(c);
  }

  SparseMatrix system() const {
    const int n = space_.states();
    const SparseMatrix& by_u = space_.residual_by_state();
    const SparseMatrix curvature = by_u.transpose() * by_u;
    std::vector<Eigen::Triplet<double>> entries;
    const auto append = [&](const SparseMatrix& part, int row, int column, double factor) {
      for (int j = 0; j < part.outerSize(); ++j) {
        for (SparseMatrix::InnerIterator it(part, j); it; ++it) {
          entries.emplace_back(row + static_cast<int>(it.row()), column + static_cast<int>(it.col()),
                               factor * it.value());
        }
      }
    };
    append(curvature, 0, 0, 1);
    for (int i = 0; i < n; ++i) entries.emplace_back(i, i, damping_);
    append(space_.hessian(), 0, n, 1);
    append(space_.hessian(), n, 0, 1);
    append(metric_.inverse(), n, n, -1 / penalty_);
    SparseMatrix matrix(2 * n, 2 * n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  }

  bool make_step(const VecX& pulled, Step& step) {
    const int n = space_.states(), m = space_.parameters();
    const SparseMatrix &by_u = space_.residual_by_state(), &by_x = space_.residual_by_x(), &mixed = space_.mixed();
    factor_.compute(system());
    space_.count(1, 1 + m);
    if (factor_.info() != Eigen::Success) return false;
    const VecX g = space_.gradient();
    MatX right(2 * n, m + 1);
    right.topLeftCorner(n, m) = -MatX(by_u.transpose() * by_x);
    right.bottomLeftCorner(n, m) = -MatX(mixed);
    right.col(m) << -g.head(n), -(space_.constraint() + metric_.inverse() * lambda_ / penalty_);
    const MatX solved = factor_.solve(right);
    if (!solved.allFinite()) return false;
    const MatX by_step = solved.leftCols(m);
    const VecX still = solved.col(m);
    const auto onto_x = [&](const MatX& v) -> MatX {
      return by_x.transpose() * (by_u * v.topRows(n)) + mixed.transpose() * v.bottomRows(n);
    };
    MatX b = onto_x(by_step) + MatX(by_x.transpose() * by_x);
    b = 0.5 * (b + MatX(b.transpose()));
    b.diagonal().array() += damping_;
    const VecX gx = g.tail(m) + VecX(onto_x(still));
    const VecX lower = (space_.lower() - space_.x()).cwiseMin(0).cwiseMax(-cap_);
    const VecX upper = (space_.upper() - space_.x()).cwiseMax(0).cwiseMin(cap_);
    const VecX dx = solve_box_qp(b, gx, lower, upper).x, states = still + by_step * dx;
    step.d.resize(n + m);
    step.d << states.head(n), dx;
    step.length = dx.cwiseAbs().maxCoeff();
    const VecX rd = by_u * states.head(n) + by_x * dx, jd = space_.constraint_times(step.d);
    step.slope = space_.residual().dot(rd) + pulled.dot(jd);
    step.curvature = 0.5 * rd.squaredNorm() + 0.5 * jd.dot(states.tail(n) - pulled);
    return step.d.allFinite();
  }

  /// F at point + fraction d less F at the point, infinite where there is no state; attempts it.
  double change_at(const VecX& d, double fraction, const VecX& pulled) {
    if (!space_.attempt(d, fraction)) return kInfinity;
    const VecX by = space_.attempted_constraint() - space_.constraint();
    return space_.attempted_change() + 0.5 * by.dot(pulled + pull(space_.attempted_constraint()));
  }

  /// d with the states that the matrices of the point make best of the last attempt, fraction d.
  VecX correct(const VecX& d, double fraction) {
    const int n = space_.states();
    VecX right(2 * n);
    right << -(space_.residual_by_state().transpose() * space_.attempted_residual()) - damping_ * fraction * d.head(n),
        -(space_.attempted_constraint() + metric_.inverse() * lambda_ / penalty_);
    space_.count(0, 1);
    const VecX solved = factor_.solve(right);
    VecX corrected = d;
    corrected.head(n) += solved.head(n) / fraction;
    return corrected;
  }

  /// One step, accepted or not. False: there is a verdict.
  bool iterate() {
    if (penalty_ > run_.options.largest_penalty * first_penalty_) {
      run_.end(TotalVerdict::kPenaltyLimit, run_.worst());
      return false;
    }
    const VecX pulled = pull(space_.constraint());
    const double value = space_.value();
    Step step;
    run_.record.penalty = penalty_;
    run_.record.damping = damping_;
    if (!make_step(pulled, step)) return run_.end(TotalVerdict::kSingular, run_.worst()), false;
    const double fraction = space_.reach(step.d), promised = -step.change(fraction);
    run_.record.merit_slope = promised;
    run_.record.step_length = step.length;
    double change = promised > 0 ? change_at(step.d, fraction, pulled) : kInfinity;
    // Where the valley of small |c| bends away from the step, states are brought back into it at the same parameters.
    for (int k = 0; k < kCorrections && std::isfinite(change) && !(-change > kGood * promised); ++k) {
      if (promised <= kHidden * value) break;
      const VecX corrected = correct(step.d, fraction);
      const double again = change_at(corrected, fraction, pulled);
      if (!(again < change)) {
        // The attempt before was the better one.
        change = change_at(step.d, fraction, pulled);
        break;
      }
      step.d = corrected;
      change = again;
    }
    // Below what rounding of F shows, a step has only not to raise it.
    const double level = value + std::abs(0.5 * space_.constraint().dot(pulled));
    const double violation = 0.5 * space_.constraint().dot(pulled - lambda_);
    const bool hidden = promised <= kHidden * level;
    const double ratio = hidden ? (change <= kHidden * level ? 1 : 0) : -change / promised;
    const bool accepted = ratio > 1e-4;
    run_.record.fraction = accepted ? fraction : 0;
    run_.finish_iteration();
    if (accepted) space_.accept();
    if (ratio > kGood) damping_ = std::max(damping_ / 3, kLeastDamping * first_damping_);
    if (!(ratio > kPoor)) damping_ *= growth_;
    growth_ = accepted ? kGrowth : 2 * growth_;  // [Nielsen 1999]
    if (accepted && ratio > kGood && step.length >= 0.99 * cap_) cap_ *= 2;
    if (!accepted) cap_ = std::min(cap_, 0.5 * step.length);
    if (damping_ > kMostDamping * first_damping_) return run_.end(TotalVerdict::kStalled, run_.worst()), false;
    // Steps that damping or turns hold back gain little without being near the end; of those that promise next to nothing
    // rounding may deny even that.
    const bool still = run_.record.gradient <= run_.options.gradient_tolerance * run_.first_gradient();
    const bool little = promised <= kLittle * violation;
    const bool done = hidden || still || (fraction == 1 && damping_ <= first_damping_ && (ratio > 0.5 || little));
    if (done) update(promised);
    return true;
  }

  /// Next multipliers or penalty, once steps gain less than what is left in c.
  void update(double gained) {
    if (run_.in_equilibrium()) return;
    const VecX& c = space_.constraint();
    const VecX weighted = metric_.times(c);
    space_.count(0, 1);
    const double squared = c.dot(weighted);
    if (gained > 0.5 * penalty_ * squared) return;
    const double size = std::sqrt(squared);
    if (multiplies_) lambda_ += penalty_ * weighted;
    if (!multiplies_ || (last_size_ >= 0 && size > kEnoughFall * last_size_)) penalty_ *= run_.options.penalty_growth;
    last_size_ = size;
    // F is another function now: what rounding or curvature did to the steps before says little.
    cap_ = std::max(cap_, run_.options.first_cap);
    damping_ = std::min(damping_, first_damping_);
    growth_ = kGrowth;
  }

  TotalRun& run_;
  TotalSpace& space_;
  bool multiplies_;
  double cap_, growth_ = kGrowth;
  Metric metric_;
  Eigen::SparseLU<SparseMatrix> factor_;
  VecX lambda_;
  double penalty_ = 1, first_penalty_ = 1, damping_ = 0, first_damping_ = 0, last_size_ = -1;
};

}  // namespace

void run_penalty(TotalRun& run) { Penalty(run).run(); }

}  // namespace lissom
