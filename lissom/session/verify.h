#pragma once
/// Verification as a feature: does the document do what it claims? [docs/guide/quantities.md]

#include <filesystem>
#include <string>
#include <vector>

#include "lissom/core/context.h"
#include "lissom/model/model.h"

namespace lissom {

/// One claimed number and what was measured.
struct Check {
  bool passed = false;
  std::string label;             ///< what is claimed: label or quantity, and the pose where there are several
  std::string failure;           ///< why nothing could be measured; empty when something was
  double got = 0, expected = 0;  ///< in `unit`
  double deviation = 0;          ///< got - expected, in `unit`
  double relative = 0;           ///< deviation / |expected|; NaN when 0 is expected
  double tolerance = 0;          ///< relative, or in `unit`
  bool relative_tolerance = false;
  std::string unit;  ///< empty: a pure number
  std::string source;
};

/// Runs the expectations of a model in order. A model without any gives one failed check that says so.
std::vector<Check> verify(const Model& model, const Context& context);

/// "PASS  cantilever: tip deflection / L [half]: got 0.162139, expected 0.162144, deviation -0.003 %, tolerance 0.5 %".
std::string check_line(const Check& check, const std::string& document);

}  // namespace lissom
