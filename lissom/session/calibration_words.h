#pragma once
/// What a calibration found, in words and in units that people use. Plain text: pages have to escape it.

#include <string>
#include <vector>

#include "lissom/design/calibration_fit.h"
#include "lissom/session/design_report.h"

namespace lissom {

/// "determined", "at_lower_bound", ..., as in JSON.
const char* certainty_name(ParameterCertainty::State state);

struct CertaintyWords {
  std::string name;      ///< of the parameter
  std::string value;     ///< "31.2 MPa"; nothing where a number would say nothing
  std::string interval;  ///< "30.8 to 31.6 MPa", of the confidence asked for; may be empty
  std::string error;     ///< "0.19 MPa"; may be empty
  std::string remark;    ///< why there is no value or no interval; may be empty
};
std::vector<CertaintyWords> certainty_words(const CalibrationFit& fit);

/// "24 measured numbers, 2 parameters, 22 degrees of freedom; residual standard deviation 0.11 mm".
std::string count_words(const CalibrationFit& fit);

/// "95 %".
std::string confidence_words(double confidence);

/// How numbers of this kind are shown: moduli in MPa.
DesignReport::Measure measure_of(ParameterKind kind);

/// What was measured with one file.
struct MeasuredSet {
  std::string file;
  bool shapes = false;
  bool by_force = false;        ///< of pairs: forces were set
  std::string length_word;      ///< of pairs: "length" or "displacement"
  DesignReport::Measure force;  ///< of pairs
  DesignReport::Measure measured;
  std::vector<int> numbers;     ///< of CalibrationSteps::numbers
  double rms = 0, largest = 0;  ///< SI, of measured - fitted
};
std::vector<MeasuredSet> measured_sets(const CalibrationFit& fit, const std::vector<MeasurementBrief>& briefs);

}  // namespace lissom
