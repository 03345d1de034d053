/// Times the sparse solver on rod and membrane matrices, against Eigen's. Medians in milliseconds.

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cstdio>
#include <numeric>

#include "bench/rod_matrices.h"
#include "bench/timing.h"
#include "lissom/core/linear_solver.h"

namespace lissom {
namespace {

Eigen::SparseMatrix<double> to_eigen(const SparsePattern& p, const std::vector<double>& values) {
  const Eigen::Map<const Eigen::SparseMatrix<double>> view(p.size(), p.size(), p.nonzeros(), p.column_start().data(),
                                                           p.row().data(), values.data());
  return view;
}

/// A row of build/bench.json, see tools/bench.py.
void report(const char* name, int unknowns, const char* metric, double ms) {
  std::printf("linear solver, %s, %d unknowns\t%s\t%.6g\tms\n", name, unknowns, metric, ms);
}

void measure(const char* name, const rod_matrices::Blocks& blocks, int repeats) {
  SparsePattern pattern;
  const double pattern_ms = median_ms(3, [&] { pattern = blocks.pattern(); });
  const std::vector<double> values = rod_matrices::values(blocks, pattern);
  std::vector<int> all(pattern.size());
  std::iota(all.begin(), all.end(), 0);
  std::printf("%s: %d unknowns, %d nonzeros, pattern %.2f ms\n", name, pattern.size(), pattern.nonzeros(), pattern_ms);
  const VecX b = VecX::LinSpaced(pattern.size(), -1, 1);
  VecX x;
  const MatX many = b.replicate(1, 64);
  MatX solutions;
  std::printf("  %-9s %-6s %10s %9s %9s %9s %8s %10s\n", "factor", "order", "nnz(L)", "Mflop", "analyse", "numeric",
              "solve", "solve 64");
  for (const FactorKind kind : {FactorKind::kLdl, FactorKind::kCholesky, FactorKind::kBest}) {
    for (const Ordering ordering : {Ordering::kAmd, Ordering::kMetis, Ordering::kBest}) {
      if ((kind == FactorKind::kBest) != (ordering == Ordering::kBest)) continue;
      const LinearSolverOptions options{.ordering = ordering, .kind = kind};
      const double analyse = median_ms(3, [&] { LinearSolver(pattern, all, options); });
      LinearSolver solver(pattern, all, options);
      bool ok = solver.factorize(values).complete;
      const double numeric = median_ms(repeats, [&] { ok = solver.factorize(values).complete && ok; });
      const double solve = median_ms(repeats, [&] { solver.solve(b, x); });
      const double solve_many = median_ms(3, [&] { solver.solve_many(many, solutions); });
      const LinearSolver::Statistics& s = solver.statistics();
      std::printf("  %-9s %-6s %10lld %9.2f %9.2f %9.3f %8.3f %10.2f%s%s\n",
                  s.kind == FactorKind::kLdl ? "LDL'" : "LL'", s.ordering == Ordering::kAmd ? "AMD" : "METIS",
                  static_cast<long long>(s.factor_nonzeros), s.factor_flops * 1e-6, analyse, numeric, solve, solve_many,
                  kind == FactorKind::kBest ? "  <- best" : "", ok ? "" : "  FAILED");
      if (kind == FactorKind::kBest && ok) {
        report(name, pattern.size(), "factorisation", numeric);
        report(name, pattern.size(), "solve", solve);
        report(name, pattern.size(), "solve of 64 right-hand sides", solve_many);
      }
    }
  }
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> eigen;
  const Eigen::SparseMatrix<double> matrix = to_eigen(pattern, values);
  const double analyse = median_ms(3, [&] { eigen.analyzePattern(matrix); });
  const double numeric = median_ms(repeats, [&] { eigen.factorize(matrix); });
  const double solve = median_ms(repeats, [&] { x = eigen.solve(b); });
  std::printf("  %-9s %-6s %10s %9s %9.2f %9.3f %8.3f\n", "Eigen", "AMD", "", "", analyse, numeric, solve);
}

}  // namespace
}  // namespace lissom

int main() {
  using namespace lissom;
  measure("chain of 1,000 nodes", rod_matrices::chain(1000), 41);
  measure("honeycomb", rod_matrices::honeycomb(22, 22, 4), 15);
  measure("honeycomb", rod_matrices::honeycomb(22, 22, 6), 15);
  measure("membrane", rod_matrices::membrane(30, 30), 11);
  measure("membrane", rod_matrices::membrane(52, 52), 7);
}
