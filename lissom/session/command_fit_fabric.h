#pragma once
/// `fit-fabric`: moduli from the stretch tests of a document.

#include <string>
#include <vector>

#include "lissom/design/fabric_fit.h"
#include "lissom/model/model.h"

namespace lissom {

struct FittedFabric {
  std::string test;
  FabricFit fit;
  int measured = 0;      ///< stretches that were fitted
  std::string document;  ///< the fabric as an entry of "membrane_materials", one line
  std::string summary;   ///< JSON, one line
};

/// `tests`: names; empty: all.
Result<std::vector<FittedFabric>> fit_fabric_command(const Model& model, const std::vector<std::string>& tests);

}  // namespace lissom
