#include "lissom/mechanics/null_motions.h"

#include <Eigen/Dense>
#include <cmath>

#include "lissom/geometry/frame.h"
#include "lissom/mechanics/energies.h"

namespace lissom {

namespace {

/// Rolls of a rod turn together without any energy when nothing tells its sections' directions apart.
void remove_spins(const System& system, std::vector<bool>& held, std::vector<std::string>& removed) {
  const Structure& structure = system.structure;
  std::vector<bool> has_spring(structure.edges.size(), false), directed(structure.rods.size(), false);
  for (size_t p = 0; p < structure.pairs.size(); ++p) {
    const PairRest& rest = system.rest.pairs[p];
    const StructurePair& pair = structure.pairs[p];
    has_spring[pair.edge0] = has_spring[pair.edge1] = true;
    const bool round = std::abs(rest.bend_1 - rest.bend_2) <= 1e-12 * (rest.bend_1 + rest.bend_2);
    const bool straight = std::hypot(rest.kappa_1, rest.kappa_2) <= 1e-12;
    if (!round || !straight) directed[structure.edges[pair.edge0].rod] = true;
  }
  for (const Connection& c : system.connections) {
    has_spring[c.edge] = true;
    directed[structure.edges[c.edge].rod] = true;
  }
  for (size_t r = 0; r < structure.rods.size(); ++r) {
    const StructureRod& rod = structure.rods[r];
    bool held_roll = false;
    for (const int e : rod.edges) held_roll = held_roll || held[system.layout.roll(e)];
    if (!directed[r] && !held_roll) {
      held[system.layout.roll(rod.edges[rod.edges.size() / 2])] = true;
      removed.push_back("rod " + rod.name + " is round, straight at rest and held in no frame: its spin was taken out");
      continue;
    }
    for (const int e : rod.edges) {
      if (has_spring[e] || held[system.layout.roll(e)]) continue;
      held[system.layout.roll(e)] = true;
      removed.push_back("rod " + rod.name + " has an edge whose roll nothing resists: it was taken out");
    }
  }
}

/// Loads of a pose at their full value in the drawn shape: forces per node, moments per joint.
Result<VecX> full_loads(const Model& model, const System& system, const Pose& pose, const std::string& where) {
  Pose loads;
  loads.forces = pose.forces;
  loads.moments = pose.moments;
  loads.line_loads = pose.line_loads;
  loads.edge_loads = pose.edge_loads;
  loads.gravity = pose.gravity;
  loads.soft_pins = pose.soft_pins;
  auto all = make_terms(model, system, &loads, where);
  if (!all) return all.error();
  std::vector<std::unique_ptr<EnergyTerm>> terms;
  for (auto& term : all.value()) {
    if (!term->has_hessian()) terms.push_back(std::move(term));
  }
  State state = drawn_state(system);
  state.load_factor = 1;
  const Potential potential(system.layout.size(), std::move(terms));
  AssemblyBuffers buffers;
  VecX gradient;
  potential.gradient(state, gradient, buffers);
  return VecX(-gradient);
}

/// The six rigid motions of one part about its centroid, rotations scaled by its size: unknowns x 6.
struct RigidMotions {
  Vec3 centre = Vec3::Zero();
  double radius = 0;
  std::vector<int> nodes;

  Vec3 displacement(const Vec3& position, int motion) const {
    if (motion < 3) return Vec3::Unit(motion);
    return Vec3::Unit(motion - 3).cross(position - centre) / radius;
  }
};

RigidMotions rigid_motions_of(const Structure& structure, int part) {
  RigidMotions rigid;
  for (int i = 0; i < static_cast<int>(structure.nodes.size()); ++i) {
    if (structure.component[i] == part) rigid.nodes.push_back(i);
  }
  for (const int i : rigid.nodes) rigid.centre += structure.nodes[i] / static_cast<double>(rigid.nodes.size());
  for (const int i : rigid.nodes) rigid.radius = std::max(rigid.radius, (structure.nodes[i] - rigid.centre).norm());
  return rigid;
}

/// A part by something in it that the user has named.
std::string part_name(const Structure& structure, int node) {
  for (const StructureEdge& edge : structure.edges) {
    if (edge.node0 == node || edge.node1 == node) return "the part of rod " + structure.rods[edge.rod].name;
  }
  for (const StructureMembrane& membrane : structure.membranes) {
    for (const int own : membrane.nodes) {
      if (own == node) return "the part of membrane " + membrane.name;
    }
  }
  for (const StructureSolid& solid : structure.solids) {
    for (const int own : solid.nodes) {
      if (own == node) return "the part of solid " + solid.name;
    }
  }
  return "the part of node " + std::to_string(node);
}

using Mat6X = Eigen::Matrix<double, Eigen::Dynamic, 6>;

class PartSupport {
 public:
  PartSupport(const System& system, const std::vector<LocalAxes>& local_axes, const std::vector<bool>& held)
      : system_(system), held_(held), axes_(system.layout.size(), -1), local_axes_(local_axes) {
    for (int a = 0; a < static_cast<int>(local_axes.size()); ++a) axes_[local_axes[a].first_dof] = a;
  }

  /// Motion of three unknowns in their local axes.
  Vec3 in_axes(int first_dof, const Vec3& v) const {
    return axes_[first_dof] < 0 ? v : Vec3(local_axes_[axes_[first_dof]].axes.transpose() * v);
  }
  bool has_axes(int first_dof) const { return axes_[first_dof] >= 0; }

  /// Rows: held unknowns of the part; columns: what each rigid motion would do to them.
  Mat6X held_rows(const RigidMotions& rigid) const {
    std::vector<Eigen::Matrix<double, 1, 6>> rows;
    const auto add = [&](int first, const auto& motion_of) {
      for (int i = 0; i < 3; ++i) {
        if (!held_[first + i]) continue;
        Eigen::Matrix<double, 1, 6> row;
        for (int m = 0; m < 6; ++m) row[m] = in_axes(first, motion_of(m))[i];
        rows.push_back(row);
      }
    };
    for (const int node : rigid.nodes) {
      add(3 * node, [&](int m) { return rigid.displacement(system_.structure.nodes[node], m); });
      const int joint = system_.joint_of_node[node];
      const int r = joint < 0 ? -1 : system_.layout.rotation(joint);
      if (r >= 0) add(r, [&](int m) -> Vec3 { return m < 3 ? Vec3(Vec3::Zero()) : Vec3(Vec3::Unit(m - 3)); });
    }
    Mat6X matrix(static_cast<int>(rows.size()), 6);
    for (int i = 0; i < matrix.rows(); ++i) matrix.row(i) = rows[i];
    return matrix;
  }

 private:
  const System& system_;
  const std::vector<bool>& held_;
  std::vector<int> axes_;
  const std::vector<LocalAxes>& local_axes_;
};

/// First-order work of the loads on the rigid motions, and their second-order work on the rotations (3 x 3).
struct LoadWork {
  Eigen::Matrix<double, 6, 1> first = Eigen::Matrix<double, 6, 1>::Zero();
  Mat3 second = Mat3::Zero();
  double size = 0;  ///< N, sum of the magnitudes
};

LoadWork load_work(const System& system, const RigidMotions& rigid, const VecX& load) {
  LoadWork work;
  for (const int node : rigid.nodes) {
    const Vec3 f = load.segment<3>(3 * node), x = (system.structure.nodes[node] - rigid.centre) / rigid.radius;
    work.size += f.norm();
    for (int m = 0; m < 6; ++m) work.first[m] += f.dot(rigid.displacement(system.structure.nodes[node], m));
    // f . (w x (w x x)) = w' (sym(f x') - (f . x) I) w
    work.second += 0.5 * (f * x.transpose() + x * f.transpose()) - f.dot(x) * Mat3::Identity();
    const int joint = system.joint_of_node[node];
    const int r = joint < 0 ? -1 : system.layout.rotation(joint);
    if (r < 0) continue;
    const Vec3 moment = load.segment<3>(r) / rigid.radius;
    work.first.tail<3>() += moment;
    work.size += moment.norm();
  }
  return work;
}

bool has_soft_pin(const Model& model, const System& system, const Pose& pose, int part) {
  for (const SoftPin& pin : pose.soft_pins) {
    const Result<std::vector<int>> nodes = select(model, system.structure, pin.at, "");
    if (!nodes) continue;  // reported where the terms are made
    for (const int node : nodes.value()) {
      if (system.structure.component[node] == part) return true;
    }
  }
  return false;
}

}  // namespace

Status remove_null_motions(const Model& model, const System& system, const Pose& pose, const std::string& where,
                           const std::vector<LocalAxes>& local_axes, NullMotions choice, std::vector<bool>& held,
                           std::vector<std::string>& removed, std::vector<int>& free_parts) {
  if (choice == NullMotions::kKeep) return {};
  remove_spins(system, held, removed);
  if (choice == NullMotions::kKeepRigid) return {};
  const Result<VecX> load = full_loads(model, system, pose, where);
  if (!load) return load.error();
  const PartSupport support(system, local_axes, held);
  for (int part = 0; part < system.structure.components; ++part) {
    const RigidMotions rigid = rigid_motions_of(system.structure, part);
    const Mat6X rows = support.held_rows(rigid);
    Eigen::Matrix<double, 6, 6> gram = rows.transpose() * rows;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> eigen(gram);
    const double limit = 1e-10 * std::max(1.0, eigen.eigenvalues()[5]);
    int count = 0;
    while (count < 6 && eigen.eigenvalues()[count] <= limit) ++count;
    if (count == 0) continue;
    const Eigen::Matrix<double, 6, Eigen::Dynamic> unheld = eigen.eigenvectors().leftCols(count);
    if (has_soft_pin(model, system, pose, part)) continue;  // their springs resist; the solve tells whether enough

    const LoadWork work = load_work(system, rigid, load.value());
    const Eigen::VectorXd first = unheld.transpose() * work.first;
    const std::string name = part_name(system.structure, rigid.nodes.front());
    const double tolerance = 1e-9 * std::max(work.size, 1e-300);
    // Translations that the loads drive have no equilibrium at all.
    Eigen::Matrix<double, 6, Eigen::Dynamic> rotation_part = unheld;
    rotation_part.topRows(3).setZero();
    for (int m = 0; m < count; ++m) {
      const bool translation = rotation_part.col(m).norm() < 1e-9;
      if (translation && std::abs(first[m]) > tolerance) {
        return Error{ErrorCode::kConflict, where + "/supports",
                     name + " is held by nothing and its loads do not balance: it would move away",
                     "hold it, or balance the loads"};
      }
    }
    // A rigid motion is neutral when the loads do no work on it to second order; others have an equilibrium to find.
    // Removing all of them on request leaves out those on which the loads do first-order work.
    Eigen::MatrixXd second = rotation_part.bottomRows(3).transpose() * work.second * rotation_part.bottomRows(3);
    Eigen::MatrixXd active = first * first.transpose() / std::max(work.size, 1e-300);
    if (pose.rigid_motion == RigidMotion::kRemoveNeutral)
      active += (second * second).eval() / std::max(work.size, 1e-300);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> neutral(active);
    int neutral_count = 0;
    while (neutral_count < count && neutral.eigenvalues()[neutral_count] <= 1e-12 * std::max(work.size, 1e-300)) {
      ++neutral_count;
    }
    if (neutral_count == 0) continue;
    const Eigen::MatrixXd motions = unheld * neutral.eigenvectors().leftCols(neutral_count);

    // Hold as many positions as there are neutral motions, chosen one after the other where they move most.
    Eigen::MatrixXd displacement(3 * static_cast<int>(rigid.nodes.size()), neutral_count);
    displacement.setZero();
    for (int k = 0; k < static_cast<int>(rigid.nodes.size()); ++k) {
      const int node = rigid.nodes[k];
      if (support.has_axes(3 * node)) continue;
      for (int m = 0; m < neutral_count; ++m) {
        Vec3 u = Vec3::Zero();
        for (int j = 0; j < 6; ++j) u += motions(j, m) * rigid.displacement(system.structure.nodes[node], j);
        for (int i = 0; i < 3; ++i) displacement(3 * k + i, m) = held[3 * node + i] ? 0 : u[i];
      }
    }
    const Eigen::MatrixXd wide = displacement.transpose();
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(wide);
    if (neutral_count == 6) free_parts.push_back(part);
    for (int m = 0; m < std::min<int>(neutral_count, static_cast<int>(qr.rank())); ++m) {
      const int column = qr.colsPermutation().indices()[m];
      held[3 * rigid.nodes[column / 3] + column % 3] = true;
    }
    removed.push_back(std::to_string(neutral_count) + " rigid motion" + (neutral_count > 1 ? "s" : "") + " of " + name +
                      (neutral_count > 1 ? " were" : " was") + " taken out: nothing resists " +
                      (neutral_count > 1 ? "them" : "it"));
  }
  return {};
}

}  // namespace lissom
