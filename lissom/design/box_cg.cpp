#include "lissom/design/box_cg.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "lissom/core/assert.h"
#include "lissom/design/free_factor.h"

namespace lissom {

namespace {

constexpr double kArmijo = 1e-4;
constexpr double kFlat = 1e-14;      // of |p| |Hp|: less curvature along p than this is none
constexpr double kLeastLike = 1e-6;  // of the largest diagonal entry, added to the preconditioner
constexpr double kShare = 0.5;       // of the tolerance, to which one run of conjugate gradients goes
constexpr double kShortest = 0.03;   // of a step, clipped: below it another direction is taken

struct Move {
  VecX w, image;  // and H w
};

class BoxCg {
 public:
  BoxCg(const std::function<VecX(const VecX&)>& times, const VecX& lower, const VecX& upper, const MatX& like_h,
        int max_products)
      : times_(times), lower_(lower), upper_(upper), max_products_(max_products), like_(like_h) {
    if (like_.size() == 0) return;
    largest_ = std::max(like_.diagonal().cwiseAbs().maxCoeff(), 1e-300);
    like_.diagonal().array() += kLeastLike * largest_;
  }

  BoxCgSolution solve(const VecX& g, double tolerance) {
    const int m = static_cast<int>(g.size());
    out_.x = VecX::Zero(m);
    gradient_ = g;
    for (;;) {
      look_at_bounds();
      if (!(out_.gradient_left > tolerance) || out_.products >= max_products_) return out_;
      if (like_.size() > 0) factor_.prepare(like_, free_, largest_);
      const bool moved = take(run(kShare * tolerance), Else::kNothing);
      if (!moved && !take(steepest(), Else::kAsFits)) return out_;
    }
  }

 private:
  void look_at_bounds() {
    free_.clear();
    out_.gradient_left = 0;
    for (int i = 0; i < gradient_.size(); ++i) {
      const bool low = out_.x[i] <= lower_[i] && gradient_[i] >= 0, high = out_.x[i] >= upper_[i] && gradient_[i] <= 0;
      if (low || high) continue;
      free_.push_back(i);
      out_.gradient_left = std::max(out_.gradient_left, std::abs(gradient_[i]));
    }
  }

  VecX on_free(const VecX& v) const {
    VecX part = VecX::Zero(v.size());
    for (const int i : free_) part[i] = v[i];
    return part;
  }

  VecX preconditioned(const VecX& r) const { return like_.size() > 0 ? factor_.solve(r) : r; }

  /// How much of w fits into the box at x, at most `most`.
  double room(const VecX& w, double most) const {
    for (const int i : free_) {
      if (w[i] < 0) most = std::min(most, (lower_[i] - out_.x[i]) / w[i]);
      if (w[i] > 0) most = std::min(most, (upper_[i] - out_.x[i]) / w[i]);
    }
    return std::max(most, 0.0);
  }

  /// Conjugate gradients on the free parameters until the gradient is below `tolerance` or the box is left: what follows would
  /// go on from a place that is not to be had.
  Move run(double tolerance) {
    Move m{VecX::Zero(gradient_.size()), VecX::Zero(gradient_.size())};
    VecX r = -on_free(gradient_), z = preconditioned(r), p = z;
    double rz = r.dot(z);
    while (out_.products < max_products_ && r.cwiseAbs().maxCoeff() > tolerance) {
      const VecX image = times_(p);
      ++out_.products;
      const double curvature = p.dot(image);
      if (!(curvature > kFlat * p.norm() * image.norm())) {
        out_.negative_curvature = true;
        follow(p, image, m);
        break;
      }
      const double a = rz / curvature;
      m.w += a * p;
      m.image += a * image;
      if (room(m.w, 1) < 1) break;
      r -= a * on_free(image);
      z = preconditioned(r);
      const double next = r.dot(z);
      p = z + (next / rz) * p;
      rz = next;
    }
    return m;
  }

  /// Down the gradient to the least value of the model, or where it has none to the first bound.
  Move steepest() {
    const VecX p = -on_free(gradient_), image = times_(p);
    ++out_.products;
    const double curvature = p.dot(image);
    const double a = curvature > kFlat * p.norm() * image.norm() ? p.squaredNorm() / curvature
                                                                 : room(p, std::numeric_limits<double>::max());
    return {a * p, a * image};
  }

  /// Along p without curvature to the first bound, unless m.w has left the box already: then that step is worth more.
  void follow(const VecX& p, const VecX& image, Move& m) const {
    if (room(m.w, 1) < 1) return;
    const VecX from = out_.x + m.w;
    double most = std::numeric_limits<double>::infinity();
    for (const int i : free_) {
      if (p[i] < 0) most = std::min(most, (lower_[i] - from[i]) / p[i]);
      if (p[i] > 0) most = std::min(most, (upper_[i] - from[i]) / p[i]);
    }
    LISSOM_ASSERT(std::isfinite(most));
    most = std::max(most, 0.0);
    m.w += most * p;
    m.image += most * image;
  }

  bool take_whole(const VecX& w, const VecX& image, double change) {
    if (!(change < 0)) return false;
    out_.x = (out_.x + w).cwiseMax(lower_).cwiseMin(upper_);
    gradient_ += image;
    out_.decrease -= change;
    return true;
  }

  enum class Else { kNothing, kAsFits };

  /// Moves by w, clipped and halved until the model falls by enough. Where it does at no length, nothing is moved, or as much
  /// of w as fits: that often ends at a single bound, of hundreds on the way.
  bool take(const Move& m, Else otherwise) {
    if ((m.w.array() == 0).all()) return false;
    double a = 1;
    for (; a > kShortest && room(m.w, a) < a && out_.products < max_products_; a *= 0.5) {
      const VecX w = (out_.x + a * m.w).cwiseMax(lower_).cwiseMin(upper_) - out_.x, image = times_(w);
      ++out_.products;
      const double slope = gradient_.dot(w), change = slope + 0.5 * w.dot(image);
      if (change <= kArmijo * slope && slope < 0) return take_whole(w, image, change);
    }
    const double fits = room(m.w, 1);
    if (fits < a && otherwise == Else::kNothing && out_.products < max_products_) return false;
    const VecX w = snapped(fits * m.w), image = fits * m.image;
    return take_whole(w, image, gradient_.dot(w) + 0.5 * w.dot(image));
  }

  /// A step that was cut at a bound ends there exactly, so that the bound is seen.
  VecX snapped(VecX w) const {
    for (const int i : free_) {
      const double reach = out_.x[i] + w[i], rounding = 1e-14 * (std::abs(out_.x[i]) + std::abs(w[i]));
      if (reach - lower_[i] <= rounding) w[i] = lower_[i] - out_.x[i];
      if (upper_[i] - reach <= rounding) w[i] = upper_[i] - out_.x[i];
    }
    return w;
  }

  const std::function<VecX(const VecX&)>& times_;
  const VecX &lower_, &upper_;
  int max_products_;
  MatX like_;
  double largest_ = 0;
  FreeFactor factor_;
  std::vector<int> free_;
  VecX gradient_;
  BoxCgSolution out_;
};

}  // namespace

BoxCgSolution solve_box_cg(const std::function<VecX(const VecX&)>& times, const VecX& g, const VecX& lower,
                           const VecX& upper, const MatX& like_h, double tolerance, int max_products) {
  const int m = static_cast<int>(g.size());
  LISSOM_ASSERT(lower.size() == m && upper.size() == m && (like_h.size() == 0 || like_h.rows() == m));
  LISSOM_ASSERT((lower.array() <= 0).all() && (upper.array() >= 0).all() && g.allFinite());
  return BoxCg(times, lower, upper, like_h, max_products).solve(g, tolerance);
}

}  // namespace lissom
