// Forces across a cut through the structure, and the stiffness of a ring against becoming oval.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lissom/equilibrium/newton_workspace.h"
#include "lissom/session/quantity_families.h"

namespace lissom {

namespace {

enum class Carrier { kAll, kMembranes, kRods };

bool carries(std::string_view term, Carrier carrier) {
  const bool membrane = term.starts_with("membrane");
  const bool rod = term.starts_with("rod") || term.starts_with("joint");
  return carrier == Carrier::kAll ? membrane || rod : carrier == Carrier::kMembranes ? membrane : rod;
}

/// Force with which the part in front of the plane pulls at the part behind it: the sum over the stencils that the plane
/// cuts, of their forces on the nodes behind it. Forces of the others cancel, for they are in balance by themselves.
Result<double> cut_force(const Measurement& m, Carrier carrier) {
  const Result<const Situation*> found = m.study.situation(m.pose(), m.refine);
  if (!found) return found.error();
  if (m.at.kind != Selector::Kind::kPoint) {
    return Error{ErrorCode::kConflict, m.where + "/at", "\"" + m.expectation.quantity + "\" is measured at a plane",
                 "write \"at\": {\"point\": [x, y, z]}, a point of the plane; \"axis\" is its normal"};
  }
  const Situation& s = *found.value();
  const Vec3 normal = m.expectation.axis->normalized();
  const auto behind = [&](int node) { return normal.dot(s.state.position(node) - m.at.point) <= 0; };
  Vec3 force = Vec3::Zero();
  for (const auto& term : s.problem->potential.terms()) {
    if (!carries(term->name(), carrier)) continue;
    const int dofs = term->dofs();
    std::vector<double> gradient(static_cast<size_t>(term->groups()) * kLanes * dofs);
    term->derivatives(s.state, 0, term->groups(), gradient.data(), nullptr);
    for (int stencil = 0; stencil < term->stencils(); ++stencil) {
      for (int i = 0; i < dofs; ++i) {
        const int dof = term->indices()[static_cast<size_t>(stencil) * dofs + i];
        if (s.system->layout.dof_class(dof) != DofClass::kPosition || !behind(dof / 3)) continue;
        force[dof % 3] -= gradient[static_cast<size_t>(stencil) * dofs + i];
      }
    }
  }
  return force.dot(normal);
}

}  // namespace

Result<double> cut_force_all(const Measurement& m) { return cut_force(m, Carrier::kAll); }
Result<double> cut_force_membranes(const Measurement& m) { return cut_force(m, Carrier::kMembranes); }
Result<double> cut_force_rods(const Measurement& m) { return cut_force(m, Carrier::kRods); }

Result<double> ring_stiffness(const Measurement& m) {
  const Result<const Situation*> found = m.study.situation(m.pose(), m.refine);
  if (!found) return found.error();
  const Situation& s = *found.value();
  const int index = s.system->structure.rod_index(m.expectation.rod);
  if (index < 0 || !s.system->structure.rods[index].closed || m.expectation.mode < 2) {
    return Error{ErrorCode::kConflict, m.where + (m.expectation.mode < 2 ? "/mode" : "/rod"),
                 "\"ring_stiffness\" needs a closed rod and a mode of at least 2",
                 "mode 2 makes the ring oval, mode 3 three-cornered"};
  }
  const std::vector<int>& nodes = s.system->structure.rods[index].nodes;
  const double count = static_cast<double>(nodes.size());
  Vec3 centre = Vec3::Zero(), normal = Vec3::Zero();
  for (const int node : nodes) centre += s.state.position(node) / count;
  for (size_t k = 0; k < nodes.size(); ++k) {
    normal += (s.state.position(nodes[k]) - centre).cross(s.state.position(nodes[(k + 1) % nodes.size()]) - centre);
  }
  normal.normalize();

  // Radial amplitude a = c' q of the mode; the energy of the softest shape with that amplitude is a^2 / (2 c' H^-1 c).
  VecX local = VecX::Zero(s.system->layout.size());
  for (size_t k = 0; k < nodes.size(); ++k) {
    const Vec3 out = s.state.position(nodes[k]) - centre;
    const Vec3 radial = (out - normal * normal.dot(out)).normalized();
    const double angle = 2 * std::numbers::pi * m.expectation.mode * static_cast<double>(k) / count;
    local.segment<3>(s.system->layout.position(nodes[k])) = 2 / count * std::cos(angle) * radial;
  }
  s.problem->potential.to_local(local);
  NewtonWorkspace workspace(*s.problem, m.study.context());
  workspace.assemble(s.state);
  VecX shape, answer;
  s.problem->supports.restrict(local, shape);
  const Error singular{ErrorCode::kGeometry, m.where, "something can move without a force", "hold it"};
  if (!workspace.factorize(0).complete) return singular;
  workspace.factor().solve(shape, answer);
  const double softness = shape.dot(answer);
  if (!std::isfinite(softness) || softness == 0) return singular;
  return 1 / (std::numbers::pi * softness);
}

}  // namespace lissom
