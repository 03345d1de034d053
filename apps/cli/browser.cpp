#include "apps/cli/browser.h"

#include <cstdlib>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;  // NOLINT(readability-identifier-naming): POSIX calls it so

namespace lissom::cli {

namespace {

bool is_set(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != '\0';
}

}  // namespace

bool somebody_looks() {
  if (isatty(STDOUT_FILENO) == 0) return false;
#if defined(__APPLE__)
  return !is_set("SSH_CONNECTION");
#else
  return is_set("DISPLAY") || is_set("WAYLAND_DISPLAY");
#endif
}

bool open_in_browser(const std::string& address) {
  // The shell returns at once, so that nothing has to wait for the browser. The address is an argument, not part of the script.
  const char* script =
      "for p in xdg-open open; do command -v $p >/dev/null && { $p \"$1\" >/dev/null 2>&1 </dev/null & exit 0; }; "
      "done; exit 1";
  std::string words[] = {"sh", "-c", script, "sh", address};
  char* arguments[] = {words[0].data(), words[1].data(), words[2].data(), words[3].data(), words[4].data(), nullptr};
  pid_t child = 0;
  if (posix_spawnp(&child, "sh", nullptr, nullptr, arguments, environ) != 0) return false;
  int status = 0;
  return waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace lissom::cli
