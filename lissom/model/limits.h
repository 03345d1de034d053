#pragma once
/// What is taken for a slip of the pen rather than a structure: beyond these numbers memory, time or arithmetic end.

namespace lissom {

constexpr int kMostNodes = 2'000'000;  ///< of a structure, and edges of one rod
constexpr int kMostTurns = 1'000'000;  ///< of a helix
constexpr double kMostSteps = 1e7;     ///< of a motion
constexpr double kLargest = 1e18;      ///< of any number in SI: fourth powers times moduli stay far from overflow
constexpr double kSmallest = 1e-18;    ///< of any number in SI that has to be positive

}  // namespace lissom
