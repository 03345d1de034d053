/// What a third derivative along two directions costs beside one assembly of the Hessian, as a whole and by term, on one
/// thread and on two. Rows of name, metric, value, unit.

#include <cmath>
#include <cstdio>
#include <utility>

#include "bench/networks.h"
#include "bench/timing.h"
#include "lissom/core/file_io.h"
#include "lissom/mechanics/energies.h"
#include "lissom/mechanics/rest_jacobian.h"
#include "lissom/mechanics/third_derivative.h"
#include "lissom/model/document.h"

namespace lissom {
namespace {

constexpr int kRepeats = 15;

/// Any vector without zeros.
VecX waves(Eigen::Index size, double amplitude) {
  VecX x(size);
  for (Eigen::Index i = 0; i < size; ++i) x[i] = amplitude * std::sin(1.7 * static_cast<double>(i) + 0.3);
  return x;
}

void measure_potential(const std::string& name, const Potential& potential, const State& state, Eigen::Index numbers,
                       ThreadPool* threads) {
  AssemblyBuffers buffers;
  VecX gradient, by_q, by_numbers;
  std::vector<double> values;
  const VecX lambda = waves(potential.dofs(), 1e-3), dq = waves(potential.dofs(), 2e-3), dn = waves(numbers, 1e-4);
  const double hessian = least_ms(kRepeats, [&] { potential.hessian(state, gradient, values, buffers, threads); });
  const double third =
      least_ms(kRepeats, [&] { third_derivative(potential, state, lambda, dq, dn, by_q, by_numbers, threads); });
  row(name, "Hessian", hessian, "ms");
  row(name, "third derivative", third, "ms");
  row(name, "ratio", third / hessian, "");
}

void measure(const std::string& name, const Model& model) {
  const Result<System> made = make_system(model);
  if (!made) {
    std::fprintf(stderr, "%s: %s\n", name.c_str(), made.error().text().c_str());
    return;
  }
  const System& system = made.value();
  const State drawn = drawn_state(system);
  State state;
  auto terms = make_terms(model, system, &model.poses[0], "/poses/0");
  if (!terms || !advance(system, drawn, waves(drawn.q.size(), 1e-4), state)) return;
  const RestInputs inputs(system.structure);
  const Eigen::Index numbers = RestNumbers(system.structure).size();
  row(name, "nodes", system.layout.nodes(), "");
  {
    const Potential potential(system.layout.size(), std::move(terms).value());
    measure_potential(name + ", one thread", potential, state, numbers, nullptr);
    ThreadPool threads(2);
    measure_potential(name + ", two threads", potential, state, numbers, &threads);
  }
  const VecX y = waves(numbers, 1), direction = waves(inputs.size(), 1e-4);
  row(name, "curvature of rest numbers",
      least_ms(kRepeats, [&] { return rest_curvature(model, system, y, direction); }), "ms");
  row(name, "jacobian of rest numbers", least_ms(kRepeats, [&] { return rest_jacobian(model, system); }), "ms");
  auto each = make_terms(model, system, &model.poses[0], "/poses/0");
  for (auto& term : each.value()) {
    const std::string label = name + ", " + std::string(term->name()) + " on " + std::to_string(term->dofs());
    row(label, "stencils", term->stencils(), "");
    std::vector<std::unique_ptr<EnergyTerm>> one;
    one.push_back(std::move(term));
    measure_potential(label, Potential(system.layout.size(), std::move(one)), state, numbers, nullptr);
  }
}

}  // namespace
}  // namespace lissom

int main() {
  using namespace lissom;
  Model honeycomb = networks::hanging_honeycomb(3, 6, 10);
  measure("honeycomb", honeycomb);
  honeycomb.joint_kind = JointKind::kCorotational;
  measure("corotational honeycomb", honeycomb);
  const Result<std::string> text = read_file("scenes/data/fabric/butterfly.lissom");
  const Result<Model> butterfly = text ? read_document(text.value()) : Result<Model>(text.error());
  if (butterfly) measure("butterfly", butterfly.value());
  return butterfly ? 0 : 1;
}
