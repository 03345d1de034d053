#include "bench/yardsticks/alglib_yardstick.h"

#include <cmath>
#include <libalglib/optimization.h>

namespace lissom {

namespace {

alglib::real_1d_array array_of(const VecX& v) {
  alglib::real_1d_array a;
  a.setcontent(v.size(), v.data());
  return a;
}

struct Bridge {
  ReducedProblem& problem;
  LibraryPoint& point;
  const YardstickOptions& options;
  alglib::minbcstate state;
};

void evaluate(const alglib::real_1d_array& array, double& h, alglib::real_1d_array& gradient, void* data) {
  Bridge& bridge = *static_cast<Bridge*>(data);
  if (bridge.options.cancelled()) alglib::minbcrequesttermination(bridge.state);
  const VecX x = Eigen::Map<const VecX>(array.getcontent(), array.length());
  VecX g;
  if (!bridge.point.value(x, h) || !bridge.point.gradient(x, g)) {
    const VecX away = x - bridge.problem.x();
    const double steep = 2 * std::max(std::abs(bridge.problem.value()), 1e-12) / std::max(away.squaredNorm(), 1e-300);
    h = bridge.problem.value() + 0.5 * steep * away.squaredNorm();
    g = steep * away;
  }
  for (int i = 0; i < g.size(); ++i) gradient[i] = g[i];
}

std::string ending_of(alglib::ae_int_t type) {
  if (type == 8) return "cancelled";
  if (type == 5) return "iteration limit";
  if (type == 7) return "too strict";
  return type > 0 ? "converged" : "status " + std::to_string(type);
}

}  // namespace

YardstickReport run_alglib(ReducedProblem& problem, const YardstickOptions& options) {
  LibraryPoint point(problem);
  Bridge bridge{problem, point, options, {}};
  alglib::minbccreate(array_of(problem.x()), bridge.state);
  alglib::minbcsetbc(bridge.state, array_of(problem.lower()), array_of(problem.upper()));
  alglib::minbcsetcond(bridge.state, options.tolerance, 0, 0, options.max_iterations);
  alglib::minbcoptimize(bridge.state, evaluate, nullptr, &bridge);
  alglib::real_1d_array x;
  alglib::minbcreport library;
  alglib::minbcresults(bridge.state, x, library);
  YardstickReport report = point.finish();
  report.ending = ending_of(library.terminationtype);
  report.iterations = static_cast<int>(library.iterationscount);
  return report;
}

VecX alglib_box_qp(const MatX& b, const VecX& g, const VecX& lower, const VecX& upper) {
  const int m = static_cast<int>(g.size());
  alglib::real_2d_array matrix;
  matrix.setcontent(m, m, b.data());  // symmetric: either order
  alglib::minqpstate state;
  alglib::minqpreport report;
  alglib::minqpcreate(m, state);
  alglib::minqpsetquadraticterm(state, matrix);
  alglib::minqpsetlinearterm(state, array_of(g));
  alglib::minqpsetbc(state, array_of(lower), array_of(upper));
  alglib::minqpsetscale(state, array_of(VecX::Ones(m)));
  alglib::minqpsetalgoquickqp(state, 0, 0, 0, 0, true);
  alglib::minqpoptimize(state);
  alglib::real_1d_array x;
  alglib::minqpresults(state, x, report);
  return Eigen::Map<const VecX>(x.getcontent(), m);
}

}  // namespace lissom
