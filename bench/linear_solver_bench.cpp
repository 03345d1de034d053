/// Times the sparse solver on rod and membrane matrices, against Eigen's. Medians in milliseconds.
///   linear_solver_bench [DOCUMENT...]   adds the matrices of these documents, where their first poses start

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <numeric>
#include <string>
#include <vector>

#include "bench/fabric_problems.h"
#include "bench/first_pose.h"
#include "bench/rod_matrices.h"
#include "bench/timing.h"
#include "lissom/core/file_io.h"
#include "lissom/core/linear_solver.h"
#include "lissom/equilibrium/newton_workspace.h"
#include "lissom/model/document.h"

namespace lissom {
namespace {

/// The kept part of a matrix.
struct Matrix {
  SparsePattern pattern;
  std::vector<double> values;
  std::vector<int> kept;
};

Eigen::SparseMatrix<double> to_eigen(const Matrix& m, int unknowns) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int j = 0; j < m.pattern.size(); ++j) {
    for (int s = m.pattern.column_start()[j]; s < m.pattern.column_start()[j + 1]; ++s) {
      const int i = m.pattern.row()[s];
      if (m.kept[i] >= 0 && m.kept[j] >= 0) entries.emplace_back(m.kept[i], m.kept[j], m.values[s]);
    }
  }
  Eigen::SparseMatrix<double> a(unknowns, unknowns);
  a.setFromTriplets(entries.begin(), entries.end());
  return a;
}

/// A row of build/bench.json, see tools/bench.py.
void report(const std::string& name, int unknowns, const char* metric, double ms) {
  std::printf("linear solver, %s, %d unknowns\t%s\t%.6g\tms\n", name.c_str(), unknowns, metric, ms);
}

void measure(const std::string& name, const Matrix& m, int repeats) {
  std::printf("%s: %d nonzeros\n", name.c_str(), m.pattern.nonzeros());
  std::printf("  %-9s %10s %9s %9s %9s %9s %8s %10s\n", "order", "nnz(L)", "Mflop", "analyse", "numeric", "stopped",
              "solve", "solve 64");
  VecX x;
  int unknowns = 0;
  for (const Ordering ordering : {Ordering::kAmd, Ordering::kMetis, Ordering::kBest}) {
    const LinearSolverOptions options{.ordering = ordering};
    const double analyse = median_ms(3, [&] { LinearSolver(m.pattern, m.kept, options); });
    LinearSolver solver(m.pattern, m.kept, options);
    unknowns = solver.unknowns();
    const VecX b = VecX::LinSpaced(unknowns, -1, 1);
    const MatX many = b.replicate(1, 64);
    MatX solutions;
    const double stopped = median_ms(repeats, [&] { solver.factorize(m.values, 0, {}, Indefinite::kStop); });
    bool ok = true;
    const double numeric = median_ms(repeats, [&] { ok = solver.factorize(m.values).complete && ok; });
    const double solve = ok ? median_ms(repeats, [&] { solver.solve(b, x); }) : 0;
    const double solve_many = ok ? median_ms(3, [&] { solver.solve_many(many, solutions); }) : 0;
    const LinearSolver::Statistics& s = solver.statistics();
    std::printf("  %-9s %10lld %9.2f %9.2f %9.3f %9.3f %8.3f %10.2f%s%s\n",
                s.ordering == Ordering::kAmd ? "AMD" : "METIS", static_cast<long long>(s.factor_nonzeros),
                s.factor_flops * 1e-6, analyse, numeric, stopped, solve, solve_many,
                ordering == Ordering::kBest ? "  <- best" : "", ok ? "" : "  FAILED");
    if (ordering == Ordering::kBest && ok) {
      report(name, unknowns, "factorisation", numeric);
      report(name, unknowns, "solve", solve);
      report(name, unknowns, "solve of 64 right-hand sides", solve_many);
    }
  }
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> eigen;
  const Eigen::SparseMatrix<double> matrix = to_eigen(m, unknowns);
  const VecX b = VecX::LinSpaced(unknowns, -1, 1);
  const double analyse = median_ms(3, [&] { eigen.analyzePattern(matrix); });
  const double numeric = median_ms(repeats, [&] { eigen.factorize(matrix); });
  const double solve = median_ms(repeats, [&] { x = eigen.solve(b); });
  std::printf("  %-9s %10s %9s %9.2f %9.3f %9s %8.3f\n", "Eigen", "", "", analyse, numeric, "", solve);
}

void measure(const std::string& name, const rod_matrices::Blocks& blocks, int repeats) {
  Matrix m{blocks.pattern(), {}, std::vector<int>(blocks.size)};
  m.values = rod_matrices::values(blocks, m.pattern);
  std::iota(m.kept.begin(), m.kept.end(), 0);
  measure(name, m, repeats);
}

void measure(const std::string& name, const Model& model, int repeats) {
  const FirstPose ready = first_pose(name, model);
  if (!ready.problem) return;
  const Context context;
  NewtonWorkspace workspace(*ready.problem, context);
  workspace.assemble(start_state(*ready.problem, model.poses[0]));
  const std::span<const int> kept = ready.problem->supports.kept();
  measure(name, {ready.problem->potential.pattern(), workspace.hessian(), {kept.begin(), kept.end()}}, repeats);
}

}  // namespace
}  // namespace lissom

int main(int argc, char** argv) {
  using namespace lissom;
  measure("chain of 1,000 nodes", rod_matrices::chain(1000), 41);
  measure("honeycomb", rod_matrices::honeycomb(22, 22, 4), 15);
  measure("honeycomb", rod_matrices::honeycomb(22, 22, 6), 15);
  measure("membrane", rod_matrices::membrane(30, 30), 11);
  measure("membrane", rod_matrices::membrane(52, 52), 7);
  measure("frame on fabric", networks::square_frame_on_fabric({.cells = 49}), 7);
  for (int i = 1; i < argc; ++i) {
    const std::filesystem::path path(argv[i]);
    const Result<std::string> text = read_file(path);
    const Result<Model> model = text ? read_document(text.value(), path.parent_path()) : Result<Model>(text.error());
    if (!model) {
      std::fprintf(stderr, "%s\n", model.error().text().c_str());
      return 1;
    }
    measure(path.stem().string(), model.value(), 7);
  }
  return 0;
}
