#pragma once
/// A model with what has been computed about it: systems at several resolutions, equilibria, paths, rates, modes. Each is
/// computed once, when it is first asked for, and kept; so is the error of what cannot be computed.

#include <map>
#include <string>
#include <utility>

#include "lissom/core/context.h"
#include "lissom/equilibrium/continuation.h"
#include "lissom/equilibrium/form_finding.h"
#include "lissom/equilibrium/options.h"
#include "lissom/equilibrium/stability.h"
#include "lissom/equilibrium/static_problem.h"
#include "lissom/model/model.h"
#include "lissom/motion/natural_modes.h"

namespace lissom {

/// A pose in balance [docs/guide/quantities.md, "How an entry is evaluated", 1].
struct Situation {
  const System* system = nullptr;
  const StaticProblem* problem = nullptr;
  State state;
  VecX reaction;  ///< N, N m, per unknown in global axes: what the supports exert on the structure
};

/// How everything begins to change with the load factor: derivatives at the first load factor of a pose.
struct Rate {
  const System* system = nullptr;
  const StaticProblem* problem = nullptr;
  State state;         ///< the equilibrium at which it is taken
  VecX reaction;       ///< N, N m, in that state
  VecX unknowns;       ///< derivative of the unknowns, global axes
  VecX reaction_rate;  ///< derivative of `reaction`
};

/// The model and the context have to outlive the study. References that it hands out stay valid as long as it lives.
class Study {
 public:
  Study(const Model& model, const SolveOptions& options, const Context& context)
      : model_(model), options_(options), context_(context) {}
  Study(const Study&) = delete;
  Study& operator=(const Study&) = delete;

  const Model& model() const { return model_; }
  const Context& context() const { return context_; }
  const SolveOptions& options() const { return options_; }

  /// `refine` multiplies all numbers of edges; `pose` is an index into Model::poses.
  Result<const System*> system(double refine = 1);
  Result<const StaticProblem*> problem(int pose, double refine = 1);
  /// Of a pose with form finding.
  Result<const FoundForm*> form(int pose, double refine = 1);
  Result<const PathResult*> path(int pose, double refine = 1);
  Result<const Situation*> situation(int pose, double refine = 1);
  Result<const Rate*> rate(int pose, double refine = 1);
  /// At least `modes` of the lowest modes in the situation, unless there are fewer.
  Result<const Stability*> stability(int pose, int modes, double refine = 1);
  /// At least `modes` of the slowest free vibrations about the situation, unless there are fewer.
  Result<const std::vector<NaturalMode>*> vibrations(int pose, int modes, double refine = 1);

 private:
  using Key = std::pair<int, double>;  // pose, refine

  Result<StaticProblem> make_problem(Key key);
  Result<FoundForm> make_form(Key key);
  Result<PathResult> make_path(Key key);
  Result<Situation> make_situation(Key key);
  Result<Rate> make_rate(Key key);
  /// "pose \"loaded\"", for messages.
  std::string name_of(int pose) const;

  const Model& model_;
  SolveOptions options_;
  Context context_;
  std::map<double, Result<System>> systems_;
  std::map<Key, Result<StaticProblem>> problems_;
  std::map<Key, Result<FoundForm>> forms_;
  std::map<Key, Result<PathResult>> paths_;
  std::map<Key, Result<Situation>> situations_;
  std::map<Key, Result<Rate>> rates_;
  std::map<Key, Result<Stability>> stabilities_;
  std::map<Key, std::pair<int, Result<std::vector<NaturalMode>>>> vibrations_;  // with how many were asked for
};

/// Forces and moments of the supports in a state, global axes.
VecX support_reactions(const StaticProblem& problem, const State& state);

}  // namespace lissom
