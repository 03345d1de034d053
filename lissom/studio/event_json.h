#pragma once
/// What has become of a design, as events for pages (docs/studio/protocol.md, "Events").

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "lissom/editing/history.h"
#include "lissom/equilibrium/equilibrium.h"
#include "lissom/mechanics/system.h"
#include "lissom/session/warnings.h"

namespace lissom {

/// {code, where, message, hint}
nlohmann::json error_json(const Error& error);

nlohmann::json history_event(const History& history);

/// How a verdict came about.
struct VerdictStory {
  double milliseconds = 0;
  const char* shown = "settled";  ///< "settled", "last good" or "unsettled"
  std::string note;               ///< a sentence, or nothing
};
nlohmann::json verdict_event(const Equilibrium& equilibrium, const VerdictStory& story);

/// `share`: part of the pre-stretch that is there.
nlohmann::json measures_event(const System& system, const State& state, double energy, double share);

/// `one_click`: of each warning, whether there is a remedy that can be taken by itself.
nlohmann::json warnings_event(const std::vector<Warning>& warnings, const std::vector<bool>& one_click);

}  // namespace lissom
