#pragma once
/// What pages can ask for: one list, from which requests are answered (docs/studio/protocol.md, "Requests").

#include <nlohmann/json.hpp>
#include <string_view>

#include "lissom/core/result.h"
#include "lissom/studio/ask.h"

namespace lissom {

class Desk;

/// The fields of an answer besides `id` and `ok`.
using Answer = Result<nlohmann::json>;

struct RequestInfo {
  std::string_view name;
  /// `page`: who asks.
  Answer (*answer)(Desk& desk, int page, Ask& ask);
  /// Whether there has to be a document.
  enum class Needs { kNothing, kDocument, kPlan } needs = Needs::kPlan;
  /// Whether it takes the place of a shape that is still being sought.
  bool another_shape = false;
};

/// Whether what waits makes the shape that is being sought now one that nobody waits for.
bool asks_for_another_shape(const nlohmann::json& body);

/// The whole answer to a request, `id` included. Never throws.
nlohmann::json answer_request(Desk& desk, int page, const nlohmann::json& body);

}  // namespace lissom
