#include "lissom/geometry/obj_lines.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>

#include "lissom/geometry/text_words.h"

namespace lissom {

namespace {

/// As read_number, but finite.
bool read_coordinate(std::string_view word, double& value) { return read_number(word, value) && std::isfinite(value); }

class Reader {
 public:
  Reader(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  Result<ObjLines> read() {
    if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
    std::string joined;
    while (!text_.empty()) {
      std::string_view line = take_line();
      if (continues(line)) {
        joined.clear();
        while (continues(line)) {
          joined.append(line.substr(0, line.find_last_of('\\')));
          joined += ' ';
          line = text_.empty() ? std::string_view() : take_line();
        }
        joined.append(line);
        line = joined;
      }
      if (Status s = statement(line); !s) return s.error();
      statement_line_ = line_ + 1;
    }
    return finished();
  }

 private:
  std::string_view take_line() {
    ++line_;
    return next_line(text_);
  }

  static bool continues(std::string_view line) {
    while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
    return !line.empty() && line.back() == '\\';
  }

  Error refuse(ErrorCode code, int line, std::string message, std::string hint) const {
    return {code, fmt::format("{}:{}", file_, line), std::move(message), std::move(hint)};
  }

  Status statement(std::string_view line) {
    line = line.substr(0, line.find('#'));
    const std::string_view key = next_word(line);
    if (key.empty()) return {};
    if (key == "v") return point(line);
    if (key == "l") return polyline(line);
    ++lines_.ignored;
    return {};
  }

  Status point(std::string_view line) {
    Vec3 p;
    for (int i = 0; i < 3; ++i) {
      const std::string_view word = next_word(line);
      if (word.empty()) {
        return refuse(ErrorCode::kSyntax, statement_line_, fmt::format("the point has {} coordinates", i),
                      "give three");
      }
      if (!read_coordinate(word, p(i))) {
        return refuse(ErrorCode::kSyntax, statement_line_,
                      fmt::format("\"{}\" is not a finite number", shown_word(word)),
                      "write coordinates such as 1.5 or -2e-3");
      }
    }
    lines_.points.push_back(p);
    return {};
  }

  Status polyline(std::string_view line) {
    long long before = 0;
    int count = 0;
    for (std::string_view word = next_word(line); !word.empty(); word = next_word(line), ++count) {
      const std::string_view number = word.substr(0, word.find('/'));
      long long index = 0;
      if (!read_integer(number, index)) {
        return refuse(ErrorCode::kSyntax, statement_line_,
                      fmt::format("\"{}\" is not the number of a point", shown_word(word)),
                      "lines list points by number: l 1 2");
      }
      if (index < 0) index += static_cast<long long>(lines_.points.size()) + 1;
      if (index < 1 || index > kMostPoints) {
        return refuse(ErrorCode::kRange, statement_line_, fmt::format("there is no point {}", shown_word(number)),
                      fmt::format("{} points come before this line; the first one has number 1", lines_.points.size()));
      }
      if (count > 0) {
        lines_.segments.push_back({static_cast<int>(before - 1), static_cast<int>(index - 1)});
        places_.push_back(statement_line_);
      }
      before = index;
    }
    if (count >= 2) return {};
    return refuse(ErrorCode::kSyntax, statement_line_, fmt::format("the line has {} points", count),
                  "a line has at least two");
  }

  Result<ObjLines> finished() {
    if (lines_.segments.empty()) {
      return Error{ErrorCode::kSyntax, file_, fmt::format("the file has {} points but no lines", lines_.points.size()),
                   "export the network as lines (`l` statements), not as faces"};
    }
    const int points = static_cast<int>(lines_.points.size());
    for (size_t i = 0; i < lines_.segments.size(); ++i) {
      const int highest = std::max(lines_.segments[i][0], lines_.segments[i][1]);
      if (highest < points) continue;
      return refuse(ErrorCode::kRange, places_[i], fmt::format("there is no point {}", highest + 1),
                    fmt::format("the file has {} points", points));
    }
    return std::move(lines_);
  }

  static constexpr long long kMostPoints = 1'000'000'000;

  std::string_view text_;
  const std::string& file_;
  int line_ = 0, statement_line_ = 1;
  ObjLines lines_;
  std::vector<int> places_;  ///< file line by segment
};

}  // namespace

Result<ObjLines> read_obj_lines(std::string_view text, const std::string& file) { return Reader(text, file).read(); }

std::string write_obj_lines(const ObjLines& lines) {
  fmt::memory_buffer out;
  for (const Vec3& p : lines.points) {
    fmt::format_to(std::back_inserter(out), "v {:.17g} {:.17g} {:.17g}\n", p.x(), p.y(), p.z());
  }
  for (const auto& [a, b] : lines.segments) fmt::format_to(std::back_inserter(out), "l {} {}\n", a + 1, b + 1);
  return fmt::to_string(out);
}

}  // namespace lissom
