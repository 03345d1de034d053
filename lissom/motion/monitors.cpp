#include "lissom/motion/monitors.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace lissom {

Result<Monitors> Monitors::make(const Model& model, const StaticProblem& problem, const MotionOptions& options,
                                const std::string& where) {
  Monitors monitors(problem);
  const Structure& structure = problem.system->structure;
  for (size_t w = 0; w < options.watches.size(); ++w) {
    const MotionWatch& watch = options.watches[w];
    const std::string place = where + "/watches/" + std::to_string(w);
    if (!(watch.axis.norm() > 0) || !watch.axis.allFinite() || !watch.point.value_or(Vec3::Zero()).allFinite()) {
      return Error{ErrorCode::kRange, place + "/axis", "an axis needs a direction and a point",
                   "give two finite vectors"};
    }
    Result<std::vector<int>> nodes = select(model, structure, watch.nodes, place + "/nodes");
    if (!nodes) return nodes.error();
    Watched watched{Vec3::Zero(), watch.axis.normalized(), std::move(nodes).value(), {}};
    for (const int node : watched.nodes) watched.point += structure.nodes[node];
    watched.point /= static_cast<double>(watched.nodes.size());
    if (watch.point) watched.point = *watch.point;
    std::vector<bool> selected(structure.nodes.size(), false);
    for (const int node : watched.nodes) selected[node] = true;
    for (int e = 0; e < problem.system->edge_count(); ++e) {
      const StructureEdge& edge = structure.edges[e];
      if (selected[edge.node0] && selected[edge.node1]) watched.edges.push_back(e);
    }
    monitors.watched_.push_back(std::move(watched));
  }
  return monitors;
}

WatchRecord Monitors::look(Watched& watched, const State& state, const VecX& velocity, const VecX& mass) const {
  const System& system = *problem_->system;
  WatchRecord record;
  double inertia = 0, sine = 0, cosine = 0;
  for (const int node : watched.nodes) {
    const double m = mass[3 * node];
    const Vec3 arm = state.position(node) - watched.point;
    const Vec3 drawn = system.structure.nodes[node] - watched.point;
    const Vec3 flat = arm - watched.axis * watched.axis.dot(arm);
    record.angular_momentum += m * watched.axis.dot(arm.cross(velocity.segment<3>(3 * node)));
    inertia += m * flat.squaredNorm();
    sine += m * watched.axis.dot(drawn.cross(flat));
    cosine += m * drawn.dot(flat);
  }
  if (inertia > 0) record.turn_rate = record.angular_momentum / inertia;
  const double turn = std::atan2(sine, cosine);
  watched.turn += std::remainder(turn - watched.turn, 2 * std::numbers::pi);
  record.turn = watched.turn;
  for (const int e : watched.edges) {
    const int roll = system.layout.roll(e);
    record.angular_momentum += mass[roll] * velocity[roll] * watched.axis.dot(state.edges[e].t);
  }
  return record;
}

MotionRecord Monitors::record(const Integrator& integrator, const State& state, const Context& context) {
  const System& system = *problem_->system;
  const VecX velocity = integrator.velocity();
  const VecX& mass = integrator.mass();
  MotionRecord record;
  record.time = integrator.time();
  record.load_factor = state.load_factor;
  record.translation_energy = integrator.translation_energy();
  record.roll_energy = integrator.roll_energy();
  const auto terms = problem_->potential.terms();
  by_term_.resize(terms.size());
  problem_->potential.value(state, buffers_, context.threads, by_term_);
  for (size_t t = 0; t < terms.size(); ++t) {
    (terms[t]->has_hessian() ? record.elastic_energy : record.load_potential) += by_term_[t];
  }
  record.ledger = integrator.ledger();
  record.total = record.translation_energy + record.roll_energy + record.elastic_energy - record.ledger.load_work -
                 record.ledger.support_work + record.ledger.rayleigh_loss + record.ledger.numerical_loss;
  if (!std::exchange(started_, true)) first_total_ = record.total;
  record.drift = record.total - first_total_;

  for (int i = 0; i < system.layout.nodes(); ++i) {
    const Vec3 p = mass[3 * i] * velocity.segment<3>(3 * i);
    record.momentum += p;
    record.angular_momentum += state.position(i).cross(p);
  }
  for (int e = 0; e < system.edge_count(); ++e) {
    const int roll = system.layout.roll(e);
    record.angular_momentum += mass[roll] * velocity[roll] * state.edges[e].t;
  }
  for (Watched& watched : watched_) record.watches.push_back(look(watched, state, velocity, mass));
  return record;
}

}  // namespace lissom
