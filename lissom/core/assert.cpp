#include "lissom/core/assert.h"

#include <cstdio>
#include <cstdlib>

namespace lissom {

void assertion_failed(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "lissom: internal check failed: %s (%s:%d)\n", condition, file, line);
  std::abort();
}

}  // namespace lissom
