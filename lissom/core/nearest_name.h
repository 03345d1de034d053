#pragma once
/// "Did you mean ...?": the known name closest to a mistyped one.

#include <span>
#include <string>
#include <string_view>

namespace lissom {

/// The candidate with the fewest changed, missing, added or swapped letters (case counts half), first of equals; empty when
/// none is close enough to be a likely slip.
std::string nearest_name(std::string_view name, std::span<const std::string> candidates);

/// `did you mean "beam"?` when a candidate is near, else `known: "beam", "arch"` (at most eight), else empty.
std::string suggestion(std::string_view name, std::span<const std::string> candidates);

}  // namespace lissom
