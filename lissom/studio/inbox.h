#pragma once
/// What waits for the engine's thread: requests of pages, and work that other threads hand over.

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <variant>
#include <vector>

namespace lissom {

/// A request of a page, an object.
struct Asked {
  int page = 0;
  nlohmann::json body;
  std::size_t bytes = 0;  ///< of its text
};

class Inbox {
 public:
  using Task = std::function<void()>;
  using Item = std::variant<Asked, Task>;

  enum class Taken {
    kYes,
    kFull,    ///< too much waits: the request is not taken
    kClosed,  ///< nothing is taken any more
  };
  /// Of drags and moved handles only the newest of a page counts: older ones that still wait are moved to `skipped`.
  Taken ask(Asked asked, std::vector<Asked>& skipped);
  void hand_over(Task task);

  /// The next one; nothing after `patience`, or once it is closed.
  std::optional<Item> next(std::chrono::milliseconds patience);

  /// Whether a request waits that passes. `passes` must be quick.
  bool any(const std::function<bool(const Asked&)>& passes) const;

  void close();
  bool closed() const;

 private:
  mutable std::mutex in_use_;
  std::condition_variable arrived_;
  std::deque<Item> items_;
  std::size_t bytes_ = 0;  // of the requests
  int requests_ = 0;
  bool closed_ = false;
};

}  // namespace lissom
