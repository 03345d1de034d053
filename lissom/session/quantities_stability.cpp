// Critical loads and stiffnesses.

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>

#include "lissom/session/quantity_families.h"

namespace lissom {

namespace {

Result<double> first_critical(const Measurement& m) {
  const Result<const PathResult*> path = m.study.path(m.pose(), m.refine);
  if (!path) return path.error();
  if (!path.value()->critical.empty()) return path.value()->critical.front().load_factor;
  return Error{ErrorCode::kGeometry, m.where, "there is no critical point on the path", "let it go further"};
}

}  // namespace

Result<double> critical_load_factor(const Measurement& m) { return first_critical(m); }

Result<double> critical_load(const Measurement& m) {
  const Result<double> factor = first_critical(m);
  if (!factor) return factor;
  const Model& model = m.study.model();
  const System& system = *m.study.system(m.refine).value();
  const Result<std::vector<int>> nodes = selected_nodes(m, m.at, system);
  if (!nodes) return nodes.error();
  Vec3 sum = Vec3::Zero();
  const std::vector<PointForce>& forces = model.poses[m.pose()].forces;
  for (size_t i = 0; i < forces.size(); ++i) {
    if (forces[i].scaling != Scaling::kProportional) continue;
    const Result<std::vector<int>> loaded =
        select(model, system.structure, forces[i].at,
               "/poses/" + std::to_string(m.pose()) + "/forces/" + std::to_string(i) + "/at");
    if (!loaded) return loaded.error();
    const double share = forces[i].shared ? 1.0 / static_cast<double>(loaded.value().size()) : 1.0;
    for (const int node : loaded.value()) {
      if (std::binary_search(nodes.value().begin(), nodes.value().end(), node)) sum += share * forces[i].force;
    }
  }
  if (sum.norm() > 0) return factor.value() * sum.norm();
  return Error{ErrorCode::kConflict, m.where + "/at", "no proportional force acts on the selected nodes",
               "select the loaded nodes, or ask for \"critical_load_factor\""};
}

Result<double> mode_stiffness(const Measurement& m) {
  const int mode = m.expectation.mode;
  const Result<const Stability*> stability = m.study.stability(m.pose(), mode + 1, m.refine);
  if (!stability) return stability.error();
  const std::vector<Mode>& modes = stability.value()->modes;
  if (mode < static_cast<int>(modes.size())) return modes[mode].stiffness;
  return Error{ErrorCode::kRange, m.where + "/mode", "there are only " + std::to_string(modes.size()) + " modes", ""};
}

Result<double> principal_stiffness(const Measurement& m) {
  const int count = static_cast<int>(m.poses.size());
  if (count < 2 || count > 3) {
    return Error{ErrorCode::kConflict, m.where + "/poses", "\"principal_stiffness\" needs two or three poses",
                 "name poses that move the place in independent directions"};
  }
  Eigen::Matrix3Xd moves(3, count), forces(3, count);
  for (int j = 0; j < count; ++j) {
    const Result<const Rate*> found = m.study.rate(m.poses[j], m.refine);
    if (!found) return found.error();
    const Rate& rate = *found.value();
    const Result<std::vector<int>> nodes = selected_nodes(m, m.at, *rate.system);
    if (!nodes) return nodes.error();
    Vec3 move = Vec3::Zero();
    for (const int node : nodes.value()) move += rate.unknowns.segment<3>(3 * node);
    moves.col(j) = move / static_cast<double>(nodes.value().size());
    forces.col(j) = force_sum(*rate.system, rate.reaction_rate, nodes.value());
  }
  Eigen::Matrix3Xd basis = moves;
  for (int j = 0; j < count; ++j) {
    for (int i = 0; i < j; ++i) basis.col(j) -= basis.col(i) * basis.col(i).dot(basis.col(j));
    const double left = basis.col(j).norm();
    if (!(left > 1e-6 * moves.col(j).norm())) {
      return Error{ErrorCode::kConflict, m.where + "/poses",
                   "the poses do not move the place in independent directions", ""};
    }
    basis.col(j) /= left;
  }
  const MatX stiffness = (basis.transpose() * forces) * (basis.transpose() * moves).inverse();
  const Eigen::SelfAdjointEigenSolver<MatX> principal(0.5 * (stiffness + stiffness.transpose()));
  if (m.expectation.mode < count) return principal.eigenvalues()[m.expectation.mode];
  return Error{ErrorCode::kRange, m.where + "/mode",
               "there are only " + std::to_string(count) + " principal stiffnesses", ""};
}

}  // namespace lissom
