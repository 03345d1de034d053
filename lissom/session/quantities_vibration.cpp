// Natural frequencies.

#include <algorithm>

#include "lissom/core/nearest_name.h"
#include "lissom/session/quantity_families.h"

namespace lissom {

namespace {

struct NamedKind {
  std::string_view name;
  ModeKind kind;
};
constexpr NamedKind kKinds[] = {{"", ModeKind::kAny},
                                {"bending", ModeKind::kBending},
                                {"axial", ModeKind::kAxial},
                                {"torsional", ModeKind::kTorsional}};

Result<ModeFilter> filter_of(const Measurement& m) {
  ModeFilter filter;
  if (m.expectation.axis) filter.axis = m.expectation.axis->normalized();
  std::vector<std::string> known;
  for (const NamedKind& kind : kKinds) {
    if (kind.name == m.expectation.mode_kind) {
      filter.kind = kind.kind;
      return filter;
    }
    if (!kind.name.empty()) known.emplace_back(kind.name);
  }
  return Error{ErrorCode::kUnknown, m.where + "/mode_kind",
               "there is no kind of mode \"" + m.expectation.mode_kind + "\"",
               suggestion(m.expectation.mode_kind, known)};
}

}  // namespace

Result<double> natural_frequency(const Measurement& m) {
  const Result<ModeFilter> filter = filter_of(m);
  if (!filter) return filter.error();
  const Result<const Situation*> found = m.study.situation(m.pose(), m.refine);
  if (!found) return found.error();
  const Situation& s = *found.value();
  // As many modes as it takes to meet the one that is asked for.
  int last = 0;
  for (int count = 2 * (m.expectation.mode + 2);; count *= 2) {
    const Result<const std::vector<NaturalMode>*> modes = m.study.vibrations(m.pose(), count, m.refine);
    if (!modes) return modes.error();
    const std::vector<NaturalMode> sorted =
        separated(*s.system, s.state, *modes.value(), RollInertia::kLumped, filter.value());
    const int index = find_mode(sorted, filter.value(), m.expectation.mode);
    // The last modes may belong to a group that goes on: look at one beyond.
    const int size = static_cast<int>(sorted.size());
    if (index >= 0 && (index + 2 < size || size < count)) {
      if (!sorted[index].unstable()) return sorted[index].frequency;
      return Error{ErrorCode::kGeometry, m.where + "/mode",
                   "the mode does not vibrate: it grows, the shape is unstable", ""};
    }
    if (size < count || size == last) break;
    last = size;
  }
  return Error{ErrorCode::kRange, m.where + "/mode", "there are not that many modes of this kind",
               "ask for a lower one"};
}

}  // namespace lissom
