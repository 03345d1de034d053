#include "lissom/session/place_name.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <vector>

#include "lissom/core/nearest_name.h"
#include "lissom/model/units.h"

namespace lissom {

namespace {

/// "start", "end" or "0.5" as a fraction of a rod; NaN when it is none of these.
double fraction_of(const std::string& text) {
  if (text == "start") return 0;
  if (text == "end") return 1;
  const Result<double> number = to_si(text, Unit{});
  return number ? number.value() : std::nan("");
}

}  // namespace

Result<Selector> parse_place(const Model& model, const std::string& text, const std::string& where) {
  Selector selector;
  for (const SelectorWord& word : selector_words()) {
    if (text != word.word) continue;
    selector.kind = word.kind;
    return selector;
  }
  std::vector<std::string> known;
  for (const NamedSet& set : model.sets) known.push_back(set.name);
  if (std::find(known.begin(), known.end(), text) != known.end()) {
    selector.kind = Selector::Kind::kSet;
    selector.name = text;
    return selector;
  }
  const size_t colon = text.rfind(':');
  const std::string rod = text.substr(0, colon);
  for (const Rod& candidate : model.rods) known.push_back(candidate.name);
  const bool is_rod = std::any_of(model.rods.begin(), model.rods.end(), [&](const Rod& r) { return r.name == rod; });
  if (!is_rod) {
    return Error{ErrorCode::kUnknown, where, fmt::format("there is no set or rod \"{}\"", rod), suggestion(rod, known)};
  }
  selector.kind = Selector::Kind::kRod;
  selector.name = rod;
  if (colon == std::string::npos) return selector;
  selector.fraction = fraction_of(text.substr(colon + 1));
  if (selector.fraction >= 0 && selector.fraction <= 1) return selector;
  return Error{ErrorCode::kRange, where, fmt::format("\"{}\" is not a place on a rod", text.substr(colon + 1)),
               "write start, end, or a fraction of its length such as 0.5"};
}

}  // namespace lissom
