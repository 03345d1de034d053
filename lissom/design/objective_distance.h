#pragma once
/// How far two sets of nodes are apart: what a ruler or a machine measures.

#include <memory>
#include <optional>
#include <vector>

#include "lissom/design/objective.h"

namespace lissom {

/// One component, m: from the mean place of `from` (of one node at least) to that of `to`, as a distance or, with `axis` (any
/// length, made unit), along it and with its sign. Without an axis both means have to be apart.
std::shared_ptr<const Objective> make_distance(const std::vector<int>& from, const std::vector<int>& to,
                                               const std::optional<Vec3>& axis);

/// The same from a place that stays, m.
std::shared_ptr<const Objective> make_distance(const Vec3& from, const std::vector<int>& to,
                                               const std::optional<Vec3>& axis);

}  // namespace lissom
