#pragma once
/// Material numbers of a structure from what was measured on it: least squares of deviations over their standard deviations
/// through the equilibria of all steps, by the methods of inverse design, and what the measurements say about each number.

#include <memory>
#include <string>
#include <vector>

#include "lissom/core/context.h"
#include "lissom/design/calibration_steps.h"
#include "lissom/design/fit_statistics.h"
#include "lissom/design/optimizer_state.h"
#include "lissom/design/structure_problem.h"

namespace lissom {

struct CalibrationFit {
  std::vector<Parameter> parameters;  ///< with bounds in SI
  VecX start, values;                 ///< SI
  CalibrationSteps steps;
  VecX fitted_at_start, fitted;  ///< SI, per CalibrationSteps::numbers
  FitStatistics statistics;      ///< of the parameters in SI; residuals are over sigma
  DesignVerdict verdict = DesignVerdict::kBadStart;
  std::string message;  ///< the verdict in a sentence, with its reason
  int iterations = 0;
  DesignEffort effort;
  Model model;  ///< the document with the materials found, which name the files they come from, without the calibration

  Design first;                               ///< of the start
  DesignPoint first_point;                    ///< of the start
  std::unique_ptr<StructureProblem> problem;  ///< stands at the end
};

/// `base` is a valid document with a calibration, discretised. Errors: those of make_calibration_steps; fewer numbers than
/// parameters; starts outside of their bounds; steps that have no stable equilibrium, by file and line. `context` has to outlive
/// the fit.
Result<CalibrationFit> fit_calibration(const Design& base, const std::vector<MeasurementData>& data,
                                       const Context& context);

}  // namespace lissom
