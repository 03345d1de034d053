#include "lissom/equilibrium/form_finding.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <vector>

#include "lissom/equilibrium/solve.h"

namespace lissom {

namespace {

using Mat2 = Eigen::Matrix2d;

/// Symmetric positive root of a symmetric positive matrix.
Mat2 root(const Mat2& m) {
  const double determinant = std::sqrt(m.determinant());
  return (m + determinant * Mat2::Identity()) / std::sqrt(m.trace() + 2 * determinant);
}

/// The present shape becomes the drawn one, from which rest shapes are made. Material axes turn with the triangle as its
/// rigid rotation does, so that in them the present sides are U = (F'F)^1/2 times those at rest.
void redraw(const State& state, System& system) {
  Structure& structure = system.structure;
  for (size_t t = 0; t < structure.triangles.size(); ++t) {
    StructureTriangle& triangle = structure.triangles[t];
    const std::array<Vec2, 3>& rest = system.rest.triangles[t].corner;
    Mat2 sides;
    Eigen::Matrix<double, 3, 2> now;
    for (int i = 0; i < 2; ++i) {
      sides.col(i) = rest[i + 1] - rest[0];
      now.col(i) = state.position(triangle.node[i + 1]) - state.position(triangle.node[0]);
    }
    const Eigen::Matrix<double, 3, 2> gradient = now * sides.inverse();
    const Mat2 drawn = root(gradient.transpose() * gradient) * sides;
    triangle.corner = {Vec2::Zero(), drawn.col(0), drawn.col(1)};
  }
  for (StructureHinge& hinge : structure.hinges) {
    const Vec3 x0 = state.position(hinge.node[0]), e = state.position(hinge.node[1]) - x0;
    const Vec3 left = e.cross(state.position(hinge.node[2]) - x0),
               right = (state.position(hinge.node[3]) - x0).cross(e);
    hinge.rest_angle = std::atan2(e.normalized().dot(left.cross(right)), left.dot(right));
  }
}

/// Movement from a to b: of membranes across themselves, for vertices that slide within a surface leave the form as it is
/// and may do so for long; of all other nodes in any direction.
double largest_move(const System& system, const State& a, const State& b) {
  std::vector<Vec3> normal(system.layout.nodes(), Vec3::Zero());
  for (const StructureTriangle& triangle : system.structure.triangles) {
    const Vec3 x = a.position(triangle.node[0]);
    const Vec3 area = (a.position(triangle.node[1]) - x).cross(a.position(triangle.node[2]) - x);
    for (const int node : triangle.node) normal[node] += area;
  }
  double largest = 0;
  for (int i = 0; i < system.layout.nodes(); ++i) {
    const Vec3 move = b.position(i) - a.position(i);
    const double length = normal[i].norm();
    largest = std::max(largest, length > 0 ? std::abs(move.dot(normal[i])) / length : move.norm());
  }
  return largest;
}

bool settled(Verdict verdict) { return verdict == Verdict::kStable || verdict == Verdict::kCritical; }

}  // namespace

Result<FoundForm> find_form(const Model& model, const System& system, const Pose& pose, const std::string& where,
                            const SolveOptions& options, const Context& context) {
  if (system.structure.triangles.empty()) {
    return Error{ErrorCode::kConflict, where + "/form_finding", "there is no membrane whose form could be found",
                 "add one to \"membranes\", or remove \"form_finding\""};
  }
  const FormFinding& wanted = *pose.form_finding;
  FoundForm form;
  form.system = std::make_unique<System>(system);
  State before;
  for (form.rounds = 1;; ++form.rounds) {
    Result<StaticProblem> problem = make_static_problem(model, *form.system, pose, where);
    if (!problem) return problem.error();
    form.problem = std::make_unique<StaticProblem>(std::move(problem).value());
    const State start = form.rounds == 1 ? start_state(*form.problem, pose) : before;
    form.equilibrium = solve(*form.problem, start, 1, options, context);
    if (!settled(form.equilibrium.verdict)) return form;
    if (form.rounds > 1) {
      form.last_move = largest_move(*form.system, before, form.equilibrium.state);
      context.report({.task = "find form",
                      .fraction = static_cast<double>(form.rounds) / wanted.rounds,
                      .iteration = form.rounds,
                      .residual = form.last_move,
                      .detail = {}});
      if (form.last_move <= wanted.tolerance * system.structure.size) break;
    }
    if (form.rounds == wanted.rounds) {
      form.equilibrium.verdict = Verdict::kIterationLimit;
      form.equilibrium.message =
          fmt::format("the form still moves by {:.3g} mm after {} rounds; allow more rounds or a larger tolerance",
                      1e3 * form.last_move, form.rounds);
      return form;
    }
    before = form.equilibrium.state;
    redraw(before, *form.system);
    Result<RestState> rest = make_rest_state(model, form.system->structure);
    if (!rest) return rest.error();
    form.system->rest = std::move(rest).value();
  }
  form.equilibrium.message += fmt::format("; form found in {} rounds", form.rounds);
  return form;
}

}  // namespace lissom
