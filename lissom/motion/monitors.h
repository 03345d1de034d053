#pragma once
/// Energies and momenta of a moving structure. Used by simulate().

#include <vector>

#include "lissom/motion/integrator.h"
#include "lissom/motion/motion.h"

namespace lissom {

class Monitors {
 public:
  /// Resolves the watches; `where` for errors.
  static Result<Monitors> make(const Model& model, const StaticProblem& problem, const MotionOptions& options,
                               const std::string& where);

  /// Record of the integrator's present state, `settled`; the first one sets what drift is counted from.
  MotionRecord record(const Integrator& integrator, const State& settled, const Context& context);

 private:
  struct Watched {
    Vec3 point, axis;
    std::vector<int> nodes, edges;
    double turn = 0;  ///< rad, last recorded
  };

  explicit Monitors(const StaticProblem& problem) : problem_(&problem) {}
  WatchRecord look(Watched& watched, const State& state, const VecX& velocity, const VecX& mass) const;

  const StaticProblem* problem_;
  std::vector<Watched> watched_;
  AssemblyBuffers buffers_;
  std::vector<double> by_term_;
  bool started_ = false;
  double first_total_ = 0;
};

}  // namespace lissom
