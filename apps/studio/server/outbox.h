#pragma once
/// What waits for one page. Threads of the engine put messages in, the server takes them out as fast as the page reads.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>

#include "lissom/studio/door.h"

namespace lissom {

/// Messages leave in the order in which they came, except that a newer one of the lane of shapes, or of previews, drops the
/// older one that still waits.
class Outbox {
 public:
  /// `limit`: bytes that may wait in order. `wake` is called, from any thread, when there is something to take again.
  Outbox(size_t limit, std::function<void()> wake);

  void put(const StudioMessage& message);
  /// The next message. After nothing was there, the next put() wakes.
  std::optional<StudioMessage> take();
  /// The page is too slow: more than the limit waited. From then on nothing is kept.
  bool overflowed() const;
  /// Nothing is kept from now on, and nobody is woken.
  void close();

 private:
  struct Waiting {
    uint64_t number = 0;
    StudioMessage message;
  };

  const size_t limit_;
  mutable std::mutex mutex_;
  std::function<void()> wake_;
  std::deque<Waiting> ordered_;
  std::optional<Waiting> shape_, preview_;
  uint64_t next_number_ = 0;
  size_t bytes_ = 0;  // in ordered_
  bool awake_ = false, overflowed_ = false, closed_ = false;
};

}  // namespace lissom
