#pragma once
/// Numbers as pages show them. Edits, which are saved, use editing/people_units.h.

#include <chrono>

namespace lissom {

inline constexpr double kMillimetres = 1e3;  ///< per metre
inline constexpr double kMillijoules = 1e3;  ///< per joule

/// For people, of what has just been done.
inline double milliseconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace lissom
