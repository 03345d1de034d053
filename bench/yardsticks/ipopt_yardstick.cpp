#include "bench/yardsticks/ipopt_yardstick.h"

// Ipopt 3.11 asks its users' build for the names of C headers.
#ifndef HAVE_CSTDDEF
#define HAVE_CSTDDEF  // NOLINT(readability-identifier-naming)
#endif
#include <IpIpoptApplication.hpp>
#include <IpSolveStatistics.hpp>
#include <IpTNLP.hpp>
#include <algorithm>

namespace lissom {

namespace {

using Ipopt::Index;
using Ipopt::Number;

/// The problem in the words of Ipopt: bounds, no constraints.
class Bridge final : public Ipopt::TNLP {
 public:
  Bridge(ReducedProblem& problem, LibraryPoint& point, const YardstickOptions& options)
      : problem_(problem), point_(point), options_(options), start_(problem.x()) {}

  int iterations = 0;

  bool get_nlp_info(Index& n, Index& m, Index& jacobian, Index& hessian, IndexStyleEnum& style) override {
    n = problem_.size();
    m = jacobian = hessian = 0;
    style = C_STYLE;
    return true;
  }
  bool get_bounds_info(Index n, Number* lower, Number* upper, Index, Number*, Number*) override {
    for (int i = 0; i < n; ++i) {  // beyond 1e19 there is no bound
      lower[i] = std::max(problem_.lower()[i], -1e20);
      upper[i] = std::min(problem_.upper()[i], 1e20);
    }
    return true;
  }
  bool get_starting_point(Index n, bool, Number* x, bool, Number*, Number*, Index, bool, Number*) override {
    std::copy_n(start_.data(), n, x);
    return true;
  }
  bool eval_f(Index n, const Number* x, bool, Number& h) override {
    return point_.value(Eigen::Map<const VecX>(x, n), h);
  }
  bool eval_grad_f(Index n, const Number* x, bool, Number* gradient) override {
    VecX g;
    if (!point_.gradient(Eigen::Map<const VecX>(x, n), g)) return false;
    std::copy_n(g.data(), n, gradient);
    return true;
  }
  bool eval_g(Index, const Number*, bool, Index, Number*) override { return true; }
  bool eval_jac_g(Index, const Number*, bool, Index, Index, Index*, Index*, Number*) override { return true; }
  bool intermediate_callback(Ipopt::AlgorithmMode, Index iteration, Number, Number, Number, Number, Number, Number,
                             Number, Number, Index, const Ipopt::IpoptData*,
                             Ipopt::IpoptCalculatedQuantities*) override {
    iterations = iteration;
    return !options_.cancelled();
  }
  void finalize_solution(Ipopt::SolverReturn, Index, const Number*, const Number*, const Number*, Index, const Number*,
                         const Number*, Number, const Ipopt::IpoptData*, Ipopt::IpoptCalculatedQuantities*) override {}

 private:
  ReducedProblem& problem_;
  LibraryPoint& point_;
  const YardstickOptions& options_;
  VecX start_;
};

std::string ending_of(Ipopt::ApplicationReturnStatus status) {
  switch (status) {
    case Ipopt::Solve_Succeeded:
      return "converged";
    case Ipopt::Solved_To_Acceptable_Level:
      return "acceptable";
    case Ipopt::Maximum_Iterations_Exceeded:
      return "iteration limit";
    case Ipopt::User_Requested_Stop:
      return "cancelled";
    default:
      return "status " + std::to_string(static_cast<int>(status));
  }
}

}  // namespace

YardstickReport run_ipopt(ReducedProblem& problem, const YardstickOptions& options) {
  LibraryPoint point(problem);
  Ipopt::SmartPtr<Bridge> bridge = new Bridge(problem, point, options);
  Ipopt::SmartPtr<Ipopt::IpoptApplication> application = new Ipopt::IpoptApplication(false);
  application->Options()->SetIntegerValue("print_level", 0);
  application->Options()->SetStringValue("sb", "yes");
  application->Options()->SetStringValue("hessian_approximation", "limited-memory");
  application->Options()->SetIntegerValue("max_iter", options.max_iterations);
  application->Options()->SetNumericValue("tol", options.tolerance);
  application->Options()->SetNumericValue("bound_relax_factor", 0);
  if (application->Initialize() != Ipopt::Solve_Succeeded) return {.ending = "not initialised"};
  const Ipopt::ApplicationReturnStatus status = application->OptimizeTNLP(Ipopt::GetRawPtr(bridge));
  YardstickReport report = point.finish();
  report.ending = ending_of(status);
  report.iterations = bridge->iterations;
  return report;
}

}  // namespace lissom
