#include "lissom/session/command_fit_fabric.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "lissom/core/nearest_name.h"
#include "lissom/model/json_value.h"
#include "lissom/model/units.h"

namespace lissom {

namespace {

FittedFabric fitted(const FabricTest& test, const FabricFit& fit) {
  FittedFabric result{test.name, fit, 0, {}, {}};
  for (const StripPull& pull : test.pulls) result.measured += pull.across > 0 ? 2 : 1;
  const auto text = [](double stiffness) { return number_text(stiffness) + " N/m"; };
  nlohmann::ordered_json fabric;
  fabric["stiffness"] = {text(fit.stiffness_1), text(fit.stiffness_2)};
  fabric["poisson_ratio"] = fit.poisson_ratio;
  result.document = nlohmann::ordered_json(test.name).dump() + ": " + fabric.dump();
  nlohmann::ordered_json summary;
  summary["test"] = test.name;
  summary["stiffness_1"] = fit.stiffness_1;
  summary["stiffness_2"] = fit.stiffness_2;
  summary["poisson_ratio"] = fit.poisson_ratio;
  summary["shear"] = fit.shear();
  summary["measured"] = result.measured;
  summary["rms_deviation"] = fit.rms;
  summary["largest_deviation"] = fit.largest;
  summary["iterations"] = fit.iterations;
  result.summary = summary.dump();
  return result;
}

}  // namespace

Result<std::vector<FittedFabric>> fit_fabric_command(const Model& model, const std::vector<std::string>& tests) {
  std::vector<std::string> known;
  for (const FabricTest& test : model.fabric_tests) known.push_back(test.name);
  for (const std::string& name : tests) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    return Error{ErrorCode::kUnknown, "--test", "there is no fabric test \"" + name + "\"", suggestion(name, known)};
  }
  if (known.empty()) {
    return Error{ErrorCode::kConflict, "/fabric_tests", "the document has no fabric test",
                 "add the pulls of some strips under \"fabric_tests\""};
  }
  std::vector<FittedFabric> results;
  for (const FabricTest& test : model.fabric_tests) {
    if (!tests.empty() && std::find(tests.begin(), tests.end(), test.name) == tests.end()) continue;
    const Result<FabricFit> fit = fit_fabric(test, "/fabric_tests/" + pointer_step(test.name));
    if (!fit) return fit.error();
    results.push_back(fitted(test, fit.value()));
  }
  return results;
}

}  // namespace lissom
