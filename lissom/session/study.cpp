#include "lissom/session/study.h"

#include "lissom/equilibrium/report.h"
#include "lissom/equilibrium/solve.h"

namespace lissom {

namespace {

/// The entry of a cache, made when it is missing.
template <class Key, class T, class Make>
Result<const T*> once(std::map<Key, Result<T>>& cache, const Key& key, const Make& make) {
  auto entry = cache.find(key);
  if (entry == cache.end()) entry = cache.emplace(key, make()).first;
  if (!entry->second) return entry->second.error();
  return &entry->second.value();
}

bool in_balance(Verdict verdict) {
  return verdict == Verdict::kStable || verdict == Verdict::kCritical || verdict == Verdict::kUnstable;
}

}  // namespace

VecX support_reactions(const StaticProblem& problem, const State& state) {
  AssemblyBuffers buffers;
  VecX gradient;
  problem.potential.gradient(state, gradient, buffers);
  return reactions(problem, gradient);
}

std::string Study::name_of(int pose) const { return "pose \"" + model_.poses[pose].name + "\""; }

Result<const System*> Study::system(double refine) {
  return once(systems_, refine, [&] { return make_system(model_, refine); });
}

Result<const StaticProblem*> Study::problem(int pose, double refine) {
  if (model_.poses[pose].form_finding) {
    const Result<const FoundForm*> form = this->form(pose, refine);
    if (!form) return form.error();
    return form.value()->problem.get();
  }
  return once(problems_, Key(pose, refine), [&] { return make_problem({pose, refine}); });
}

Result<const FoundForm*> Study::form(int pose, double refine) {
  return once(forms_, Key(pose, refine), [&] { return make_form({pose, refine}); });
}

Result<const PathResult*> Study::path(int pose, double refine) {
  return once(paths_, Key(pose, refine), [&] { return make_path({pose, refine}); });
}

Result<const Situation*> Study::situation(int pose, double refine) {
  return once(situations_, Key(pose, refine), [&] { return make_situation({pose, refine}); });
}

Result<const Rate*> Study::rate(int pose, double refine) {
  return once(rates_, Key(pose, refine), [&] { return make_rate({pose, refine}); });
}

Result<const Stability*> Study::stability(int pose, int modes, double refine) {
  const Result<const Situation*> situation = this->situation(pose, refine);
  if (!situation) return situation.error();
  const StaticProblem& problem = *situation.value()->problem;
  const Key key(pose, refine);
  const auto known = stabilities_.find(key);
  if (known != stabilities_.end()) {
    const int found = static_cast<int>(known->second.value().modes.size());
    if (found >= std::min(modes, problem.supports.unknowns())) return &known->second.value();
    stabilities_.erase(known);
  }
  return once(stabilities_, key, [&]() -> Result<Stability> {
    NewtonWorkspace workspace(problem, context_);
    workspace.assemble(situation.value()->state);
    return examine_stability(workspace, modes);
  });
}

Result<const std::vector<NaturalMode>*> Study::vibrations(int pose, int modes, double refine) {
  const Key key(pose, refine);
  auto known = vibrations_.find(key);
  if (known != vibrations_.end() && known->second.first < modes) {
    vibrations_.erase(known);
    known = vibrations_.end();
  }
  if (known == vibrations_.end()) {
    const Result<const Situation*> situation = this->situation(pose, refine);
    if (!situation) return situation.error();
    // Nothing is taken out: everything has inertia.
    const Result<StaticProblem> free = make_static_problem(model_, *situation.value()->system, model_.poses[pose],
                                                           "/poses/" + std::to_string(pose), NullMotions::kKeep);
    if (!free) return free.error();
    known = vibrations_
                .emplace(key, std::pair(modes, natural_modes(free.value(), situation.value()->state, modes,
                                                             RollInertia::kLumped, context_)))
                .first;
  }
  if (!known->second.second) return known->second.second.error();
  return &known->second.second.value();
}

Result<StaticProblem> Study::make_problem(Key key) {
  const Result<const System*> system = this->system(key.second);
  if (!system) return system.error();
  return make_static_problem(model_, *system.value(), model_.poses[key.first], "/poses/" + std::to_string(key.first));
}

Result<FoundForm> Study::make_form(Key key) {
  const Result<const System*> system = this->system(key.second);
  if (!system) return system.error();
  Result<FoundForm> form = find_form(model_, *system.value(), model_.poses[key.first],
                                     "/poses/" + std::to_string(key.first), options_, context_);
  if (form && !in_balance(form.value().equilibrium.verdict)) {
    return Error{ErrorCode::kGeometry,
                 {},
                 name_of(key.first) + " has no form: " + form.value().equilibrium.message,
                 "let it take more rounds"};
  }
  return form;
}

Result<PathResult> Study::make_path(Key key) {
  const Pose& pose = model_.poses[key.first];
  const Result<const StaticProblem*> problem = this->problem(key.first, key.second);
  if (!problem) return problem.error();
  if (!pose.path) {
    return Error{
        ErrorCode::kConflict, {}, name_of(key.first) + " has no \"path\"", "give it one, such as \"path\": {}"};
  }
  PathResult path =
      follow_path(*problem.value(), start_state(*problem.value(), pose), *pose.path, {.solve = options_}, context_);
  const bool arrived =
      path.end == PathEnd::kReached || (path.end == PathEnd::kStoppedAtCritical && pose.path->stop_at_critical);
  if (!arrived || path.points.empty()) {
    return Error{
        ErrorCode::kGeometry, {}, "the path of " + name_of(key.first) + " did not arrive: " + path.message, ""};
  }
  return path;
}

Result<Situation> Study::make_situation(Key key) {
  const Pose& pose = model_.poses[key.first];
  const Result<const StaticProblem*> found = problem(key.first, key.second);
  if (!found) return found.error();
  const StaticProblem& problem = *found.value();
  Situation situation{problem.system, &problem, {}, {}};
  if (pose.frozen) {
    situation.state = drawn_state(*problem.system);
    situation.state.load_factor = 1;
  } else if (pose.form_finding) {
    situation.state = form(key.first, key.second).value()->equilibrium.state;
  } else if (pose.path) {
    const Result<const PathResult*> path = this->path(key.first, key.second);
    if (!path) return path.error();
    const bool stopped = path.value()->end == PathEnd::kStoppedAtCritical && !path.value()->critical.empty();
    situation.state = stopped ? path.value()->critical.back().state : path.value()->points.back().state;
  } else {
    Equilibrium equilibrium = solve(problem, start_state(problem, pose), 1, options_, context_);
    if (!in_balance(equilibrium.verdict)) {
      return Error{ErrorCode::kGeometry, {}, name_of(key.first) + " is not in balance: " + equilibrium.message, ""};
    }
    situation.state = std::move(equilibrium.state);
  }
  situation.reaction = support_reactions(problem, situation.state);
  return situation;
}

}  // namespace lissom
