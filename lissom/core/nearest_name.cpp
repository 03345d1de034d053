#include "lissom/core/nearest_name.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace lissom {
namespace {

/// Longer names are not compared: nobody mistypes them, and the cost is quadratic.
constexpr std::size_t kLongestCompared = 64;

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

int replacement(char a, char b) {
  if (a == b) return 0;
  return lower(a) == lower(b) ? 1 : 2;
}

/// Edit distance with swaps of neighbours; every edit costs 2, a change of case 1.
int distance(std::string_view a, std::string_view b) {
  std::vector<int> before(b.size() + 1), last(b.size() + 1), now(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = static_cast<int>(2 * j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    now[0] = static_cast<int>(2 * i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      now[j] = std::min({last[j] + 2, now[j - 1] + 2, last[j - 1] + replacement(a[i - 1], b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) now[j] = std::min(now[j], before[j - 2] + 2);
    }
    before.swap(last);
    last.swap(now);
  }
  return last[b.size()];
}

}  // namespace

std::string nearest_name(std::string_view name, std::span<const std::string> candidates) {
  if (name.empty() || name.size() > kLongestCompared) return {};
  const std::string* best = nullptr;
  int least = static_cast<int>(std::max<std::size_t>(2, 2 * name.size() / 3));  // about one slip in three letters
  for (const std::string& candidate : candidates) {
    if (candidate.size() > kLongestCompared) continue;
    const int d = distance(name, candidate);
    if (d < least || (d == least && !best)) {
      least = d;
      best = &candidate;
    }
  }
  return best ? *best : std::string();
}

std::string suggestion(std::string_view name, std::span<const std::string> candidates) {
  if (const std::string near = nearest_name(name, candidates); !near.empty()) return "did you mean \"" + near + "\"?";
  if (candidates.empty()) return {};
  constexpr std::size_t kShown = 8;
  std::string list = "known: ";
  for (std::size_t i = 0; i < std::min(kShown, candidates.size()); ++i) {
    list += (i ? ", \"" : "\"") + candidates[i] + "\"";
  }
  if (candidates.size() > kShown) list += " and " + std::to_string(candidates.size() - kShown) + " more";
  return list;
}

}  // namespace lissom
