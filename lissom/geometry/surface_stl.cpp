/// STL, text and binary. Facets share no points in such files: points with the same coordinates become one here.
#include <algorithm>
#include <bit>
#include <cctype>
#include <cstring>
#include <fmt/format.h>
#include <unordered_map>

#include "lissom/geometry/surface_reading.h"
#include "lissom/geometry/text_words.h"

namespace lissom {

namespace {

constexpr std::size_t kHeaderBytes = 84, kFacetBytes = 50;  // bytes

std::uint32_t little_endian(const char* bytes) {
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i) value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

/// Numbers of points by their coordinates, bit by bit (but -0 is 0).
class StlPoints {
 public:
  /// The point's number, which is new when it equals `next`.
  int number(const Vec3& p, std::size_t next) {
    const Key key = {std::bit_cast<std::uint64_t>(p.x() + 0.0), std::bit_cast<std::uint64_t>(p.y() + 0.0),
                     std::bit_cast<std::uint64_t>(p.z() + 0.0)};
    return known_.try_emplace(key, static_cast<int>(next)).first->second;
  }

 private:
  using Key = std::array<std::uint64_t, 3>;
  struct Mixed {
    std::size_t operator()(const Key& key) const {
      std::uint64_t hash = 0;
      for (const std::uint64_t part : key) {
        hash = (hash ^ part) * 0x9E3779B97F4A7C15U;
        hash ^= hash >> 29;
      }
      return hash;
    }
  };
  std::unordered_map<Key, int, Mixed> known_;
};

class StlReader {
 public:
  StlReader(const std::string& file, std::string format, SurfaceReading::Places places)
      : file_(file), reading_(file, std::move(format), places) {}

  Result<RawSurface> binary(std::string_view bytes) {
    const std::uint32_t count = little_endian(bytes.data() + kHeaderBytes - 4);
    const std::size_t whole = (bytes.size() - kHeaderBytes) / kFacetBytes;
    if (count > whole) {
      return Error{ErrorCode::kFile, fmt::format("{}, face {}", file_, whole),
                   fmt::format("the file ends here, but its header announces {} faces", count),
                   "it was cut off, or its header is damaged; export the surface again"};
    }
    for (std::uint32_t f = 0; f < count; ++f) {
      const char* const facet = bytes.data() + kHeaderBytes + f * kFacetBytes + 12;  // behind the normal
      corners_.clear();
      for (int c = 0; c < 3; ++c) {
        Vec3 p;
        for (int i = 0; i < 3; ++i) p[i] = std::bit_cast<float>(little_endian(facet + 12 * c + 4 * i));
        if (Status s = corner(p, f); !s) return s.error();
      }
      if (Status s = reading_.add_polygon(corners_, f); !s) return s.error();
    }
    if (const std::size_t rest = bytes.size() - kHeaderBytes - count * kFacetBytes; rest > 0) {
      reading_.leave_out(fmt::format("stretch of {} bytes behind the last face", rest), "the end of the file");
    }
    return reading_.finish();
  }

  Result<RawSurface> text(std::string_view rest) {
    for (long long line = 1; !rest.empty(); ++line) {
      std::string_view words = next_line(rest);
      if (Status s = statement(words, line); !s) return s.error();
      last_line_ = line;
    }
    if (expected_ == Expected::kFacet && ended_) return reading_.finish();
    return Error{ErrorCode::kFile, fmt::format("{}:{}", file_, last_line_), "the file ends without \"endsolid\"",
                 "it was cut off; export the surface again"};
  }

 private:
  enum class Expected { kFacet, kLoop, kVertex, kEndFacet };

  Status corner(const Vec3& p, long long place) {
    const int number = points_.number(p, reading_.points());
    corners_.push_back(number);
    return number == static_cast<int>(reading_.points()) ? reading_.add_point(p, place) : Status();
  }

  Status statement(std::string_view words, long long line) {
    std::string key(next_word(words));
    std::transform(key.begin(), key.end(), key.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (key.empty()) return {};
    if (expected_ == Expected::kFacet && (key == "solid" || key == "endsolid")) {
      ended_ = key == "endsolid";
      return {};
    }
    if (expected_ == Expected::kFacet && key == "facet") return expect(Expected::kLoop);
    if (expected_ == Expected::kLoop && key == "outer") {
      corners_.clear();
      return expect(Expected::kVertex);
    }
    if (expected_ == Expected::kVertex && key == "vertex") return vertex(words, line);
    if (expected_ == Expected::kVertex && key == "endloop") {
      if (Status s = reading_.add_polygon(corners_, line); !s) return s;
      return expect(Expected::kEndFacet);
    }
    if (expected_ == Expected::kEndFacet && key == "endfacet") return expect(Expected::kFacet);
    constexpr const char* kWords[] = {"facet", "outer loop", "vertex", "endfacet"};
    return reading_.refuse(
        ErrorCode::kSyntax, line,
        fmt::format("\"{}\" stands where \"{}\" is expected", shown_word(key), kWords[static_cast<int>(expected_)]),
        "the file is damaged; export the surface again");
  }

  Status expect(Expected next) {
    expected_ = next;
    return {};
  }

  Status vertex(std::string_view words, long long line) {
    Vec3 p;
    for (int i = 0; i < 3; ++i) {
      const std::string_view word = next_word(words);
      if (read_number(word, p[i])) continue;
      return reading_.refuse(ErrorCode::kSyntax, line, fmt::format("\"{}\" is not a number", shown_word(word)),
                             "vertices are written like vertex 1.5 0 -2e-3; export the surface "
                             "again");
    }
    return corner(p, line);
  }

  const std::string& file_;
  SurfaceReading reading_;
  StlPoints points_;
  std::vector<long long> corners_;
  Expected expected_ = Expected::kFacet;
  bool ended_ = false;
  long long last_line_ = 0;
};

/// Text begins with "solid"; but so do the free 80 bytes of some binary files, whose length then fits their count.
bool is_text(std::string_view bytes) {
  if (bytes.size() >= kHeaderBytes &&
      bytes.size() == kHeaderBytes + kFacetBytes * little_endian(bytes.data() + kHeaderBytes - 4)) {
    return false;
  }
  std::string_view start = bytes.substr(0, 1024);
  while (!start.empty() && (is_blank(start.front()) || start.front() == '\n')) start.remove_prefix(1);
  return start.starts_with("solid") && start.find('\0') == std::string_view::npos;
}

}  // namespace

Result<RawSurface> read_surface_stl(std::string_view bytes, const std::string& file) {
  if (is_text(bytes)) return StlReader(file, "STL text", SurfaceReading::Places::kLines).text(bytes);
  if (bytes.size() >= kHeaderBytes)
    return StlReader(file, "binary STL", SurfaceReading::Places::kElements).binary(bytes);
  return Error{ErrorCode::kSyntax, file,
               fmt::format("{} bytes that do not begin with \"solid\" are no STL file", bytes.size()),
               "it was cut off, or is of another format; export the surface again"};
}

}  // namespace lissom
