/// Geomview OFF text, with normals, texture coordinates or colours per vertex (COFF, NOFF, STOFF; colours also without
/// the letter, as many programs write them).
#include <fmt/format.h>

#include "lissom/geometry/surface_reading.h"
#include "lissom/geometry/text_words.h"

namespace lissom {

namespace {

class OffReader {
 public:
  OffReader(std::string_view text, const std::string& file)
      : text_(text), file_(file), reading_(file, "OFF", SurfaceReading::Places::kLines) {}

  Result<RawSurface> read() {
    if (Status s = header(); !s) return s.error();
    for (long long v = 0; v < vertices_; ++v) {
      if (!advance()) return cut_off("vertex", v, vertices_);
      if (Status s = vertex(); !s) return s.error();
    }
    for (long long f = 0; f < faces_; ++f) {
      if (!advance()) return cut_off("face", f, faces_);
      if (Status s = face(); !s) return s.error();
    }
    return reading_.finish();
  }

 private:
  /// To the next line with something on it, in rest_.
  bool advance() {
    while (!text_.empty()) {
      ++line_;
      rest_ = next_line(text_);
      rest_ = rest_.substr(0, rest_.find('#'));
      std::string_view ahead = rest_;
      if (!next_word(ahead).empty()) return true;
    }
    return false;
  }

  Error cut_off(const char* element, long long at, long long of) const {
    return {ErrorCode::kFile, fmt::format("{}:{}", file_, line_),
            fmt::format("the file ends before {} {} of {}", element, at, of),
            "it was cut off, or its header counts too many; export the surface "
            "again"};
  }
  Error wrong(std::string message, std::string hint) const {
    return reading_.refuse(ErrorCode::kSyntax, line_, std::move(message), std::move(hint));
  }

  /// "OFF", "COFF", ..., then the counts on the same line or the next.
  Status header() {
    if (!advance()) return Error{ErrorCode::kSyntax, file_, "the file is empty", "export the surface again"};
    std::string_view kind = next_word(rest_);
    if (!kind.ends_with("OFF")) return wrong("the file does not begin with OFF", "is it a file of another format?");
    std::string_view letters = kind.substr(0, kind.size() - 3);
    if (letters.starts_with("ST")) skipped_after_ = 2, letters.remove_prefix(2);
    if (letters.starts_with("C")) letters.remove_prefix(1);
    if (letters.starts_with("N")) skipped_before_ = 3, letters.remove_prefix(1);
    std::string_view ahead = rest_;
    if (!letters.empty() || next_word(ahead) == "BINARY") {
      return reading_.refuse(ErrorCode::kUnsupported, line_, "OFF files of this kind are not read",
                             "export the surface as plain OFF text, or as PLY");
    }
    ahead = rest_;
    if (next_word(ahead).empty() && !advance())
      return wrong("the file has no counts", "it was cut off; export it again");
    return counts();
  }

  Status counts() {
    const bool both = read_integer(next_word(rest_), vertices_) && read_integer(next_word(rest_), faces_);
    if (!both || vertices_ < 0 || faces_ < 0) {
      return wrong("the numbers of vertices and faces are missing", "the second line is like 8 12 0");
    }
    // A vertex takes at least 6 bytes ("0 0 0\n"), a face 8.
    const auto left = static_cast<long long>(text_.size()) + 1;
    if (vertices_ <= left / 6 && faces_ <= left / 8) return {};
    return reading_.refuse(
        ErrorCode::kFile, line_,
        fmt::format("{} vertices and {} faces do not fit into {} bytes", vertices_, faces_, left - 1),
        "the file was cut off, or its header is damaged; export the surface "
        "again");
  }

  Status vertex() {
    numbers_.clear();
    for (std::string_view word = next_word(rest_); !word.empty() && numbers_.size() < 16; word = next_word(rest_)) {
      double number = 0;
      if (!read_number(word, number)) {
        return wrong(fmt::format("\"{}\" is not a number", shown_word(word)), "export the surface again");
      }
      numbers_.push_back(number);
    }
    if (numbers_.size() < 3) {
      return wrong(fmt::format("the vertex has {} coordinates", numbers_.size()), "give three; is the file cut off?");
    }
    if (Status s = reading_.add_point({numbers_[0], numbers_[1], numbers_[2]}, line_); !s) return s;
    const std::size_t first = 3 + skipped_before_;
    if (numbers_.size() >= first + 3 + skipped_after_) {
      reading_.paint({numbers_[first], numbers_[first + 1], numbers_[first + 2]});
    }
    return {};
  }

  Status face() {
    long long count = 0, index = 0;
    if (!read_integer(next_word(rest_), count) || count < 0) {
      return wrong("the face does not begin with its number of corners", "faces are written like 3 0 1 2");
    }
    corners_.clear();
    for (long long i = 0; i < count; ++i) {
      const std::string_view word = next_word(rest_);
      if (word.empty()) return wrong(fmt::format("the face has {} of {} corners", i, count), "is the file cut off?");
      if (!read_integer(word, index)) {
        return wrong(fmt::format("\"{}\" is not the number of a vertex", shown_word(word)),
                     "vertices are numbered from 0");
      }
      corners_.push_back(index);
    }
    return reading_.add_polygon(corners_, line_);
  }

  std::string_view text_, rest_;
  const std::string& file_;
  SurfaceReading reading_;
  int line_ = 0;
  std::size_t skipped_before_ = 0,
              skipped_after_ = 0;  // numbers around the colour
  long long vertices_ = 0, faces_ = 0;
  std::vector<double> numbers_;
  std::vector<long long> corners_;
};

}  // namespace

Result<RawSurface> read_surface_off(std::string_view text, const std::string& file) {
  return OffReader(text, file).read();
}

}  // namespace lissom
