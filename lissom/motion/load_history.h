#pragma once
/// Load factor over time: piecewise linear, constant before the first and after the last point.

#include <span>
#include <string>
#include <vector>

#include "lissom/core/result.h"
#include "lissom/core/types.h"

namespace lissom {

class LoadHistory {
 public:
  /// 1 throughout.
  LoadHistory() = default;

  /// (time s, factor), times ascending; none: 1 throughout. `where` is the JSON pointer of the list, for errors.
  static Result<LoadHistory> make(std::span<const Vec2> points, const std::string& where);

  double at(double time) const;
  /// First time after `time` at which the slope changes; infinity when there is none. Steps end there.
  double next_kink(double time) const;
  bool constant() const;

 private:
  std::vector<Vec2> points_;
};

}  // namespace lissom
