#include "lissom/editing/text_lines.h"

#include <algorithm>
#include <cstdint>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <span>

namespace lissom {

namespace {

using Json = nlohmann::ordered_json;

/// Longest common subsequence of two lists of lines, and the way along it. Of lists whose table would be large nothing is
/// common.
class CommonLines {
 public:
  enum class Step { kKeep, kReplace, kRemove, kAdd };

  CommonLines(std::span<const std::string> a, std::span<const std::string> b) : a_(a), b_(b) {
    constexpr std::size_t kLargestTable = 4'000'000;
    if (a.empty() || b.empty() || (a.size() + 1) > kLargestTable / (b.size() + 1)) return;
    longest_.assign((a.size() + 1) * (b.size() + 1), 0);
    for (std::size_t i = a.size(); i-- > 0;) {
      for (std::size_t j = b.size(); j-- > 0;) {
        const int along = a[i] == b[j] ? 1 + longest(i + 1, j + 1) : std::max(longest(i + 1, j), longest(i, j + 1));
        longest_[i * (b.size() + 1) + j] = along;
      }
    }
  }

  /// What to do with line i of the first list and line j of the second.
  Step next(std::size_t i, std::size_t j) const {
    if (i == a_.size()) return Step::kAdd;
    if (j == b_.size()) return Step::kRemove;
    if (a_[i] == b_[j]) return Step::kKeep;
    if (longest(i + 1, j + 1) == longest(i, j)) return Step::kReplace;
    return longest(i + 1, j) >= longest(i, j + 1) ? Step::kRemove : Step::kAdd;
  }

 private:
  /// Of the lists from there on.
  int longest(std::size_t i, std::size_t j) const { return longest_.empty() ? 0 : longest_[i * (b_.size() + 1) + j]; }

  std::span<const std::string> a_, b_;
  std::vector<int> longest_;
};

}  // namespace

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  for (;;) {
    const std::size_t end = text.find('\n');
    lines.emplace_back(text.substr(0, end));
    if (end == std::string_view::npos) return lines;
    text.remove_prefix(end + 1);
  }
}

std::string text_of(const std::vector<std::string>& lines) {
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (i > 0) text += '\n';
    text += lines[i];
  }
  return text;
}

std::string line_patch(const std::vector<std::string>& from, const std::vector<std::string>& to) {
  const std::size_t shorter = std::min(from.size(), to.size());
  std::size_t head = 0, tail = 0;
  while (head < shorter && from[head] == to[head]) ++head;
  while (tail < shorter - head && from[from.size() - 1 - tail] == to[to.size() - 1 - tail]) ++tail;
  const std::span<const std::string> before(from.data() + head, from.size() - head - tail);
  const std::span<const std::string> after(to.data() + head, to.size() - head - tail);
  const CommonLines common(before, after);
  Json patch = Json::array();
  std::size_t i = 0, j = 0;
  while (i < before.size() || j < after.size()) {
    const std::string line = fmt::format("/{}", head + j);
    switch (common.next(i, j)) {
      case CommonLines::Step::kKeep:
        ++i, ++j;
        break;
      case CommonLines::Step::kReplace:
        patch.push_back({{"op", "replace"}, {"path", line}, {"value", after[j]}});
        ++i, ++j;
        break;
      case CommonLines::Step::kRemove:
        patch.push_back({{"op", "remove"}, {"path", line}});
        ++i;
        break;
      case CommonLines::Step::kAdd:
        patch.push_back({{"op", "add"}, {"path", line}, {"value", after[j]}});
        ++j;
        break;
    }
  }
  return patch.dump();
}

std::string text_hash(std::string_view text) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return fmt::format("{:016x}", hash);
}

}  // namespace lissom
