#pragma once
/// Random numbers that are the same on every platform: the distributions of the standard library are not.

#include <cmath>
#include <cstdint>
#include <random>

namespace lissom::scene_models {

class RandomNumbers {
 public:
  explicit RandomNumbers(unsigned seed) : engine_(seed) {}

  /// Evenly from `low` to `high`.
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  /// The same for the logarithm: as likely between 1 and 2 as between 2 and 4.
  double log_between(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
  /// From `low` to `high`, both included.
  int whole(int low, int high) { return low + static_cast<int>(between(0, high - low + 1)); }
  bool chance(double probability) { return between(0, 1) < probability; }

 private:
  std::mt19937_64 engine_;
};

}  // namespace lissom::scene_models
