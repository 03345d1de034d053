#include "lissom/editing/text_lines.h"

#include <algorithm>
#include <cstdint>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace lissom {

namespace {

std::string place(std::size_t line) { return fmt::format("/{}", line); }

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
  const std::size_t before = from.size() - head - tail, after = to.size() - head - tail;
  nlohmann::ordered_json patch = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < std::min(before, after); ++i) {
    if (from[head + i] == to[head + i]) continue;
    patch.push_back({{"op", "replace"}, {"path", place(head + i)}, {"value", to[head + i]}});
  }
  for (std::size_t i = after; i < before; ++i) patch.push_back({{"op", "remove"}, {"path", place(head + after)}});
  for (std::size_t i = before; i < after; ++i) {
    patch.push_back({{"op", "add"}, {"path", place(head + i)}, {"value", to[head + i]}});
  }
  return patch.dump();
}

std::string text_hash(std::string_view text) {
  std::uint64_t hash = 14695981039346656037ULL;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return fmt::format("{:016x}", hash);
}

}  // namespace lissom
