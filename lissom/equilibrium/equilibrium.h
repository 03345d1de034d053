#pragma once
/// Result of a static solve: the state, what became of it, and why.

#include <string>
#include <string_view>
#include <vector>

#include "lissom/core/types.h"
#include "lissom/mechanics/state.h"

namespace lissom {

/// The fixed list of endings. Names, sentences and exit codes are in verdicts().
enum class Verdict {
  kStable,          ///< in equilibrium, every small motion costs energy
  kCritical,        ///< in equilibrium, some motion costs no energy to second order
  kUnstable,        ///< in equilibrium, but some motion releases energy (only when asked to stay there)
  kIterationLimit,  ///< best state kept; more iterations may help
  kStalled,         ///< no step lowers the energy although forces are left
  kRunaway,         ///< grows without bound: something is not held
  kCancelled,       ///< stopped by the caller; best state kept
  kBadStart,        ///< the start state has no finite energy
};

struct VerdictInfo {
  Verdict verdict;
  std::string_view name;      ///< "stable", as in JSON
  std::string_view sentence;  ///< for people
  int exit_code;              ///< of the command line
};
const VerdictInfo& verdict_info(Verdict verdict);

struct Mode {
  double stiffness = 0;  ///< N/m, energy = 1/2 stiffness amplitude^2 for a root-mean-square displacement `amplitude`
  VecX shape;            ///< global increments of all unknowns, normalised by StaticProblem::mode_metric
};

struct IterationRecord {
  int iteration = 0;
  double load_factor = 0;
  double energy = 0;    ///< J
  double residual = 0;  ///< N, largest of forces and moments / L0
  double shift = 0;
  double step = 0;         ///< fraction of the Newton step taken
  double turn = 0;         ///< rad, largest turn of an edge
  int factorizations = 0;  ///< so far
};

struct EnergyShare {
  std::string term;
  double energy = 0;  ///< J
};

/// A place worth looking at: what is largest there.
struct WorstElement {
  std::string what;  ///< "unbalanced force", "turning angle", "axial strain", ...
  std::string rod;   ///< name
  int node = -1, edge = -1;
  double value = 0;  ///< SI
  std::string unit;
  std::string membrane = {};  ///< name
  int triangle = -1;          ///< of the structure
};

struct Equilibrium {
  State state;
  Verdict verdict = Verdict::kBadStart;
  std::string message;   ///< one sentence: the verdict with its reason
  double residual = 0;   ///< N
  double tolerance = 0;  ///< N, what the residual was judged by
  int iterations = 0;
  int factorizations = 0;  ///< all attempted, stability check included
  int negative_modes = 0;
  int spins = 0;                ///< straight rods that turn about their own axis without energy: nothing moves
  bool start_smoothed = false;  ///< the start was crumpled (start_smoothing.h)
  double energy = 0;            ///< J
  std::vector<EnergyShare> energy_shares;
  std::vector<Mode> modes;  ///< lowest, ascending
  std::vector<WorstElement> worst;
  std::vector<IterationRecord> records;
  VecX reaction;  ///< N, N m, per unknown (global axes): what held unknowns carry, 0 elsewhere
};

}  // namespace lissom
