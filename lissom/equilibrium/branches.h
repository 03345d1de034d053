#pragma once
/// The stable shapes of one design. Thin structures have several: from the drawn shape and from every shape that is found,
/// low modes push to both sides and the energy is minimised again, until nothing new turns up.

#include <string>
#include <vector>

#include "lissom/core/context.h"
#include "lissom/equilibrium/equilibrium.h"
#include "lissom/equilibrium/options.h"
#include "lissom/equilibrium/static_problem.h"

namespace lissom {

struct BranchOptions {
  SolveOptions solve;
  int most_solves = 80;  ///< of all pushes together
  int modes = 4;         ///< lowest modes of a shape that push it
  double alike = 0.01;   ///< shapes whose root-mean-square distance is below this share of the size are one

  Status validate() const;
};

/// One stable shape.
struct Branch {
  Equilibrium equilibrium;
  bool barrier_free = false;  ///< reached from the drawn shape by going downhill all the way
  bool mirrored = false;      ///< its mirror image in the plane of the drawing is another shape, and stable too
  int same_energy_as = -1;    ///< earlier branch of equal energy and size: alike under a symmetry of the plan
  std::string found_by;       ///< how the search came to it
};

struct BranchSearch {
  std::vector<Branch> branches;  ///< by energy, lowest first
  int solves = 0;
  int not_settled = 0;     ///< solves that ended in no stable equilibrium
  bool exhausted = true;   ///< false: the limit of solves or a cancellation ended the search
  int drawn_negative = 0;  ///< modes of the drawn shape, in balance in its plane, that release energy
};

/// At load factor 1. Starts do not depend on each other's order: the same branches at any number of threads.
BranchSearch find_branches(const StaticProblem& problem, const Pose& pose, const BranchOptions& options,
                           const Context& context = {});

/// Root-mean-square distance of the nodes of two states once one is laid over the other, m; with `mirrored`, of the mirror
/// image of the second in the plane of the drawing.
enum class Image { kItself, kMirrored };
double shape_distance(const StaticProblem& problem, const State& a, const State& b, Image image);

}  // namespace lissom
