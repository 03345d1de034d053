#pragma once
/// Checks for programming errors. Bad input is never reported this way: see `Result`.

namespace lissom {

/// Prints the failed condition with its place and aborts.
[[noreturn]] void assertion_failed(const char* condition, const char* file, int line);

}  // namespace lissom

/// On in release builds too; keep it out of inner loops.
#define LISSOM_ASSERT(condition) \
  ((condition) ? static_cast<void>(0) : ::lissom::assertion_failed(#condition, __FILE__, __LINE__))
