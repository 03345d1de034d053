#pragma once
/// What was found in a surface that somebody brought, where, and what was done about it.

#include <optional>
#include <string>
#include <vector>

#include "lissom/core/types.h"

namespace lissom {

struct SurfaceNote {
  enum class Outcome {
    kMended,  ///< the surface was changed
    kKept,    ///< it is left as it was, for the user to know
  };
  struct Place {
    std::string element;     ///< "triangle 12", "edge 3-7", "line 40"; numbers from 0
    std::optional<Vec3> at;  ///< m
  };

  std::string what;  ///< "duplicate triangles"
  int count = 0;
  std::vector<Place> places;  ///< the first kMost of them
  std::string done;           ///< "left out"
  Outcome outcome = Outcome::kMended;

  static constexpr std::size_t kMost = 5;

  /// Counts one more, and remembers its place if that is among the first.
  void add(const std::string& element, const std::optional<Vec3>& at = std::nullopt) {
    ++count;
    if (places.size() < kMost) places.push_back({element, at});
  }
  /// "2 duplicate triangles: left out (triangle 12 at (1.5, 0, 3) mm, triangle 40 at (2, 0, 3) mm)".
  std::string text() const;
};

/// "(1.5, 0, 3) mm".
std::string in_millimetres(const Vec3& at);

/// "1 x 2.5 x 30 mm".
std::string size_in_millimetres(const Vec3& size);

}  // namespace lissom
