#pragma once
/// Form finding of membranes by renewing their rest shape [updated reference strategy, Bletzinger & Ramm 1999]: solve, make
/// the present shape over the pre-stretch the rest shape of every triangle, and repeat until nothing moves. What is left is
/// the pre-stretch alone, everywhere: where it is equal both ways the tension is uniform and the surface is minimal.

#include <memory>
#include <string>

#include "lissom/core/context.h"
#include "lissom/equilibrium/equilibrium.h"
#include "lissom/equilibrium/options.h"
#include "lissom/equilibrium/static_problem.h"

namespace lissom {

struct FoundForm {
  std::unique_ptr<System> system;  ///< with the rest shapes that were found
  std::unique_ptr<StaticProblem> problem;
  Equilibrium equilibrium;  ///< iteration limit: the shape still moves; otherwise that of the last round
  int rounds = 0;           ///< solves
  double last_move = 0;     ///< m, largest movement of the last round; of membranes across themselves
};

/// Starts from `system` as drawn and the seed of the pose, at load factor 1; `pose.form_finding` says when to stop.
Result<FoundForm> find_form(const Model& model, const System& system, const Pose& pose, const std::string& where,
                            const SolveOptions& options, const Context& context = {});

}  // namespace lissom
