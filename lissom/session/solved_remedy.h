#pragma once
/// The remedy against slack fabric, found by solving: what the design would really do.

#include <optional>
#include <string>

#include "lissom/core/context.h"
#include "lissom/equilibrium/equilibrium.h"
#include "lissom/equilibrium/options.h"
#include "lissom/model/model.h"
#include "lissom/session/slack_remedy.h"

namespace lissom {

struct SolvedRemedy {
  SlackRemedy remedy;
  double smallest_stretch = 0;  ///< of the fabric with it
  double moved = 0;             ///< m, root mean square over nodes, between the shapes laid over each other
};

/// `model` with other pre-stretch of all fabrics and all radii of rods multiplied.
Model remedied(const Model& model, double pre_stretch_factor, double radius_factor);

/// Raises the pre-stretch, and the radii with it so that bending keeps its balance with the fabric, until the smallest
/// stretch is about `wanted` and at least `enough`; of the radii those at which the shape moves least. Each trial is solved, from
/// the shape at hand: twelve at most. Nothing where none ends in a stable shape that is taut. `slack`: stable shape of `pose` with
/// fabric stretched by less than `enough`.
std::optional<SolvedRemedy> solved_remedy(const Model& model, const Pose& pose, const std::string& where,
                                          const Equilibrium& slack, double enough, double wanted,
                                          const SolveOptions& options, const Context& context);

/// For people: what was found, as a continuation of a sentence.
std::string solved_remedy_text(const SolvedRemedy& solved);

}  // namespace lissom
