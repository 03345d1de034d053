#include "lissom/equilibrium/branches.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "lissom/equilibrium/newton_workspace.h"
#include "lissom/equilibrium/rigid_drift.h"
#include "lissom/equilibrium/solve.h"
#include "lissom/equilibrium/stability.h"
#include "lissom/equilibrium/step_limits.h"
#include "lissom/equilibrium/step_path.h"
#include "lissom/geometry/frame.h"

namespace lissom {

namespace {

constexpr double kGentle = 0.03, kHard = 0.6;  // rad, largest turn of a push
constexpr double kSameEnergy = 1e-4;           // relative, of shapes alike under a symmetry

/// A start of the search.
struct Push {
  State from;
  VecX direction;  ///< global axes; empty: the state itself
  double turn = 0;
  bool downhill = false;
  std::string name;
};

/// `state` pushed along a direction until the edge that turns most has turned by `turn`; lengths of rods are kept.
std::optional<State> pushed(const StaticProblem& problem, const Push& push, const Context& context) {
  if (push.direction.size() == 0) return push.from;
  const System& system = *problem.system;
  NewtonWorkspace workspace(problem, context);
  const double turn = std::max(largest_turn(system, push.from, push.direction), largest_roll(system, push.direction));
  if (!(turn > 0)) return {};
  StepPathPolicy path(workspace, StepPath::kRotating);
  const VecX step = push.turn / turn * push.direction;
  path.begin(push.from, step, 1, false);
  State moved;
  for (const double a : {1.0, 0.5, 0.25}) {
    if (path.at(a, moved)) return moved;
  }
  return {};
}

/// Principal values of the covariance of the nodes, m^2: what a symmetry of the plan leaves alone.
Vec3 spread(const System& system, const State& state) {
  Vec3 centre = Vec3::Zero();
  const int n = system.layout.nodes();
  for (int i = 0; i < n; ++i) centre += state.position(i) / n;
  Mat3 covariance = Mat3::Zero();
  for (int i = 0; i < n; ++i) {
    covariance += (state.position(i) - centre) * (state.position(i) - centre).transpose() / n;
  }
  return Eigen::SelfAdjointEigenSolver<Mat3>(covariance).eigenvalues();
}

class Search {
 public:
  Search(const StaticProblem& problem, const Pose& pose, const BranchOptions& options, const Context& context)
      : problem_(problem), pose_(pose), options_(options), context_(context) {}

  BranchSearch run();

 private:
  void push_from_drawn(std::vector<Push>& pushes);
  void push_from(const Branch& branch, std::vector<Push>& pushes) const;
  void try_all(std::vector<Push> pushes);
  void add(Branch branch);
  void sort_and_compare();

  const StaticProblem& problem_;
  const Pose& pose_;
  const BranchOptions& options_;
  const Context& context_;
  BranchSearch result_;
};

/// Both sides of each mode, and of the sums and differences of the first three.
std::vector<std::pair<VecX, std::string>> directions(const std::vector<Mode>& modes, size_t most) {
  std::vector<std::pair<VecX, std::string>> all;
  const size_t count = std::min(modes.size(), most);
  const auto both = [&](const VecX& v, const std::string& name) {
    all.emplace_back(v, "+" + name);
    all.emplace_back(-v, "-" + name);
  };
  for (size_t i = 0; i < count; ++i) both(modes[i].shape, "mode " + std::to_string(i));
  for (size_t i = 0; i < std::min<size_t>(count, 3); ++i) {
    for (size_t j = i + 1; j < std::min<size_t>(count, 3); ++j) {
      both(modes[i].shape + modes[j].shape, "(mode " + std::to_string(i) + " + mode " + std::to_string(j) + ")");
      both(modes[i].shape - modes[j].shape, "(mode " + std::to_string(i) + " - mode " + std::to_string(j) + ")");
    }
  }
  return all;
}

void Search::push_from_drawn(std::vector<Push>& pushes) {
  Pose flat = pose_;
  flat.seed = Seed{};
  SolveOptions stay = options_.solve;
  stay.at_saddle = AtSaddle::kStay;
  stay.modes = options_.modes;
  const Equilibrium drawn = solve(problem_, start_state(problem_, flat), 1, stay, context_);
  ++result_.solves;
  result_.drawn_negative = drawn.negative_modes;
  if (drawn.verdict == Verdict::kStable) {
    Branch branch{drawn, true, false, -1, "the drawn shape"};
    add(std::move(branch));
  }
  pushes.push_back({start_state(problem_, pose_), {}, 0, true, "the seed of the pose"});
  for (auto& [direction, name] : directions(drawn.modes, static_cast<size_t>(options_.modes))) {
    pushes.push_back({drawn.state, direction, kGentle, true, name + " of the drawn shape"});
    pushes.push_back({drawn.state, direction, kHard, false, name + " of the drawn shape, hard"});
  }
}

void Search::push_from(const Branch& branch, std::vector<Push>& pushes) const {
  for (auto& [direction, name] : directions(branch.equilibrium.modes, 2)) {
    pushes.push_back({branch.equilibrium.state, direction, kHard, false, name + " of a shape found, hard"});
  }
}

void Search::try_all(std::vector<Push> pushes) {
  const int left = options_.most_solves - result_.solves;
  if (static_cast<int>(pushes.size()) > left) {
    pushes.resize(static_cast<size_t>(std::max(left, 0)));
    result_.exhausted = false;
  }
  SolveOptions options = options_.solve;
  options.modes = std::max(options_.modes, 1);
  std::vector<std::optional<Equilibrium>> found(pushes.size());
  // One solve per thread: each is sequential inside, so that results do not depend on who else runs.
  Context alone = context_;
  alone.threads = nullptr;
  alone.progress = {};
  parallel_for(context_.threads, static_cast<int>(pushes.size()), 1, [&](int begin, int end) {
    for (int k = begin; k < end; ++k) {
      if (context_.cancelled()) return;
      if (const std::optional<State> start = pushed(problem_, pushes[k], alone)) {
        found[k] = solve(problem_, *start, 1, options, alone);
      }
    }
  });
  for (size_t k = 0; k < pushes.size(); ++k) {
    if (!found[k]) continue;
    ++result_.solves;
    if (found[k]->verdict != Verdict::kStable) {
      ++result_.not_settled;
      continue;
    }
    add({std::move(*found[k]), pushes[k].downhill, false, -1, pushes[k].name});
  }
  if (context_.cancelled()) result_.exhausted = false;
  context_.report({"branches", double(result_.solves) / options_.most_solves, result_.solves, 0,
                   std::to_string(result_.branches.size()) + " shapes found"});
}

void Search::add(Branch branch) {
  const double alike = options_.alike * problem_.scales.length;
  for (Branch& known : result_.branches) {
    const State &a = known.equilibrium.state, &b = branch.equilibrium.state;
    const bool itself = shape_distance(problem_, a, b, Image::kItself) < alike;
    if (!itself && shape_distance(problem_, a, b, Image::kMirrored) >= alike) continue;
    known.mirrored = known.mirrored || !itself;
    known.barrier_free = known.barrier_free || branch.barrier_free;
    return;
  }
  result_.branches.push_back(std::move(branch));
}

void Search::sort_and_compare() {
  std::vector<Branch>& all = result_.branches;
  std::stable_sort(all.begin(), all.end(),
                   [](const Branch& a, const Branch& b) { return a.equilibrium.energy < b.equilibrium.energy; });
  for (size_t k = 0; k < all.size(); ++k) {
    const Vec3 own = spread(*problem_.system, all[k].equilibrium.state);
    for (size_t j = 0; j < k && all[k].same_energy_as < 0; ++j) {
      const double difference = std::abs(all[k].equilibrium.energy - all[j].equilibrium.energy);
      if (difference > kSameEnergy * std::abs(all[j].equilibrium.energy)) continue;
      const Vec3 other = spread(*problem_.system, all[j].equilibrium.state);
      if ((own - other).norm() < 0.01 * other.norm()) all[k].same_energy_as = static_cast<int>(j);
    }
  }
}

BranchSearch Search::run() {
  std::vector<Push> pushes;
  push_from_drawn(pushes);
  try_all(std::move(pushes));
  // Shapes found on the way are pushed in turn.
  for (size_t next = 0; next < result_.branches.size() && result_.exhausted; ++next) {
    std::vector<Push> more;
    push_from(result_.branches[next], more);
    try_all(std::move(more));
  }
  sort_and_compare();
  return std::move(result_);
}

}  // namespace

Status BranchOptions::validate() const {
  if (const Status s = solve.validate(); !s) return s;
  if (most_solves < 1) return Error{ErrorCode::kRange, "most_solves", "at least one solve is needed", "80 is usual"};
  if (modes < 1) return Error{ErrorCode::kRange, "modes", "at least one mode is needed", "4 is usual"};
  if (!(alike > 0) || alike > 0.5) {
    return Error{ErrorCode::kRange, "alike", "has to lie between 0 and 0.5", "0.01 is usual"};
  }
  return {};
}

double shape_distance(const StaticProblem& problem, const State& a, const State& b, Image image) {
  const System& system = *problem.system;
  const int n = system.layout.nodes();
  Mat3 flip = Mat3::Identity();
  if (image == Image::kMirrored) flip(2, 2) = -1;
  const bool free = system.structure.components == 1 && !problem.supports.free_parts().empty();
  Vec3 centre_a = Vec3::Zero(), centre_b = Vec3::Zero();
  Mat3 rotation = Mat3::Identity();
  if (free) {
    for (int i = 0; i < n; ++i) {
      centre_a += a.position(i) / n;
      centre_b += flip * b.position(i) / n;
    }
    Mat3 covariance = Mat3::Zero();
    for (int i = 0; i < n; ++i) {
      covariance += (a.position(i) - centre_a) * (flip * b.position(i) - centre_b).transpose();
    }
    rotation = nearest_rotation(covariance);
  }
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    sum += (a.position(i) - centre_a - rotation * (flip * b.position(i) - centre_b)).squaredNorm();
  }
  return std::sqrt(sum / n);
}

BranchSearch find_branches(const StaticProblem& problem, const Pose& pose, const BranchOptions& options,
                           const Context& context) {
  return Search(problem, pose, options, context).run();
}

}  // namespace lissom
