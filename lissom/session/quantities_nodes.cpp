// Places and motions of nodes, and what supports carry.

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "lissom/geometry/frame.h"
#include "lissom/session/quantity_families.h"

namespace lissom {

namespace {

template <class At>
Vec3 mean(const std::vector<int>& nodes, const At& at) {
  Vec3 sum = Vec3::Zero();
  for (const int node : nodes) sum += at(node);
  return sum / static_cast<double>(nodes.size());
}

Vec3 mean_position(const State& state, const std::vector<int>& nodes) {
  return mean(nodes, [&](int node) { return state.position(node); });
}

Vec3 mean_drawn(const System& system, const std::vector<int>& nodes) {
  return mean(nodes, [&](int node) { return system.structure.nodes[node]; });
}

Vec3 mean_velocity(const Rate& rate, const std::vector<int>& nodes) {
  return mean(nodes, [&](int node) { return Vec3(rate.unknowns.segment<3>(3 * node)); });
}

/// A situation with the selected nodes.
template <class Which>
struct Placed {
  const Which* in = nullptr;
  std::vector<int> nodes, to;
};

template <class Which>
Result<Placed<Which>> place(const Measurement& m, const Result<const Which*>& found) {
  if (!found) return found.error();
  Result<std::vector<int>> nodes = selected_nodes(m, m.at, *found.value()->system);
  if (!nodes) return nodes.error();
  return Placed<Which>{found.value(), std::move(nodes).value(), {}};
}

Result<Placed<Situation>> placed(const Measurement& m) { return place(m, m.study.situation(m.pose(), m.refine)); }
Result<Placed<Rate>> placed_rate(const Measurement& m) { return place(m, m.study.rate(m.pose(), m.refine)); }

template <class Which>
Result<Placed<Which>> with_second(const Measurement& m, Result<Placed<Which>> first) {
  if (!first) return first;
  Result<std::vector<int>> to = selected_nodes(m, *m.expectation.to, *first.value().in->system);
  if (!to) return to.error();
  first.value().to = std::move(to).value();
  return first;
}

/// Index of a node in a rod, -1 when it is not there.
int index_in(const StructureRod& rod, int node) {
  const auto found = std::find(rod.nodes.begin(), rod.nodes.end(), node);
  return found == rod.nodes.end() ? -1 : static_cast<int>(found - rod.nodes.begin());
}

/// Tangent of a rod at its node number k: of the last edge at an end, else the normalised sum of both tangents.
Vec3 tangent_at(const StructureRod& rod, int k, const State& state) {
  const int edges = static_cast<int>(rod.edges.size());
  const auto tangent = [&](int e) { return state.edges[rod.edges[(e + edges) % edges]].t; };
  if (!rod.closed && k == 0) return tangent(0);
  if (!rod.closed && k == edges) return tangent(edges - 1);
  return (tangent(k - 1) + tangent(k)).normalized();
}

double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

Result<int> joint_at(const Measurement& m, const System& system) {
  const Result<int> node = selected_node(m, system);
  if (!node) return node.error();
  const int joint = system.joint_of_node[node.value()];
  if (joint >= 0) return joint;
  return Error{ErrorCode::kConflict, m.where + "/at", "there is no frame at node " + std::to_string(node.value()),
               "measure at a joint or clamp, or use \"slope\""};
}

/// Moments on held frames, and torques on held rolls of edges between selected nodes, as vectors.
template <class Roll>
Vec3 moment_sum(const System& system, const VecX& reaction, const std::vector<int>& nodes, const Roll& roll) {
  Vec3 sum = Vec3::Zero();
  std::vector<bool> selected(system.structure.nodes.size(), false);
  for (const int node : nodes) {
    selected[node] = true;
    const int joint = system.joint_of_node[node];
    const int r = joint < 0 ? -1 : system.layout.rotation(joint);
    if (r >= 0) sum += reaction.segment<3>(r);
  }
  for (int e = 0; e < system.edge_count(); ++e) {
    const StructureEdge& edge = system.structure.edges[e];
    if (selected[edge.node0] && selected[edge.node1]) sum += roll(e);
  }
  return sum;
}

}  // namespace

Result<std::vector<int>> selected_nodes(const Measurement& m, const Selector& at, const System& system) {
  return select(m.study.model(), system.structure, at, m.where + "/at");
}

Result<int> selected_node(const Measurement& m, const System& system) {
  const Result<std::vector<int>> nodes = selected_nodes(m, m.at, system);
  if (!nodes) return nodes.error();
  if (nodes.value().size() == 1) return nodes.value().front();
  return Error{ErrorCode::kConflict, m.where + "/at",
               "\"" + m.expectation.quantity + "\" is measured at one node, " + std::to_string(nodes.value().size()) +
                   " are selected",
               "select one node"};
}

double component_or_norm(const Measurement& m, const Vec3& v) {
  return m.expectation.axis ? v.dot(m.expectation.axis->normalized()) : v.norm();
}

Vec3 force_sum(const System& system, const VecX& reaction, const std::vector<int>& nodes) {
  Vec3 sum = Vec3::Zero();
  for (const int node : nodes) sum += reaction.segment<3>(system.layout.position(node));
  return sum;
}

Result<double> node_position(const Measurement& m) {
  const Result<Placed<Situation>> p = placed(m);
  if (!p) return p.error();
  return component_or_norm(m, mean_position(p.value().in->state, p.value().nodes));
}

Result<double> node_position_rate(const Measurement& m) {
  const Result<Placed<Rate>> p = placed_rate(m);
  if (!p) return p.error();
  return component_or_norm(m, mean_velocity(*p.value().in, p.value().nodes));
}

Result<double> node_displacement(const Measurement& m) {
  const Result<Placed<Situation>> p = placed(m);
  if (!p) return p.error();
  const auto& [in, nodes, to] = p.value();
  return component_or_norm(m, mean_position(in->state, nodes) - mean_drawn(*in->system, nodes));
}

Result<double> node_displacement_rate(const Measurement& m) { return node_position_rate(m); }

Result<double> node_distance(const Measurement& m) {
  const Result<Placed<Situation>> p = with_second(m, placed(m));
  if (!p) return p.error();
  const auto& [in, nodes, to] = p.value();
  return (mean_position(in->state, to) - mean_position(in->state, nodes)).norm();
}

Result<double> node_distance_rate(const Measurement& m) {
  const Result<Placed<Rate>> p = with_second(m, placed_rate(m));
  if (!p) return p.error();
  const auto& [in, nodes, to] = p.value();
  const Vec3 between = mean_position(in->state, to) - mean_position(in->state, nodes);
  if (between.norm() > 0) return between.normalized().dot(mean_velocity(*in, to) - mean_velocity(*in, nodes));
  return Error{ErrorCode::kGeometry, m.where, "the two places coincide, so their distance has no rate", ""};
}

Result<double> node_distance_change(const Measurement& m) {
  const Result<Placed<Situation>> p = with_second(m, placed(m));
  if (!p) return p.error();
  const auto& [in, nodes, to] = p.value();
  const double now = (mean_position(in->state, to) - mean_position(in->state, nodes)).norm();
  return now - (mean_drawn(*in->system, to) - mean_drawn(*in->system, nodes)).norm();
}

Result<double> node_slope(const Measurement& m) {
  const Result<const Situation*> found = m.study.situation(m.pose(), m.refine);
  if (!found) return found.error();
  const System& system = *found.value()->system;
  const Result<int> node = selected_node(m, system);
  if (!node) return node.error();
  const StructureRod* rod = nullptr;
  int k = -1;
  for (const StructureRod& candidate : system.structure.rods) {
    if (!m.expectation.rod.empty() && candidate.name != m.expectation.rod) continue;
    const int index = index_in(candidate, node.value());
    if (index < 0) continue;
    if (rod != nullptr) {
      return Error{ErrorCode::kConflict, m.where + "/at", "several rods meet at node " + std::to_string(node.value()),
                   "say which one with \"rod\""};
    }
    rod = &candidate;
    k = index;
  }
  if (rod == nullptr) {
    return Error{ErrorCode::kUnknown, m.where + "/rod", "the rod does not pass node " + std::to_string(node.value()),
                 ""};
  }
  const Vec3 now = tangent_at(*rod, k, found.value()->state);
  if (m.expectation.axis) return angle_between(now, *m.expectation.axis);
  return angle_between(now, tangent_at(*rod, k, drawn_state(system)));
}

Result<double> node_rotation(const Measurement& m) {
  const Result<const Situation*> found = m.study.situation(m.pose(), m.refine);
  if (!found) return found.error();
  const Situation& s = *found.value();
  const Result<int> joint = joint_at(m, *s.system);
  if (!joint) return joint.error();
  const Mat3 drawn = drawn_state(*s.system).joint_rotation[joint.value()];
  return component_or_norm(m, vector_from_rotation(s.state.joint_rotation[joint.value()] * drawn.transpose()));
}

Result<double> node_rotation_rate(const Measurement& m) {
  const Result<const Rate*> found = m.study.rate(m.pose(), m.refine);
  if (!found) return found.error();
  const Rate& rate = *found.value();
  const Result<int> joint = joint_at(m, *rate.system);
  if (!joint) return joint.error();
  const Mat3 now = rate.state.joint_rotation[joint.value()];
  const int r = rate.system->layout.rotation(joint.value());
  Vec3 spin;
  if (r >= 0) {
    spin = rate.unknowns.segment<3>(r);
  } else {
    // The fitted rotation is a smooth function of the unknowns: central difference along their rate.
    const double h = 1e-4 / std::max(1e-300, largest_turn(*rate.system, rate.state, rate.unknowns));
    State ahead, back;
    if (!advance(*rate.system, rate.state, h * rate.unknowns, ahead) ||
        !advance(*rate.system, rate.state, -h * rate.unknowns, back)) {
      return Error{ErrorCode::kGeometry, m.where, "the joint turns too fast to measure its rate", ""};
    }
    spin = vector_from_rotation(ahead.joint_rotation[joint.value()] * back.joint_rotation[joint.value()].transpose()) /
           (2 * h);
  }
  const Vec3 turned = vector_from_rotation(now * drawn_state(*rate.system).joint_rotation[joint.value()].transpose());
  return component_or_norm(m, left_jacobian(turned).inverse() * spin);
}

Result<double> reaction_force(const Measurement& m) {
  const Result<Placed<Situation>> p = placed(m);
  if (!p) return p.error();
  return component_or_norm(m, force_sum(*p.value().in->system, p.value().in->reaction, p.value().nodes));
}

Result<double> reaction_force_rate(const Measurement& m) {
  const Result<Placed<Rate>> p = placed_rate(m);
  if (!p) return p.error();
  return component_or_norm(m, force_sum(*p.value().in->system, p.value().in->reaction_rate, p.value().nodes));
}

Result<double> reaction_moment(const Measurement& m) {
  const Result<Placed<Situation>> p = placed(m);
  if (!p) return p.error();
  const auto& [in, nodes, to] = p.value();
  const Situation& s = *in;
  return component_or_norm(m, moment_sum(*s.system, s.reaction, nodes, [&](int e) {
                             return Vec3(s.reaction[s.system->layout.roll(e)] * s.state.edges[e].t);
                           }));
}

Result<double> reaction_moment_rate(const Measurement& m) {
  const Result<Placed<Rate>> p = placed_rate(m);
  if (!p) return p.error();
  const auto& [in, nodes, to] = p.value();
  const Rate& r = *in;
  return component_or_norm(m, moment_sum(*r.system, r.reaction_rate, nodes, [&](int e) {
                             const StructureEdge& edge = r.system->structure.edges[e];
                             const EdgeState& now = r.state.edges[e];
                             const Vec3 stretch =
                                 r.unknowns.segment<3>(3 * edge.node1) - r.unknowns.segment<3>(3 * edge.node0);
                             const Vec3 turning = (stretch - now.t * now.t.dot(stretch)) / now.length;
                             const int roll = r.system->layout.roll(e);
                             return Vec3(r.reaction_rate[roll] * now.t + r.reaction[roll] * turning);
                           }));
}

}  // namespace lissom
