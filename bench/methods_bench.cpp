/// Methods of inverse design on problems in closed form, beside Ipopt and ALGLIB, and the quadratic subproblem beside ALGLIB's.

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <string>

#include "bench/timing.h"
#include "bench/yardsticks/alglib_yardstick.h"
#include "bench/yardsticks/ipopt_yardstick.h"
#include "lissom/design/box_qp.h"
#include "lissom/design/optimizer.h"
#include "scenes/analytic_cases.h"

namespace lissom {
namespace {

using Make = AnalyticCase (*)();
AnalyticCase creeping() { return exponential_fit(0.9); }
constexpr Make kCases[] = {linear_in_box, rosenbrock_free, rosenbrock_bounded, creeping, rank_deficient,
                           indefinite,    failing};

void print(const AnalyticCase& c, const std::string& method, int iterations, std::string_view ending) {
  const AskedFor& a = c.problem.asked;
  const double error = c.solution.size() > 0 ? (c.problem.x() - c.solution).cwiseAbs().maxCoeff() : c.problem.value();
  std::printf("%-20s %-32s %5d %8d %9d %5d %8d %9.1e  %s\n", c.name.c_str(), method.c_str(), iterations, a.attempts,
              a.gradients, a.grams, a.products, error, std::string(ending).c_str());
}

void compare(Make make) {
  for (const DesignMethodInfo& info : design_methods()) {
    for (const StepControl control : {StepControl::kLineSearch, StepControl::kTrustRegion}) {
      const bool line = control == StepControl::kLineSearch;
      if (!line && !secant_rule(info.method)) continue;
      AnalyticCase c = make();
      Optimizer optimizer(c.problem, {.method = info.method,
                                      .control = control,
                                      .max_iterations = 500,
                                      .gradient_tolerance = 1e-9,
                                      .decrease_tolerance = 0});
      const DesignVerdict verdict = optimizer.run({});
      std::string name(info.name);
      if (secant_rule(info.method)) name += line ? ", line search" : ", region";
      print(c, name, optimizer.state().iteration, design_verdict_info(verdict).name);
    }
  }
  AnalyticCase c = make(), d = make();
  const YardstickReport ipopt = run_ipopt(c.problem, {});
  print(c, "Ipopt, limited memory", ipopt.iterations, ipopt.ending);
  const YardstickReport alglib = run_alglib(d.problem, {});
  print(d, "ALGLIB minbc", alglib.iterations, alglib.ending);
}

/// B of full rank with few bounds met (kind 0), or with eigenvalues falling over four decades and half of the bounds met.
void compare_box_qp(int m, int kind) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  const auto any = [&] { return normal(random); };
  const MatX a = MatX::NullaryExpr(m, m, any);
  MatX b = a.transpose() * a + 1e-3 * MatX::Identity(m, m);
  VecX g = VecX::NullaryExpr(m, any), width = VecX::NullaryExpr(m, any).cwiseAbs();
  if (kind == 1) {
    const MatX q = Eigen::HouseholderQR<MatX>(a).householderQ();
    const VecX share = VecX::LinSpaced(m, 0, -4);
    const VecX eigenvalues = share.unaryExpr([](double e) { return std::pow(10.0, e); });
    b = q * eigenvalues.asDiagonal() * q.transpose();
    b = 0.5 * (b + MatX(b.transpose()));
    g = b * VecX::NullaryExpr(m, any);
    width.setConstant(0.5);
  }
  VecX theirs;
  BoxQpSolution ours;
  const double our_ms = least_ms(5, [&] { ours = solve_box_qp(b, g, -width, width); });
  const double their_ms = least_ms(5, [&] { theirs = alglib_box_qp(b, g, -width, width); });
  const std::string name =
      "box QP, " + std::to_string(m) + (kind == 0 ? " parameters, few held" : " parameters, many held");
  row(name, "lissom", our_ms, "ms");
  row(name, "ALGLIB QuickQP", their_ms, "ms");
  const auto value = [&](const VecX& x) { return x.dot(0.5 * (b * x) + g); };
  std::printf("  %d iterations, %d factorizations, %d held; lower by %.1e of %.3g\n", ours.iterations,
              ours.factorizations, static_cast<int>(std::count(ours.at_bound.begin(), ours.at_bound.end(), true)),
              value(theirs) - value(ours.x), value(ours.x));
}

}  // namespace
}  // namespace lissom

int main() {
  std::printf("%-20s %-32s %5s %8s %9s %5s %8s %9s\n", "problem", "method", "iter.", "attempts", "gradients", "J'J",
              "products", "error");
  for (const auto make : lissom::kCases) lissom::compare(make);
  for (const int m : {54, 200, 980}) {
    for (const int kind : {0, 1}) lissom::compare_box_qp(m, kind);
  }
}
