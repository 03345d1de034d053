#pragma once
/// Third derivatives of one scalar expression: along two directions at once, and by each of its variables. Two nilpotent
/// units carry the directions (hyper-dual numbers [Fike and Alonso 2011]); a sweep back over the recorded operations
/// [Griewank and Walther 2008, chapter 3] gives the derivatives by all variables for the cost of a few evaluations, where
/// carrying them forward would cost one evaluation each. Used for second-order products of inverse design [mathematics 5.2].

#include <vector>

#include "lissom/core/dual.h"

namespace lissom {

/// a + d1 e1 + d2 e2 + d12 e1 e2 with e1^2 = e2^2 = 0: of a function, its value, its derivatives along two directions, and
/// its second derivative along both.
struct HyperDual {
  double a = 0, d1 = 0, d2 = 0, d12 = 0;

  HyperDual& operator+=(const HyperDual& o) {
    a += o.a;
    d1 += o.d1;
    d2 += o.d2;
    d12 += o.d12;
    return *this;
  }
  HyperDual times(const HyperDual& o) const {
    return {a * o.a, a * o.d1 + d1 * o.a, a * o.d2 + d2 * o.a, a * o.d12 + d12 * o.a + d1 * o.d2 + d2 * o.d1};
  }
  HyperDual times(double s) const { return {a * s, d1 * s, d2 * s, d12 * s}; }

  /// f(x) from f, f' and f'' at x.a.
  static HyperDual chain(const HyperDual& x, double f, double f1, double f2) {
    return {f, f1 * x.d1, f1 * x.d2, f1 * x.d12 + f2 * x.d1 * x.d2};
  }
};

class TracedDual;

/// The operations of one expression in the order in which they were carried out. Keeps its memory when cleared. Numbers
/// refer to it by address; not shared between threads.
class Tape {
 public:
  Tape() = default;
  Tape(const Tape&) = delete;
  Tape& operator=(const Tape&) = delete;

  void clear() {
    links_.clear();
    sensitivity_.clear();
    numbers_ = 0;
  }
  TracedDual variable(const HyperDual& value);

  /// Sets which sum of results is differentiated: weight times this one is added. After the last operation.
  void add_result(const TracedDual& result, double weight);
  /// Derivatives of the sum by every number.
  void sweep();
  /// Derivative of the sum by a variable: value, along direction 1, along direction 2, along both.
  const HyperDual& by(const TracedDual& variable) const;

 private:
  friend class TracedDual;
  struct Link {
    HyperDual partial;
    int result, from;
  };

  std::vector<Link> links_;
  std::vector<HyperDual> sensitivity_;  // of the sum, by number
  int numbers_ = 0;
};

/// A hyper-dual number whose operations are recorded. Satisfies AnyDual.
class TracedDual : public HyperDual {
 public:
  TracedDual() = default;
  TracedDual(double value) : HyperDual{value} {}  // NOLINT(google-explicit-constructor): constants mix freely

  TracedDual& operator+=(const TracedDual& o) { return *this = *this + o; }
  TracedDual& operator-=(const TracedDual& o) { return *this = *this - o; }
  TracedDual& operator*=(const TracedDual& o) { return *this = *this * o; }
  TracedDual& operator/=(const TracedDual& o) { return *this = *this / o; }

  LISSOM_NOINLINE friend TracedDual operator+(const TracedDual& x, const TracedDual& y) {
    return TracedDual({x.a + y.a, x.d1 + y.d1, x.d2 + y.d2, x.d12 + y.d12}, x, {1}, y, {1});
  }
  LISSOM_NOINLINE friend TracedDual operator-(const TracedDual& x, const TracedDual& y) {
    return TracedDual({x.a - y.a, x.d1 - y.d1, x.d2 - y.d2, x.d12 - y.d12}, x, {1}, y, {-1});
  }
  LISSOM_NOINLINE friend TracedDual operator-(const TracedDual& x) { return TracedDual(x.times(-1), x, {-1}); }
  LISSOM_NOINLINE friend TracedDual operator*(const TracedDual& x, const TracedDual& y) {
    if (y.tape_ == nullptr) return TracedDual(x.times(y.a), x, {y.a});
    if (x.tape_ == nullptr) return TracedDual(y.times(x.a), y, {x.a});
    return TracedDual(x.times(y), x, y, y, x);
  }
  LISSOM_NOINLINE friend TracedDual operator/(const TracedDual& x, const TracedDual& y) {
    const double inverse = 1 / y.a;
    if (y.tape_ == nullptr) return TracedDual(x.times(inverse), x, {inverse});
    const HyperDual by_x = HyperDual::chain(y, inverse, -inverse * inverse, 2 * inverse * inverse * inverse);
    const HyperDual quotient = x.times(by_x);
    return TracedDual(quotient, x, by_x, y, quotient.times(by_x).times(-1));
  }
  friend bool operator<(const TracedDual& x, const TracedDual& y) { return x.a < y.a; }
  friend bool operator>(const TracedDual& x, const TracedDual& y) { return x.a > y.a; }

  /// f(x) from f and its first three derivatives at x.a.
  LISSOM_NOINLINE static TracedDual chain(const TracedDual& x, double f, double f1, double f2, double f3) {
    return TracedDual(HyperDual::chain(x, f, f1, f2), x, HyperDual::chain(x, f1, f2, f3));
  }

 private:
  friend class Tape;

  /// An operation on one and on two numbers, with its partial derivatives. Constants are not recorded.
  TracedDual(const HyperDual& value, const TracedDual& x, const HyperDual& by_x) : HyperDual(value) { follow(x, by_x); }
  TracedDual(const HyperDual& value, const TracedDual& x, const HyperDual& by_x, const TracedDual& y,
             const HyperDual& by_y)
      : HyperDual(value) {
    follow(x, by_x);
    follow(y, by_y);
  }
  void follow(const TracedDual& x, const HyperDual& partial) {
    if (x.tape_ == nullptr) return;
    if (tape_ == nullptr) {
      tape_ = x.tape_;
      number_ = tape_->numbers_++;
    }
    tape_->links_.push_back({partial, number_, x.number_});
  }

  Tape* tape_ = nullptr;  // null: a constant
  int number_ = -1;
};

inline TracedDual Tape::variable(const HyperDual& value) {
  TracedDual x;
  static_cast<HyperDual&>(x) = value;
  x.tape_ = this;
  x.number_ = numbers_++;
  return x;
}

}  // namespace lissom
