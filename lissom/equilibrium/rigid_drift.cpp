#include "lissom/equilibrium/rigid_drift.h"

#include <Eigen/Dense>

#include "lissom/geometry/frame.h"

namespace lissom {

std::vector<double> node_weights(const System& system) {
  std::vector<double> weight(system.structure.nodes.size());
  const double length = system.rest.mean_edge_length;
  for (size_t i = 0; i < weight.size(); ++i) {
    weight[i] = system.rest.node_length[i] / length + system.rest.node_area[i] / (length * length) +
                system.rest.node_volume[i] / (length * length * length) + 1e-9;
  }
  return weight;
}

RigidDrift::RigidDrift(const StaticProblem& problem) : system_(*problem.system), weight_(node_weights(system_)) {
  const Structure& structure = system_.structure;
  const Supports& supports = problem.supports;
  can_move_.assign(system_.layout.size(), false);
  for (size_t i = 0; i < can_move_.size(); ++i) can_move_[i] = supports.kept()[i] >= 0;
  for (const int component : supports.free_parts()) {
    Part part;
    for (int i = 0; i < system_.layout.nodes(); ++i) {
      if (structure.component[i] != component) continue;
      part.nodes.push_back(i);
      for (int k = 0; k < 3; ++k) can_move_[3 * i + k] = true;
      if (system_.joint_of_node[i] >= 0) part.joints.push_back(system_.joint_of_node[i]);
    }
    for (int e = 0; e < system_.edge_count(); ++e) {
      if (structure.component[structure.edges[e].node0] == component) part.edges.push_back(e);
    }
    parts_.push_back(std::move(part));
  }
}

void RigidDrift::remove(const State& state, VecX& dq) const {
  for (const Part& part : parts_) {
    double weight = 0;
    Vec3 centre = Vec3::Zero(), shift = Vec3::Zero();
    for (const int i : part.nodes) {
      weight += weight_[i];
      centre += weight_[i] * state.position(i);
      shift += weight_[i] * dq.segment<3>(3 * i);
    }
    centre /= weight;
    shift /= weight;
    Mat3 inertia = Mat3::Zero();
    Vec3 spin = Vec3::Zero();
    for (const int i : part.nodes) {
      const Vec3 arm = state.position(i) - centre;
      inertia += weight_[i] * (arm.squaredNorm() * Mat3::Identity() - arm * arm.transpose());
      spin += weight_[i] * arm.cross(dq.segment<3>(3 * i));
    }
    const Vec3 turn = inertia.ldlt().solve(spin);
    if (!turn.allFinite()) continue;
    for (const int i : part.nodes) dq.segment<3>(3 * i) -= shift + turn.cross(state.position(i) - centre);
    for (const int e : part.edges) dq[system_.layout.roll(e)] -= turn.dot(state.edges[e].t);
    for (const int j : part.joints) {
      const int r = system_.layout.rotation(j);
      if (r >= 0) dq.segment<3>(r) -= turn;
    }
  }
}

bool can_be_laid_down(const StaticProblem& problem) {
  // One motion for the whole structure: parts that hold together by nothing else keep their places.
  return problem.system->structure.components == 1 && !problem.supports.free_parts().empty();
}

void lay_down(const StaticProblem& problem, State& state) {
  const System& system = *problem.system;
  if (!can_be_laid_down(problem)) return;
  const std::vector<double> weight = node_weights(system);
  double total = 0;
  Vec3 drawn = Vec3::Zero(), now = Vec3::Zero();
  for (int i = 0; i < system.layout.nodes(); ++i) {
    total += weight[i];
    drawn += weight[i] * system.structure.nodes[i];
    now += weight[i] * state.position(i);
  }
  drawn /= total;
  now /= total;
  Mat3 covariance = Mat3::Zero();
  for (int i = 0; i < system.layout.nodes(); ++i) {
    covariance += weight[i] * (system.structure.nodes[i] - drawn) * (state.position(i) - now).transpose();
  }
  if (!covariance.allFinite()) return;
  state = rigidly_moved(system, state, nearest_rotation(covariance), now, drawn - now);
}

}  // namespace lissom
