#pragma once
/// What benches share: a clock, repeated runs, and rows for tools/bench.py.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

namespace lissom {

inline double now_ms() {
  using Clock = std::chrono::steady_clock;
  return std::chrono::duration<double, std::milli>(Clock::now().time_since_epoch()).count();
}

/// Median time of a few repetitions, ms.
template <class F>
double median_ms(int repetitions, const F& f) {
  std::vector<double> times;
  for (int k = 0; k < repetitions; ++k) {
    const double begin = now_ms();
    f();
    times.push_back(now_ms() - begin);
  }
  std::nth_element(times.begin(), times.begin() + repetitions / 2, times.end());
  return times[repetitions / 2];
}

/// Least time of a few repetitions, ms: others on the machine only ever add.
template <class F>
double least_ms(int repetitions, const F& f) {
  double least = 1e300;
  for (int k = 0; k < repetitions; ++k) {
    const double begin = now_ms();
    f();
    least = std::min(least, now_ms() - begin);
  }
  return least;
}

/// A row of build/bench.json.
inline void row(const std::string& name, const char* metric, double value, const char* unit) {
  std::printf("%s\t%s\t%.6g\t%s\n", name.c_str(), metric, value, unit);
  std::fflush(stdout);
}

}  // namespace lissom
