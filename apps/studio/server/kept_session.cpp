#include "apps/studio/server/kept_session.h"

#include <algorithm>
#include <cstdlib>
#include <fcntl.h>
#include <optional>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

#include "apps/studio/server/gate.h"

namespace lissom {

namespace {

namespace fs = std::filesystem;

constexpr size_t kLength = 32;

fs::path from_environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? fs::path() : fs::path(value);
}

fs::path session_file(const fs::path& folder, unsigned short port) {
  return folder / ("studio-" + std::to_string(port) + ".session");
}

/// A folder of this user that nobody else can enter; made when it is missing.
bool is_private(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder.parent_path(), error);
  ::mkdir(folder.c_str(), S_IRWXU);
  struct stat info {};
  return ::lstat(folder.c_str(), &info) == 0 && S_ISDIR(info.st_mode) && info.st_uid == ::geteuid() &&
         (info.st_mode & (S_IRWXG | S_IRWXO)) == 0;
}

std::optional<std::string> read_session(const fs::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor < 0) return std::nullopt;
  struct stat info {};
  char text[kLength + 1];
  const bool trusted = ::fstat(descriptor, &info) == 0 && S_ISREG(info.st_mode) && info.st_uid == ::geteuid() &&
                       (info.st_mode & (S_IRWXG | S_IRWXO)) == 0;
  const ssize_t count = trusted ? ::read(descriptor, text, sizeof text) : -1;
  ::close(descriptor);
  if (count != static_cast<ssize_t>(kLength)) return std::nullopt;
  const std::string session(text, kLength);
  if (session.find_first_not_of("0123456789abcdef") != std::string::npos) return std::nullopt;
  return session;
}

void write_session(const fs::path& file, const std::string& session) {
  ::unlink(file.c_str());
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, S_IRUSR | S_IWUSR);
  if (descriptor < 0) return;
  const ssize_t count = ::write(descriptor, session.data(), session.size());
  ::close(descriptor);
  if (count != static_cast<ssize_t>(session.size())) ::unlink(file.c_str());
}

}  // namespace

fs::path state_folder() {
  if (const fs::path state = from_environment("XDG_STATE_HOME"); !state.empty()) return state / "lissom";
  const fs::path home = from_environment("HOME");
  return home.empty() ? fs::path() : home / ".local" / "state" / "lissom";
}

fs::path session_folder() {
  if (const fs::path runtime = from_environment("XDG_RUNTIME_DIR"); !runtime.empty()) return runtime / "lissom";
  // A folder of its own: the one above holds recent files too, and whoever made it may have let others look into it.
  const fs::path state = state_folder();
  return state.empty() ? fs::path() : state / "sessions";
}

std::string kept_session(const fs::path& folder, unsigned short port) {
  if (folder.empty() || !is_private(folder)) return random_secret();
  const fs::path file = session_file(folder, port);
  if (const std::optional<std::string> session = read_session(file)) return *session;
  std::string session = random_secret();
  write_session(file, session);
  return session;
}

void forget_session(const fs::path& folder, unsigned short port) {
  if (folder.empty()) return;
  std::error_code error;
  fs::remove(session_file(folder, port), error);
}

}  // namespace lissom
