/// Wavefront OBJ: `v` (with colours behind the coordinates, as many programs write them) and `f`.
#include <fmt/format.h>

#include "lissom/geometry/surface_reading.h"
#include "lissom/geometry/text_words.h"

namespace lissom {

namespace {

class ObjReader {
 public:
  ObjReader(std::string_view text, const std::string& file)
      : text_(text), reading_(file, "OBJ", SurfaceReading::Places::kLines) {}

  Result<RawSurface> read() {
    if (text_.starts_with("\xEF\xBB\xBF")) text_.remove_prefix(3);
    std::string joined;
    while (!text_.empty()) {
      statement_line_ = line_ + 1;
      std::string_view line = take_line();
      if (continues(line)) {
        joined.clear();
        for (; continues(line); line = text_.empty() ? std::string_view() : take_line()) {
          joined.append(line.substr(0, line.find_last_of('\\')));
          joined += ' ';
        }
        joined.append(line);
        line = joined;
      }
      if (Status s = statement(line.substr(0, line.find('#'))); !s) return s.error();
    }
    return reading_.finish();
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

  Status statement(std::string_view line) {
    const std::string_view key = next_word(line);
    if (key == "v") return vertex(line);
    if (key == "f") return face(line);
    if (key == "curv" || key == "curv2" || key == "surf") {
      reading_.leave_out("free-form curves and surfaces", fmt::format("line {}", statement_line_));
    }
    return {};
  }

  Status vertex(std::string_view line) {
    double numbers[6] = {};
    int count = 0;
    for (std::string_view word = next_word(line); !word.empty() && count < 6; word = next_word(line)) {
      if (read_number(word, numbers[count])) {
        ++count;
        continue;
      }
      return reading_.refuse(ErrorCode::kSyntax, statement_line_,
                             fmt::format("\"{}\" is not a number", shown_word(word)),
                             "vertices are written like v 1.5 0 -2e-3; export the surface again");
    }
    if (count < 3) {
      return reading_.refuse(ErrorCode::kSyntax, statement_line_, fmt::format("the vertex has {} coordinates", count),
                             "give three; is the file cut off?");
    }
    if (Status s = reading_.add_point({numbers[0], numbers[1], numbers[2]}, statement_line_); !s) return s;
    if (count == 6) reading_.paint({numbers[3], numbers[4], numbers[5]});
    return {};
  }

  Status face(std::string_view line) {
    corners_.clear();
    for (std::string_view word = next_word(line); !word.empty(); word = next_word(line)) {
      long long index = 0;
      if (!read_integer(word.substr(0, word.find('/')), index) || index == 0) {
        return reading_.refuse(ErrorCode::kSyntax, statement_line_,
                               fmt::format("\"{}\" is not the number of a vertex", shown_word(word)),
                               "faces list vertices by number from 1: f 1 2 3");
      }
      corners_.push_back(index > 0 ? index - 1 : index + static_cast<long long>(reading_.points()));
    }
    return reading_.add_polygon(corners_, statement_line_);
  }

  std::string_view text_;
  SurfaceReading reading_;
  int line_ = 0, statement_line_ = 1;
  std::vector<long long> corners_;
};

}  // namespace

Result<RawSurface> read_surface_obj(std::string_view text, const std::string& file) {
  return ObjReader(text, file).read();
}

}  // namespace lissom
