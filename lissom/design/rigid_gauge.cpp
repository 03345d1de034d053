#include "lissom/design/rigid_gauge.h"

#include <Eigen/Dense>

#include "lissom/equilibrium/rigid_drift.h"
#include "lissom/geometry/frame.h"

namespace lissom {

namespace {

constexpr double kLeastMotion = 1e-7;  // weight of all nodes together against that of one pin
constexpr int kMostSteps = 20;
constexpr double kSameTurn = 1e-12;  // rad

using Mat6 = Eigen::Matrix<double, 6, 6>;
using Vec6 = Eigen::Matrix<double, 6, 1>;

/// The motion of a place at arm `r` from the centre, of a shift and a turn: (3 x 6).
Eigen::Matrix<double, 3, 6> motion_at(const Vec3& r) {
  Eigen::Matrix<double, 3, 6> motion;
  motion.leftCols<3>().setIdentity();
  motion.rightCols<3>() = -skew(r);
  return motion;
}

Vec3 centre_of(const State& state, int nodes) {
  return Eigen::Map<const Eigen::Matrix3Xd>(state.q.data(), 3, nodes).rowwise().mean();
}

/// Normal matrix of moving pins, and everything a little, as one piece about `centre`.
Mat6 stiffness_of(const State& state, int nodes, const std::vector<PinnedNode>& pins, const Vec3& centre) {
  Mat6 matrix = Mat6::Zero();
  for (int i = 0; i < nodes; ++i) {
    const auto motion = motion_at(state.position(i) - centre);
    matrix += kLeastMotion / nodes * motion.transpose() * motion;
  }
  for (const PinnedNode& pin : pins) {
    const auto motion = motion_at(state.position(pin.node) - centre);
    matrix += motion.transpose() * motion;
  }
  return matrix;
}

/// Adds rigid motions (6 x columns: shifts and turns about `centre`) to responses.
void add_motions(const System& system, const State& state, const Vec3& centre, const MatX& motions, MatX& response) {
  const DofLayout& layout = system.layout;
  for (int i = 0; i < layout.nodes(); ++i) {
    response.middleRows<3>(3 * i) += motion_at(state.position(i) - centre) * motions;
  }
  const auto turns = motions.bottomRows<3>();
  for (int e = 0; e < system.edge_count(); ++e) {
    response.row(layout.roll(e)) += state.edges[static_cast<std::size_t>(e)].t.transpose() * turns;
  }
  for (int j = 0; j < system.joint_count(); ++j) {
    const int r = layout.rotation(j);
    if (r >= 0) response.middleRows<3>(r) += turns;
  }
}

}  // namespace

State pinned_down(const StaticProblem& problem, const State& state, const std::vector<PinnedNode>& pins) {
  if (pins.empty() || !can_be_laid_down(problem)) return state;
  const System& system = *problem.system;
  const int nodes = system.layout.nodes();
  State moved = state;
  for (int step = 0; step < kMostSteps; ++step) {
    const Vec3 centre = centre_of(moved, nodes);
    Vec6 rhs = Vec6::Zero();
    for (const PinnedNode& pin : pins) {
      const Vec3 place = moved.position(pin.node);
      rhs += motion_at(place - centre).transpose() * (pin.at - place);
    }
    const Vec6 motion = stiffness_of(moved, nodes, pins, centre).ldlt().solve(rhs);
    if (!motion.allFinite()) return state;
    const Vec3 turn = motion.tail<3>();
    moved = rigidly_moved(system, moved, rotation_from_vector(turn), centre, motion.head<3>());
    if (turn.norm() < kSameTurn) break;
  }
  return moved;
}

void pin_down_response(const StaticProblem& problem, const State& state, const std::vector<PinnedNode>& pins,
                       const SparseMatrix& drawn, MatX& response) {
  if (!can_be_laid_down(problem)) return;
  const System& system = *problem.system;
  const int nodes = system.layout.nodes();
  // Laid down: the covariance with the drawn shape stays symmetric, its centre stays where it is. The state may have been
  // moved since; the drawn shape then moves along.
  const std::vector<double> weight = node_weights(system);
  double total = 0;
  Vec3 centre = Vec3::Zero(), drawn_centre = Vec3::Zero();
  for (int i = 0; i < nodes; ++i) {
    const double w = weight[static_cast<std::size_t>(i)];
    total += w;
    centre += w * state.position(i);
    drawn_centre += w * system.structure.nodes[static_cast<std::size_t>(i)];
  }
  centre /= total;
  drawn_centre /= total;
  Mat3 covariance = Mat3::Zero();
  for (int i = 0; i < nodes; ++i) {
    const Vec3 arm = system.structure.nodes[static_cast<std::size_t>(i)] - drawn_centre;
    covariance += weight[static_cast<std::size_t>(i)] * (state.position(i) - centre) * arm.transpose();
  }
  const Mat3 along = nearest_rotation(covariance);
  const Mat3 symmetric = covariance * along.transpose();
  // What moving nodes, and moving drawn nodes, ask of the shift and the turn: (6 x 3 per node).
  MatX by_node(6, 3 * nodes), by_drawn(6, 3 * nodes);
  for (int i = 0; i < nodes; ++i) {
    const double w = weight[static_cast<std::size_t>(i)];
    const Vec3 arm = along * (system.structure.nodes[static_cast<std::size_t>(i)] - drawn_centre);
    by_node.block<3, 3>(0, 3 * i) = -w / total * Mat3::Identity();
    by_node.block<3, 3>(3, 3 * i) = -w * skew(arm);
    by_drawn.block<3, 3>(0, 3 * i) = w / total * along;
    by_drawn.block<3, 3>(3, 3 * i) = w * skew(state.position(i) - centre) * along;
  }
  MatX rhs = by_node * response.topRows(3 * nodes);
  rhs += by_drawn * drawn;
  const Mat3 inertia = symmetric.trace() * Mat3::Identity() - symmetric;
  MatX motions = rhs;
  motions.bottomRows<3>() = inertia.ldlt().solve(rhs.bottomRows<3>());
  if (!motions.allFinite()) return;
  add_motions(system, state, centre, motions, response);
  if (pins.empty()) return;
  const Vec3 middle = centre_of(state, nodes);
  rhs.setZero();
  for (const PinnedNode& pin : pins) {
    rhs -= motion_at(state.position(pin.node) - middle).transpose() * response.middleRows<3>(3 * pin.node);
  }
  motions = stiffness_of(state, nodes, pins, middle).ldlt().solve(rhs);
  if (motions.allFinite()) add_motions(system, state, middle, motions, response);
}

}  // namespace lissom
