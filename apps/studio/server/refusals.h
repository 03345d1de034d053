#pragma once
/// What the server does not do, with the words for it, and a log of it that nobody can fill.

#include <array>
#include <chrono>
#include <functional>
#include <string>
#include <string_view>

namespace lissom {

enum class Refusal {
  kHost,         ///< the header Host names somebody else
  kOrigin,       ///< a page of somebody else asks
  kToken,        ///< unknown, or used before
  kSession,      ///< neither token nor cookie
  kPath,         ///< no such file
  kMethod,       ///< neither GET nor HEAD
  kUpgrade,      ///< /live without the wish for a WebSocket
  kRequest,      ///< not HTTP, or with a body
  kHeader,       ///< too long
  kSlow,         ///< took too long to ask, or to take what was sent
  kConnections,  ///< too many at once
  kMessage,      ///< a message that is too long, or binary
  kFrame,        ///< not what WebSocket frames look like
};
constexpr int kRefusals = 13;

struct RefusalInfo {
  int status;                      ///< of HTTP; 0: the connection is just closed
  std::string_view log;            ///< what happened
  std::string_view title, remedy;  ///< for whoever sees the answer in a browser
};
const RefusalInfo& refusal_info(Refusal refusal);

/// A page that says what to do.
std::string refusal_page(Refusal refusal);

/// Logs each kind when it first happens, then at most every ten seconds, with how often it has happened meanwhile.
class RefusalLog {
 public:
  using Clock = std::chrono::steady_clock;
  explicit RefusalLog(std::function<void(const std::string&)> log);

  void add(Refusal refusal, Clock::time_point now = Clock::now());
  /// Logs what was held back.
  void flush();
  /// How often it has happened.
  int count(Refusal refusal) const { return kinds_[static_cast<size_t>(refusal)].count; }

 private:
  struct Kind {
    int count = 0, logged = 0;
    Clock::time_point last;
  };
  void write(size_t kind);

  std::function<void(const std::string&)> log_;
  std::array<Kind, kRefusals> kinds_;
};

}  // namespace lissom
